// The nearest points of the surface to points in space, and where rays meet it, by a tree of boxes.
#pragma once

#include <algorithm>
#include <memory>
#include <utility>
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

/// A tree of boxes, each split at the median of its longest side. It holds the order of the items, not the
/// items: the caller measures the distances of boxes. Items are named by their indices. Immutable.
class BoxTree {
 public:
  struct SkipNone {
    bool operator()(Index) const { return false; }
  };

  explicit BoxTree(const std::vector<Box>& items);

  /// The box around all items. \pre There is an item.
  const Box& bounds() const { return nodes_.front().bounds; }
  std::size_t memory_bytes() const {
    return order_.capacity() * sizeof(Index) + nodes_.capacity() * sizeof(Node);
  }

  /// Calls visit(item) for the items of the leaves whose boxes are within reach, nearer halves first. The
  /// reach is `reach` at first, then what visit last returned; below 0 ends the search. distance(box) may be
  /// in any measure. Nodes for which skip(node) holds are passed over.
  template <class Distance, class Visit, class Skip = SkipNone>
  void search(double reach, Distance&& distance, Visit&& visit, const Skip& skip = {}) const {
    if (order_.empty()) return;
    std::vector<Open> open{{distance(bounds()), 0}};
    while (!open.empty()) {
      const auto [apart, id] = open.back();
      open.pop_back();
      if (!(apart <= reach) || skip(id)) continue;
      const Node& node = nodes_[id];
      if (node.second == no_index) {
        for (Index i = node.begin; i < node.end; ++i) reach = visit(order_[i]);
        continue;
      }
      Open first{distance(nodes_[id + 1].bounds), id + 1};
      Open second{distance(nodes_[node.second].bounds), node.second};
      if (first.apart < second.apart) std::swap(first, second);
      open.push_back(first);
      open.push_back(second);
    }
  }

  /// The same with distances of boxes in space: calls visit(item) for items whose box, box_of(item), is
  /// within reach of the box `around`, at most `max_visits` times.
  template <class BoxOf, class Visit, class Skip = SkipNone>
  void visit_near(const Box& around, double reach, int max_visits, BoxOf&& box_of, Visit&& visit,
                  const Skip& skip = {}) const {
    auto look_at = [&](Index item) {
      if (box_of(item).distance(around) <= reach) reach = max_visits-- > 0 ? visit(item) : -1.0;
      return reach;
    };
    search(
        reach, [&](const Box& box) { return box.distance(around); }, look_at, skip);
  }

  /// For each node, the label that all items in it have; no_index where they differ.
  void common_labels(const std::vector<Index>& label_of_item, std::vector<Index>& label) const;

 private:
  struct Node {
    Box bounds;
    Index begin;
    Index end;
    Index second = no_index;  ///< node of the second half; that of the first follows its parent; no_index: a
                              ///< leaf
  };
  struct Open {
    double apart;
    Index node;
  };

  Index build(const std::vector<Box>& items, Index begin, Index end);

  std::vector<Index> order_;
  std::vector<Node> nodes_;
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

  /// The nearest point of the surface without bridges over gaps, moved to a vertex or an edge that it misses
  /// only by rounding; for a distant point, one whose distance exceeds the least only by rounding. Of several
  /// faces equally near, the one with the lowest number: where sheets coincide (the two sides of a slit,
  /// doubled vertices), all points there are moved to the same sheet, and the other can only be named by
  /// vertex or face numbers. \throw InvalidInput for a coordinate that is not finite or above 1e307; names
  /// the point. Complexity: O(log m) for points near the surface.
  SnappedPoint nearest(const Point& point) const;
  /// How far a ray from a point of the surface, in a direction of length 1, runs to the first face that does
  /// not hold the point; `unreachable` if it meets none. Complexity: O(log m) for most rays.
  double ray_length(const SurfacePoint& from, const Point& direction) const;
  std::size_t memory_bytes() const { return tree_.memory_bytes(); }

 private:
  /// A point from which the same point of the surface is nearest, and whose squared distances do not
  /// overflow.
  Point drawn_near(const Point& point) const;

  std::shared_ptr<const Mesh> mesh_;
  BoxTree tree_;
};

}  // namespace vorogeo
