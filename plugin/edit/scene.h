// The scene of a view: what is picked from it by its matrices and depths, and what the ruler draws over it.
#pragma once

#include <Eigen/Core>
#include <QPainter>
#include <QPointF>
#include <QString>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "edit/ruler_surface.h"
#include "tasks/surface_lines.h"

namespace vorogeo::plugin {

// ---- Picking

/// From the coordinates of a layer to those of the scene.
using Transform = Eigen::Matrix4d;

/// A view, captured while it is painted. Picks need no painting and no OpenGL afterwards, as long as the view
/// stays the same, which it does while the mouse drags a tool. Pixels count from the lower left corner.
class SceneView {
 public:
  /// Only while the scene is painted, with the view's matrices in place. `with_depth`: for pick().
  static SceneView capture(const Transform& layer, bool with_depth);

  /// The point that is seen at a pixel, in the coordinates of the layer; nothing where the scene is empty.
  std::optional<Picked> pick(int x, int y) const;
  /// The pixel at which a point of the layer is seen, if it lies in front of the viewer.
  std::optional<QPointF> pixel_of(const Point& point) const;
  int height() const { return height_; }

 private:
  Point position(double x, double y, double depth) const;  ///< in the scene

  Eigen::Matrix4d to_clip_;    ///< from the layer
  Eigen::Matrix4d from_clip_;  ///< to the scene
  Eigen::Matrix4d to_layer_;
  int left_ = 0;
  int bottom_ = 0;
  int width_ = 0;
  int height_ = 0;
  std::vector<float> depth_;
};

// ---- Drawing: lines that are seen on every colour, a coloured surface, labels

/// A triangle mesh with a colour at each vertex, as OpenGL takes it.
struct ColoredSurface {
  std::vector<float> positions;        ///< three for each vertex
  std::vector<float> normals;          ///< likewise
  std::vector<std::uint8_t> colors;    ///< four for each vertex
  std::vector<std::uint32_t> corners;  ///< three for each face
};

using Color = std::array<float, 3>;
inline constexpr Color measured_color{1.0F, 0.85F, 0.1F};
inline constexpr Color live_color{1.0F, 0.35F, 0.1F};
inline constexpr Color no_path_color{1.0F, 0.15F, 0.15F};
inline constexpr Color isoline_color{1.0F, 1.0F, 1.0F};

/// Draws over the scene while it lives; the state of OpenGL is then as before. Only while the scene is
/// painted. The depth of the scene decides what is hidden.
class Overlay {
 public:
  /// `ratio`: pixels of the picture to a pixel of the window.
  Overlay(const Transform& layer, float ratio);
  ~Overlay();
  Overlay(const Overlay&) = delete;
  Overlay& operator=(const Overlay&) = delete;

  /// With a dark rim. `width` in pixels of the window; `dotted`: what the scene hides is drawn in dots,
  /// otherwise not at all.
  void lines(const SurfaceLines& lines, const Color& color, float width, bool dotted = true);
  /// In place of the surface that was drawn, in the light of the scene.
  void surface(const ColoredSurface& surface);

 private:
  void segments(const SurfaceLines& lines, const Color& color, float width, float opacity);

  const float ratio_;
};

struct Label {
  QPointF pixel;  ///< from the lower left corner
  QString text;   ///< empty: a dot at the place itself
};

/// Light text on dark ground, beside its place, and dots. Ends the painter's native painting and begins it
/// again.
void draw_labels(QPainter& painter, const SceneView& view, const std::vector<Label>& labels);

}  // namespace vorogeo::plugin
