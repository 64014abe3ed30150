// A line shortened until it is a geodesic, and how uneven the surface along it is.
#include "query/path_refine.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exact/surface_path.h"

namespace vorogeo {

// ---- Flipping strips around vertices

namespace {

constexpr double pi = std::numbers::pi;
/// Shortening by less than this (relative) is rounding.
constexpr double least_gain = 1e-13;
/// Most rounds of flips. Nearly every round shortens the line, and the number of strips is finite, but
/// rounding may cause cycles. Lines in meshes of a million vertices take some tens.
constexpr int max_rounds = 1000;
/// Turns of less than this in the wrong direction are rounding.
constexpr double least_turn = 1e-12;
/// Vertices tried on their other side, at most.
constexpr int max_trials = 64;

double length_of(const PlanePoint& vector) {
  return std::sqrt(vector[0] * vector[0] + vector[1] * vector[1]);
}

}  // namespace

/// One round: moves the strip to the other side of all bends where the angle there is below pi, and releases
/// those that are no longer bends. \return whether anything changed.
bool PathRefiner::flip_bends() {
  const auto& joints = line_.joints();
  changes_.assign(joints.size(), PathLine::Change::keep);
  bool any = false;
  for (std::size_t k = 1; k + 1 < joints.size(); ++k) {
    const Joint& joint = joints[k];
    if (joint.settled) continue;
    const double turn = line_.turn(k);
    if (joint.is_seam && turn < -least_turn && turn > -0.5 * pi) {
      changes_[k] = PathLine::Change::release;
    } else if (mesh_.fan(joint.vertex) == Mesh::Fan::closed &&
               mesh_.total_angle(joint.vertex) - pi - std::abs(turn) < pi) {
      changes_[k] = PathLine::Change::flip;
    } else {
      line_.settle(k);
      continue;
    }
    any = true;
  }
  return any && (line_.change(changes_) > 0 || std::ranges::any_of(joints, [](const Joint& joint) {
                   return joint.vertex != no_index && !joint.settled;
                 }));
}

void PathRefiner::straighten() {
  double length = line_.length();
  int without_gain = 0;
  for (int round = 0; round < max_rounds && flip_bends(); ++round) {
    // A round may gain nothing where several vertices lie on the line; then a few more rounds are allowed.
    const double now = line_.length();
    without_gain = now < length * (1.0 - least_gain) ? 0 : without_gain + 1;
    if (without_gain > 8) return;
    length = std::min(length, now);
  }
}

/// Collects the vertices of positive curvature near a piece of the line at which its ends subtend a smaller
/// angle on the far side.
void PathRefiner::look_beside(std::size_t piece) {
  const Joint& from = line_.joints()[piece];
  const Joint& to = line_.joints()[piece + 1];
  const PlanePoint& a = from.out;
  const PlanePoint& b = to.in;
  const auto& crossings = line_.crossings();
  const Index end = std::min(to.last + 1, static_cast<Index>(crossings.size()));
  for (Index i = from.last + 1; i < end; ++i) {
    for (const bool left : {true, false}) {
      const Index v = left ? crossings[i].left : crossings[i].right;
      if (i > 0 && v == (left ? crossings[i - 1].left : crossings[i - 1].right)) continue;
      const double total = mesh_.total_angle(v);
      if (total >= 2.0 * pi) continue;
      const PlanePoint& at = left ? crossings[i].at_left : crossings[i].at_right;
      const PlanePoint to_a{a[0] - at[0], a[1] - at[1]};
      const PlanePoint to_b{b[0] - at[0], b[1] - at[1]};
      const double across = std::abs(to_a[0] * to_b[1] - to_a[1] * to_b[0]);
      const double along = to_a[0] * to_b[0] + to_a[1] * to_b[1];
      // The angle on this side must be more than half of the total; the tangent of a small angle is less than
      // twice the angle.
      const double missing = 2.0 * pi - total;
      if (missing < 1.0 && !(across < -along * missing)) continue;
      const double here = std::atan2(across, along);
      const double there = total - here;
      if (there >= here || mesh_.fan(v) != Mesh::Fan::closed) continue;
      const double distance_a = length_of(to_a);
      const double distance_b = length_of(to_b);
      auto third_side = [&](double angle) {
        const double s = std::sin(0.5 * angle);
        const double difference = distance_a - distance_b;
        return std::sqrt(difference * difference + 4.0 * distance_a * distance_b * s * s);
      };
      const double gain = third_side(here) - third_side(there);
      if (gain < 1e-9 * line_.length()) continue;
      if (std::ranges::find(tried_, v) != tried_.end()) continue;
      Joint beside;
      beside.vertex = v;
      beside.left = left;
      line_.find_range(i, beside);
      candidates_.push_back({gain, piece, beside});
    }
  }
}

bool PathRefiner::try_other_sides() {
  candidates_.clear();
  for (std::size_t piece = 0; piece + 1 < line_.joints().size(); ++piece) look_beside(piece);
  if (candidates_.empty()) return false;
  std::ranges::sort(candidates_, [](const Candidate& a, const Candidate& b) { return a.gain > b.gain; });
  const double length = line_.length();
  shortest_.assign(line_);
  for (const Candidate& candidate : candidates_) {
    if (static_cast<int>(tried_.size()) >= max_trials) break;
    tried_.push_back(candidate.beside.vertex);
    if (line_.flip_beside(candidate.piece, candidate.beside)) {
      straighten();
      if (line_.length() < length * (1.0 - least_gain)) return true;
    }
    line_.assign(shortest_);
  }
  return false;
}

double PathRefiner::tighten(const FaceStrip& strip) {
  line_.assign(strip);
  straighten();
  return line_.length();
}

double PathRefiner::refine(const FaceStrip& strip) {
  tried_.clear();
  tighten(strip);
  // This loop ends: each round tries at least one more vertex, and at most max_trials are tried.
  while (try_other_sides()) {
  }
  return line_.length();
}

SurfacePath PathRefiner::path() const {
  SurfacePath path;
  path.points.reserve(line_.crossings().size() + 2);
  path.points.push_back(line_.source());
  path.length = line_.length();
  const auto& joints = line_.joints();
  constexpr double at_end = 1e-12;
  auto add_vertex = [&](Index vertex) {
    const SurfacePoint& last = path.points.back();
    if (!last.is_vertex() || last.vertex != vertex) path.points.push_back(SurfacePoint::at_vertex(vertex));
  };
  for (std::size_t piece = 0; piece + 1 < joints.size(); ++piece) {
    const PlanePoint& a = joints[piece].out;
    const PlanePoint& b = joints[piece + 1].in;
    const double dx = b[0] - a[0], dy = b[1] - a[1];
    for (Index i = joints[piece].last + 1; i < joints[piece + 1].first; ++i) {
      const UnfoldedCrossing& crossing = line_.crossings()[i];
      const double left = dx * (crossing.at_left[1] - a[1]) - dy * (crossing.at_left[0] - a[0]);
      const double right = dx * (crossing.at_right[1] - a[1]) - dy * (crossing.at_right[0] - a[0]);
      const double width = left - right;
      const double t = width > 0.0 ? std::clamp(left / width, 0.0, 1.0) : 0.5;  // from left to right
      if (t < at_end || t > 1.0 - at_end) {
        add_vertex(t < 0.5 ? crossing.left : crossing.right);
        continue;
      }
      const Index h = crossing.entry;
      std::array<double, 3> weights{};
      const bool left_is_tail = mesh_.tail(h) == crossing.left;
      weights[h % 3] = left_is_tail ? 1.0 - t : t;
      weights[Mesh::next_in_face(h) % 3] = left_is_tail ? t : 1.0 - t;
      path.points.push_back(SurfacePoint::in_face(Mesh::face_of(h), weights));
    }
    if (joints[piece + 1].vertex != no_index) add_vertex(joints[piece + 1].vertex);
  }
  const SurfacePoint& target = line_.target();
  const SurfacePoint& last = path.points.back();
  const bool same_vertex = last.is_vertex() && target.is_vertex() && last.vertex == target.vertex;
  if (!same_vertex || path.points.size() == 1) path.points.push_back(target);
  // The points are right even where unfolding has lost the length.
  if (line_.is_rough()) path.length = measured_length(mesh_, path.points).length;
  return path;
}

// ---- The surface along a path

double roughness(const Mesh& mesh, const PathLine& line) {
  constexpr double crease_angle = 0.2;  // creases of a shape say nothing about the roughness of its faces
  double sum = 0.0;
  for (const UnfoldedCrossing& crossing : line.crossings()) {
    for (const Index vertex : {crossing.left, crossing.right}) {
      if (mesh.fan(vertex) != Mesh::Fan::closed) continue;
      sum += std::min(crease_angle, std::abs(2.0 * std::numbers::pi - mesh.total_angle(vertex)));
    }
  }
  return line.crossings().empty() ? 0.0 : 0.5 * sum / static_cast<double>(line.crossings().size());
}

}  // namespace vorogeo
