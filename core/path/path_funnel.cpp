// The funnel as a double-ended queue.
#include "path/path_funnel.h"

#include <algorithm>

namespace vorogeo {

namespace {

double cross(const PlanePoint& origin, const PlanePoint& a, const PlanePoint& b) {
  return (a[0] - origin[0]) * (b[1] - origin[1]) - (a[1] - origin[1]) * (b[0] - origin[0]);
}

}  // namespace

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
      if (cross(slot[head + 1].at, slot[head].at, point) > 0.0) break;
      ++head;
    } else {
      if (cross(slot[head].at, slot[head + 1].at, point) >= 0.0) break;
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
      if (cross(slot[tail - 1].at, slot[tail].at, point) < 0.0) break;
      --tail;
    } else {
      if (cross(slot[tail].at, slot[tail - 1].at, point) <= 0.0) break;
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

}  // namespace vorogeo
