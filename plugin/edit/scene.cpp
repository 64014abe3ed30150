// Reads the depth buffer once, and takes points from it by the inverse of the view's matrices; draws by
// OpenGL.
#include "edit/scene.h"

#include <Eigen/LU>
#include <QFontMetrics>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QOpenGLFunctions_1_1>
#include <algorithm>
#include <cmath>

namespace vorogeo::plugin {

// ---- Picking

namespace {

/// The functions of a version of OpenGL that every host has.
QOpenGLFunctions_1_1& gl() {
  auto* functions = QOpenGLContext::currentContext()->versionFunctions<QOpenGLFunctions_1_1>();
  functions->initializeOpenGLFunctions();
  return *functions;
}

/// Steps of a depth buffer of 24 bits by which a pixel's depth may be off.
constexpr double depth_error = 4.0 / (1 << 24);
/// Pixels by which a picked point may be off: the depth is that of some place within the pixel.
constexpr double pixel_error = 1.5;
/// Rounding of the positions that are drawn, relative to the largest coordinate.
constexpr double rounding = 1e-6;

}  // namespace

SceneView SceneView::capture(const Transform& layer, bool with_depth) {
  Eigen::Matrix4d view;
  Eigen::Matrix4d projection;
  gl().glGetDoublev(GL_MODELVIEW_MATRIX, view.data());
  gl().glGetDoublev(GL_PROJECTION_MATRIX, projection.data());
  GLint area[4];
  gl().glGetIntegerv(GL_VIEWPORT, area);
  SceneView scene;
  scene.left_ = area[0];
  scene.bottom_ = area[1];
  scene.width_ = area[2];
  scene.height_ = area[3];
  scene.to_clip_ = projection * view * layer;
  scene.from_clip_ = (projection * view).inverse();
  scene.to_layer_ = layer.inverse();
  if (with_depth) {
    scene.depth_.resize(static_cast<std::size_t>(scene.width_) * static_cast<std::size_t>(scene.height_));
    gl().glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    gl().glPixelStorei(GL_PACK_ALIGNMENT, 4);
    gl().glPixelStorei(GL_PACK_ROW_LENGTH, 0);
    gl().glReadPixels(scene.left_, scene.bottom_, scene.width_, scene.height_, GL_DEPTH_COMPONENT, GL_FLOAT,
                      scene.depth_.data());
    gl().glPopClientAttrib();
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
  const Eigen::Vector4d in_layer = to_layer_ * Eigen::Vector4d(at[0], at[1], at[2], 1.0);
  if (!std::isfinite(in_layer.sum() + tolerance)) return std::nullopt;
  return Picked{{in_layer[0], in_layer[1], in_layer[2]}, tolerance};
}

std::optional<QPointF> SceneView::pixel_of(const Point& point) const {
  const Eigen::Vector4d clip = to_clip_ * Eigen::Vector4d(point[0], point[1], point[2], 1.0);
  if (!(clip[3] > 0.0)) return std::nullopt;
  return QPointF(0.5 * (clip[0] / clip[3] + 1.0) * width_, 0.5 * (clip[1] / clip[3] + 1.0) * height_);
}

// ---- Drawing

namespace {

/// Lines are drawn this much nearer than the surface that they lie on.
constexpr double nearer = 5e-4;
/// And a coloured surface by this much.
constexpr double nearer_surface = 2e-4;
constexpr float rim = 2.5F;
constexpr float opacity_hidden = 0.6F;
constexpr GLushort dots = 0x3333;
constexpr double dot_radius = 3.5;

}  // namespace

Overlay::Overlay(const Transform& layer, float ratio) : ratio_(ratio) {
  gl().glPushAttrib(GL_ALL_ATTRIB_BITS);
  gl().glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
  gl().glMatrixMode(GL_MODELVIEW);
  gl().glPushMatrix();
  gl().glMultMatrixd(layer.data());
  QOpenGLFunctions* modern = QOpenGLContext::currentContext()->functions();
  modern->glUseProgram(0);
  modern->glBindBuffer(GL_ARRAY_BUFFER, 0);
  modern->glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
  gl().glDisable(GL_TEXTURE_2D);
  gl().glDisable(GL_LIGHTING);
  gl().glDisable(GL_CULL_FACE);
  gl().glEnable(GL_DEPTH_TEST);
  gl().glDepthMask(GL_FALSE);
  gl().glEnable(GL_BLEND);
  gl().glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  gl().glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

Overlay::~Overlay() {
  gl().glMatrixMode(GL_MODELVIEW);
  gl().glPopMatrix();
  gl().glPopClientAttrib();
  gl().glPopAttrib();
}

void Overlay::segments(const SurfaceLines& lines, const Color& color, float width, float opacity) {
  gl().glLineWidth(ratio_ * width);
  gl().glColor4f(color[0], color[1], color[2], opacity);
  gl().glEnableClientState(GL_VERTEX_ARRAY);
  gl().glVertexPointer(3, GL_DOUBLE, 0, lines.points.data());
  gl().glDrawElements(GL_LINES, static_cast<GLsizei>(2 * lines.segments.size()), GL_UNSIGNED_INT,
                      lines.segments.data());
  gl().glDisableClientState(GL_VERTEX_ARRAY);
}

void Overlay::lines(const SurfaceLines& lines, const Color& color, float width, bool dotted) {
  if (lines.segments.empty()) return;
  constexpr Color dark{0.0F, 0.0F, 0.0F};
  gl().glDepthRange(0.0, 1.0 - nearer);
  if (dotted) {
    gl().glDepthFunc(GL_GREATER);
    gl().glEnable(GL_LINE_STIPPLE);
    gl().glLineStipple(std::max(1, static_cast<int>(std::lround(2.0F * ratio_))), dots);
    segments(lines, color, width, opacity_hidden);
    gl().glDisable(GL_LINE_STIPPLE);
  }
  gl().glDepthFunc(GL_LEQUAL);
  segments(lines, dark, width + rim, 1.0F);
  segments(lines, color, width, 1.0F);
  gl().glDepthRange(0.0, 1.0);
}

void Overlay::surface(const ColoredSurface& surface) {
  if (surface.corners.empty()) return;
  gl().glEnable(GL_LIGHTING);
  gl().glEnable(GL_LIGHT0);
  gl().glEnable(GL_NORMALIZE);
  gl().glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  gl().glEnable(GL_COLOR_MATERIAL);
  gl().glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
  gl().glShadeModel(GL_SMOOTH);
  gl().glDepthRange(0.0, 1.0 - nearer_surface);
  gl().glDepthFunc(GL_LEQUAL);
  gl().glEnableClientState(GL_VERTEX_ARRAY);
  gl().glEnableClientState(GL_NORMAL_ARRAY);
  gl().glEnableClientState(GL_COLOR_ARRAY);
  gl().glVertexPointer(3, GL_FLOAT, 0, surface.positions.data());
  gl().glNormalPointer(GL_FLOAT, 0, surface.normals.data());
  gl().glColorPointer(4, GL_UNSIGNED_BYTE, 0, surface.colors.data());
  // The nearest of several faces at a pixel wins only if their depths are kept.
  gl().glDepthMask(GL_TRUE);
  gl().glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(surface.corners.size()), GL_UNSIGNED_INT,
                      surface.corners.data());
  gl().glDepthMask(GL_FALSE);
  gl().glDisableClientState(GL_VERTEX_ARRAY);
  gl().glDisableClientState(GL_NORMAL_ARRAY);
  gl().glDisableClientState(GL_COLOR_ARRAY);
  gl().glDisable(GL_LIGHTING);
  gl().glDepthRange(0.0, 1.0);
}

void draw_labels(QPainter& painter, const SceneView& view, const std::vector<Label>& labels) {
  if (labels.empty()) return;
  // The painter sets matrices of its own.
  gl().glPushAttrib(GL_ENABLE_BIT | GL_VIEWPORT_BIT);
  gl().glDisable(GL_DEPTH_TEST);
  gl().glMatrixMode(GL_PROJECTION);
  gl().glPushMatrix();
  gl().glMatrixMode(GL_MODELVIEW);
  gl().glPushMatrix();
  painter.endNativePainting();
  painter.save();
  QFont font = painter.font();
  font.setPixelSize(13);
  painter.setFont(font);
  const QFontMetrics metrics(font);
  const double ratio = painter.device()->devicePixelRatioF();
  for (const Label& label : labels) {
    const QPointF place(label.pixel.x() / ratio, (view.height() - label.pixel.y()) / ratio);
    if (label.text.isEmpty()) {
      painter.setPen(Qt::black);
      painter.setBrush(Qt::white);
      painter.drawEllipse(place, dot_radius, dot_radius);
      continue;
    }
    const QPointF at = place + QPointF(12.0, -12.0);
    QRectF ground = metrics.boundingRect(label.text);
    ground = ground.adjusted(-4.0, -2.0, 4.0, 2.0).translated(at);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 190));
    painter.drawRoundedRect(ground, 3.0, 3.0);
    painter.setPen(Qt::white);
    painter.drawText(at, label.text);
  }
  painter.restore();
  painter.beginNativePainting();
  gl().glMatrixMode(GL_PROJECTION);
  gl().glPopMatrix();
  gl().glMatrixMode(GL_MODELVIEW);
  gl().glPopMatrix();
  gl().glPopAttrib();
}

}  // namespace vorogeo::plugin
