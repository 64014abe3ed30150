// The funnel as a double-ended queue.
#include "query/path_funnel.h"

#include <algorithm>

namespace vorogeo {

namespace {

double cross(const PlanePoint& origin, const PlanePoint& a, const PlanePoint& b) {
  return (a[0] - origin[0]) * (b[1] - origin[1]) - (a[1] - origin[1]) * (b[0] - origin[0]);
}

}  // namespace

void Funnel::start(const PlanePoint& point, std::size_t gates) {
  nodes_.clear();
  const std::size_t middle = gates + 2;
  if (funnel_.size() < 2 * middle + 1) funnel_.resize(2 * middle + 1);
  head_ = tail_ = apex_ = middle;
  nodes_.push_back({point, 0, {no_index, true}});
  funnel_[middle] = 0;
}

void Funnel::add_left(const PlanePoint& point, Index gate) {
  auto at = [&](std::size_t slot) -> const PlanePoint& { return nodes_[funnel_[slot]].at; };
  while (head_ < tail_) {
    if (head_ < apex_) {
      if (cross(at(head_ + 1), at(head_), point) > 0.0) break;
      ++head_;
    } else {
      if (cross(at(head_), at(head_ + 1), point) >= 0.0) break;
      ++head_;
      apex_ = head_;
    }
  }
  nodes_.push_back({point, funnel_[head_], {gate, true}});
  funnel_[--head_] = static_cast<std::uint32_t>(nodes_.size() - 1);
}

void Funnel::add_right(const PlanePoint& point, Index gate) {
  auto at = [&](std::size_t slot) -> const PlanePoint& { return nodes_[funnel_[slot]].at; };
  while (head_ < tail_) {
    if (tail_ > apex_) {
      if (cross(at(tail_ - 1), at(tail_), point) < 0.0) break;
      --tail_;
    } else {
      if (cross(at(tail_), at(tail_ - 1), point) <= 0.0) break;
      --tail_;
      apex_ = tail_;
    }
  }
  nodes_.push_back({point, funnel_[tail_], {gate, false}});
  funnel_[++tail_] = static_cast<std::uint32_t>(nodes_.size() - 1);
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
