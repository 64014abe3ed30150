// Geodesic Voronoi cells of sample vertices, as labels of faces.
#pragma once

#include <span>

#include "mesh/outliers.h"
#include "partition/front.h"
#include "partition/sampling.h"

namespace vorogeo {

/// Label of each face of the part (in `faces`): the sample nearest to the face by the distances of the front,
/// with borders shortened by letting a face join two neighbours whose labels agree. Every label is a position
/// in `samples`; a label may own no face. Written to label[face]; other faces keep their labels.
///
/// All faces at a group of outliers get the same label, so that no outlier is on a patch border: tables
/// between borders then hold distances of one scale. Groups that are larger than a patch should be are left
/// as they are. Complexity: O(faces).
void label_voronoi_faces(Front& front, const Mesh& mesh, const MeshPart& part, std::span<const Index> faces,
                         std::span<const Index> samples, const Outliers& outliers, std::span<Index> label);

}  // namespace vorogeo
