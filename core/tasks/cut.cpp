// A mesh cut along lines over it: faces divided, each part with its region, and points that say where they
// were.
#include "tasks/cut.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

#include "mesh/mesh_input.h"
#include "mesh/orientation.h"
#include "support/disjoint_sets.h"
#include "support/error.h"
#include "tasks/face_division.h"

namespace vorogeo {

namespace {

using CutWeights = std::array<double, 3>;

/// Points that differ by less, as fractions of an edge or as weights, are one.
constexpr double same_place = 1e-10;

/// Collects the points and the pieces of lines by face, and divides the faces.
class MeshCutter {
 public:
  explicit MeshCutter(const Mesh& mesh) : mesh_(mesh), turned_(turned_faces(mesh)) {
    for (Index v = 0; v < mesh.vertex_count(); ++v) result_.points.push_back(SurfacePoint::at_vertex(v));
  }

  /// The point of an edge at a fraction of it, from its first vertex.
  Index on_edge(Index edge, double fraction) {
    const auto [a, b] = mesh_.edge_vertices(edge);
    if (!(fraction > same_place)) return a;
    if (fraction >= 1.0 - same_place) return b;
    auto& points = on_edge_[edge];
    const auto near = points.lower_bound(fraction - same_place);
    if (near != points.end() && near->first <= fraction + same_place) return near->second;
    return points.emplace_hint(near, fraction, add(point_on_edge(mesh_, edge, fraction)))->second;
  }

  Index at(const SurfacePoint& given) {
    if (given.is_vertex()) return given.vertex;
    const CutWeights& weights = given.barycentric;
    for (int i = 0; i < 3; ++i) {
      if (weights[(i + 2) % 3] > same_place) continue;
      const Index h = 3 * given.face + i;
      const Index edge = mesh_.edge_of(h);
      const double along = weights[(i + 1) % 3] / (weights[i] + weights[(i + 1) % 3]);
      return on_edge(edge, mesh_.edge_vertices(edge)[0] == mesh_.tail(h) ? along : 1.0 - along);
    }
    auto& points = in_face_[given.face];
    const auto begin = points.lower_bound(weights[0] - same_place);
    for (auto near = begin; near != points.end() && near->first <= weights[0] + same_place; ++near) {
      const CutWeights& other = result_.points[near->second].barycentric;
      if (std::abs(weights[0] - other[0]) + std::abs(weights[1] - other[1]) +
              std::abs(weights[2] - other[2]) <=
          same_place) {
        return near->second;
      }
    }
    return points.emplace(weights[0], add(given))->second;
  }
  /// Whether a face is turned against most others.
  bool is_turned(Index face) const { return turned_[face]; }

  /// Adds a straight piece of a line in a face, between two points of the face.
  void add_piece(Index face, Index from, Index to) {
    if (from == to) return;
    pieces_[face].push_back({from, to, passed_.size()});
    passed_.emplace_back();
  }
  std::size_t piece_count() const { return passed_.size(); }

  /// Divides the faces. Regions are left to the caller.
  CutMesh divided() {
    for (const auto& [edge, points] : on_edge_) {
      mesh_.for_each_halfedge(edge, [&](Index h) { pieces_.try_emplace(Mesh::face_of(h)); });
    }
    auto next = pieces_.begin();
    for (const Index f : checked(mesh_.first_bridge())) {
      if (next == pieces_.end() || next->first != f) {
        result_.faces.push_back(mesh_.face_vertices(f));
        result_.face_of.push_back(f);
        continue;
      }
      divide(f, next->second);
      ++next;
    }
    std::set<std::pair<Index, Index>> edges;
    for (const auto& points : passed_) {
      for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        if (edges.insert(std::minmax(points[k], points[k + 1])).second) {
          result_.edges.push_back({points[k], points[k + 1]});
        }
      }
    }
    mark_sides();
    return std::move(result_);
  }
  /// After the division: the points on each piece, in the order in which pieces were added.
  const std::vector<std::vector<Index>>& passed() const { return passed_; }

 private:
  struct Piece {
    Index from;
    Index to;
    std::size_t number;
  };

  Index add(const SurfacePoint& point) {
    result_.points.push_back(point);
    return static_cast<Index>(result_.points.size()) - 1;
  }

