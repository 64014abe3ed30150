// Many distances in one call: matrices between two sets of points, fields of many sources.
#pragma once

#include <span>

#include "tasks/workers.h"

namespace vorogeo {

/// How the entries of a matrix are computed. Both methods approximate the same distances and agree within the
/// errors of the index.
enum class MatrixMethod {
  automatic,  ///< whichever should be faster for the size of the matrix
  pairs,      ///< the distance of two points (Query::distance), entry by entry
  fields      ///< a field from each point of the shorter list
};

// Entries are double, or rounded to float.

/// Distances between all rows and columns, row by row: matrix[i * columns.size() + j]; `unreachable` where no
/// path leads. Rows or columns may be empty. \throw InvalidInput for a point that is not on the mesh or a
/// matrix of another size, Cancelled (the matrix is then partly filled).
template <class Entry>
void distance_matrix(Surface& surface, const PointList& rows, const PointList& columns, MatrixMethod method,
                     std::span<Entry> matrix, const TaskOptions& options = {});

/// The matrix of one list with itself: symmetric to the last bit, zero on the diagonal and for repeated
/// points. With fields, the value of a pair is read from the field of its smaller point
/// (SurfacePoint::<=>).
template <class Entry>
void distance_matrix(Surface& surface, const PointList& points, MatrixMethod method, std::span<Entry> matrix,
                     const TaskOptions& options = {});

/// The field of each source at all vertices in a row of n values; distances above max_distance are
/// `unreachable`. \throw as distance_matrix, and for a max_distance that is negative or NaN.
template <class Entry>
void distance_fields(Surface& surface, const PointList& sources, double max_distance, std::span<Entry> rows,
                     const TaskOptions& options = {});

}  // namespace vorogeo
