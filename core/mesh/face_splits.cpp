// Bisection of longest sides, in the order in which faces and their parts are found to need it.
#include "mesh/face_splits.h"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <unordered_map>
#include <utility>

#include "mesh/sorted_sides.h"
#include "mesh/vectors.h"
#include "support/checkpoint.h"

namespace vorogeo {

namespace {

/// Less is rounding, which is not split but shortened.
constexpr double split_slack = 1e-9;

/// Bisections of a face one after the other: beside an edge that is nearly for free, parts of all sizes would
/// be too long on one side, 16 times as many faces with these.
constexpr Index most_splits = 6;

struct Part {
  std::array<Index, 3> corners;
  Index given_face;
  Index depth;  ///< bisections it took; no_index: it was split itself
};

class Splitter {
 public:
  Splitter(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
           const LengthsAlongLines& lines)
      : lines_(lines), positions_(positions.begin(), positions.end()) {
    parts_.reserve(faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (f % elements_per_checkpoint == 0) checkpoint();
      const auto& v = faces[f];
      parts_.push_back({v, static_cast<Index>(f), 0});
      if (is_usable(v)) link(static_cast<Index>(f));
    }
  }

  /// Splits a part, if it needs that and can be split.
  void split(Index part) {
    const Part at = parts_[part];
    if (at.depth == no_index || at.depth >= most_splits || !has_width(at.corners)) return;
    const auto sides = sides_of(at.corners);
    if (!breaks_triangle(sides, split_slack)) return;
    const auto apex = static_cast<int>(std::ranges::max_element(sides) - sides.begin());
    const Index a = at.corners[(apex + 1) % 3];
    const Index b = at.corners[(apex + 2) % 3];
    const auto middle = static_cast<Index>(positions_.size());
    const auto [low, high] = std::minmax(a, b);
    splits_.middle_of.push_back({low, high});
    positions_.push_back(moved(positions_[low], 0.5, minus(positions_[high], positions_[low])));
    lines_.add_middle(low, high);
    const std::vector<Index> around = faces_at_[key(a, b)];
    for (Index each : around) bisect(each, low, high, middle);
  }

  /// The parts that a split has made or changed since the last call.
  std::vector<Index> take_new() { return std::exchange(new_, {}); }

  FaceSplits take() {
    std::vector<Index> order;
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      if (parts_[p].depth != no_index) order.push_back(static_cast<Index>(p));
    }
    std::ranges::stable_sort(order, {}, [&](Index p) { return parts_[p].given_face; });
    for (Index p : order) {
      splits_.faces.push_back(parts_[p].corners);
      splits_.given_face.push_back(parts_[p].given_face);
      splits_.sides.push_back(sides_of(parts_[p].corners));
    }
    return std::move(splits_);
  }

 private:
  static std::uint64_t key(Index a, Index b) {
    const auto [low, high] = std::minmax(a, b);
    return static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint64_t>(high);
  }

  std::array<double, 3> sides_of(const std::array<Index, 3>& v) const {
    std::array<double, 3> sides{};
    for (int i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(v[(i + 1) % 3], v[(i + 2) % 3]);
      if (low != high) sides[i] = lines_.length(low, high);
    }
    return sides;
  }

  bool has_width(const std::array<Index, 3>& v) const {
    constexpr double least_square = 1e-12;  // of the sine; rounding of the difference is 1e-15
    const Point u = minus(positions_[v[1]], positions_[v[0]]);
    const Point w = minus(positions_[v[2]], positions_[v[0]]);
    return dot(u, u) * dot(w, w) - dot(u, w) * dot(u, w) > least_square * dot(u, u) * dot(w, w);
  }

  void link(Index part) {
    const auto& v = parts_[part].corners;
    for (int i = 0; i < 3; ++i) faces_at_[key(v[i], v[(i + 1) % 3])].push_back(part);
  }

  void bisect(Index part, Index low, Index high, Index middle) {
    const Part old = parts_[part];
    for (int i = 0; i < 3; ++i) {
      auto& there = faces_at_[key(old.corners[i], old.corners[(i + 1) % 3])];
      std::erase(there, part);
    }
    parts_[part].depth = no_index;
    for (Index end : {low, high}) {
      Part half{old.corners, old.given_face, old.depth + 1};
      *std::ranges::find(half.corners, end) = middle;
      new_.push_back(static_cast<Index>(parts_.size()));
      parts_.push_back(half);
      link(new_.back());
    }
  }

  const LengthsAlongLines& lines_;
  std::vector<Point> positions_;
  std::vector<Part> parts_;
  std::unordered_map<std::uint64_t, std::vector<Index>> faces_at_;
  std::vector<Index> new_;
  FaceSplits splits_;
};

}  // namespace

bool breaks_triangle(const std::array<double, 3>& sides, double slack) {
  const auto k = static_cast<int>(std::ranges::max_element(sides) - sides.begin());
  return sides[k] > (sides[(k + 1) % 3] + sides[(k + 2) % 3]) * (1.0 + slack);
}

FaceSplits split_faces_for(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                           const SideLengths& sides, const LengthsAlongLines& lines, Index& split_faces) {
  split_faces = 0;
  std::vector<Index> broken;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (breaks_triangle(sides[f], split_slack)) broken.push_back(static_cast<Index>(f));
  }
  if (broken.empty()) return {};
  std::deque<Index> open(broken.begin(), broken.end());
  Splitter splitter(positions, faces, lines);
  while (!open.empty()) {
    checkpoint();
    const Index part = open.front();
    open.pop_front();
    splitter.split(part);
    for (Index fresh : splitter.take_new()) open.push_back(fresh);
  }
  FaceSplits splits = splitter.take();
  if (splits.empty()) return {};
  // A face may have been split by its neighbour only.
  for (const Index f : broken) split_faces += std::ranges::equal_range(splits.given_face, f).size() > 1;
  return splits;
}

}  // namespace vorogeo
