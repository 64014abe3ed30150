// Differences and products of points as vectors.
#pragma once

#include "mesh/mesh.h"

namespace vorogeo {

inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
/// a + t d.
inline Point moved(const Point& a, double t, const Point& d) {
  return {a[0] + t * d[0], a[1] + t * d[1], a[2] + t * d[2]};
}
inline double length_of(const Point& p) { return std::hypot(p[0], p[1], p[2]); }

}  // namespace vorogeo