  void divide(Index face, const std::vector<Piece>& pieces) {
    std::vector<std::pair<Index, CutWeights>> outline;
    for (int i = 0; i < 3; ++i) {
      const Index h = 3 * face + i;
      CutWeights weights{};
      weights[i] = 1.0;
      outline.emplace_back(mesh_.tail(h), weights);
      const auto found = on_edge_.find(mesh_.edge_of(h));
      if (found == on_edge_.end()) continue;
      const bool along = mesh_.edge_vertices(found->first)[0] == mesh_.tail(h);
      const auto first = static_cast<std::ptrdiff_t>(outline.size());
      for (const auto& [fraction, point] : found->second) {
        weights[(i + 1) % 3] = along ? fraction : 1.0 - fraction;
        weights[i] = 1.0 - weights[(i + 1) % 3];
        outline.emplace_back(point, weights);
      }
      if (!along) std::ranges::reverse(outline.begin() + first, outline.end());
    }
    FaceDivision division(
        outline, [&](const CutWeights& weights) { return add(SurfacePoint::in_face(face, weights)); });
    if (const auto inside = in_face_.find(face); inside != in_face_.end()) {
      // In the order of the lines, so that each point is near the last one.
      std::vector<Index> points;
      for (const auto& [weight, point] : inside->second) points.push_back(point);
      std::ranges::sort(points);
      for (const Index point : points) {
        checkpoint();
        division.add_point(point, result_.points[point].barycentric);
      }
    }
    for (const Piece& piece : pieces) {
      checkpoint();
      if (division.add_line(piece.from, piece.to).back() == piece.to) continue;
      throw Error("The line could not be drawn through face " + std::to_string(mesh_.input_face(face)) +
                  ": its points lie nearer to each other than weights are rounded.");
    }
    // Once more, for the points at which later lines have crossed earlier ones.
    for (const Piece& piece : pieces) {
      passed_[piece.number] = division.add_line(piece.from, piece.to);
    }
    for (const auto& triangle : division.triangles()) {
      result_.faces.push_back(triangle);
      result_.face_of.push_back(face);
    }
  }

  void mark_sides() {
    std::set<std::pair<Index, Index>> along;
    for (const auto& [a, b] : result_.edges) along.emplace(a, b);
    for (const std::size_t f : checked(result_.faces.size())) {
      const std::array<Index, 3>& face = result_.faces[f];
      bool left = false;
      bool right = false;
      for (int i = 0; i < 3; ++i) {
        left = left || along.contains({face[i], face[(i + 1) % 3]});
        right = right || along.contains({face[(i + 1) % 3], face[i]});
      }
      if (is_turned(result_.face_of[f])) std::swap(left, right);
      result_.side.push_back(static_cast<Index>(left) - static_cast<Index>(right));
    }
  }

  const Mesh& mesh_;
  const std::vector<bool> turned_;
  CutMesh result_;
  std::unordered_map<Index, std::map<double, Index>> on_edge_;       ///< by the fraction of the edge
  std::unordered_map<Index, std::multimap<double, Index>> in_face_;  ///< by the weight of the first corner
  std::map<Index, std::vector<Piece>> pieces_;                       ///< by face
  std::vector<std::vector<Index>> passed_;                           ///< by piece, the points on it
};

/// By face, its connected part: faces are joined over all edges but those of the cut.
std::vector<Index> parts_between(const CutMesh& cut) {
  std::set<std::array<Index, 2>> closed;
  for (const auto& [a, b] : cut.edges) closed.insert(edge_of(a, b));
  const std::vector<SideOfFace>& sides = cut.sides;
  DisjointSets sets(static_cast<Index>(cut.faces.size()));
  for (std::size_t k = 0; k + 1 < sides.size(); ++k) {
    if (sides[k].ends == sides[k + 1].ends && !closed.contains(sides[k].ends)) {
      sets.join(sides[k].face, sides[k + 1].face);
    }
  }
  std::map<Index, Index> number;
  std::vector<Index> region;
  for (const Index f : checked(static_cast<Index>(cut.faces.size()))) {
    region.push_back(number.try_emplace(sets.root(f), static_cast<Index>(number.size())).first->second);
  }
  return region;
}

}  // namespace

