// What closed lines over a surface enclose.
#include "tasks/enclosed_part.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "mesh/vectors.h"
#include "support/error.h"

namespace vorogeo {

EnclosedPart::EnclosedPart(const Mesh& mesh, CutMesh cut, const std::string& lines)
    : mesh_(mesh), cut_(std::move(cut)) {
  const std::vector<Index> side = sides();
  // By side; two for each component.
  const std::size_t count = side.empty() ? 0 : 2 * (static_cast<std::size_t>(std::ranges::max(side)) / 2 + 1);
  std::vector<double> area(count, 0.0);
  std::vector<bool> is_there(count, false), has_border(count, false), is_inside(count, false);
  std::vector<bool> lines_are_border(count, true);
  bool has_inside = count > 0;
  if (has_inside) {
    for (std::size_t f = 0; f < cut_.faces.size(); ++f) {
      const Index own = side[cut_.region[f]];
      if (own == no_index) continue;
      is_there[own] = true;
      const auto at = corners(static_cast<Index>(f));
      area[own] += 0.5 * length_of(cross(minus(at[1], at[0]), minus(at[2], at[0])));
    }
    std::set<std::array<Index, 2>> along;
    for (const auto& [a, b] : cut_.edges) along.insert(edge_of(a, b));
    for_each_edge([&](const std::array<Index, 2>& ends, std::span<const SideOfFace> faces) {
      const Index own = side[cut_.region[faces[0].face]];
      if (own == no_index) return;
      if (along.contains(ends)) {
        if (faces.size() > 1) lines_are_border[own / 2 * 2] = false;
      } else if (faces.size() == 1) {
        has_border[own] = true;
      }
    });
  }
  for (std::size_t k = 0; k < count; k += 2) {
    const bool is_all = !is_there[k + 1] && lines_are_border[k];
    has_inside = has_inside && is_there[k] && (is_there[k + 1] || is_all);
    const bool is_second = has_border[k] != has_border[k + 1] ? has_border[k] : area[k + 1] < area[k];
    const std::size_t chosen = !is_all && is_second ? k + 1 : k;
    is_inside[chosen] = true;
    area_ += area[chosen];
  }
  if (!has_inside) {
    throw InvalidInput(lines +
                       " have the same side left and right, as around a handle or a tube or from border to "
                       "border, so there is no inside; give others, around a part that they can separate.");
  }
  for (const Index own : side) is_inside_.push_back(own != no_index && is_inside[own]);
}

/// By region, 2 k or 2 k + 1 for the two sides of the lines in the k-th component that has lines, so that it
/// changes across every line; no_index in components without lines. Empty if there is no such numbering.
std::vector<Index> EnclosedPart::sides() const {
  std::map<std::array<Index, 2>, int> passes;
  for (const auto& line : cut_.lines) {
    for (std::size_t k = 0; k + 1 < line.size(); ++k) ++passes[edge_of(line[k], line[k + 1])];
  }
  const auto faces_beside = [&](const std::array<Index, 2>& ends) {
    return std::ranges::equal_range(cut_.sides, ends, {}, &SideOfFace::ends);
  };
  std::vector<std::vector<std::pair<Index, Index>>> beside(
      1 + static_cast<std::size_t>(std::ranges::max(cut_.region)));
  for (const auto& [ends, count] : passes) {
    for (const SideOfFace& f : faces_beside(ends)) {
      for (const SideOfFace& g : faces_beside(ends)) {
        if (f.face != g.face) beside[cut_.region[f.face]].push_back({cut_.region[g.face], count % 2});
      }
    }
  }
  std::vector<Index> side(beside.size(), no_index);
  Index number = 0;
  for (const auto& line : cut_.lines) {
    std::vector<Index> next{cut_.region[faces_beside(edge_of(line[0], line[1])).front().face]};
    if (side[next[0]] != no_index) continue;
    side[next[0]] = number;
    number += 2;
    while (!next.empty()) {
      const Index region = next.back();
      next.pop_back();
      for (const auto& [other, changes] : beside[region]) {
        const Index wanted = side[region] ^ changes;
        if (side[other] == no_index) {
          side[other] = wanted;
          next.push_back(other);
        } else if (side[other] != wanted) {
          return {};
        }
      }
    }
  }
  return side;
}

std::array<Point, 3> EnclosedPart::corners(Index face) const {
  const Index whole = cut_.face_of[face];
  const auto at = mesh_.face_corners(whole);
  std::array<Point, 3> places{};
  for (int i = 0; i < 3; ++i) {
    std::array<double, 3> weights{};
    weights_in_face(mesh_, cut_.points[cut_.faces[face][i]], whole, weights);
    for (int c = 0; c < 3; ++c) places[i] = moved(places[i], weights[c], at[c]);
  }
  return places;
}

bool EnclosedPart::holds(const SurfacePoint& point) const {
  constexpr double rounding = 1e-9;  // of weights
  bool is_held = false;
  for_each_face_at(mesh_, point, [&](Index whole, const std::array<double, 3>& place) {
    const auto parts = std::ranges::equal_range(cut_.face_of, whole);
    for (auto part = parts.begin(); part != parts.end() && !is_held; ++part) {
      const auto face = static_cast<Index>(part - cut_.face_of.begin());
      if (!has(face)) continue;
      std::array<std::array<double, 3>, 3> corner{};
      for (int i = 0; i < 3; ++i) weights_in_face(mesh_, cut_.points[cut_.faces[face][i]], whole, corner[i]);
      is_held = true;
      for (int i = 0; i < 3; ++i) {
        const auto &a = corner[i], &b = corner[(i + 1) % 3];
        const double left = (b[1] - a[1]) * (place[2] - a[2]) - (b[2] - a[2]) * (place[1] - a[1]);
        is_held = is_held && left >= -rounding;
      }
    }
  });
  return is_held;
}

Index EnclosedPart::euler_characteristic() const {
  std::set<Index> points;
  Index sum = 0;
  for (std::size_t f = 0; f < cut_.faces.size(); ++f) {
    if (!has(static_cast<Index>(f))) continue;
    ++sum;
    points.insert(cut_.faces[f].begin(), cut_.faces[f].end());
  }
  for_each_edge([&](const std::array<Index, 2>&, std::span<const SideOfFace> faces) {
    if (std::ranges::any_of(faces, [&](const SideOfFace& side) { return has(side.face); })) --sum;
  });
  return sum + static_cast<Index>(points.size());
}

}  // namespace vorogeo
