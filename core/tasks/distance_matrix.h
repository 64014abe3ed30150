// Matrices of distances, and the fields of landmarks.
#pragma once

#include <memory>
#include <span>

#include "exact/exact_landmarks.h"
#include "index/geodesic_index.h"
#include "support/progress.h"
#include "tasks/field_team.h"

namespace vorogeo {

// ---- Many distances in one call: pairs, matrices between two sets of points, fields of many sources

/// How the entries of a matrix are computed. Both methods approximate the same distances and agree within the
/// errors of the index.
enum class MatrixMethod {
  automatic,  ///< whichever should be faster for the size of the matrix
  pairs,      ///< the distance of two points (FieldTeam::distance), entry by entry
  fields      ///< a field from each point of the shorter list
};

/// distance[i] of the pair (sources[i], targets[i]). \throw InvalidInput for a point that is not on the mesh
/// or lists of different lengths, Cancelled.
void pair_distances(FieldTeam& team, const PointList& sources, const PointList& targets,
                    std::span<double> distance, const Progress& progress = {});

/// Distances between all rows and columns, row by row: matrix[i * columns.size() + j]; `unreachable` where no
/// path leads. Rows or columns may be empty. \throw InvalidInput for a point that is not on the mesh or a
/// matrix of another size, Cancelled (the matrix is then partly filled).
void distance_matrix(FieldTeam& team, const PointList& rows, const PointList& columns, MatrixMethod method,
                     std::span<double> matrix, const Progress& progress = {});
/// The same, rounded to single precision.
void distance_matrix(FieldTeam& team, const PointList& rows, const PointList& columns, MatrixMethod method,
                     std::span<float> matrix, const Progress& progress = {});

/// The matrix of one list with itself: symmetric to the last bit, zero on the diagonal and for repeated
/// points. With fields, the value of a pair is read from the field of its smaller point
/// (SurfacePoint::<=>).
void distance_matrix(FieldTeam& team, const PointList& points, MatrixMethod method, std::span<double> matrix,
                     const Progress& progress = {});
/// The same, rounded to single precision.
void distance_matrix(FieldTeam& team, const PointList& points, MatrixMethod method, std::span<float> matrix,
                     const Progress& progress = {});

/// The field of each source at all vertices in a row of n values; distances above max_distance are
/// `unreachable`. \throw as distance_matrix, and for a max_distance that is negative or NaN.
void distance_fields(FieldTeam& team, const PointList& sources, double max_distance, std::span<double> rows,
                     const Progress& progress = {});
/// The same, rounded to single precision.
void distance_fields(FieldTeam& team, const PointList& sources, double max_distance, std::span<float> rows,
                     const Progress& progress = {});

// ---- Landmarks for exact paths: spread by the index, measured by the exact solver

/// Exact distances, on the surface of exact runs (IndexData::unsplit), from `count` vertices that are far
/// from one another, all in the component with the most vertices. \throw InvalidInput for a count that is not
/// in 1 to ExactLandmarks::max_count, Cancelled. Complexity: an exact field for each, on `threads` threads
/// (0: one per core).
std::shared_ptr<const ExactLandmarks> landmarks_of(const std::shared_ptr<const GeodesicIndex>& index,
                                                   int count, int threads = 0, const Progress& progress = {});

}  // namespace vorogeo
