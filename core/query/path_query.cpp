// From end points to a path: near ends by propagation, the others through the index.
#include "query/path_query.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "index/index_data.h"
#include "index/local_tables.h"
#include "mesh/face_distance.h"
#include "query/exact_pair.h"
#include "query/path_hops.h"
#include "query/path_refine.h"
#include "query/route_unfolding.h"
#include "query/router.h"
#include "query/work_points.h"

namespace vorogeo {

namespace {

/// A length from the tables, this much longer, is an upper bound in spite of their precision.
constexpr double estimate_slack = 1.0 + 1e-3;
/// Rounding of lengths summed along different ways.
constexpr double rounding = 1e-9;
/// A refined path that is this much longer (relative) than the index's distance has probably taken a wrong
/// way: exact propagation decides. Measured: of the paths that are not shortest, what such ones add to the
/// mean error is most of it, while few paths are concerned (docs/paths.md).
constexpr double suspicious = 2e-4;

double distance_between(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// An end point in the work mesh.
struct End {
  SurfacePoint point;
  Index vertex = no_index;  ///< the point itself or the nearest corner of its face
  double beside = 0.0;      ///< distance of that vertex
  std::vector<Index> patches;
};

/// A path and how it was found.
struct Found {
  SurfacePath path;
  bool certified = false;   ///< proven to be a shortest one
  bool propagated = false;  ///< by exact propagation with the bounds of the index
};

}  // namespace

struct PathQuery::State {
  explicit State(std::shared_ptr<const GeodesicIndex> shared_index)
      : index(std::move(shared_index)),
        data(index->data()),
        solver(data.geometry),
        halo(*data.work.mesh, data.work.second_layer, data.second.patch_count),
        router(data),
        refiner(*data.geometry),
        unfolder(data),
        bounds(data) {
    const Mesh& mesh = *data.work.mesh;
    for (Index e = 0; e < mesh.edge_count(); ++e) branches = branches || mesh.edge_face_count(e) > 2;
  }

  End end_at(const SurfacePoint& point) const;
  Index component(const SurfacePoint& point) const {
    return data.mesh->component(point.is_vertex() ? point.vertex
                                                  : data.mesh->face_vertices(point.face).front());
  }
  bool connected(const SurfacePoint& source, const SurfacePoint& target) const {
    auto on_surface = [&](const SurfacePoint& p) {
      return !p.is_vertex() || data.work.work_vertex[p.vertex] != no_index;
    };
    return on_surface(source) && on_surface(target) && component(source) == component(target);
  }
  /// The border nodes of the end's patch with their distances from it.
  RouteEnd starts_of(const End& end) const;
  bool near(const End& a, const End& b) const;
  /// Of an end in a face.
  Index patch_of(const End& end) const {
    return end.point.is_vertex() ? no_index : data.work.second_layer[end.point.face];
  }
  GraphRoute route(const End& from, const End& to);
  SurfacePath run(const End& from, const End& to, const ExactLimits& limits);
  SurfacePath path_nearby(const End& from, const End& to, double estimate);
  SurfacePath path_by_chain(const End& from, const End& to, const GraphRoute& way);
  SurfacePath shorter_path(const End& from, const End& to, double length, bool by_index);
  double expected_length(const End& from, const End& to, const GraphRoute& way);
  Found path(const End& from, const End& to);

