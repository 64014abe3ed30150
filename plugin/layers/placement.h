// Where a layer stands in the scene: its transformation matrix, applied to points and taken back.
#pragma once

#include <array>
#include <string>

#include "mesh/mesh.h"

namespace vorogeo::plugin {

/// From the coordinates of a layer to those of the scene, in which everything is measured, and back.
class Placement {
 public:
  /// The coordinates of the layer are those of the scene.
  Placement() = default;
  /// `matrix`: by rows. `layer`: how errors name the layer. \throw InvalidInput for a matrix that is not
  /// finite, projective, or singular.
  Placement(const std::array<std::array<double, 4>, 4>& matrix, const std::string& layer);

  bool is_identity() const { return is_identity_; }
  /// Whether left and right change places, so that normals that pointed outwards point inwards.
  bool is_mirrored() const { return is_mirrored_; }
  /// The point in the scene, to the last bit as by the host's "Freeze Current Matrix" in double precision.
  Point to_scene(const Point& at) const { return is_identity_ ? at : times(to_scene_, at); }
  Point to_layer(const Point& at) const { return is_identity_ ? at : times(to_layer_, at); }

  friend bool operator==(const Placement&, const Placement&) = default;

 private:
  using Rows = std::array<std::array<double, 4>, 3>;
  static Point times(const Rows& rows, const Point& p) {
    Point found{};
    for (int i = 0; i < 3; ++i) {
      found[i] = rows[i][0] * p[0] + rows[i][1] * p[1] + rows[i][2] * p[2] + rows[i][3];
    }
    return found;
  }

  bool is_identity_ = true;
  bool is_mirrored_ = false;
  Rows to_scene_{};  ///< unused for the identity
  Rows to_layer_{};
};

}  // namespace vorogeo::plugin
