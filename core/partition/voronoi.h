// Geodesic Voronoi cells of sample vertices, as labels of faces.
#pragma once

#include <span>

#include "partition/front.h"
#include "partition/sampling.h"

namespace vorogeo {

/// Label of each face of the part (in `faces`): the sample nearest to the face by the distances of the front,
/// its borders shortened by letting a face join two neighbours that agree. Every label is a position in
/// `samples`; a label may own no face. Written to label[face]; other faces keep their labels.
/// Complexity: O(faces).
void label_voronoi_faces(Front& front, const Mesh& mesh, const MeshPart& part, std::span<const Index> faces,
                         std::span<const Index> samples, std::span<Index> label);

}  // namespace vorogeo
