// Straightest geodesics: lines traced over the faces from a point, in a direction, for a length.
#include "exact/straightest.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "exact/edge_axes.h"
#include "support/progress.h"

namespace vorogeo {

namespace {

/// A line that passes a vertex this close, relative to the shortest edge around, passes through it.
constexpr double through_vertex = 1e-12;
/// Lines that glide in turns: while one waits for the memory of its next face, the others go on.
constexpr std::size_t lines_side_by_side = 8;
/// Rounding of directions, in radians.
constexpr double angle_rounding = 1e-15;
/// Directions this far outside all faces, in radians, are along the border.
constexpr double along_border = 1e-9;

using Weights = std::array<double, 3>;

class Line {
 public:
  Line(const ExactGeometry& geometry, const FaceSteps::Step* steps, AtBorder at_border, double length)
      : geometry_(&geometry),
        mesh_(geometry.mesh.get()),
        steps_(steps),
        at_border_(at_border),
        left_(length) {}

  void begin(const TangentFrame& frame, double angle) {
    end_ = frame.point();
    leave(frame, angle);
  }
  /// Goes on to the end of the line, or to where it begins to glide. \return whether it glides.
  bool walk_on() {
    for (int step = 1; !is_done_; ++step) {
      if (step % 256 == 0) checkpoint();
      if (vertex_frame_) {
        const TangentFrame here = *std::exchange(vertex_frame_, std::nullopt);
        leave(here, onwards_);
      } else if (steps_ != nullptr && begin_to_glide()) {
        return true;
      } else {
        cross();
      }
    }
    return false;
  }
  SurfacePoint end() const { return validated(*mesh_, end_); }
  /// The length that is left.
  double left() const { return left_; }

  // A line glides through faces that need no care: it does not end there and comes near no vertex, and behind
  // each side is one more face, oriented alike. It is followed in the plane in which it is the x axis.

  /// Glides through one face. \return false if the face needs care; it is not crossed then.
  bool glide() {
    const FaceSteps::Step& step = steps_[halfedge_];
    const PlanePoint to_apex{step.from_tail * way_[0] - step.depth * way_[1],
                             step.from_tail * way_[1] + step.depth * way_[0]};
    const double apex = tail_ + to_apex[1];
    const bool is_left = apex > 0.0;
    const Index next = step.behind[is_left ? 1 : 0];
    if (next == no_index) return false;
    prefetch_line(&steps_[next]);
    const PlanePoint next_way = is_left ? PlanePoint{step.from_head * way_[0] + step.depth * way_[1],
                                                     step.from_head * way_[1] - step.depth * way_[0]}
                                        : to_apex;
    const double next_forth = is_left ? forth_ + to_apex[0] : forth_;
    const double next_squared = dot_in_plane(next_way, next_way);
    if (apex * apex <= through_vertex * through_vertex * std::min(squared_, next_squared)) return false;
    if (!(std::max(next_forth, next_forth + next_way[0]) < left_)) {
      steps_ = nullptr;
      return false;
    }
    (is_left ? tail_ : head_) = apex;
    way_ = next_way;
    forth_ = next_forth;
    squared_ = next_squared;
    halfedge_ = next;
    return true;
  }

  /// Crosses the face that needs care.
  void stop_gliding() {
    const double part = tail_ / (tail_ - head_), size = std::sqrt(squared_), length = length_of(halfedge_);
    const bool is_forth = geometry_->frame[halfedge_].along;
    edge_ = {mesh_->next_around_edge(halfedge_), length, length * (is_forth ? part : 1.0 - part),
             (is_forth ? way_[0] : -way_[0]) / size, -way_[1] / size};
    left_ -= forth_ + part * way_[0];
    cross();
  }

 private:
  double length_of(Index halfedge) const { return mesh_->edge_length(mesh_->edge_of(halfedge)); }

  Weights on_edge(Index halfedge, double x) const {
    const double second = std::clamp(x / length_of(halfedge), 0.0, 1.0);
    const bool along = geometry_->frame[halfedge].along;
    Weights weights{};
    weights[halfedge % 3] = along ? 1.0 - second : second;
    weights[Mesh::next_in_face(halfedge) % 3] = along ? second : 1.0 - second;
    return weights;
  }

  /// Walks straight through a face, from() to to(); the line ends on the way if it reaches no farther.
  template <class From, class To>
  void walk(Index face, double distance, const From& from, const To& to) {
    if (distance < left_) {
      left_ -= distance;
      return;
    }
    const double part = left_ / distance;
    left_ = 0.0;
    is_done_ = true;
    end_ = SurfacePoint::in_face(face, to());
    const Weights begin = from();
    for (int i = 0; i < 3 && part < 1.0; ++i) {
      end_.barycentric[i] = (1.0 - part) * begin[i] + part * end_.barycentric[i];
    }
  }

