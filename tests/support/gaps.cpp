// Cracks, loose triangles, plates, rolls and fingers.
#include "support/gaps.h"

#include <cmath>
#include <map>
#include <numbers>
#include <random>

namespace vorogeo::test {

Cut exploded(const Soup& whole, double jitter, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> moved(-jitter, jitter);
  Cut cut;
  for (const auto& face : whole.faces) {
    const auto first = static_cast<Index>(cut.soup.positions.size());
    cut.soup.faces.push_back({first, first + 1, first + 2});
    for (const Index v : face) {
      Point p = whole.positions[v];
      if (jitter > 0.0) {
        for (double& x : p) x += moved(random);
      }
      cut.soup.positions.push_back(p);
      cut.origin.push_back(v);
    }
  }
  return cut;
}

Cut cracked(const Cut& whole, const Point& normal, double width, double removed) {
  const auto height = [&](const Point& p) { return p[0] * normal[0] + p[1] * normal[1] + p[2] * normal[2]; };
  Cut cut = whole;
  cut.soup.faces.clear();
  std::vector<int> side(whole.soup.positions.size(), 0);  // of the faces at a vertex; 2: both
  std::vector<int> of_face;
  for (const auto& face : whole.soup.faces) {
    double middle = 0.0;
    for (const Index v : face) middle += height(whole.soup.positions[v]) / 3.0;
    if (std::abs(middle) < 0.5 * removed) continue;
    cut.soup.faces.push_back(face);
    of_face.push_back(middle < 0.0 ? -1 : 1);
    for (const Index v : face) side[v] = side[v] == 0 || side[v] == of_face.back() ? of_face.back() : 2;
  }
  std::vector<Index> second(whole.soup.positions.size(), no_index);
  for (std::size_t v = 0; v < side.size(); ++v) {
    if (side[v] != 2) continue;
    second[v] = static_cast<Index>(cut.soup.positions.size());
    Point p = cut.soup.positions[v];
    for (int k = 0; k < 3; ++k) {
      cut.soup.positions[v][k] -= 0.5 * width * normal[k];
      p[k] += 0.5 * width * normal[k];
    }
    cut.soup.positions.push_back(p);
    cut.origin.push_back(cut.origin[v]);
  }
  for (std::size_t f = 0; f < of_face.size(); ++f) {
    if (of_face[f] < 0) continue;
    for (Index& v : cut.soup.faces[f]) v = second[v] == no_index ? v : second[v];
  }
  return cut;
}

Shape two_plates(int left, int right, double gap) {
  Soup second = plane_grid(right, right, 1.0 - gap, 1.0).soup;
  for (Point& p : second.positions) p[0] += 1.0 + gap;
  Shape shape;
  shape.soup = two_components(plane_grid(left, left, 1.0, 1.0).soup, second);
  shape.distance = [mesh = make_mesh(shape.soup)](const SurfacePoint& a, const SurfacePoint& b) {
    return distance_between(position_of(*mesh, a), position_of(*mesh, b));
  };
  return shape;
}

Soup rolled_sheet(int turns, int cells_per_turn, double apart) {
  Soup soup = plane_grid(turns * cells_per_turn, 4, static_cast<double>(turns), 1.0).soup;
  for (Point& p : soup.positions) {
    const double angle = 2.0 * std::numbers::pi * p[0];
    const double radius = 1.0 + apart * p[0];
    p = {radius * std::cos(angle), radius * std::sin(angle), p[1]};
  }
  return soup;
}

Soup hand(int fingers, int cells, double length, double apart, bool open) {
  Soup soup;
  std::map<std::array<std::int64_t, 3>, Index> known;  // sides meet up to rounding
  const auto vertex = [&](const Point& p) {
    std::array<std::int64_t, 3> place{};
    for (int k = 0; k < 3; ++k) place[k] = std::llround(1e9 * p[k]);
    const auto [at, is_new] = known.try_emplace(place, static_cast<Index>(soup.positions.size()));
    if (is_new) soup.positions.push_back(p);
    return at->second;
  };
  // A grid of cells over corner + s u + t v.
  const auto sheet = [&](const Point& corner, const Point& u, const Point& v, int along_u, int along_v) {
    const auto at = [&](int i, int j) {
      Point p{};
      for (int k = 0; k < 3; ++k) p[k] = corner[k] + u[k] * i / along_u + v[k] * j / along_v;
      return vertex(p);
    };
    for (int i = 0; i < along_u; ++i) {
      for (int j = 0; j < along_v; ++j) {
        soup.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        soup.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    }
  };
  const int high = static_cast<int>(std::lround(length * cells));
  const auto left = [&](int f) { return f * (1.0 + apart); };
  for (int f = 0; f < fingers; ++f) {
    const double x = left(f);
    const double end = left(f + 1) - apart;
    const Point across{end - x, 0, 0};
    for (const double y : {0.0, 1.0}) {
      sheet({x, y, 0}, across, {0, 0, length}, cells, high);
      sheet({x, y, -1}, across, {0, 0, 1}, cells, cells);
    }
    sheet({x, 0, 0}, {0, 1, 0}, {0, 0, length}, cells, high);
    sheet({end, 0, 0}, {0, 1, 0}, {0, 0, length}, cells, high);
    sheet({x, 0, -1}, across, {0, 1, 0}, cells, cells);
    if (!open) sheet({x, 0, length}, across, {0, 1, 0}, cells, cells);
    if (f + 1 == fingers) break;
    const Point between{left(f + 1) - end, 0, 0};  // the palm between two fingers
    for (const double z : {-1.0, 0.0}) sheet({end, 0, z}, between, {0, 1, 0}, 1, cells);
    for (const double y : {0.0, 1.0}) sheet({end, y, -1}, between, {0, 0, 1}, 1, cells);
  }
  for (const double x : {0.0, left(fingers) - apart}) sheet({x, 0, -1}, {0, 1, 0}, {0, 0, 1}, cells, cells);
  return soup;
}

}  // namespace vorogeo::test
