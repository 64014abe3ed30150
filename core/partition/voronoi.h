// Geodesic Voronoi cells of sample vertices, as labels of faces.
#pragma once

#include <span>
#include <vector>

#include "exact/exact_solver.h"
#include "partition/sampling.h"

namespace vorogeo {

/// Label of each face of the part (in `faces`): the sample nearest to the face by exact geodesic distance,
/// its borders shortened by letting a face join two neighbours that agree. Every label is a position in
/// `samples`; a label may own no face. Written to label[face]; other faces keep their labels.
/// `progress`, if given, must belong to the calling thread.
void label_voronoi_faces(ExactSolver& solver, const MeshPart& part, std::span<const Index> faces,
                         std::span<const Index> samples, std::span<Index> label,
                         const Progress* progress = nullptr);

}  // namespace vorogeo
