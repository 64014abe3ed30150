// A side of the face being crossed, and how windows arrive there.
#pragma once

#include <algorithm>
#include <cmath>

#include "exact/window.h"
#include "mesh/mesh.h"

namespace vorogeo {

/// A side of the face being crossed; positions on the crossed edge count from the vertex it shares with the
/// side.
struct Side {
  Side(const Mesh& mesh, Index side_halfedge, bool is_reversed, double apex_from_shared, double depth)
      : halfedge(side_halfedge),
        edge(mesh.edge_of(side_halfedge)),
        reversed(is_reversed),
        length(mesh.edge_length(edge)),
        apex_x(apex_from_shared),
        apex_depth(depth),
        cosine(apex_from_shared / length),
        sine(depth / length) {}

  /// Where the ray through x leaves the side, counted from the shared vertex.
  double crossing(double x, double source_x, double source_y) const {
    const double denominator = source_y * apex_x - (x - source_x) * apex_depth;
    if (!(denominator > 0.0)) {
      // Source, edge and side on one line: the face has no width, so positions stay where they are.
      if (source_y == 0.0 && apex_depth == 0.0 && apex_x > 0.0) return std::min(x, length);
      return x > 0.0 ? length : 0.0;
    }
    return length * std::min(1.0, x * source_y / denominator);
  }
  double inside(double x) const { return std::clamp(x, 0.0, length); }

  /// A pseudo-source that rounding has taken behind the line of the side is laid on the line, as far from
  /// where positions count from as it was, (across, away): at an edge of a few units in the last place, it
  /// may lie anywhere behind.
  static void lay_on_line(double& x, double& y, double across, double away) {
    x = std::copysign(std::sqrt(across * across + away * away), x);
    y = 0.0;
  }

  /// The part [begin, end] of a window, as it arrives at the side. `to_end`: it ends at the ray to the apex.
  /// `second`: the side shares the crossed edge's second vertex.
  Window arriving(const Window& window, double begin, double end, bool to_end, bool second,
                  double crossed_length) const {
    // Positions on the crossed edge from the vertex shared with the side.
    const double source_x = second ? crossed_length - window.source_x : window.source_x;
    const double source_y = window.source_y;
    const double from = crossing(second ? crossed_length - end : begin, source_x, source_y);
    const double to = to_end ? length : crossing(second ? crossed_length - begin : end, source_x, source_y);
    double turned_x = source_x * cosine - source_y * sine;
    double turned_y = source_y * cosine + source_x * sine;
    if (turned_y < 0.0) lay_on_line(turned_x, turned_y, source_x, source_y);
    return {inside(reversed ? length - to : from),
            inside(reversed ? length - from : to),
            reversed ? length - turned_x : turned_x,
            turned_y,
            window.offset,
            halfedge,
            window.source};
  }

  /// The same for a side whose positions count from the apex, without differences of large numbers: the
  /// shared vertex may be an outlier. `apex_along`: of the apex on the crossed edge, `to_apex`: where the ray
  /// to it passes, both from the crossed edge's first vertex.
  Window arriving_from_apex(const Window& window, double begin, double end, bool to_end, bool second,
                            double crossed_length, double apex_along, double to_apex) const {
    const double sign = second ? -1.0 : 1.0;
    const double source_y = window.source_y;
    const double height = source_y + apex_depth;
    auto from_apex = [&](double x) {
      const double aside = sign * (x - window.source_x);
      const double denominator = source_y * apex_x - aside * apex_depth;
      if (denominator > 0.0)
        return inside(length * std::min(1.0, sign * (to_apex - x) * height / denominator));
      const double from_shared = second ? crossed_length - x : x;
      return inside(length - crossing(from_shared, from_shared - aside, source_y));
    };
    const double source_x = second ? crossed_length - window.source_x : window.source_x;
    double turned_x = sign * (apex_along - window.source_x) * cosine + height * sine;
    double turned_y = source_y * cosine + source_x * sine;
    if (turned_y < 0.0) lay_on_line(turned_x, turned_y, apex_along - window.source_x, height);
    return {to_end ? 0.0 : from_apex(second ? begin : end),
            from_apex(second ? end : begin),
            turned_x,
            turned_y,
            window.offset,
            halfedge,
            window.source};
  }

  Index halfedge;
  Index edge;
  bool reversed;
  double length;
  double apex_x;
  double apex_depth;
  double cosine;
  double sine;
};

}  // namespace vorogeo
