// Regions from the distances of all sites that matter at each vertex, then face by face.
#include "query/voronoi_regions.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "support/error.h"
#include "support/parallel.h"

namespace vorogeo {

namespace {

/// Fields from one and from several sources may differ by this part of the distance.
constexpr double slack = 1.02;

struct SiteDistance {
  Index vertex;
  Index site;
  double distance;
};

/// For each vertex the sites that may own a part of one of its faces, with their distances; by site.
struct Candidates {
  std::vector<std::size_t> begin;
  std::vector<SiteDistance> entries;
  std::span<const SiteDistance> at(Index vertex) const {
    return std::span(entries).subspan(begin[vertex], begin[vertex + 1] - begin[vertex]);
  }
};

/// Longest edge of the faces at each vertex. A site that owns a point of a face is, at the face's corners,
/// at most twice this farther than the nearest one, by the triangle inequality.
std::vector<double> reach_of_vertices(const Mesh& mesh) {
  std::vector<double> reach(mesh.vertex_count(), 0.0);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    double longest = 0.0;
    for (int i = 0; i < 3; ++i) longest = std::max(longest, mesh.edge_length(mesh.edge_of(3 * f + i)));
    for (Index v : mesh.face_vertices(f)) reach[v] = std::max(reach[v], longest);
  }
  return reach;
}

Candidates find_candidates(FieldTeam& team, std::span<const Index> sites, const std::vector<Index>& owners,
                           const Progress& progress) {
  const Mesh& mesh = team.mesh();
  const auto nearest = team.field_on_all_threads(sites);
  const auto reach = reach_of_vertices(mesh);
  std::vector<double> bound(mesh.vertex_count(), -1.0);
  double radius = 0.0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (nearest[v] == unreachable) continue;
    bound[v] = slack * nearest[v] + 2.0 * slack * reach[v];
    radius = std::max(radius, bound[v]);
  }
  std::vector<std::vector<SiteDistance>> of_site(owners.size());
  parallel_for(owners.size(), team.threads(), progress, "Voronoi regions", [&](std::size_t i, int worker) {
    const Index site = owners[i];
    const auto field = team.field(sites[site], radius, worker);
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      if (field[v] <= bound[v]) of_site[i].push_back({v, site, field[v]});
    }
  });
  Candidates result;
  result.begin.assign(static_cast<std::size_t>(mesh.vertex_count()) + 1, 0);
  for (const auto& list : of_site) {
    for (const SiteDistance& entry : list) ++result.begin[entry.vertex + 1];
  }
  for (std::size_t v = 1; v < result.begin.size(); ++v) result.begin[v] += result.begin[v - 1];
  result.entries.resize(result.begin.back());
  auto next = result.begin;
  for (auto& list : of_site) {
    for (const SiteDistance& entry : list) result.entries[next[entry.vertex]++] = entry;
    list = {};
  }
  return result;
}

/// A site and the squares of its distances at the corners of a face.
struct FaceSite {
  Index site;
  std::array<double, 3> square;
};

/// The sites known at all three corners.
void sites_of_face(const Mesh& mesh, const Candidates& candidates, Index face, std::vector<FaceSite>& sites) {
  sites.clear();
  const auto& corners = mesh.face_vertices(face);
  const auto second = candidates.at(corners[1]);
  const auto third = candidates.at(corners[2]);
  auto find = [](std::span<const SiteDistance> list, Index site) {
    const auto place = std::lower_bound(list.begin(), list.end(), site,
                                        [](const SiteDistance& entry, Index s) { return entry.site < s; });
    return place != list.end() && place->site == site ? &*place : nullptr;
  };
  for (const SiteDistance& entry : candidates.at(corners[0])) {
    const SiteDistance* b = find(second, entry.site);
    const SiteDistance* c = find(third, entry.site);
    if (!b || !c) continue;
    sites.push_back(
        {entry.site,
         {entry.distance * entry.distance, b->distance * b->distance, c->distance * c->distance}});
  }
}

using Barycentric = std::array<double, 3>;

double value_at(const std::array<double, 3>& corners, const Barycentric& at) {
  return corners[0] * at[0] + corners[1] * at[1] + corners[2] * at[2];
}

