// Checks and inverts a matrix.
#include "layers/placement.h"

#include <algorithm>
#include <cmath>

#include "mesh/vectors.h"
#include "support/error.h"

namespace vorogeo::plugin {

namespace {

/// What single precision makes of 0 in a determinant of columns of length 1, and of 1 in the last row.
constexpr double rounding = 1e-6;

}  // namespace

Placement::Placement(const std::array<std::array<double, 4>, 4>& matrix, const std::string& layer) {
  const auto refuse = [&](const char* why) {
    throw InvalidInput("The transformation matrix of " + layer + " " + why +
                       ". Take it back by 'Matrix: Reset Current Matrix', or set another one.");
  };
  bool is_finite = true;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      is_finite = is_finite && std::isfinite(matrix[i][j]);
      is_identity_ = is_identity_ && matrix[i][j] == (i == j ? 1.0 : 0.0);
    }
  }
  if (!is_finite) refuse("has an element that is NaN or infinite");
  const auto& last = matrix[3];
  if (last[0] != 0.0 || last[1] != 0.0 || last[2] != 0.0 || std::abs(last[3] - 1.0) > rounding) {
    refuse("is projective, as its last row is not 0 0 0 1");
  }
  if (is_identity_) return;
  std::ranges::copy(matrix.begin(), matrix.begin() + 3, to_scene_.begin());
  std::array<Point, 4> column{};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 4; ++j) column[j][i] = matrix[i][j];
  }
  const double determinant = dot(column[0], cross(column[1], column[2]));
  const double size =
      vorogeo::length_of(column[0]) * vorogeo::length_of(column[1]) * vorogeo::length_of(column[2]);
  if (!(std::abs(determinant) > rounding * size)) refuse("is singular: it presses the layer flat");
  is_mirrored_ = determinant < 0.0;
  for (int i = 0; i < 3; ++i) {
    const Point row = moved({}, 1.0 / determinant, cross(column[(i + 1) % 3], column[(i + 2) % 3]));
    to_layer_[i] = {row[0], row[1], row[2], -dot(row, column[3])};
  }
}

}  // namespace vorogeo::plugin