  /// Leaves a point into the face that lies in that direction.
  void leave(const TangentFrame& frame, double angle) {
    const EdgeView* into = nullptr;
    double least = frame.is_on_border() ? along_border : 2.0 * frame.full_turn();
    double direction = 0.0;
    for (const EdgeView& view : frame.views()) {
      const double first = view.angle_to(0.0);
      const double second = view.angle_to(length_of(view.halfedge));
      const double middle = 0.5 * (first + second);
      const double off = std::remainder(angle - middle, frame.full_turn());
      const double outside = std::abs(off) - 0.5 * std::abs(second - first);
      if (!(outside < least)) continue;
      into = &view;
      least = outside;
      direction = middle + off;
    }
    if (into == nullptr) return meet_border(frame, angle);
    const Index h = into->halfedge;
    const Index face = Mesh::face_of(h);
    const double length = length_of(h);
    Weights from{};
    weights_in_face(*mesh_, frame.point(), face, from);
    // How far the line passes from the ends of the edge, and how far along the line these are.
    std::array<double, 2> to_end{}, aside{}, along{};
    const double rounding = angle_rounding * std::max(1.0, std::abs(direction));
    for (const int k : {0, 1}) {
      const double x = k * length;
      const double angle_to_end = std::max(0.0, std::abs(direction - into->angle_to(x)) - rounding);
      to_end[k] = std::hypot(x - into->x, into->y);
      aside[k] = to_end[k] * std::sin(angle_to_end);
      along[k] = to_end[k] * std::cos(angle_to_end);
    }
    const double near = through_vertex * std::min({length, to_end[0], to_end[1]});
    const int nearer = aside[1] < aside[0] ? 1 : 0;
    if (aside[nearer] <= near && along[nearer] >= 0.0) {
      return reach(geometry_->ends(mesh_->edge_of(h))[nearer], face, from, along[nearer]);
    }
    const double both = aside[0] + aside[1];
    const double x = both > 0.0 ? length * (aside[0] / both) : std::clamp(into->x, 0.0, length);
    walk(
        face, std::hypot(x - into->x, into->y), [&] { return from; }, [&] { return on_edge(h, x); });
    const double slope = into->sign * (direction - into->across);
    edge_ = {h, length, x, std::sin(slope), std::cos(slope)};
  }

  /// \return whether there is one more face behind the edge, oriented alike or not, and the line passes
  /// between its ends.
  bool begin_to_glide() {
    halfedge_ = mesh_->next_around_edge(edge_.halfedge);
    if (halfedge_ == edge_.halfedge || mesh_->next_around_edge(halfedge_) != edge_.halfedge) return false;
    const bool is_forth = geometry_->frame[halfedge_].along;
    way_ = {(is_forth ? edge_.along : -edge_.along) * edge_.length, -edge_.across * edge_.length};
    const double share = (is_forth ? edge_.x : edge_.length - edge_.x) / edge_.length;
    tail_ = -share * way_[1];
    head_ = (1.0 - share) * way_[1];
    forth_ = -share * way_[0];
    squared_ = edge_.length * edge_.length;
    return tail_ > 0.0 && head_ < 0.0;
  }

  /// Crosses the face behind the edge.
  void cross() {
    const Index h = mesh_->next_around_edge(edge_.halfedge);
    if (h == edge_.halfedge || mesh_->next_around_edge(h) != edge_.halfedge) {
      return slide(edge_.halfedge, edge_.x, edge_.along > 0.0);
    }
    const FaceFrame& frame = geometry_->frame[h];
    const double length = edge_.length;
    const double depth = frame.apex_depth;
    const bool second = (frame.apex_x - edge_.x) * edge_.across < edge_.along * depth;
    // All counts from the vertex that the edge shares with the side by which the line leaves.
    const double x = second ? length - edge_.x : edge_.x;
    const double along = second ? -edge_.along : edge_.along;
    const double apex_x = second ? geometry_->apex_from_second(h) : frame.apex_x;
    const Index halfedge = second ? frame.second_side(h) : frame.first_side(h);
    const bool is_reversed = second ? frame.second_side_reversed : frame.first_side_reversed;
    const Index face = Mesh::face_of(h);
    const auto from = [&] { return on_edge(h, edge_.x); };
    // On a long edge, positions have their digits at the first end only.
    const bool from_first = second && geometry_->is_long(mesh_->edge_of(h));
    const double to_apex = from_first ? edge_.x - frame.apex_x : apex_x - x;
    const double shared_aside = x * edge_.across;
    const double apex_aside = std::max(0.0, to_apex * edge_.across - along * depth);
    const double side = length_of(halfedge);
    const double near = through_vertex * std::min(length, side);
    const double ahead = to_apex * along + depth * edge_.across;
    if (apex_aside <= near && ahead >= 0.0) return reach(frame.apex, face, from(), ahead);
    if (shared_aside <= near && along < 0.0) {
      return reach(geometry_->ends(mesh_->edge_of(h))[second ? 1 : 0], face, from(), -x * along);
    }
    const double both = shared_aside + apex_aside;
    if (!(both > 0.0)) {  // along the edge
      const int end = edge_.along > 0.0 ? 1 : 0;
      return reach(geometry_->ends(mesh_->edge_of(h))[end], face, from(), std::abs(end * length - edge_.x));
    }
    const double to_side = shared_aside / both;
    const double at = side * (is_reversed ? apex_aside / both : to_side);
    const bool is_steep = edge_.across > 0.5;
    walk(face, is_steep ? depth * to_side / edge_.across : std::abs((to_side * apex_x - x) / along), from,
         [&] { return on_edge(halfedge, at); });
    // The direction in the frame of the side, times its length.
    const double turned = along * apex_x + edge_.across * depth;
    const double across = std::max(0.0, edge_.across * apex_x - along * depth);
    const double size = std::sqrt(turned * turned + across * across);
    edge_ = {halfedge, side, at, (is_reversed ? -turned : turned) / size, across / size};
  }