/// Part of a face's area, in [0, 1], where the site at `mine` is the nearest: the triangle cut by one line
/// for each other site.
double share_of_face(const std::vector<FaceSite>& sites, std::size_t mine) {
  std::vector<Barycentric> polygon{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::vector<Barycentric> cut;
  for (std::size_t other = 0; other < sites.size() && !polygon.empty(); ++other) {
    if (other == mine) continue;
    std::array<double, 3> lead{};  // of the other over this one
    for (int c = 0; c < 3; ++c) lead[c] = sites[other].square[c] - sites[mine].square[c];
    cut.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Barycentric& p = polygon[i];
      const Barycentric& q = polygon[(i + 1) % polygon.size()];
      const double a = value_at(lead, p);
      const double b = value_at(lead, q);
      if (a >= 0.0) cut.push_back(p);
      if ((a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0)) {
        const double t = a / (a - b);
        cut.push_back({p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2])});
      }
    }
    // On a tie all over the face, the first owns it.
    if (other < mine && lead[0] == 0.0 && lead[1] == 0.0 && lead[2] == 0.0) cut.clear();
    polygon.swap(cut);
  }
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Barycentric& p = polygon[i];
    const Barycentric& q = polygon[(i + 1) % polygon.size()];
    twice += p[0] * q[1] - p[1] * q[0];
  }
  return std::abs(twice);
}

/// Draws the borders of the regions in one face after another.
class BorderTracer {
 public:
  BorderTracer(const Mesh& mesh, VoronoiRegions& regions) : mesh_(mesh), regions_(regions), builder_(mesh) {}

  void trace(Index face, const std::vector<FaceSite>& sites) {
    for (std::size_t i = 0; i < sites.size(); ++i) {
      for (std::size_t j = i + 1; j < sites.size(); ++j) trace_pair(face, sites, i, j);
    }
  }
  SurfaceLines take() { return builder_.take(); }

 private:
  static std::uint64_t line_of(Index first, Index second) {
    return static_cast<std::uint64_t>(first) << 32 | static_cast<std::uint64_t>(second);
  }

  /// An end of the line of a pair in a face: at a corner or on an edge.
  struct End {
    Barycentric at{};
    Index corner = no_index;
    Index edge = no_index;
    double t = 0.0;
  };

  Index point_of(const End& end, std::uint64_t line) {
    return end.corner != no_index ? builder_.at_vertex(end.corner, line)
                                  : builder_.on_edge(end.edge, end.t, line);
  }

  /// Ends of the line on which the lead vanishes; fewer than two if it does not cross the face.
  int find_ends(Index face, const std::array<double, 3>& lead, End* ends) const {
    const auto& corners = mesh_.face_vertices(face);
    int count = 0;
    const auto zeros = std::count(lead.begin(), lead.end(), 0.0);
    if (zeros == 3) return 0;
    for (int i = 0; i < 3; ++i) {
      if (lead[i] == 0.0) {
        // A line along an edge belongs to the face on whose side the second site is nearer.
        if (zeros == 2 && lead[0] + lead[1] + lead[2] > 0.0) return 0;
        End end;
        end.at[i] = 1.0;
        end.corner = corners[i];
        ends[count++] = end;
        continue;
      }
      const int j = (i + 1) % 3;
      if (lead[i] * lead[j] >= 0.0) continue;
      End end;
      end.edge = mesh_.edge_of(3 * face + i);
      // Computed from the first vertex of the edge, so that both faces get the same number.
      const bool along = mesh_.edge_vertices(end.edge)[0] == corners[i];
      const double first = along ? lead[i] : lead[j];
      const double second = along ? lead[j] : lead[i];
      end.t = first / (first - second);
      end.at[i] = along ? 1.0 - end.t : end.t;
      end.at[j] = along ? end.t : 1.0 - end.t;
      ends[count++] = end;
    }
    return count;
  }