  std::shared_ptr<const GeodesicIndex> index;
  const IndexData& data;
  ExactSolver solver;
  Halo halo;
  Router router;
  PathRefiner refiner;
  FaceStrip strip;
  RouteUnfolder unfolder;
  RemainingBounds bounds;
  /// Whether an edge has more than two faces: crossings are unfolded as on a surface, so the margin of the
  /// bounds does not hold there.
  bool branches = false;
};

PathQuery::PathQuery(std::shared_ptr<const GeodesicIndex> index)
    : state_(std::make_unique<State>(std::move(index))) {}
PathQuery::~PathQuery() = default;
PathQuery::PathQuery(PathQuery&&) noexcept = default;
PathQuery& PathQuery::operator=(PathQuery&&) noexcept = default;
const GeodesicIndex& PathQuery::index() const { return *state_->index; }

End PathQuery::State::end_at(const SurfacePoint& user) const {
  const Mesh& mesh = *data.work.mesh;
  End end;
  end.point = work_point(data, user);
  auto add = [&](Index patch) {
    if (std::ranges::find(end.patches, patch) == end.patches.end()) end.patches.push_back(patch);
  };
  if (end.point.is_vertex()) {
    end.vertex = end.point.vertex;
  } else {
    const Point at = position_of(mesh, end.point);
    end.beside = unreachable;
    for (Index v : mesh.face_vertices(end.point.face)) {
      const double beside = distance_between(at, mesh.position(v));
      if (beside < end.beside) {
        end.beside = beside;
        end.vertex = v;
      }
    }
  }
  for_each_face_at(mesh, end.point,
                   [&](Index face, const std::array<double, 3>&) { add(data.work.second_layer[face]); });
  return end;
}

/// Whether a patch of one end is or touches a patch of the other.
bool PathQuery::State::near(const End& a, const End& b) const {
  auto is_of_b = [&](Index p) { return std::ranges::find(b.patches, p) != b.patches.end(); };
  return std::ranges::any_of(a.patches, [&](Index p) {
    if (is_of_b(p)) return true;
    return std::ranges::any_of(data.second.nodes(p), [&](Index node) {
      return std::ranges::any_of(data.second.patches_of(node),
                                 [&](const PatchRow& at) { return is_of_b(at.patch); });
    });
  });
}

RouteEnd PathQuery::State::starts_of(const End& end) const {
  RouteEnd result;
  if (end.point.is_vertex()) {
    route_end(data, end.vertex, result);
    return result;
  }
  result.patch = data.work.second_layer[end.point.face];
  const auto nodes = data.second.nodes(result.patch);
  result.parents.push_back(data.partition.parent[result.patch]);
  const Mesh& mesh = *data.work.mesh;
  std::array<Index, 3> column{};
  for (int k = 0; k < 3; ++k) {
    column[k] = column_in_patch(data, result.patch, mesh.face_vertices(end.point.face)[k]);
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    std::array<double, 3> corners{};
    for (int k = 0; k < 3; ++k) {
      corners[k] = data.second.distance(result.patch, static_cast<Index>(i), column[k]);
    }
    const double distance = distance_in_face(mesh, end.point.face, end.point.barycentric, corners);
    if (distance < unreachable) result.starts.push_back({nodes[i], distance});
  }
  return result;
}

GraphRoute PathQuery::State::route(const End& from, const End& to) {
  const RouteEnd a = starts_of(from);
  const RouteEnd b = starts_of(to);
  GraphRoute best;
  router.route(a, b, best);
  return best;
}

/// One propagation and the path it finds; without points if there is none within the limits.
SurfacePath PathQuery::State::run(const End& from, const End& to, const ExactLimits& limits) {
  const ExactSource source{from.point};
  ExactLimits corridor = limits;
  corridor.corridor_point = &to.point;
  solver.run(std::span(&source, 1), corridor);
  SurfacePath path = solver.path_to_source(to.point);
  if (path.points.empty()) path.length = unreachable;
  std::ranges::reverse(path.points);
  return path;
}

/// Exact: first in the patches of both ends and their halo; if a path could have left them, everywhere.
SurfacePath PathQuery::State::path_nearby(const End& from, const End& to, double estimate) {
  std::vector<Index> patches = from.patches;
  for (Index p : to.patches) {
    if (std::ranges::find(patches, p) == patches.end()) patches.push_back(p);
  }
  halo.surround(patches);
  ExactLimits limits;
  limits.max_distance = estimate;
  limits.face_allowed = halo.mask();
  SurfacePath found = run(from, to, limits);
  if (found.length <= solver.barrier_distance() && found.length < unreachable) return found;
  limits.face_allowed = {};
  limits.max_distance = std::min(found.length, estimate) * (1.0 + rounding);
  SurfacePath better = run(from, to, limits);
  return better.length <= found.length ? better : found;
}

/// The way of the index, refined; without points if the tables do not lead all the way.
SurfacePath PathQuery::State::path_by_chain(const End& from, const End& to, const GraphRoute& way) {
  SurfacePath none;
  none.length = unreachable;
  if (way.length == unreachable) return none;
  strip.source = from.point;
  strip.target = to.point;
  const PathChain chain = chain_of_route(data, way, from.vertex, to.vertex, patch_of(from), patch_of(to));
  if (!strip_along_chain(data, chain, strip)) return none;
  refiner.refine(strip);
  return refiner.path();
}

/// The index's distance along a route; of points in faces from those of their corners. Unreachable where the
/// tables of the route do not hold the corners.
double PathQuery::State::expected_length(const End& from, const End& to, const GraphRoute& way) {
  const Mesh& mesh = *data.work.mesh;
  auto between = [&](const End& end, auto&& of_vertex) {
    if (end.point.is_vertex()) return of_vertex(end.point.vertex);
    std::array<double, 3> corners{};
    for (int i = 0; i < 3; ++i) corners[i] = of_vertex(mesh.face_vertices(end.point.face)[i]);
    return distance_in_face(mesh, end.point.face, end.point.barycentric, corners);
  };
  return between(from, [&](Index source) {
    return between(
        to, [&](Index target) { return unfolder.length(way, source, target, patch_of(from), patch_of(to)); });
  });
}

/// A path shorter than `length` by exact propagation; without points if there is none. `by_index`: within the
/// bounds that the index gives.
SurfacePath PathQuery::State::shorter_path(const End& from, const End& to, double length, bool by_index) {
  ExactLimits limits;
  limits.max_distance = length * (1.0 + rounding);
  if (by_index) limits.least_remaining = bounds.fill(starts_of(from), starts_of(to), to.patches, length);
  return run(from, to, limits);
}

Found PathQuery::State::path(const End& from, const End& to) {
  Found found;
  const GraphRoute way = from.vertex == to.vertex ? GraphRoute{0.0, {}, {}} : route(from, to);
  const double estimate = (from.beside + way.length + to.beside) * estimate_slack;
  if (near(from, to)) {
    found.certified = true;
    found.path = path_nearby(from, to, estimate);
  } else {
    found.path = path_by_chain(from, to, way);
    if (found.path.points.empty()) {
      // The tables did not lead all the way: exact, within the length that the graph gives.
      found.certified = true;
      found.path = shorter_path(from, to, estimate, false);
    } else if (found.path.length > expected_length(from, to, way) * (1.0 + suspicious)) {
      found.certified = branches;
      found.propagated = true;
      SurfacePath better = shorter_path(from, to, found.path.length, !branches);
      if (better.length < found.path.length) found.path = std::move(better);
    }
  }
  if (found.path.points.empty()) {
    // On faces without width, lengths may be off by more than the slack.
    found.certified = true;
    found.path = run(from, to, {});
  }
  return found;
}

SurfacePath PathQuery::path(const SurfacePoint& source, const SurfacePoint& target) {
  State& state = *state_;
  const SurfacePoint s = validated(*state.data.mesh, source);
  const SurfacePoint t = validated(*state.data.mesh, target);
  SurfacePath none;
  none.length = unreachable;
  if (!state.connected(s, t)) return none;
  if (position_of(*state.data.mesh, s) == position_of(*state.data.mesh, t)) return {{s, t}, 0.0};
  return user_path(state.data, state.path(state.end_at(s), state.end_at(t)).path);
}

ExactPath PathQuery::exact_path(const SurfacePoint& source, const SurfacePoint& target, bool certify) {
  State& state = *state_;
  const SurfacePoint s = validated(*state.data.mesh, source);
  const SurfacePoint t = validated(*state.data.mesh, target);
  ExactPath result;
  result.path.length = unreachable;
  result.certified = true;
  if (!state.connected(s, t)) return result;
  const End from = state.end_at(s);
  const End to = state.end_at(t);
  Found found = state.path(from, to);
  result.certified = found.certified;
  if (!found.certified && (certify || !found.propagated)) {
    result.certified = certify || state.branches;
    SurfacePath better = state.shorter_path(from, to, found.path.length, !result.certified);
    if (better.length < found.path.length) found.path = std::move(better);
  }
  result.path = user_path(state.data, found.path);
  return result;
}

}  // namespace vorogeo
