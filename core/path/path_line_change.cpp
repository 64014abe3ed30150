// Changes of a line: strips moved to the other side of vertices, and the parts that stay.
#include <algorithm>

#include "path/path_line.h"

namespace vorogeo {

/// Adds a crossing to the strip being made, without detours: a face left and entered again at once. Calls
/// itself only after removing a crossing, so no more often than there are crossings.
void PathLine::push(const UnfoldedCrossing& crossing) {
  if (!next_.empty()) {
    const UnfoldedCrossing last = next_.back();
    const bool turns = last.entry == crossing.exit;
    const bool returns = Mesh::face_of(last.exit) == Mesh::face_of(crossing.entry);
    if (turns || returns) {
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
