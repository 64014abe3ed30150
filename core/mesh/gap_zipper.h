// Closes gaps between borders like a zipper: triangles from vertex to vertex, along both of them.
#pragma once

#include <compare>
#include <functional>
#include <queue>
#include <vector>

#include "mesh/border_sides.h"
#include "mesh/gap_bridges.h"

namespace vorogeo {

/// Makes the triangles between borders. Each border edge becomes the side of one triangle at most.
class GapZipper {
 public:
  GapZipper(const Mesh& mesh, const BorderSides& sides, const GapLimit& limit)
      : mesh_(mesh), sides_(sides), limit_(limit), used_(sides.count(), 0) {}

  /// Two sides that run beside each other, `apart` from each other: rows of triangles may begin there.
  void add_start(double apart, Index first, Index second) { starts_.push_back({apart, first, second}); }
  /// Bridges the gaps: at every moment the row of triangles grows, or begins, where the gap is narrowest, so
  /// that where several gaps meet each border is joined to the one across and not to one round the corner.
  void close();
  /// Small holes that are left where several gaps meet.
  void fill_holes();

  std::vector<std::array<Index, 3>> take_faces() { return std::move(faces_); }

 private:
  /// The end of a row of triangles: a vertex of each border and the sides that leave them.
  struct Front {
    Index p, q;
    Index from_p, from_q;  ///< no_index: that border ends
    Index last_p, last_q;  ///< the sides passed last, which give the directions where a border ends
  };

  /// A pair of sides to begin at.
  struct Start {
    double apart;
    Index first, second;
    auto operator<=>(const Start&) const = default;
  };
  /// A row that grows next where the gap is `apart` wide.
  struct Growing {
    double apart;
    std::size_t number;  ///< for an order of its own
    Front front;
    bool operator>(const Growing& other) const {
      return apart != other.apart ? apart > other.apart : number > other.number;
    }
  };

  Front front_between(Index first, Index second) const;
  void begin(const Start& start);
  void begin_at_corner(Front front);
  /// Width of the gap at the next vertex of one border; `unreachable` if the row may not go on to it.
  double next_width(Index side, Index from, Index opposite, Index opposite_side, Index last,
                    Index last_own) const;
  double next_width_p(const Front& front) const {
    return next_width(front.from_p, front.p, front.q, front.from_q, front.last_q, front.last_p);
  }
  double next_width_q(const Front& front) const {
    return next_width(front.from_q, front.q, front.p, front.from_p, front.last_p, front.last_q);
  }
  void push(const Front& front);
  void grow(Front front);
  void advance(Index& vertex, Index& side, Index& last, Index opposite);
  bool is_free(Index side) const { return side != no_index && used_[side] == 0; }
  Index free_next(Index side, Index vertex) const;

  const Mesh& mesh_;
  const BorderSides& sides_;
  GapLimit limit_;
  std::vector<std::uint8_t> used_;  ///< by side
  std::vector<Start> starts_;
  std::priority_queue<Growing, std::vector<Growing>, std::greater<>> growing_;
  std::size_t pushed_ = 0;
  std::vector<std::array<Index, 3>> faces_;
  std::vector<std::array<Index, 2>> ends_;  ///< edges at which rows of triangles end
};

}  // namespace vorogeo
