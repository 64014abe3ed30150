// From end points to a path: near ends by propagation, the others through the index.
#include "query/path_query.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "index/index_data.h"
#include "index/local_tables.h"
#include "mesh/face_distance.h"
#include "query/exact_pair.h"
#include "query/path_corridor.h"
#include "query/path_ends.h"
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
/// way: exact propagation with the bounds of the index decides.
constexpr double suspicious = 2e-4;
/// Where to look for a shorter path beside the refined one: if it is longer than the index's distance by so
/// much (relative) on an even surface, by less for each radian of roughness, but no less than that. Measured:
/// on rough surfaces more paths have a shorter one close beside them, and the index's distance is itself
/// longer (docs/paths.md).
constexpr double doubtful_if_even = 2e-4;
constexpr double doubtful_by_roughness = 1.8e-2;
constexpr double least_doubtful = -1.5e-4;
/// Such shorter paths hardly ever leave so many rings of vertices around the strip.
constexpr int rings_beside = 2;

/// A path and how it was found.
struct Found {
  SurfacePath path;
  bool certified = false;  ///< proven to be a shortest one
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
        surroundings(*data.work.mesh),
        unfolder(data),
        bounds(data) {
    const Mesh& mesh = *data.work.mesh;
    for (Index e = 0; e < mesh.edge_count(); ++e) branches = branches || mesh.edge_face_count(e) > 2;
  }

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
  GraphRoute route(const PathEnd& from, const PathEnd& to);
  SurfacePath run(const PathEnd& from, const PathEnd& to, const ExactLimits& limits);
  SurfacePath path_nearby(const PathEnd& from, const PathEnd& to, double estimate);
  SurfacePath path_by_chain(const PathEnd& from, const PathEnd& to, const GraphRoute& way);
  SurfacePath path_beside(const PathEnd& from, const PathEnd& to, double length);
  SurfacePath shorter_path(const PathEnd& from, const PathEnd& to, double length, bool by_index);
  double expected_length(const PathEnd& from, const PathEnd& to, const GraphRoute& way);
  void improve(const PathEnd& from, const PathEnd& to, double expected, Found& found);
  Found path(const PathEnd& from, const PathEnd& to, bool thorough);

  std::shared_ptr<const GeodesicIndex> index;
  const IndexData& data;
  ExactSolver solver;
  Halo halo;
  Router router;
  PathRefiner refiner;
  PathCorridor surroundings;
  FaceStrip strip;
  RouteUnfolder unfolder;
  RemainingBounds bounds;
  /// Whether an edge has more than two faces: crossings are unfolded as on a surface, so the margin of the
  /// bounds does not hold there.
  bool branches = false;
  std::shared_ptr<const ExactLandmarks> landmarks;
};

PathQuery::PathQuery(std::shared_ptr<const GeodesicIndex> index)
    : state_(std::make_unique<State>(std::move(index))) {}
PathQuery::~PathQuery() = default;
PathQuery::PathQuery(PathQuery&&) noexcept = default;
PathQuery& PathQuery::operator=(PathQuery&&) noexcept = default;
const GeodesicIndex& PathQuery::index() const { return *state_->index; }
void PathQuery::use_landmarks(std::shared_ptr<const ExactLandmarks> landmarks) {
  state_->landmarks = std::move(landmarks);
}

GraphRoute PathQuery::State::route(const PathEnd& from, const PathEnd& to) {
  const RouteEnd a = route_end_of(data, from);
  const RouteEnd b = route_end_of(data, to);
  GraphRoute best;
  router.route(a, b, best);
  return best;
}

