// A strip of faces, and the shortest line in it, which can be moved to the other side of vertices.
#include "query/path_line.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "exact/exact_geometry.h"
#include "support/progress.h"

namespace vorogeo {

// ---- Walks around vertices

namespace {

/// The half-edge of the face of `halfedge` that also ends in `vertex`, but is not `halfedge`.
Index other_halfedge_at(const Mesh& mesh, Index halfedge, Index vertex) {
  const Index next = Mesh::next_in_face(halfedge);
  const Index previous = Mesh::previous_in_face(halfedge);
  return mesh.tail(halfedge) == vertex ? previous : next;
}

/// Walks around a vertex from the face of `exit` across that half-edge, until `face` is entered, and adds the
/// crossings. \return the angle between the two faces; infinity if a border of the mesh or a non-manifold
/// edge is met.
double walk(const Mesh& mesh, Index vertex, Index exit, Index face, std::vector<HalfedgePair>& passed) {
  double angle = 0.0;
  const Index begin = Mesh::face_of(exit);
  // Each step enters the next face around the vertex: the walk ends at `face`, at a border of the mesh, or
  // where it began.
  for (;;) {
    const Index entry = mesh.next_around_edge(exit);
    if (entry == exit || mesh.next_around_edge(entry) != exit) return unreachable;
    passed.push_back({exit, entry});
    const Index at = Mesh::face_of(entry);
    if (at == face) return angle;
    if (at == begin) return unreachable;
    exit = other_halfedge_at(mesh, entry, vertex);
    angle += mesh.corner_angle(mesh.tail(entry) == vertex ? entry : exit);
  }
}

/// The path around a non-manifold vertex with the fewest faces, by breadth-first search over its corners.
/// Adds its crossings.
bool search(const Mesh& mesh, Index vertex, Index from, Index to, std::vector<HalfedgePair>& passed) {
  struct Visit {
    Index face;
    HalfedgePair by;
    std::size_t predecessor;
  };
  // Each face of the fan is visited once, and the faces around each edge are passed once.
  std::vector<Visit> visited{{from, {no_index, no_index}, 0}};
  std::unordered_set<Index> faces{from}, edges;
  for (std::size_t i = 0; i < visited.size(); ++i) {
    if (i % elements_per_checkpoint == 0) checkpoint();
    if (visited[i].face == to) {
      const auto old_size = static_cast<std::ptrdiff_t>(passed.size());
      for (std::size_t at = i; at != 0; at = visited[at].predecessor) passed.push_back(visited[at].by);
      std::reverse(passed.begin() + old_size, passed.end());
      return true;
    }
    for (int k = 0; k < 3; ++k) {
      const Index exit = 3 * visited[i].face + k;
      if (mesh.tail(exit) != vertex && mesh.head(exit) != vertex) continue;
      if (!edges.insert(mesh.edge_of(exit)).second) continue;
      for (Index entry = mesh.next_around_edge(exit); entry != exit; entry = mesh.next_around_edge(entry)) {
        const Index face = Mesh::face_of(entry);
        if (faces.insert(face).second) visited.push_back({face, {exit, entry}, i});
      }
    }
  }
  return false;
}

}  // namespace

bool turn_around(const Mesh& mesh, FaceStrip& strip, Index vertex, Index face) {
  const Index from = strip.last();
  if (from == face) return true;
  // Both ways round are added to the end of the strip; the longer one is removed again.
  auto& passed = strip.crossings;
  const std::size_t old_size = passed.size();
  double least = unreachable;
  for (int k = 0; k < 3 && mesh.fan(vertex) != Mesh::Fan::non_manifold; ++k) {
    const Index exit = 3 * from + k;
    if (mesh.tail(exit) != vertex && mesh.head(exit) != vertex) continue;
    const std::size_t middle = passed.size();
    const double angle = walk(mesh, vertex, exit, face, passed);
    if (angle < least) {
      least = angle;
      passed.erase(passed.begin() + static_cast<std::ptrdiff_t>(old_size),
                   passed.begin() + static_cast<std::ptrdiff_t>(middle));
    } else {
      passed.resize(middle);
    }
  }
  return least < unreachable || search(mesh, vertex, from, face, passed);
}

bool other_side(const Mesh& mesh, Index vertex, Index exit, Index face, std::vector<HalfedgePair>& passed) {
  if (mesh.fan(vertex) != Mesh::Fan::closed) return false;
  exit = other_halfedge_at(mesh, exit, vertex);
  // The fan is one cycle, so the walk comes to `face`.
  for (Index at = Mesh::face_of(exit); at != face;) {
    const Index entry = mesh.next_around_edge(exit);
    passed.push_back({exit, entry});
    at = Mesh::face_of(entry);
    exit = other_halfedge_at(mesh, entry, vertex);
  }
  return true;
}

// ---- The funnel as a double-ended queue

void Funnel::reset(const PlanePoint& point, std::size_t gates) {
  nodes_.clear();
  const std::size_t middle = gates + 2;
  if (funnel_.size() < 2 * middle + 1) funnel_.resize(2 * middle + 1);
  head_ = tail_ = apex_ = middle;
  nodes_.push_back({0, {no_index, true}});
  funnel_[middle] = {point, 0};
}

// Each point that the loops below pass leaves the funnel for good.

void Funnel::add_left(const PlanePoint& point, Index gate) {
  const Slot* slot = funnel_.data();
  std::size_t head = head_;
  while (head < tail_) {
    if (head < apex_) {
      if (turn_in_plane(slot[head + 1].at, slot[head].at, point) > 0.0) break;
      ++head;
    } else {
      if (turn_in_plane(slot[head].at, slot[head + 1].at, point) >= 0.0) break;
      ++head;
      apex_ = head;
    }
  }
  nodes_.push_back({slot[head].node, {gate, true}});
  head_ = head - 1;
  funnel_[head_] = {point, static_cast<std::uint32_t>(nodes_.size() - 1)};
}

void Funnel::add_right(const PlanePoint& point, Index gate) {
  const Slot* slot = funnel_.data();
  std::size_t tail = tail_;
  while (head_ < tail) {
    if (tail > apex_) {
      if (turn_in_plane(slot[tail - 1].at, slot[tail].at, point) < 0.0) break;
      --tail;
    } else {
      if (turn_in_plane(slot[tail].at, slot[tail - 1].at, point) <= 0.0) break;
      --tail;
      apex_ = tail;
    }
  }
  nodes_.push_back({slot[tail].node, {gate, false}});
  tail_ = tail + 1;
  funnel_[tail_] = {point, static_cast<std::uint32_t>(nodes_.size() - 1)};
}

const std::vector<Funnel::Bend>& Funnel::finish(const PlanePoint& point) {
  add_left(point, no_index);
  bends_.clear();
  for (std::uint32_t node = nodes_.back().parent; node != 0; node = nodes_[node].parent) {
    bends_.push_back(nodes_[node].bend);
  }
  std::ranges::reverse(bends_);
  return bends_;
}

// ---- Unfolding, and pulling tight between joints

namespace {

/// The shortest of the edges crossed and the line must be at least this fraction of the longest: then ten
/// digits of the line's length remain.
constexpr double least_scale = 1e-6;

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
  first_face_ = strip.first;
  shortest_crossed_ = unreachable;
  longest_crossed_ = 0.0;
  next_.clear();
  fixed_ = 0;
  for (const HalfedgePair& crossing : strip.crossings) {
    // Corners are counterclockwise in the plane: leaving across a half-edge, its head is on the left.
    Index left = mesh.head(crossing.exit);
    Index right = mesh.tail(crossing.exit);
    if (!next_.empty() && (left == next_.back().right || right == next_.back().left)) std::swap(left, right);
    push(crossing_at(crossing.exit, crossing.entry, left, right));
  }
  trim_ends();
  std::swap(crossings_, next_);
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

std::vector<Index> PathLine::faces() const {
  std::vector<Index> faces{first_face_};
  for (const UnfoldedCrossing& crossing : crossings_) faces.push_back(Mesh::face_of(crossing.entry));
  return faces;
}

double PathLine::length() const {
  double length = 0.0;
  for (std::size_t k = 0; k + 1 < joints_.size(); ++k) {
    length += straight_in_plane(joints_[k].out, joints_[k + 1].in);
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
    FacePlane plane(*geometry_, first_face_);
    // Left and right are as seen from the face in which the strip began before it was trimmed; the present
    // first face may face the other way.
    if (!crossings_.empty() && mesh.head(crossings_[0].exit) != crossings_[0].left) {
      for (PlanePoint& corner : plane.corner) corner[1] = -corner[1];
    }
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

// ---- Changes of a line: strips moved to the other side of vertices, and the parts that stay

/// Adds a crossing to the strip being made, and removes detours: a face that is left and entered again at
/// once. Calls itself only after removing a crossing, so no more often than there are crossings.
void PathLine::push(const UnfoldedCrossing& crossing) {
  if (!next_.empty()) {
    const bool turns = next_.back().entry == crossing.exit;
    const bool returns = Mesh::face_of(next_.back().exit) == Mesh::face_of(crossing.entry);
    if (turns || returns) {
      const UnfoldedCrossing last = next_.back();
      next_.pop_back();
      disturbed_ |= size_of(next_) < fixed_;
      if (returns) return;
      // The face was left by the edge by which it was entered, to a third face of that edge: go straight
      // there.
      push(crossing_at(last.exit, crossing.entry, last.left, last.right));
      return;
    }
  }
  next_.push_back(crossing);
}

void PathLine::copy(Index begin, Index end) {
  for (; begin < end; ++begin) {
    const Index old_size = size_of(next_);
    push(crossings_[begin]);
    if (size_of(next_) > old_size) {
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

/// Removes the faces at the ends of the new strip that the end points do not need. \return how many at its
/// beginning.
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

/// Releases joints whose crossings overlap those that change.
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

/// Updates a joint that stays after rebuild(), as it may have more crossings.
void PathLine::extend(Joint& joint) {
  const Index old_last = joint.last;
  find_range(old_last, joint);
  for (Index i = old_last + 1; i <= joint.last; ++i) {
    UnfoldedCrossing& crossing = crossings_[i];
    const UnfoldedCrossing& previous = crossings_[i - 1];
    const PlanePoint apex = previous.apex();
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
