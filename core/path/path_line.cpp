// Unfolding, and pulling tight between joints.
#include "path/path_line.h"

#include <algorithm>
#include <cmath>

#include "exact/face_plane.h"

namespace vorogeo {

namespace {

/// Edges crossed, and the line itself, are this fraction of the longest of them: ten digits remain of its
/// length.
constexpr double least_scale = 1e-6;

double distance_between(const PlanePoint& a, const PlanePoint& b) {
  const double dx = a[0] - b[0], dy = a[1] - b[1];
  return std::sqrt(dx * dx + dy * dy);
}

}  // namespace

UnfoldedCrossing PathLine::crossing_at(Index exit, Index entry, Index left, Index right) {
  const Mesh& mesh = *geometry_->mesh;
  const FaceFrame& frame = geometry_->frame[entry];
  const double length = mesh.edge_length(mesh.edge_of(entry));
  shortest_crossed_ = std::min(shortest_crossed_, length);
  longest_crossed_ = std::max(longest_crossed_, length);
  UnfoldedCrossing crossing{exit, entry, left, right, 0.0, 0.0, 0.0, {}, {}};
  if (!(length > 0.0)) {
    crossing.corner_distance = mesh.edge_length(mesh.edge_of(frame.first_side(entry)));
    return crossing;
  }
  const bool left_first = (mesh.tail(entry) == left) == frame.along;
  crossing.along = (left_first ? frame.apex_x : length - frame.apex_x) / length;
  crossing.aside = frame.apex_depth / length;
  return crossing;
}

void PathLine::assign(const FaceStrip& strip) {
  const Mesh& mesh = *geometry_->mesh;
  source_ = strip.source;
  target_ = strip.target;
  first_face_ = strip.faces.front();
  shortest_crossed_ = unreachable;
  longest_crossed_ = 0.0;
  crossings_.clear();
  for (std::size_t i = 0; i < strip.entry.size(); ++i) {
    // Corners are counterclockwise in the plane: leaving across a half-edge, its head is on the left.
    Index left = mesh.head(strip.exit[i]);
    Index right = mesh.tail(strip.exit[i]);
    if (i > 0 && (left == crossings_.back().right || right == crossings_.back().left)) std::swap(left, right);
    crossings_.push_back(crossing_at(strip.exit[i], strip.entry[i], left, right));
  }
  joints_.assign(2, {});
  joints_.front().last = -1;
  joints_.back().first = joints_.back().last = size_of(crossings_);
  next_joints_.assign(1, joints_.front());
  pull(next_joints_.front(), joints_.back());
  next_joints_.push_back(joints_.back());
  std::swap(joints_, next_joints_);
}

void PathLine::assign(const PathLine& other) {
  source_ = other.source_;
  target_ = other.target_;
  first_face_ = other.first_face_;
  crossings_ = other.crossings_;
  joints_ = other.joints_;
  shortest_crossed_ = other.shortest_crossed_;
  longest_crossed_ = other.longest_crossed_;
}

bool PathLine::is_rough() const {
  const double line = length();
  return std::min(shortest_crossed_, line) < least_scale * std::max(longest_crossed_, line);
}

double PathLine::length() const {
  double length = 0.0;
  for (std::size_t k = 0; k + 1 < joints_.size(); ++k) {
    length += distance_between(joints_[k].out, joints_[k + 1].in);
  }
  return length;
}

double PathLine::turn(std::size_t joint) const {
  const Joint& j = joints_[joint];
  const PlanePoint in{j.in[0] - joints_[joint - 1].out[0], j.in[1] - joints_[joint - 1].out[1]};
  PlanePoint out{joints_[joint + 1].in[0] - j.out[0], joints_[joint + 1].in[1] - j.out[1]};
  if (j.is_seam) {
    // From the plane after the joint into the plane before it, by the direction of the edge known in both.
    const double ex = j.other_in[0] - j.in[0], ey = j.other_in[1] - j.in[1];
    const double fx = j.other_out[0] - j.out[0], fy = j.other_out[1] - j.out[1];
    const double cosine = ex * fx + ey * fy, sine = ey * fx - ex * fy;
    out = {out[0] * cosine - out[1] * sine, out[0] * sine + out[1] * cosine};
  }
  const double across = in[0] * out[1] - in[1] * out[0];
  return std::atan2(j.left ? across : -across, in[0] * out[0] + in[1] * out[1]);
}

void PathLine::find_range(Index at, Joint& joint) const {
  auto has = [&](Index i) { return (joint.left ? crossings_[i].left : crossings_[i].right) == joint.vertex; };
  joint.first = joint.last = at;
  while (joint.first > 0 && has(joint.first - 1)) --joint.first;
  while (joint.last + 1 < size_of(crossings_) && has(joint.last + 1)) ++joint.last;
}

/// Unfolds the crossings between two joints, and adds the bends found to next_joints_.
void PathLine::pull(Joint& from, Joint& to) {
  const Mesh& mesh = *geometry_->mesh;
  const Index begin = from.last + 1;
  const Index end = std::min(to.last + 1, size_of(crossings_));
  std::array<double, 3> weights{};
  if (begin == 0) {
    const FacePlane plane(*geometry_, first_face_);
    weights_in_face(mesh, source_, first_face_, weights);
    from.out = plane.at(weights);
    if (crossings_.empty()) {
      weights_in_face(mesh, target_, first_face_, weights);
      to.in = plane.at(weights);
      return;
    }
    auto corner = [&](Index vertex) {
      const auto& corners = mesh.face_vertices(first_face_);
      return plane.corner[vertex == corners[0] ? 0 : vertex == corners[1] ? 1 : 2];
    };
    crossings_[0].at_left = corner(crossings_[0].left);
    crossings_[0].at_right = corner(crossings_[0].right);
  }
  UnfoldedCrossing previous{};
  if (begin > 0) {
    previous = crossings_[from.last];
    previous.at_left = {0.0, 0.0};
    previous.at_right = {mesh.edge_length(mesh.edge_of(previous.entry)), 0.0};
    from.out = from.left ? previous.at_left : previous.at_right;
    from.other_out = from.left ? previous.at_right : previous.at_left;
    from.is_seam = true;
  }
  funnel_.reset(from.out, static_cast<std::size_t>(end - begin));
  for (Index i = begin; i < end; ++i) {
    UnfoldedCrossing& crossing = crossings_[i];
    bool new_left = true, new_right = true;
    if (i > 0) {
      const UnfoldedCrossing& before = i == begin ? previous : crossings_[i - 1];
      const PlanePoint apex = before.apex();
      const bool keeps_left = crossing.left == before.left;
      crossing.at_left = keeps_left ? before.at_left : apex;
      crossing.at_right = keeps_left ? apex : before.at_right;
      new_left = !keeps_left || i == begin;
      new_right = keeps_left || i == begin;
    }
    if (i >= to.first) continue;
    if (new_left) funnel_.add_left(crossing.at_left, i);
    if (new_right) funnel_.add_right(crossing.at_right, i);
  }
  if (to.vertex == no_index) {
    const UnfoldedCrossing& last = end > begin ? crossings_[end - 1] : previous;
    const PlanePoint apex = last.apex();
    const Index face = Mesh::face_of(last.entry);
    weights_in_face(mesh, target_, face, weights);
    to.in = {};
    for (int k = 0; k < 3; ++k) {
      const Index v = mesh.face_vertices(face)[k];
      const PlanePoint& at = v == last.left ? last.at_left : v == last.right ? last.at_right : apex;
      to.in[0] += weights[k] * at[0];
      to.in[1] += weights[k] * at[1];
    }
  } else {
    const UnfoldedCrossing& last = crossings_[to.last];
    to.in = to.left ? last.at_left : last.at_right;
    to.other_in = to.left ? last.at_right : last.at_left;
    to.is_seam = true;
  }
  for (const Funnel::Bend& bend : funnel_.finish(to.in)) {
    Joint joint;
    joint.left = bend.left;
    joint.vertex = bend.left ? crossings_[bend.gate].left : crossings_[bend.gate].right;
    find_range(bend.gate, joint);
    joint.last = std::min(joint.last, end - 1);
    const UnfoldedCrossing& last = crossings_[joint.last];
    joint.in = joint.out = bend.left ? last.at_left : last.at_right;
    joint.other_in = joint.other_out = bend.left ? last.at_right : last.at_left;
    next_joints_.push_back(joint);
  }
}

}  // namespace vorogeo
