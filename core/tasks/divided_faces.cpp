// Corners of parts shared by neighbouring faces, so that borders go on over edges.
#include "tasks/divided_faces.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "support/parallel.h"

namespace vorogeo {

namespace {

/// Numbers the corners of parts: a vertex, a point of an edge, or a point in a face once each.
class CornerNumbers {
 public:
  explicit CornerNumbers(const Mesh& mesh) : mesh_(mesh) {}

  /// `steps`: weights in parts of a side.
  Index number(Index face, const std::array<Index, 3>& steps) {
    constexpr Index n = DividedFaces::per_side;
    std::array<double, 3> weights{};
    for (int i = 0; i < 3; ++i) weights[i] = static_cast<double>(steps[i]) / n;
    SurfacePoint point = SurfacePoint::in_face(face, weights);
    std::tuple<Index, Index, Index> key{face, steps[0], steps[1]};
    for (int i = 0; i < 3; ++i) {
      if (steps[i] == n) {
        point = SurfacePoint::at_vertex(mesh_.face_vertices(face)[i]);
        key = {-1, point.vertex, 0};
        break;
      }
      const int j = (i + 1) % 3;
      if (steps[i] == 0 || steps[j] == 0 || steps[(i + 2) % 3] != 0) continue;
      const Index edge = mesh_.edge_of(3 * face + i);
      const bool along = mesh_.edge_vertices(edge)[0] == mesh_.face_vertices(face)[i];
      key = {-2 - edge, along ? steps[j] : steps[i], 0};
    }
    const auto [at, is_new] = numbers_.try_emplace(key, static_cast<Index>(points.size()));
    if (is_new) points.push_back(point);
    return at->second;
  }

  std::vector<SurfacePoint> points;  ///< by number

 private:
  const Mesh& mesh_;
  std::map<std::tuple<Index, Index, Index>, Index> numbers_;
};

}  // namespace

DividedFaces::DividedFaces(FieldTeam& team, const PointList& sites, std::vector<ContestedFace> contested,
                           double radius, const Progress& progress)
    : contested_(std::move(contested)) {
  const Mesh& mesh = team.mesh();
  CornerNumbers corners(mesh);
  std::vector<std::array<Index, 3>> faces;
  std::map<Index, std::vector<Index>> corners_of_site;
  for (const ContestedFace& each : contested_) {
    auto add = [&](std::array<Index, 3> a, std::array<Index, 3> b, std::array<Index, 3> c) {
      faces.push_back(
          {corners.number(each.face, a), corners.number(each.face, b), corners.number(each.face, c)});
    };
    constexpr Index n = per_side;
    // Row by row, from the side of corners 1 and 2 to corner 0; in each row, parts point up and down in turn.
    for (Index i = 0; i < n; ++i) {
      for (Index j = 0; i + j < n; ++j) {
        const Index k = n - 1 - i - j;
        add({i + 1, j, k}, {i, j + 1, k}, {i, j, k + 1});
        if (k > 0) add({i + 1, j, k}, {i + 1, j + 1, k - 1}, {i, j + 1, k});
      }
    }
    for (std::size_t f = faces.size() - parts_per_face; f < faces.size(); ++f) {
      for (Index site : each.sites) {
        for (Index corner : faces[f]) corners_of_site[site].push_back(corner);
      }
    }
  }
  std::vector<Point> positions;
  for (const SurfacePoint& point : corners.points) positions.push_back(position_of(mesh, point));
  parts_ = std::make_shared<const Mesh>(std::move(positions), faces);
  at_.resize(corners.points.size());
  distance_.resize(corners.points.size());
  std::vector<std::pair<Index, std::vector<Index>>> asked(corners_of_site.begin(), corners_of_site.end());
  std::vector<std::vector<double>> found(asked.size());
  const PointList all = points_on(mesh, corners.points, "Point");
  parallel_for(asked.size(), team.threads(), progress, "Voronoi regions", [&](std::size_t i, int worker) {
    auto& numbers = asked[i].second;
    std::ranges::sort(numbers);
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    std::vector<SurfacePoint> points;
    for (Index number : numbers) points.push_back(all[number]);
    found[i] = team.distances(sites[asked[i].first], points, radius, worker);
  });
  for (std::size_t i = 0; i < asked.size(); ++i) {
    for (std::size_t k = 0; k < found[i].size(); ++k) {
      at_[asked[i].second[k]].push_back(asked[i].first);
      distance_[asked[i].second[k]].push_back(found[i][k]);
    }
  }
}

std::vector<FaceSite> DividedFaces::sites_of(Index part) const {
  std::vector<FaceSite> result;
  for (Index site : contested_[part / parts_per_face].sites) {
    FaceSite one{site, {}};
    bool is_known = true;
    for (int i = 0; i < 3; ++i) {
      const Index corner = parts_->face_vertices(part)[i];
      const auto place = std::ranges::lower_bound(at_[corner], site) - at_[corner].begin();
      const double distance = distance_[corner][place];
      is_known = is_known && distance < unreachable;
      one.square[i] = distance * distance;
    }
    if (is_known) result.push_back(one);
  }
  return result;
}

}  // namespace vorogeo
