// One face divided by lines through it into triangles.
#include "tasks/face_division.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vorogeo {

FaceDivision::FaceDivision(const std::vector<std::pair<Index, Weights>>& outline, Numbering number_of)
    : number_of_(std::move(number_of)) {
  parts_.emplace_back();
  for (const auto& [point, weights] : outline) {
    place_[point] = {weights[1], weights[2]};
    parts_.front().push_back(point);
  }
}

double FaceDivision::side_of(Index a, Index b, Index c) const {
  const Place& p = place_.at(a);
  const Place to_b{place_.at(b)[0] - p[0], place_.at(b)[1] - p[1]};
  const Place to_c{place_.at(c)[0] - p[0], place_.at(c)[1] - p[1]};
  const double side = to_b[0] * to_c[1] - to_b[1] * to_c[0];
  const double b_length = std::hypot(to_b[0], to_b[1]);
  const double c_length = std::hypot(to_c[0], to_c[1]);
  // Of the angle, and of the coordinates, which are at most 1.
  const double rounding = 1e-11 * b_length * c_length + 1e-15 * (b_length + c_length);
  return std::abs(side) <= rounding ? 0.0 : side;
}

double FaceDivision::area_of(const Part& part) const {
  double twice = 0.0;
  const Place& first = place_.at(part.front());
  for (std::size_t i = 0; i < part.size(); ++i) {
    const Place& p = place_.at(part[i]);
    const Place& q = place_.at(part[(i + 1) % part.size()]);
    twice += (p[0] - first[0]) * (q[1] - first[1]) - (p[1] - first[1]) * (q[0] - first[0]);
  }
  return 0.5 * twice;
}

/// In the parts on both sides of it.
void FaceDivision::insert_into_side(Index a, Index b, Index point) {
  for (Part& part : parts_) {
    for (std::size_t i = 0; i < part.size(); ++i) {
      const std::size_t next = (i + 1) % part.size();
      if (std::minmax(part[i], part[next]) != std::minmax(a, b)) continue;
      part.insert(part.begin() + static_cast<std::ptrdiff_t>(i) + 1, point);
      break;
    }
  }
}

void FaceDivision::add_point(Index point, const Weights& weights) {
  if (!place_.try_emplace(point, Place{weights[1], weights[2]}).second) return;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const Part& part = parts_[k];
    std::vector<std::size_t> on_sides;
    bool is_inside = true;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const double side = side_of(part[i], part[(i + 1) % part.size()], point);
      is_inside = is_inside && side >= 0.0;
      if (side == 0.0) on_sides.push_back(i);
    }
    if (!is_inside) continue;
    if (!on_sides.empty()) {
      // Of several sides on one line, the one that it lies in.
      const auto outside = [&](std::size_t i) {
        const Place& p = place_.at(part[i]);
        const Place& q = place_.at(part[(i + 1) % part.size()]);
        const Place& x = place_.at(point);
        return std::hypot(p[0] - x[0], p[1] - x[1]) + std::hypot(q[0] - x[0], q[1] - x[1]) -
               std::hypot(p[0] - q[0], p[1] - q[1]);
      };
      const std::size_t i = *std::ranges::min_element(on_sides, {}, outside);
      const auto [a, b] = std::pair(part[i], part[(i + 1) % part.size()]);
      insert_into_side(a, b, point);
      return;
    }
    const Part whole = part;
    parts_.erase(parts_.begin() + static_cast<std::ptrdiff_t>(k));
    for (std::size_t i = 0; i < whole.size(); ++i) {
      parts_.push_back({point, whole[i], whole[(i + 1) % whole.size()]});
    }
    return;
  }
}

/// By a line between its points i and j.
void FaceDivision::split(std::size_t part, std::size_t i, std::size_t j) {
  if (i > j) std::swap(i, j);
  Part& whole = parts_[part];
  Part second(whole.begin() + static_cast<std::ptrdiff_t>(i),
              whole.begin() + static_cast<std::ptrdiff_t>(j) + 1);
  whole.erase(whole.begin() + static_cast<std::ptrdiff_t>(i) + 1,
              whole.begin() + static_cast<std::ptrdiff_t>(j));
  parts_.push_back(std::move(second));
}