  void trace_pair(Index face, const std::vector<FaceSite>& sites, std::size_t i, std::size_t j) {
    const FaceSite& s = sites[i];
    const FaceSite& t = sites[j];
    std::array<double, 3> lead{};  // of t over s: positive where s is nearer
    for (int c = 0; c < 3; ++c) lead[c] = t.square[c] - s.square[c];
    End ends[3];
    if (find_ends(face, lead, ends) != 2) return;
    // What other regions leave of the line.
    double from = 0.0;
    double to = 1.0;
    Index from_site = no_index;
    Index to_site = no_index;
    for (std::size_t k = 0; k < sites.size() && from < to; ++k) {
      if (k == i || k == j) continue;
      const double a = value_at(sites[k].square, ends[0].at) - value_at(s.square, ends[0].at);
      const double b = value_at(sites[k].square, ends[1].at) - value_at(s.square, ends[1].at);
      if (a >= 0.0 && b >= 0.0) continue;
      if (a <= 0.0 && b <= 0.0) return;
      const double zero = a / (a - b);
      if (a < 0.0 && zero > from) {
        from = zero;
        from_site = sites[k].site;
      } else if (b < 0.0 && zero < to) {
        to = zero;
        to_site = sites[k].site;
      }
    }
    if (!(from < to)) return;
    const std::uint64_t line = line_of(s.site, t.site);
    auto end_point = [&](double at, Index site, const End& end) {
      if (site == no_index) return point_of(end, line);
      Barycentric inside{};
      for (int c = 0; c < 3; ++c) inside[c] = ends[0].at[c] + at * (ends[1].at[c] - ends[0].at[c]);
      std::array<Index, 3> meeting{s.site, t.site, site};
      std::sort(meeting.begin(), meeting.end());
      std::uint64_t corner = 0;
      for (Index m : meeting) corner = corner * 0x100000001B3ULL + static_cast<std::uint64_t>(m) + 1;
      return builder_.in_face(face, inside, corner);
    };
    const Index a = end_point(from, from_site, ends[0]);
    const Index b = end_point(to, to_site, ends[1]);
    if (builder_.add_segment(a, b)) regions_.border_regions.push_back({s.site, t.site});
  }

  const Mesh& mesh_;
  VoronoiRegions& regions_;
  LineBuilder builder_;
};

/// The site of least distance at each vertex; of equal ones the first.
void label_vertices(const Candidates& candidates, VoronoiRegions& regions) {
  for (Index v = 0; v < static_cast<Index>(regions.vertex_region.size()); ++v) {
    for (const SiteDistance& entry : candidates.at(v)) {
      if (entry.distance >= regions.distance[v]) continue;
      regions.distance[v] = entry.distance;
      regions.vertex_region[v] = entry.site;
    }
  }
}

}  // namespace

VoronoiRegions voronoi_regions(FieldTeam& team, std::span<const Index> sites, const Progress& progress) {
  const Mesh& mesh = team.mesh();
  if (sites.empty()) throw InvalidInput("There is no point whose region could be found; name at least one.");
  require_vertices(mesh, sites, "Point");
  std::vector<Index> owners;
  std::unordered_map<Index, Index> seen;
  for (Index i = 0; i < static_cast<Index>(sites.size()); ++i) {
    if (seen.try_emplace(sites[i], i).second) owners.push_back(i);
  }
  const Candidates candidates = find_candidates(team, sites, owners, progress);

  VoronoiRegions regions;
  regions.vertex_region.assign(mesh.vertex_count(), no_index);
  regions.distance.assign(mesh.vertex_count(), unreachable);
  regions.face_region.assign(mesh.face_count(), no_index);
  regions.area.assign(sites.size(), 0.0);
  label_vertices(candidates, regions);
  BorderTracer tracer(mesh, regions);
  std::vector<FaceSite> in_face;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    sites_of_face(mesh, candidates, f, in_face);
    double least = unreachable;
    for (const FaceSite& site : in_face) {
      const double at_centre = site.square[0] + site.square[1] + site.square[2];
      if (at_centre >= least) continue;
      least = at_centre;
      regions.face_region[f] = site.site;
    }
    const double area = mesh.face_area(f);
    if (in_face.size() < 2) {
      if (in_face.empty()) regions.face_region[f] = regions.vertex_region[mesh.face_vertices(f)[0]];
      if (regions.face_region[f] != no_index) regions.area[regions.face_region[f]] += area;
      continue;
    }
    for (std::size_t i = 0; i < in_face.size(); ++i) {
      regions.area[in_face[i].site] += area * share_of_face(in_face, i);
    }
    tracer.trace(f, in_face);
  }
  regions.borders = tracer.take();
  return regions;
}

}  // namespace vorogeo