  /// Goes to a vertex of a face, and on with half of the vertex's angle on either side.
  void reach(Index vertex, Index face, const Weights& from, double distance) {
    walk(
        face, distance, [&] { return from; },
        [&] {
          Weights to{};
          for (int i = 0; i < 3; ++i) to[i] = mesh_->face_vertices(face)[i] == vertex ? 1.0 : 0.0;
          return to;
        });
    if (is_done_) return;
    end_ = SurfacePoint::at_vertex(vertex);
    // Along a border, a line goes on where the border is straight; round its bends only if it slides.
    const bool bends = mesh_->fan(vertex) == Mesh::Fan::open &&
                       std::abs(mesh_->total_angle(vertex) - std::numbers::pi) > along_border;
    is_done_ = !TangentFrame::exists_at(*mesh_, vertex) || (bends && at_border_ == AtBorder::end);
    if (is_done_) return;
    vertex_frame_.emplace(*geometry_, SurfacePoint::at_vertex(vertex));
    onwards_ = vertex_frame_->angle_in_face(face, from) + 0.5 * vertex_frame_->full_turn();
  }

  /// Meets the border at a point, which the line would leave by that angle.
  void meet_border(const TangentFrame& frame, double angle) {
    const SurfacePoint& point = frame.point();
    if (!point.is_vertex()) {
      Index h = 3 * point.face;
      while (point.barycentric[(h + 2) % 3] > 0.0) ++h;
      const bool to_head = std::cos(angle - frame.angle_to(point.face, mesh_->head(h))) > 0.0;
      const bool along = geometry_->frame[h].along;
      const double second = point.barycentric[(along ? h + 1 : h) % 3];
      return slide(h, second * length_of(h), to_head == along);
    }
    // Of the two edges on the border, the first is the x axis; the other one lies half a turn from it.
    const bool to_first = angle > 0.75 * frame.full_turn();
    const Index first = frame.first_halfedge();
    const Index h = to_first ? first : next_on_border(point.vertex, mesh_->edge_of(first));
    const bool to_second = geometry_->ends(mesh_->edge_of(h))[0] == point.vertex;
    slide(h, to_second ? 0.0 : length_of(h), to_second);
  }

  /// The other border edge at a vertex, by its half-edge.
  Index next_on_border(Index vertex, Index edge) const {
    for (const Index corner : mesh_->corners(vertex)) {
      for (const Index side : {corner, Mesh::previous_in_face(corner)}) {
        if (mesh_->edge_of(side) != edge && mesh_->is_border_edge(mesh_->edge_of(side))) return side;
      }
    }
    return no_index;
  }

  /// Ends at a place on a border edge, or slides on along the border from there.
  void slide(Index halfedge, double x, bool to_second) {
    end_ = SurfacePoint::in_face(Mesh::face_of(halfedge), on_edge(halfedge, x));
    for (int step = 1; at_border_ == AtBorder::slide; ++step) {
      if (step % 256 == 0) checkpoint();
      const Index edge = mesh_->edge_of(halfedge);
      const double length = mesh_->edge_length(edge);
      const double to = to_second ? length : 0.0;
      walk(
          Mesh::face_of(halfedge), std::abs(to - x), [&] { return on_edge(halfedge, x); },
          [&] { return on_edge(halfedge, to); });
      const Index vertex = geometry_->ends(edge)[to_second ? 1 : 0];
      if (is_done_) return;
      end_ = SurfacePoint::at_vertex(vertex);
      if (mesh_->fan(vertex) != Mesh::Fan::open) break;
      halfedge = next_on_border(vertex, edge);
      to_second = geometry_->ends(mesh_->edge_of(halfedge))[0] == vertex;
      x = to_second ? 0.0 : length_of(halfedge);
    }
    is_done_ = true;
  }

