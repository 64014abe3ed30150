// First the sites that may own a part of the faces at each vertex, then the regions face by face.
#include "tasks/voronoi_regions.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>

#include "mesh/given_points.h"
#include "support/error.h"
#include "support/parallel.h"
#include "tasks/divided_faces.h"
#include "tasks/voronoi_borders.h"

namespace vorogeo {

namespace {

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

/// Longest side of the faces at each vertex, as long as in the face: within a dear one, it is what points are
/// apart. A site that owns a point of a face is, at the face's corners, at most twice this farther than the
/// nearest one, by the triangle inequality.
std::vector<double> reach_of_vertices(const Mesh& mesh) {
  std::vector<double> reach(mesh.vertex_count(), 0.0);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    double longest = 0.0;
    for (int i = 0; i < 3; ++i) longest = std::max(longest, mesh.side_length(3 * f + i));
    for (Index v : mesh.face_vertices(f)) reach[v] = std::max(reach[v], longest);
  }
  return reach;
}

Candidates find_candidates(FieldTeam& team, const PointList& sites, const std::vector<Index>& owners,
                           double& radius, const Progress& progress) {
  const Mesh& mesh = team.mesh();
  const auto nearest = team.field_on_all_threads(sites);
  const auto reach = reach_of_vertices(mesh);
  std::vector<double> bound(mesh.vertex_count(), -1.0);
  radius = 0.0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (nearest[v] == unreachable) continue;
    bound[v] = bounded_field_slack * (nearest[v] + 2.0 * reach[v]);
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

/// The weights of the corners in the centre of a face, or in that of the split face of which it is the
/// central part, up to a factor.
std::array<double, 3> centre_weights(const Mesh& mesh, Index face) {
  constexpr std::array<double, 3> own{1.0, 1.0, 1.0};
  if (!mesh.has_split_faces() || mesh.is_bridge(face)) return own;
  constexpr double third = 1.0 / 3.0;
  const SurfacePoint centre =
      point_in_given(mesh, first_part(mesh, mesh.input_face(face)), {third, third, third});
  return centre.face == face ? centre.barycentric : own;
}

/// The site of least distance at each vertex; of equal ones, the first.
void label_vertices(const Candidates& candidates, VoronoiRegions& regions) {
  for (Index v = 0; v < static_cast<Index>(regions.vertex_region.size()); ++v) {
    for (const SiteDistance& entry : candidates.at(v)) {
      if (entry.distance >= regions.distance[v]) continue;
      regions.distance[v] = entry.distance;
      regions.vertex_region[v] = entry.site;
    }
  }
}

/// Areas, borders and the labels of the centres of faces with several sites where the metric jumps.
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

VoronoiRegions voronoi_regions(FieldTeam& team, const PointList& given, const Progress& progress) {
  const Mesh& mesh = team.mesh();
  if (given.empty()) throw InvalidInput("There is no point whose region could be found; name at least one.");
  const PointList sites = points_on(mesh, given, "Point");
  std::vector<Index> owners;
  std::map<SurfacePoint, Index, std::less<>> seen;
  for (Index i = 0; i < static_cast<Index>(sites.size()); ++i) {
    if (seen.try_emplace(sites[i], i).second) owners.push_back(i);
  }
  double radius = 0.0;
  const bool jumps = mesh.metric_jumps();
  const Candidates candidates =
      find_candidates(team, sites, owners, radius, jumps ? progress.part(0.0, 0.5) : progress);

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
    divide_faces(DividedFaces(team, sites, std::move(contested), 2.0 * radius, progress.part(0.5, 1.0)), mesh,
                 regions);
  } else {
    regions.borders = tracer.take();
  }
  return regions;
}

}  // namespace vorogeo
