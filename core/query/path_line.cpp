// Unfolding, flipping and pulling tight between joints.
#include "query/path_line.h"

#include <algorithm>
#include <cmath>

#include "exact/solver_state.h"

namespace vorogeo {

namespace {

Index size_of(const std::vector<UnfoldedCrossing>& crossings) { return static_cast<Index>(crossings.size()); }

/// Third corner of the face behind a crossing.
PlanePoint apex_of(const UnfoldedCrossing& crossing) {
  const double ux = crossing.at_right[0] - crossing.at_left[0];
  const double uy = crossing.at_right[1] - crossing.at_left[1];
  return {crossing.at_left[0] + ux * crossing.along - uy * crossing.aside,
          crossing.at_left[1] + uy * crossing.along + ux * crossing.aside};
}

double distance_between(const PlanePoint& a, const PlanePoint& b) {
  const double dx = a[0] - b[0], dy = a[1] - b[1];
  return std::sqrt(dx * dx + dy * dy);
}

}  // namespace

UnfoldedCrossing PathLine::crossing_at(Index exit, Index entry, Index left, Index right) const {
  const Mesh& mesh = *geometry_->mesh;
  const FaceFrame& frame = geometry_->frame[entry];
  const double length = mesh.edge_length(mesh.edge_of(entry));
  UnfoldedCrossing crossing{exit, entry, left, right, 0.0, 0.0, {}, {}};
  if (!(length > 0.0)) return crossing;
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
  crossings_.clear();
  for (std::size_t i = 0; i < strip.entry.size(); ++i) {
    // The plane has the corners counterclockwise: who leaves across a half-edge sees its head on the left.
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
    // From the plane behind into the plane before, by the direction of the edge known in both.
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

/// Unfolds what lies between two joints and adds the bends found to next_joints_.
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
  unfolded_ += static_cast<std::size_t>(end - begin);
  funnel_.start(from.out, static_cast<std::size_t>(end - begin));
  for (Index i = begin; i < end; ++i) {
    UnfoldedCrossing& crossing = crossings_[i];
    bool new_left = true, new_right = true;
    if (i > 0) {
      const UnfoldedCrossing& before = i == begin ? previous : crossings_[i - 1];
      const PlanePoint apex = apex_of(before);
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
    const PlanePoint apex = apex_of(last);
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

/// Adds a crossing to the strip being made, without detours: a face left and entered again at once.
void PathLine::push(const UnfoldedCrossing& crossing) {
  if (!next_.empty()) {
    const UnfoldedCrossing last = next_.back();
    const bool turns = last.entry == crossing.exit;
    const bool returns = Mesh::face_of(last.exit) == Mesh::face_of(crossing.entry);
    if (turns || returns) {
      next_.pop_back();
      disturbed_ |= size_of(next_) < fixed_;
      if (returns) return;
      // Left by the edge it was entered by, to a third face of that edge: straight there.
      push(crossing_at(last.exit, crossing.entry, last.left, last.right));
      return;
    }
  }
  next_.push_back(crossing);
}

void PathLine::copy(Index begin, Index end) {
  for (; begin < end; ++begin) {
    const Index before = size_of(next_);
    push(crossings_[begin]);
    if (size_of(next_) > before) {
      next_.insert(next_.end(), crossings_.begin() + begin + 1, crossings_.begin() + end);
      return;
    }
  }
}

bool PathLine::push_other_side(const Joint& joint) {
  const Mesh& mesh = *geometry_->mesh;
  const UnfoldedCrossing& first = crossings_[joint.first];
  passed_.clear();
  if (!other_side(mesh, joint.vertex, first.exit, Mesh::face_of(crossings_[joint.last].entry), passed_)) {
    return false;
  }
  for (const HalfedgePair& pair : passed_) {
    const Index other = mesh.tail(pair.exit) == joint.vertex ? mesh.head(pair.exit) : mesh.tail(pair.exit);
    push(crossing_at(pair.exit, pair.entry, joint.left ? other : joint.vertex,
                     joint.left ? joint.vertex : other));
  }
  return true;
}

/// Takes out the faces at the ends of the strip being made that the end points do not need. \return how many
/// at its beginning.
Index PathLine::trim_ends() {
  const Mesh& mesh = *geometry_->mesh;
  std::array<double, 3> weights{};
  Index cut = 0;
  while (cut < size_of(next_) && weights_in_face(mesh, source_, Mesh::face_of(next_[cut].entry), weights)) {
    first_face_ = Mesh::face_of(next_[cut++].entry);
  }
  next_.erase(next_.begin(), next_.begin() + cut);
  while (!next_.empty() && weights_in_face(mesh, target_, Mesh::face_of(next_.back().exit), weights)) {
    next_.pop_back();
  }
  return cut;
}

/// A joint stays only if its crossings are apart from those that change.
void PathLine::release_neighbours(std::vector<Change>& changes) const {
  auto release = [&](std::size_t k) {
    if (changes[k] == Change::keep) changes[k] = Change::release;
  };
  const std::size_t last = joints_.size() - 1;
  for (std::size_t k = 1; k < last; ++k) {
    if (changes[k] != Change::flip) continue;
    if (k > 1 && joints_[k - 1].last >= joints_[k].first) release(k - 1);
    if (k + 1 < last && joints_[k + 1].first <= joints_[k].last) release(k + 1);
  }
  for (std::size_t k = last - 1; k > 0; --k) {
    if (changes[k + 1] != Change::keep && joints_[k].last >= joints_[k + 1].first) release(k);
  }
}

/// Makes the new strip; joints that stay get the number of their last crossing in it. \return flips done.
int PathLine::rebuild(std::vector<Change>& changes) {
  const std::size_t last = joints_.size() - 1;
  int flips = 0;
  Index copied = 0;  // crossings before this one are in next_
  next_.clear();
  fixed_ = 0;
  disturbed_ = false;
  for (std::size_t k = 1; k < last; ++k) {
    Joint& joint = joints_[k];
    if (changes[k] != Change::release && joint.first < copied) changes[k] = Change::release;
    if (changes[k] == Change::release) continue;
    copy(copied, joint.first);
    copied = joint.first;
    if (changes[k] == Change::flip) {
      if (!push_other_side(joint)) continue;
      copied = joint.last + 1;
      ++flips;
      continue;
    }
    copy(copied, joint.last + 1);
    copied = joint.last + 1;
    disturbed_ |= next_.empty() || next_.back().entry != crossings_[joint.last].entry;
    joint.last = size_of(next_) - 1;
    fixed_ = size_of(next_);
  }
  copy(copied, size_of(crossings_));
  const Index cut = trim_ends();
  for (std::size_t k = 1; k < last; ++k) {
    if (changes[k] != Change::keep) continue;
    joints_[k].last -= cut;
    disturbed_ |= joints_[k].last < 0 || joints_[k].last >= size_of(next_);
  }
  std::swap(crossings_, next_);
  joints_[last].first = joints_[last].last = size_of(crossings_);
  return flips;
}

/// A joint that stays after rebuild(): its crossings may have become more.
void PathLine::extend(Joint& joint) {
  const Index before = joint.last;
  find_range(before, joint);
  for (Index i = before + 1; i <= joint.last; ++i) {
    UnfoldedCrossing& crossing = crossings_[i];
    const UnfoldedCrossing& previous = crossings_[i - 1];
    const PlanePoint apex = apex_of(previous);
    crossing.at_left = joint.left ? previous.at_left : apex;
    crossing.at_right = joint.left ? apex : previous.at_right;
    joint.other_in = apex;
  }
}

int PathLine::change(std::vector<Change>& changes) {
  release_neighbours(changes);
  const int flips = rebuild(changes);
  const std::size_t last = joints_.size() - 1;
  Index end = -1;
  for (std::size_t k = 1; k < last && !disturbed_; ++k) {
    if (changes[k] != Change::keep) continue;
    extend(joints_[k]);
    disturbed_ = joints_[k].last <= end;
    end = joints_[k].last;
  }
  if (disturbed_) std::fill(changes.begin() + 1, changes.end() - 1, Change::release);
  next_joints_.assign(1, joints_.front());
  bool changed = false;
  for (std::size_t k = 1; k <= last; ++k) {
    if (changes[k] != Change::keep) {
      changed = true;
      continue;
    }
    if (changed) {
      next_joints_.back().settled = joints_[k].settled = false;
      pull(next_joints_.back(), joints_[k]);
    }
    changed = false;
    next_joints_.push_back(joints_[k]);
  }
  std::swap(joints_, next_joints_);
  return flips;
}

bool PathLine::flip_beside(std::size_t piece, const Joint& beside) {
  joints_.insert(joints_.begin() + static_cast<std::ptrdiff_t>(piece) + 1, beside);
  std::vector<Change> changes(joints_.size(), Change::keep);
  changes[piece + 1] = Change::flip;
  return change(changes) > 0;
}

}  // namespace vorogeo