  /// Where the line has come to an edge: its place there and its direction, of unit length.
  struct OnEdge {
    Index halfedge;  ///< in the face that was crossed
    double length, x, along, across;
  };

  const ExactGeometry* geometry_;
  const Mesh* mesh_;
  const FaceSteps::Step* steps_;  ///< null if the line does not glide any more
  AtBorder at_border_;
  double left_;
  bool is_done_ = false;
  SurfacePoint end_;
  OnEdge edge_{};
  std::optional<TangentFrame> vertex_frame_;  ///< where the line has come to a vertex
  double onwards_ = 0.0;                      ///< the angle at which it leaves the vertex
  // While the line glides, it enters a face by a half-edge, whose tail is to the left of the line, its head
  // to the right.
  Index halfedge_ = no_index;
  PlanePoint way_{};                ///< from tail to head
  double tail_ = 0.0, head_ = 0.0;  ///< how far to the left of the line they are
  double forth_ = 0.0;              ///< how far along the line the tail is, from where it began to glide
  double squared_ = 0.0;            ///< squared length of the half-edge
};

}  // namespace

FaceSteps::FaceSteps(const ExactGeometry& geometry) {
  const Mesh& mesh = *geometry.mesh;
  step.resize(3 * static_cast<std::size_t>(mesh.face_count()));
  const auto behind = [&](Index side) {
    const Index h = mesh.next_around_edge(side);
    const Index edge = mesh.edge_of(side);
    const bool is_plain = h != side && mesh.next_around_edge(h) == side && mesh.tail(h) == mesh.head(side) &&
                          !geometry.is_long(edge) && mesh.edge_length(edge) > 0.0 &&
                          geometry.frame[h].apex_depth > 0.0;
    return is_plain ? h : no_index;
  };
  for (const Index h : checked(static_cast<Index>(step.size()))) {
    const FaceFrame& frame = geometry.frame[h];
    const double length = mesh.edge_length(mesh.edge_of(h));
    const double from_first = frame.apex_x / length, from_second = geometry.apex_from_second(h) / length;
    step[h] = {frame.along ? from_first : from_second,
               frame.along ? from_second : from_first,
               frame.apex_depth / length,
               {behind(Mesh::previous_in_face(h)), behind(Mesh::next_in_face(h))}};
  }
}

TracedEnd trace(const TangentFrame& frame, const Tangent& vector, AtBorder at_border) {
  const double length = std::hypot(vector[0], vector[1]);
  if (!(length > 0.0)) return {frame.point(), 0.0};
  Line line(frame.geometry(), nullptr, at_border, length);
  line.begin(frame, frame.angle_of(vector));
  line.walk_on();
  return {line.end(), length - line.left()};
}

void trace(std::span<const LineStart> starts, AtBorder at_border, const FaceSteps& steps,
           std::span<TracedEnd> ends) {
  struct Traced {
    Line line;
    std::size_t number;
  };
  std::vector<Traced> gliding;
  std::size_t next = 0;
  const auto finish = [&](const Traced& traced) {
    const Tangent& vector = starts[traced.number].vector;
    ends[traced.number] = {traced.line.end(), std::hypot(vector[0], vector[1]) - traced.line.left()};
  };
  for (std::size_t round = 1;; ++round) {
    if (round % 1024 == 0) checkpoint();
    while (gliding.size() < lines_side_by_side && next < starts.size()) {
      const auto& [frame, vector] = starts[next];
      const double length = std::hypot(vector[0], vector[1]);
      Traced traced{Line(frame->geometry(), steps.step.data(), at_border, length), next};
      ends[next++] = {frame->point(), 0.0};
      if (!(length > 0.0)) continue;
      traced.line.begin(*frame, frame->angle_of(vector));
      if (traced.line.walk_on()) {
        gliding.push_back(std::move(traced));
      } else {
        finish(traced);
      }
    }
    if (gliding.empty()) return;
    for (std::size_t i = 0; i < gliding.size(); ++i) {
      Line& line = gliding[i].line;
      if (line.glide()) continue;
      line.stop_gliding();
      if (line.walk_on()) continue;
      finish(gliding[i]);
      std::swap(gliding[i], gliding.back());
      gliding.pop_back();
      --i;
    }
  }
}

}  // namespace vorogeo
