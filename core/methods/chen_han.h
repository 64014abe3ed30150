// The window tree of Chen and Han, with the filter of Xin and Wang.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "exact/exact_geometry.h"

namespace vorogeo {

/// What a run of a WindowTree does.
struct TreeRules {
  bool ordered = true;   ///< the nearest window first (Xin, Wang 2009, section 3.1); else in order of arrival
  bool filtered = true;  ///< windows that a vertex overtakes as a whole are dropped (section 3.2)
  bool bends = true;  ///< paths go on from saddle vertices; else geodesics from the sources alone are found
  /// The run ends when so many vertices beside the sources are final.
  Index max_vertices = std::numeric_limits<Index>::max();
  /// Above 0: windows and vertices are left out where a detour over a vertex beside them is good enough for
  /// this expected relative error (graph_methods.cpp).
  double epsilon = 0.0;
};

/// Keeps its memory between runs; one object belongs to one thread. A run touches only what it reaches.
class WindowTree {
 public:
  explicit WindowTree(std::shared_ptr<const ExactGeometry> geometry);

  /// \throw Cancelled at a checkpoint.
  void run(std::span<const Index> sources, const TreeRules& rules);

  double distance(Index vertex) const { return distance_[vertex]; }
  /// Vertices in the order in which they were settled, the sources among them.
  std::span<const Index> settled() const { return settled_; }
  /// Whether the path to a vertex has no detour over a vertex beside it that is good enough (with epsilon).
  bool is_needed(Index vertex) const { return needed_[vertex] != 0; }
  std::size_t window_count() const { return made_; }
  std::size_t bytes() const;

 private:
  /// A window: the part [begin, end] of the edge of a half-edge, whose face is entered next. Positions along
  /// the edge count from the half-edge's tail; the pseudo-source lies at `x`, and `y` away on the other side.
  struct TreeWindow {
    double begin, end;
    double x, y;
    double offset;                        ///< of the pseudo-source
    double begin_critical, end_critical;  ///< distances of the vertices that bound it, along its end rays
    double greatest;                      ///< beyond this distance, detours over these are good enough
    Index halfedge;
    Index root;
    Index level;
    /// The last half-edge at which an ancestor was split at the ray to the apex; on which side of the ray
    /// this window lies, where the ray crosses the edge, and the distance of the apex along it.
    Index split_at;
    bool split_left;
    /// Whether an edge of more than two faces lies between its root and its edge, or is that edge.
    bool branched;
    double split_entry, split_distance;
  };
  struct Event {
    double key;
    Index item;  ///< a window of the pool, or ~vertex
    bool operator>(const Event& other) const { return key > other.key; }
  };

  void reset();
  void push(double key, Index item);
  void reach(Index vertex, double distance);
  void emit(Index vertex);
  void cross(const TreeWindow& window);
  bool keeps_side(Index halfedge, bool left, double entry) const;
  bool is_trimmed(const TreeWindow& window) const;
  void hand_on(const TreeWindow& window, bool left, double entry, bool to_apex, double apex_distance);
  void add(const TreeWindow& window, Index side, Index origin);
  bool is_overtaken(const TreeWindow& window, double whole, const std::array<Index, 3>& corners,
                    double to_third) const;
  double greatest_distance(const TreeWindow& window) const;
  bool has_detour(const TreeWindow& window, double apex_x, double apex_y, double direct) const;
  double length(Index halfedge) const { return mesh_.edge_length(mesh_.edge_of(halfedge)); }
  double apex_x(Index halfedge) const {
    const FaceFrame& frame = geometry_->frame[halfedge];
    return frame.along ? frame.apex_x : geometry_->apex_from_second(halfedge);
  }

  std::shared_ptr<const ExactGeometry> geometry_;
  const Mesh& mesh_;
  TreeRules rules_;
  std::vector<double> distance_;
  std::vector<std::uint8_t> is_source_;
  std::vector<std::uint8_t> is_settled_;
  std::vector<std::uint8_t> needed_;
  std::vector<Index> touched_;
  /// By half-edge: the least distance of the apex through it, and where that path crosses the edge.
  std::vector<double> apex_distance_;
  std::vector<double> apex_entry_;
  std::vector<Index> touched_halfedges_;
  std::vector<Index> settled_;
  std::vector<TreeWindow> pool_;
  std::vector<Index> free_;
  std::vector<Event> ordered_;  ///< a heap
  std::deque<Event> arrived_;
  std::size_t made_ = 0;
};

}  // namespace vorogeo
