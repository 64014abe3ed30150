// What a view of the scene shows, as far as picking needs it: its matrices and the depth of each pixel.
#pragma once

#include <Eigen/Core>
#include <QPointF>
#include <optional>
#include <vector>

#include "edit/ruler_surface.h"

namespace vorogeo::plugin {

/// From the coordinates of a layer to those of the scene.
using Transform = Eigen::Matrix4d;

/// A view, captured while it is painted. Picks need no painting and no OpenGL afterwards, as long as the view
/// stays the same, which it does while the mouse drags a tool. Pixels count from the lower left corner.
class SceneView {
 public:
  /// Only while the scene is painted, with the view's matrices in place. `with_depth`: for pick().
  static SceneView capture(const Transform& layer, bool with_depth);

  /// The point of the layer that is seen at a pixel; nothing where the scene is empty.
  std::optional<Picked> pick(int x, int y) const;
  /// The pixel at which a point of the layer is seen, if it lies in front of the viewer.
  std::optional<QPointF> pixel_of(const Point& point) const;
  int height() const { return height_; }

 private:
  Point position(double x, double y, double depth) const;

  Eigen::Matrix4d to_clip_;
  Eigen::Matrix4d from_clip_;
  int left_ = 0;
  int bottom_ = 0;
  int width_ = 0;
  int height_ = 0;
  std::vector<float> depth_;
};

}  // namespace vorogeo::plugin
