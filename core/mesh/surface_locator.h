// The nearest points of the surface to points in space, by a tree of boxes.
#pragma once

#include <algorithm>
#include <memory>
#include <numeric>
#include <vector>

#include "mesh/mesh.h"
#include "mesh/surface_point.h"

namespace vorogeo {

// ---- A tree of boxes over things in space: those near a box are found without looking at all of them

/// A box with sides along the axes.
struct Box {
  Point low;
  Point high;

  void add(const Box& other) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], other.low[k]);
      high[k] = std::max(high[k], other.high[k]);
    }
  }
  /// The distance of two boxes; 0 if they overlap.
  double distance(const Box& other) const {
    Point apart{};
    for (int k = 0; k < 3; ++k) apart[k] = std::max({0.0, low[k] - other.high[k], other.low[k] - high[k]});
    return std::hypot(apart[0], apart[1], apart[2]);
  }
};

/// Boxes that are split at the median of their longest side. Items are named by their places in the list.
class BoxTree {
 public:
  explicit BoxTree(std::vector<Box> items) : items_(std::move(items)), order_(items_.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    if (!order_.empty()) build(0, static_cast<Index>(order_.size()));
  }

  /// Calls visit(item) for the items within a distance of a box, nearer halves first: `reach` at first, then
  /// what visit last returned. Stops after `max_visits` calls. Boxes for which skip(node) holds are passed
  /// over.
  template <class Visit, class Skip>
  void visit_near(const Box& around, double reach, int max_visits, Visit&& visit, Skip&& skip) const {
    if (order_.empty()) return;
    std::vector<Open> open{{boxes_[0].bounds.distance(around), 0}};
    while (!open.empty()) {
      const auto [distance, id] = open.back();
      open.pop_back();
      if (!(distance <= reach) || skip(id)) continue;
      const Node& node = boxes_[id];
      if (node.second != no_index) {
        Open first{boxes_[id + 1].bounds.distance(around), id + 1};
        Open second{boxes_[node.second].bounds.distance(around), node.second};
        if (first.distance < second.distance) std::swap(first, second);
        open.push_back(first);
        open.push_back(second);
        continue;
      }
      for (Index i = node.begin; i < node.end; ++i) {
        if (!(items_[order_[i]].distance(around) <= reach)) continue;
        if (max_visits-- == 0) return;
        reach = visit(order_[i]);
      }
    }
  }

  /// For each node, the label that all items in it have; no_index where they differ.
  void common_labels(const std::vector<Index>& label_of_item, std::vector<Index>& label) const {
    label.resize(boxes_.size());
    for (auto id = static_cast<Index>(boxes_.size()) - 1; id >= 0; --id) {
      const Node& node = boxes_[id];
      if (node.second != no_index) {
        label[id] = label[id + 1] == label[node.second] ? label[id + 1] : no_index;
        continue;
      }
      label[id] = label_of_item[order_[node.begin]];
      for (Index i = node.begin; i < node.end; ++i) {
        if (label_of_item[order_[i]] != label[id]) label[id] = no_index;
      }
    }
  }

 private:
  struct Node {
    Box bounds;
    Index begin;
    Index end;
    Index second = no_index;  ///< node of the second half; that of the first follows its parent; no_index: a
                              ///< leaf
  };
  struct Open {
    double distance;
    Index node;
  };

  Index build(Index begin, Index end) {
    constexpr Index max_in_leaf = 8;
    const auto id = static_cast<Index>(boxes_.size());
    Node node{items_[order_[begin]], begin, end};
    for (Index i = begin; i < end; ++i) node.bounds.add(items_[order_[i]]);
    boxes_.push_back(node);
    if (end - begin <= max_in_leaf) return id;
    const auto& [low, high] = node.bounds;
    int axis = 0;
    for (int k = 1; k < 3; ++k) {
      if (high[k] - low[k] > high[axis] - low[axis]) axis = k;
    }
    const Index middle = begin + (end - begin) / 2;
    const auto place = [&](Index item) { return items_[item].low[axis] + items_[item].high[axis]; };
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](Index u, Index v) { return place(u) < place(v); });
    build(begin, middle);
    const Index second = build(middle, end);
    boxes_[id].second = second;
    return id;
  }

  std::vector<Box> items_;
  std::vector<Index> order_;
  std::vector<Node> boxes_;
};

// ---- The point of a surface nearest to a point in space

/// Weights of the corners a, b, c in the point of their triangle that is nearest to p.
std::array<double, 3> nearest_weights(const Point& p, const Point& a, const Point& b, const Point& c);

/// A surface point and how far it is from the point it was found for.
struct SnappedPoint {
  SurfacePoint point;
  double distance = 0.0;
};

/// A tree of boxes over the faces. Immutable; may be shared by threads. It is our own, as VCG's grids need a
/// VCG mesh, which the core and the Python package do not have.
class SurfaceLocator {
 public:
  /// \throw InvalidInput for a mesh without faces. Complexity: O(m log m).
  explicit SurfaceLocator(std::shared_ptr<const Mesh> mesh);

  /// The nearest point of the surface, which is not on a bridge over a gap, moved to a vertex or an edge if
  /// it differs from it only by rounding; for a distant point, one whose distance differs from the least only
  /// by rounding. Of several faces equally near, the one with the lowest number: where sheets coincide (the
  /// two sides of a slit, doubled vertices), all points there are moved to the same sheet, and the other can
  /// only be named by vertex or face numbers. \throw InvalidInput for a coordinate that is not finite or
  /// above 1e307; names the point. Complexity: O(log m) for points near the surface.
  SnappedPoint nearest(const Point& point) const;
  std::size_t memory_bytes() const {
    return order_.capacity() * sizeof(Index) + boxes_.capacity() * sizeof(Box);
  }

 private:
  struct Box {
    Point low;
    Point high;
    Index begin;  ///< into order_
    Index end;
    Index second = no_index;  ///< box of the second half; the first half's follows this one; no_index: a leaf
  };
  Index build(Index begin, Index end);
  /// A point from which the same point of the surface is nearest, and whose squared distances do not
  /// overflow.
  Point drawn_near(const Point& point) const;

  std::shared_ptr<const Mesh> mesh_;
  std::vector<Index> order_;
  std::vector<Box> boxes_;
};

}  // namespace vorogeo