std::vector<Index> FaceDivision::add_line(Index from, Index to) {
  std::vector<Index> passed{from};
  const std::size_t enough = 4 * place_.size() + 100;
  while (passed.back() != to && passed.size() < enough) {
    const Index next = step(passed.back(), to);
    if (next == no_index) break;
    passed.push_back(next);
  }
  return passed;
}

/// The next point of the line from a point that is there; no_index if there is none.
Index FaceDivision::step(Index from, Index to) {
  const Place& p = place_.at(from);
  const Place way{place_.at(to)[0] - p[0], place_.at(to)[1] - p[1]};
  const auto is_on_the_way = [&](Index point) {
    const Place& q = place_.at(point);
    return side_of(from, to, point) == 0.0 && (q[0] - p[0]) * way[0] + (q[1] - p[1]) * way[1] > 0.0;
  };
  struct Found {
    std::size_t part;
    std::size_t corner;
  };
  std::vector<Found> around;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const auto at = std::ranges::find(parts_[k], from);
    if (at != parts_[k].end()) around.push_back({k, static_cast<std::size_t>(at - parts_[k].begin())});
  }
  // Along a side that is there.
  for (const auto& [k, i] : around) {
    const std::size_t size = parts_[k].size();
    for (const Index beside : {parts_[k][(i + 1) % size], parts_[k][(i + size - 1) % size]}) {
      if (beside == to || is_on_the_way(beside)) return beside;
    }
  }
  for (const auto& [k, i] : around) {
    const Index next = cross_part(k, i, to);
    if (next != no_index) return next;
  }
  return no_index;
}

/// Splits a part by a line from one of its corners, if it runs inside. \return where it leaves the part.
Index FaceDivision::cross_part(std::size_t k, std::size_t corner, Index to) {
  const std::size_t size = parts_[k].size();
  const Index from = parts_[k][corner];
  for (std::size_t step = 1; step + 1 < size; ++step) {
    const std::size_t i = (corner + step) % size;
    const std::size_t j = (i + 1) % size;
    const Index u = parts_[k][i];
    const Index v = parts_[k][j];
    if (u == to) {
      split(k, corner, i);
      return u;
    }
    const double at_u = side_of(from, to, u);
    const double at_v = side_of(from, to, v);
    // The way out goes between a point to the right and one to the left.
    if (at_u < 0.0 && at_v == 0.0 && v != from && v != to && step + 2 < size) {
      split(k, corner, j);
      return v;
    }
    if (!(at_u < 0.0 && at_v > 0.0)) continue;
    if (v == from) continue;
    const double t = at_u / (at_u - at_v);
    const Place& p = place_.at(u);
    const Place& q = place_.at(v);
    const Place x{std::lerp(p[0], q[0], t), std::lerp(p[1], q[1], t)};
    const auto sides = std::ranges::count_if(parts_, [&](const Part& part) {
      for (std::size_t a = 0; a < part.size(); ++a) {
        if (std::minmax(part[a], part[(a + 1) % part.size()]) == std::minmax(u, v)) return true;
      }
      return false;
    });
    if (sides < 2) return no_index;  // out of the face
    const Index crossing = number_of_({1.0 - x[0] - x[1], x[0], x[1]});
    place_[crossing] = x;
    insert_into_side(u, v, crossing);
    const auto at = std::ranges::find(parts_[k], from) - parts_[k].begin();
    const auto there = std::ranges::find(parts_[k], crossing) - parts_[k].begin();
    split(k, static_cast<std::size_t>(at), static_cast<std::size_t>(there));
    return crossing;
  }
  return no_index;
}

std::vector<std::array<Index, 3>> FaceDivision::triangles() const {
  std::vector<std::array<Index, 3>> result;
  for (Part part : parts_) {
    while (part.size() > 3) {
      // The corner to cut off: that leaves the most area on the smaller side.
      const double whole = area_of(part);
      std::size_t best = 0;
      double most = -1.0;
      for (std::size_t i = 0; i < part.size(); ++i) {
        const double ear =
            area_of({part[(i + part.size() - 1) % part.size()], part[i], part[(i + 1) % part.size()]});
        const double least = std::min(ear, whole - ear);
        if (least > most) most = least, best = i;
      }
      result.push_back(
          {part[(best + part.size() - 1) % part.size()], part[best], part[(best + 1) % part.size()]});
      part.erase(part.begin() + static_cast<std::ptrdiff_t>(best));
    }
    result.push_back({part[0], part[1], part[2]});
  }
  return result;
}

}  // namespace vorogeo