CutMesh cut_at_levels(const Mesh& mesh, std::span<const double> given, std::span<const double> given_levels,
                      Interpolation interpolation, const Progress& progress) {
  require_field_and_levels(mesh, given, given_levels);
  const std::vector<double> values = InputMap(mesh).on_vertices(given);
  std::vector<double> levels(given_levels.begin(), given_levels.end());
  std::ranges::sort(levels);
  levels.erase(std::ranges::unique(levels).begin(), levels.end());
  constexpr double bytes_per_piece = 330.0;  // measured; most is for two more faces
  require_memory_for_levels(mesh, values, levels, bytes_per_piece);
  // By point, how many levels are at most its value.
  std::vector<Index> below;
  for (const double value : values) {
    below.push_back(static_cast<Index>(std::ranges::upper_bound(levels, value) - levels.begin()));
  }
  const Watch watch(progress, "Cut");
  MeshCutter cutter(mesh);
  const auto is_finite = [&](Index face) {
    return std::ranges::all_of(mesh.face_vertices(face), [&](Index v) { return std::isfinite(values[v]); });
  };
  for (const Index f : checked(mesh.first_bridge())) {
    if (!is_finite(f)) continue;
    const auto& corners = mesh.face_vertices(f);
    const auto [low, high] = std::minmax({values[corners[0]], values[corners[1]], values[corners[2]]});
    for (auto next = std::ranges::upper_bound(levels, low); next != levels.end() && *next <= high; ++next) {
      const auto number = static_cast<Index>(next - levels.begin());
      std::array<Index, 2> end{no_index, no_index};  // greater values lie to the left
      for_each_crossing(mesh, values, f, *next, interpolation, [&](Index edge, double t, bool falls) {
        const Index point = cutter.on_edge(edge, t);
        end[falls != cutter.is_turned(f) ? 0 : 1] = point;
        if (static_cast<std::size_t>(point) == below.size()) below.push_back(0);
        below[point] = std::max(below[point], number + 1);
      });
      cutter.add_piece(f, end[0], end[1]);
    }
  }
  CutMesh cut = cutter.divided();
  for (std::size_t f = 0; f < cut.faces.size(); ++f) {
    Index region = static_cast<Index>(levels.size());
    for (const Index point : cut.faces[f]) {
      if (static_cast<std::size_t>(point) < below.size()) region = std::min(region, below[point]);
    }
    cut.region.push_back(is_finite(cut.face_of[f]) ? region : no_index);
  }
  return cut;
}

CutMesh cut_along(const Mesh& mesh, const std::vector<std::vector<SurfacePoint>>& lines,
                  const Progress& progress) {
  const Watch watch(progress, "Cut");
  MeshCutter cutter(mesh);
  std::vector<std::size_t> end;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const PointList points = points_on(mesh, lines[k], ("Line " + std::to_string(k) + ", point").c_str());
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      Index face = no_index;
      bool over_gap = false;
      for_each_face_at(mesh, points[i], [&](Index own, const CutWeights&) {
        CutWeights weights;
        if (face != no_index || !weights_in_face(mesh, points[i + 1], own, weights)) return;
        over_gap = over_gap || mesh.is_bridge(own);
        if (!mesh.is_bridge(own)) face = own;
      });
      if (face == no_index) {
        throw InvalidInput("Points " + std::to_string(i) + " and " + std::to_string(i + 1) + " of line " +
                           std::to_string(k) +
                           (over_gap ? " have a gap between them, where there is no face to cut."
                                     : " share no face; give the points of a path over the surface."));
      }
      cutter.add_piece(face, cutter.at(points[i]), cutter.at(points[i + 1]));
    }
    end.push_back(cutter.piece_count());
  }
  CutMesh cut = cutter.divided();
  std::size_t next = 0;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    cut.lines.emplace_back();
    for (; next < end[k]; ++next) {
      const std::vector<Index>& passed = cutter.passed()[next];
      cut.lines[k].insert(cut.lines[k].end(), passed.begin() + (cut.lines[k].empty() ? 0 : 1), passed.end());
    }
  }
  cut.sides = sorted_sides(cut.faces);
  cut.region = parts_between(cut);
  return cut;
}

}  // namespace vorogeo