/// One propagation and the path it finds; without points if there is none within the limits.
SurfacePath PathQuery::State::run(const PathEnd& from, const PathEnd& to, const ExactLimits& limits) {
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
SurfacePath PathQuery::State::path_nearby(const PathEnd& from, const PathEnd& to, double estimate) {
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
SurfacePath PathQuery::State::path_by_chain(const PathEnd& from, const PathEnd& to, const GraphRoute& way) {
  SurfacePath none;
  none.length = unreachable;
  if (way.length == unreachable) return none;
  strip.source = from.point;
  strip.target = to.point;
  const PathChain chain = chain_of_route(data, way, from.vertex, to.vertex, from.patch(data), to.patch(data));
  if (!strip_along_chain(data, chain, strip)) return none;
  refiner.refine(strip);
  return refiner.path();
}

/// The index's distance along a route; of points in faces from those of their corners. Unreachable where the
/// tables of the route do not hold the corners.
double PathQuery::State::expected_length(const PathEnd& from, const PathEnd& to, const GraphRoute& way) {
  const Mesh& mesh = *data.work.mesh;
  auto between = [&](const PathEnd& end, auto&& of_vertex) {
    if (end.point.is_vertex()) return of_vertex(end.point.vertex);
    std::array<double, 3> corners{};
    for (int i = 0; i < 3; ++i) corners[i] = of_vertex(mesh.face_vertices(end.point.face)[i]);
    return distance_in_face(mesh, end.point.face, end.point.barycentric, corners);
  };
  return between(from, [&](Index source) {
    return between(to, [&](Index target) {
      return unfolder.length(way, source, target, from.patch(data), to.patch(data));
    });
  });
}

/// A path shorter than `length` in the faces around the one last refined; without points if there is none.
SurfacePath PathQuery::State::path_beside(const PathEnd& from, const PathEnd& to, double length) {
  ExactLimits limits;
  limits.max_distance = length * (1.0 + rounding);
  limits.face_allowed = surroundings.surround(refiner.line(), rings_beside);
  return run(from, to, limits);
}

/// A path shorter than `length` by exact propagation; without points if there is none. `by_index`: within the
/// bounds that the index gives.
SurfacePath PathQuery::State::shorter_path(const PathEnd& from, const PathEnd& to, double length,
                                           bool by_index) {
  ExactLimits limits;
  limits.max_distance = length * (1.0 + rounding);
  if (by_index) {
    limits.least_remaining =
        bounds.fill(route_end_of(data, from), route_end_of(data, to), to.patches, length);
  } else {
    limits.landmarks = landmarks.get();
  }
  return run(from, to, limits);
}

/// Looks for a shorter path than the refined one where that may have taken a wrong way.
void PathQuery::State::improve(const PathEnd& from, const PathEnd& to, double expected, Found& found) {
  const double doubtful = std::max(
      least_doubtful, doubtful_if_even - doubtful_by_roughness * roughness(*data.work.mesh, refiner.line()));
  if (found.path.length > expected * (1.0 + doubtful)) {
    SurfacePath better = path_beside(from, to, found.path.length);
    if (better.length < found.path.length) found.path = std::move(better);
  }
  if (found.path.length > expected * (1.0 + suspicious)) {
    found.certified = branches;
    SurfacePath better = shorter_path(from, to, found.path.length, !branches);
    if (better.length < found.path.length) found.path = std::move(better);
  }
}

/// `thorough`: also look for shorter paths than the first one found.
Found PathQuery::State::path(const PathEnd& from, const PathEnd& to, bool thorough) {
  Found found;
  const GraphRoute way = from.vertex == to.vertex ? GraphRoute{0.0, {}, {}} : route(from, to);
  const double estimate = (from.beside + way.length + to.beside) * estimate_slack;
  if (are_near(data, from, to)) {
    found.certified = true;
    found.path = path_nearby(from, to, estimate);
  } else {
    found.path = path_by_chain(from, to, way);
    if (found.path.points.empty()) {
      // The tables did not lead all the way: exact, within the length that the graph gives.
      found.certified = true;
      found.path = shorter_path(from, to, estimate, false);
    } else if (thorough) {
      improve(from, to, expected_length(from, to, way), found);
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
  return user_path(state.data, state.path(path_end(state.data, s), path_end(state.data, t), true).path);
}

ExactPath PathQuery::exact_path(const SurfacePoint& source, const SurfacePoint& target, bool certify) {
  State& state = *state_;
  const SurfacePoint s = validated(*state.data.mesh, source);
  const SurfacePoint t = validated(*state.data.mesh, target);
  ExactPath result;
  result.path.length = unreachable;
  result.certified = true;
  if (!state.connected(s, t)) return result;
  const PathEnd from = path_end(state.data, s);
  const PathEnd to = path_end(state.data, t);
  Found found = state.path(from, to, false);
  result.certified = found.certified;
  if (!found.certified) {
    result.certified = certify || state.branches;
    SurfacePath better = state.shorter_path(from, to, found.path.length, !result.certified);
    if (better.length < found.path.length) found.path = std::move(better);
  }
  result.path = user_path(state.data, found.path);
  return result;
}

}  // namespace vorogeo
