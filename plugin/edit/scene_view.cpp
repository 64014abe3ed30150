// Reads the depth buffer once, and takes points from it by the inverse of the view's matrices.
#include "edit/scene_view.h"

#include <Eigen/LU>
#include <QOpenGLContext>
#include <QOpenGLFunctions_1_1>
#include <algorithm>
#include <cmath>

namespace vorogeo::plugin {

namespace {

/// Steps of a depth buffer of 24 bits by which a pixel's depth may be off.
constexpr double depth_error = 4.0 / (1 << 24);
/// Pixels by which a picked point may be off: the depth is that of some place within the pixel.
constexpr double pixel_error = 1.5;
/// Rounding of the positions that are drawn, relative to the largest coordinate.
constexpr double rounding = 1e-6;

}  // namespace

SceneView SceneView::capture(const Transform& layer, bool with_depth) {
  auto* gl = QOpenGLContext::currentContext()->versionFunctions<QOpenGLFunctions_1_1>();
  gl->initializeOpenGLFunctions();
  Eigen::Matrix4d view;
  Eigen::Matrix4d projection;
  gl->glGetDoublev(GL_MODELVIEW_MATRIX, view.data());
  gl->glGetDoublev(GL_PROJECTION_MATRIX, projection.data());
  GLint area[4];
  gl->glGetIntegerv(GL_VIEWPORT, area);
  SceneView scene;
  scene.left_ = area[0];
  scene.bottom_ = area[1];
  scene.width_ = area[2];
  scene.height_ = area[3];
  scene.to_clip_ = projection * view * layer;
  scene.from_clip_ = scene.to_clip_.inverse();
  if (with_depth) {
    scene.depth_.resize(static_cast<std::size_t>(scene.width_) * static_cast<std::size_t>(scene.height_));
    gl->glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    gl->glPixelStorei(GL_PACK_ALIGNMENT, 4);
    gl->glPixelStorei(GL_PACK_ROW_LENGTH, 0);
    gl->glReadPixels(scene.left_, scene.bottom_, scene.width_, scene.height_, GL_DEPTH_COMPONENT, GL_FLOAT,
                     scene.depth_.data());
    gl->glPopClientAttrib();
  }
  return scene;
}

Point SceneView::position(double x, double y, double depth) const {
  const Eigen::Vector4d clip(2.0 * x / width_ - 1.0, 2.0 * y / height_ - 1.0, 2.0 * depth - 1.0, 1.0);
  const Eigen::Vector4d found = from_clip_ * clip;
  return {found[0] / found[3], found[1] / found[3], found[2] / found[3]};
}

std::optional<Picked> SceneView::pick(int x, int y) const {
  if (x < 0 || y < 0 || x >= width_ || y >= height_ || depth_.empty()) return std::nullopt;
  const double depth =
      depth_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
  if (!(depth < 1.0)) return std::nullopt;
  const double middle_x = x + 0.5;
  const double middle_y = y + 0.5;
  const Point at = position(middle_x, middle_y, depth);
  const double pixel = distance_between(at, position(middle_x + 1.0, middle_y, depth));
  const double step = distance_between(at, position(middle_x, middle_y, depth - depth_error));
  const double largest = std::max({std::abs(at[0]), std::abs(at[1]), std::abs(at[2])});
  const double tolerance = pixel_error * pixel + step + rounding * largest;
  if (!std::isfinite(at[0] + at[1] + at[2] + tolerance)) return std::nullopt;
  return Picked{at, tolerance};
}

std::optional<QPointF> SceneView::pixel_of(const Point& point) const {
  const Eigen::Vector4d clip = to_clip_ * Eigen::Vector4d(point[0], point[1], point[2], 1.0);
  if (!(clip[3] > 0.0)) return std::nullopt;
  return QPointF(0.5 * (clip[0] / clip[3] + 1.0) * width_, 0.5 * (clip[1] / clip[3] + 1.0) * height_);
}

}  // namespace vorogeo::plugin
