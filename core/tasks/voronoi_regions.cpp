// Geodesic Voronoi regions, their borders, and the faces that these divide.
#include "tasks/voronoi_regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <tuple>

#include "mesh/mesh_input.h"
#include "support/error.h"
#include "support/lists.h"
#include "support/parallel.h"

namespace vorogeo {

// ---- Triangles cut by the lines on which two squared distances are equal

namespace {

using Barycentric = std::array<double, 3>;

double value_at(const std::array<double, 3>& corners, const Barycentric& at) {
  return corners[0] * at[0] + corners[1] * at[1] + corners[2] * at[2];
}

std::uint64_t line_of(Index first, Index second) {
  return static_cast<std::uint64_t>(first) << 32 | static_cast<std::uint64_t>(second);
}

}  // namespace

double share_of_face(const std::vector<FaceSite>& sites, std::size_t mine) {
  std::vector<Barycentric> polygon{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::vector<Barycentric> cut;
  for (std::size_t other = 0; other < sites.size() && !polygon.empty(); ++other) {
    if (other == mine) continue;
    std::array<double, 3> lead{};  // difference of the squared distances: the other's minus this one's
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
    // If two sites tie on the whole face, the first owns it.
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

void BorderTracer::trace(Index face, const std::vector<FaceSite>& sites) {
  for (std::size_t i = 0; i < sites.size(); ++i) {
    for (std::size_t j = i + 1; j < sites.size(); ++j) trace_pair(face, sites, i, j);
  }
}

Index BorderTracer::point_of(const End& end, std::uint64_t line) {
  return end.corner != no_index ? builder_.at_vertex(end.corner, line)
                                : builder_.on_edge(end.edge, end.t, line);
}

/// Finds the ends of the line on which the lead vanishes; fewer than two if it does not cross the face.
int BorderTracer::find_ends(Index face, const std::array<double, 3>& lead, End* ends) const {
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

void BorderTracer::trace_pair(Index face, const std::vector<FaceSite>& sites, std::size_t i, std::size_t j) {
  const FaceSite& s = sites[i];
  const FaceSite& t = sites[j];
  std::array<double, 3> lead{};  // squared distance from t minus that from s: positive where s is nearer
  for (int c = 0; c < 3; ++c) lead[c] = t.square[c] - s.square[c];
  End ends[3];
  if (find_ends(face, lead, ends) != 2) return;
  // The part of the line that no other region takes.
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
  if (builder_.add_segment(a, b)) border_regions_.push_back({s.site, t.site});
}

// ---- Corners of parts shared by neighbouring faces, so that borders go on over edges

namespace {

/// Numbers the corners of parts: a vertex, a point of an edge, or a point in a face once each.
class CornerNumbers {
 public:
  explicit CornerNumbers(const Mesh& mesh) : mesh_(mesh) {}

  /// `steps`: the weights, times per_side.
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

DividedFaces::DividedFaces(Workers& workers, const PointList& sites, std::vector<ContestedFace> contested,
                           double radius, const Progress& progress)
    : contested_(std::move(contested)) {
  const Mesh& mesh = workers.mesh();
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
  parts_ = std::make_shared<const Mesh>(positions_of(mesh, corners.points), faces);
  at_.resize(corners.points.size());
  distance_.resize(corners.points.size());
  std::vector<std::pair<Index, std::vector<Index>>> asked(corners_of_site.begin(), corners_of_site.end());
  std::vector<std::vector<double>> found(asked.size());
  const PointList all = points_on(mesh, corners.points, "Point");
  parallel_for(asked.size(), workers.threads(), progress, "Voronoi regions", [&](std::size_t i, int worker) {
    auto& numbers = asked[i].second;
    sort_once(numbers);
    std::vector<SurfacePoint> points;
    for (Index number : numbers) points.push_back(all[number]);
    found[i] = workers.distances(sites[asked[i].first], points, radius, worker);
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

// ---- First the sites that may own a part of the faces at each vertex, then the regions face by face

namespace {

struct SiteDistance {
  Index vertex;
  Index site;
  double distance;
};

/// For each vertex the sites that may own a part of one of its faces, with their distances; sorted by site.
struct Candidates {
  std::vector<std::size_t> begin;
  std::vector<SiteDistance> entries;
  std::span<const SiteDistance> at(Index vertex) const {
    return std::span(entries).subspan(begin[vertex], begin[vertex + 1] - begin[vertex]);
  }
  /// By vertex, in the field of all sites at once.
  std::vector<double> distance;
  std::vector<Index> nearest;
};

/// The longest side of the faces at each vertex, measured in the face: in a dear one, points are that far
/// apart. By the triangle inequality, a site that owns a point of a face is at the face's corners at most
/// twice this farther than the nearest site.
std::vector<double> reach_of_vertices(const Mesh& mesh) {
  std::vector<double> reach(mesh.vertex_count(), 0.0);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    double longest = 0.0;
    for (int i = 0; i < 3; ++i) longest = std::max(longest, mesh.side_length(3 * f + i));
    for (Index v : mesh.face_vertices(f)) reach[v] = std::max(reach[v], longest);
  }
  return reach;
}

Candidates find_candidates(Workers& workers, const PointList& sites, const std::vector<Index>& owners,
                           double& radius, const Progress& progress) {
  const Mesh& mesh = workers.mesh();
  std::vector<SurfacePoint> different;
  for (Index site : owners) different.push_back(sites[site]);
  Candidates result;
  result.distance = workers.field_on_all_threads(PointList(different), unreachable, &result.nearest);
  for (Index& site : result.nearest) {
    if (site != no_index) site = owners[site];
  }
  const auto& nearest = result.distance;
  const auto reach = reach_of_vertices(mesh);
  std::vector<double> bound(mesh.vertex_count(), -1.0);
  radius = 0.0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (nearest[v] == unreachable) continue;
    bound[v] = bounded_field_slack * (nearest[v] + 2.0 * reach[v]);
    radius = std::max(radius, bound[v]);
  }
  std::vector<std::vector<SiteDistance>> of_site(owners.size());
  parallel_for(owners.size(), workers.threads(), progress, "Voronoi regions", [&](std::size_t i, int worker) {
    const Index site = owners[i];
    const auto field = workers.field(sites[site], radius, worker);
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      if (field[v] <= bound[v]) of_site[i].push_back({v, site, field[v]});
    }
  });
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

/// The barycentric weights, up to a factor, of the centre of a face, or of the centre of the split face of
/// which it is the central part.
std::array<double, 3> centre_weights(const Mesh& mesh, Index face) {
  constexpr std::array<double, 3> own{1.0, 1.0, 1.0};
  if (!mesh.has_split_faces() || mesh.is_bridge(face)) return own;
  constexpr double third = 1.0 / 3.0;
  const auto centre = InputMap(mesh).in_face(mesh.input_face(face), {third, third, third});
  return centre->face == face ? centre->barycentric : own;
}

/// The site of least distance at each vertex; of equal ones, the first. Where an index errs so much that no
/// site's own field is near the field of all sites, that field's site.
void label_vertices(const Candidates& candidates, VoronoiRegions& regions) {
  for (Index v = 0; v < static_cast<Index>(regions.vertex_region.size()); ++v) {
    if (candidates.at(v).empty()) {
      regions.distance[v] = candidates.distance[v];
      regions.vertex_region[v] = candidates.nearest[v];
    }
    for (const SiteDistance& entry : candidates.at(v)) {
      if (entry.distance >= regions.distance[v]) continue;
      regions.distance[v] = entry.distance;
      regions.vertex_region[v] = entry.site;
    }
  }
}

/// Adds the areas and borders in contested faces where the metric jumps, and labels them by their centres.
void divide_faces(const DividedFaces& divided, const Mesh& mesh, VoronoiRegions& regions) {
  BorderTracer tracer(divided.parts(), regions.border_regions);
  for (Index part = 0; part < divided.parts().face_count(); ++part) {
    const Index face = divided.contested()[part / DividedFaces::parts_per_face].face;
    const auto sites = divided.sites_of(part);
    const double area = mesh.face_area(face) / DividedFaces::parts_per_face;
    for (std::size_t i = 0; i < sites.size(); ++i) {
      regions.area[sites[i].site] += area * share_of_face(sites, i);
    }
    tracer.trace(part, sites);
    if (part % DividedFaces::parts_per_face != DividedFaces::central_part || sites.empty()) continue;
    regions.face_region[face] = std::ranges::min_element(sites, {}, [](const FaceSite& site) {
                                  return site.square[0] + site.square[1] + site.square[2];
                                })->site;
  }
  regions.borders = tracer.take();
}

}  // namespace

VoronoiRegions voronoi_regions(Surface& surface, const PointList& given, const TaskOptions& options) {
  const Mesh& mesh = *surface.mesh();
  if (given.empty()) throw InvalidInput("There is no point whose region could be found; name at least one.");
  const PointList sites = points_on(mesh, given, "Point");
  std::vector<Index> owners;
  std::map<SurfacePoint, Index, std::less<>> seen;
  for (Index i = 0; i < static_cast<Index>(sites.size()); ++i) {
    if (seen.try_emplace(sites[i], i).second) owners.push_back(i);
  }
  // One field over the whole surface, then one for each region.
  const auto count = static_cast<double>(owners.size());
  const double reach = (1.0 + count * reach_of_regions(count)) / (1.0 + count);
  Workers workers(surface, options, 1.0 + count, reach);
  const Progress& progress = workers.progress();
  double radius = 0.0;
  const bool jumps = mesh.metric_jumps() || mesh.is_one_way();
  const Candidates candidates =
      find_candidates(workers, sites, owners, radius, jumps ? progress.part(0.0, 0.5) : progress);

  VoronoiRegions regions;
  regions.vertex_region.assign(mesh.vertex_count(), no_index);
  regions.distance.assign(mesh.vertex_count(), unreachable);
  regions.face_region.assign(mesh.face_count(), no_index);
  regions.area.assign(sites.size(), 0.0);
  label_vertices(candidates, regions);
  BorderTracer tracer(mesh, regions.border_regions);
  std::vector<FaceSite> in_face;
  std::vector<ContestedFace> contested;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    sites_of_face(mesh, candidates, f, in_face);
    const auto& weights = centre_weights(mesh, f);
    double least = unreachable;
    for (const FaceSite& site : in_face) {
      const double at_centre =
          weights[0] * site.square[0] + weights[1] * site.square[1] + weights[2] * site.square[2];
      if (at_centre >= least) continue;
      least = at_centre;
      regions.face_region[f] = site.site;
    }
    if (jumps && in_face.size() > 1) {
      contested.push_back({f, {}});
      for (const FaceSite& site : in_face) contested.back().sites.push_back(site.site);
      continue;
    }
    const double area = mesh.is_bridge(f) ? 0.0 : mesh.face_area(f);
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
  if (jumps) {
    divide_faces(DividedFaces(workers, sites, std::move(contested), 2.0 * radius, progress.part(0.5, 1.0)),
                 mesh, regions);
  } else {
    regions.borders = tracer.take();
  }
  return regions;
}

}  // namespace vorogeo
