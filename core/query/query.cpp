// Passes each question on to the solver of its method.
#include "query/query.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "query/surface.h"

namespace vorogeo {

const char* name_of(Answer answer) {
  return std::array{"automatic", "index", "exact", "quick"}.at(static_cast<std::size_t>(answer));
}

PathQuery& Query::mesh_paths() {
  if (!mesh_paths_) mesh_paths_.emplace(surface_.geometry());
  return *mesh_paths_;
}

const IndexField& Query::index_field(std::span<const ExactSource> sources, double max_distance, int threads,
                                     bool wants_labels, const TangentFrame* directions) {
  if (!index_field_) index_field_.emplace(surface_.index()->data(), surface_.threads());
  index_field_->run(sources, max_distance, threads, wants_labels, directions);
  return *index_field_;
}

namespace {

/// Merge tolerance of quick fields (ExactLimits): time against mean errors of a twentieth of a percent.
constexpr double quick_tolerance = 5e-3;

}  // namespace

const LocalSolver& Query::solved(std::span<const ExactSource> sources, double max_distance, Answer by,
                                 int threads, bool distances_only, const Progress& progress) {
  ExactLimits limits;
  if (by == Answer::quick) {
    require_agreeing_faces(*surface_.mesh(), "Quick distances");
    limits.merge_tolerance = quick_tolerance;
  }
  limits.max_distance = max_distance;
  if (progress) {
    limits.progress = &progress;
    // A small mesh is done before the first report of the run, and a large one is laid out before it.
    const Watch watch(progress.part(0.0, 0.0), "Computing distances");
    if (!solver_) solver_.emplace(surface_.geometry());
  }
  limits.distances_only = distances_only;
  limits.threads = threads_for_field(*surface_.mesh(), threads);
  return solved(sources, limits);
}

const LocalSolver& Query::solved(std::span<const ExactSource> sources, const ExactLimits& limits) {
  if (!solver_) solver_.emplace(surface_.geometry());
  solver_->run(sources, limits);
  return *solver_;
}

namespace {

/// Sources for solvers, which know nothing of a potential (Mesh::potential), and what it adds to their
/// distances. As offsets must not be negative, the potential of a component counts from its highest source.
class Levelled {
 public:
  Levelled(const Mesh& mesh, std::span<const ExactSource> given, double greatest)
      : sources(given), limit(greatest), max_distance(greatest), mesh_(mesh) {
    if (!mesh.has_potential()) return;
    highest_.assign(static_cast<std::size_t>(mesh.component_count()), -unreachable);
    for (const auto& [point, offset] : given) {
      double& highest = highest_[component_of(mesh, point)];
      highest = std::max(highest, potential_at(mesh, point));
    }
    shifted_.assign(given.begin(), given.end());
    for (auto& [point, offset] : shifted_) offset -= rise(point);
    sources = shifted_;
    double deepest = 0.0;
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      if (highest_[mesh.component(v)] > -unreachable)
        deepest = std::min(deepest, rise(SurfacePoint::at_vertex(v)));
    }
    max_distance -= deepest;
  }
  /// The distance of a point, `unreachable` above the limit, by what the solver has found.
  double distance(const SurfacePoint& point, double found) const {
    if (found < unreachable && mesh_.has_potential()) found += rise(point);
    return found <= limit ? found : unreachable;
  }

  std::span<const ExactSource> sources;
  double limit;         ///< of distances
  double max_distance;  ///< of what the solver finds

 private:
  double rise(const SurfacePoint& point) const {
    return potential_at(mesh_, point) - highest_[component_of(mesh_, point)];
  }

  const Mesh& mesh_;
  std::vector<double> highest_;  ///< by component
  std::vector<ExactSource> shifted_;
};

/// The field that a solver has found in its last run.
template <class Solver>
std::vector<double> field_of(const Solver& solver, const Levelled& from, std::vector<Index>* labels) {
  const Index count = solver.mesh().vertex_count();
  std::vector<double> field(count, unreachable);
  if (labels != nullptr) labels->assign(count, no_index);
  for (Index v = 0; v < count; ++v) {
    const double distance = from.distance(SurfacePoint::at_vertex(v), solver.distance(v));
    if (!(distance < unreachable)) continue;
    field[v] = distance;
    if (labels != nullptr) (*labels)[v] = solver.nearest_source(v);
  }
  return field;
}

}  // namespace

std::vector<double> Query::field(std::span<const ExactSource> sources, double max_distance, Answer by,
                                 int threads, std::vector<Index>* labels, const Progress& progress) {
  const Levelled from(*surface_.mesh(), sources, max_distance);
  if (by == Answer::index) {
    const Watch watch(progress, "Geodesic distances");
    return field_of(index_field(sources, max_distance, threads, labels != nullptr), from, labels);
  }
  return field_of(solved(from.sources, from.max_distance, by, threads, true, progress), from, labels);
}

std::vector<double> Query::field_of_lines(std::span<const ExactSource> sources,
                                          std::span<const SourceSegment> segments, double max_distance,
                                          int threads, const Progress& progress) {
  const ExactLimits limits{.max_distance = max_distance,
                           .distances_only = true,
                           .threads = threads_for_field(*surface_.mesh(), threads),
                           .segments = segments,
                           .progress = progress ? &progress : nullptr};
  return field_of(solved(sources, limits), Levelled(*surface_.mesh(), sources, max_distance), nullptr);
}

std::vector<double> Query::distances(std::span<const ExactSource> sources, const PointList& targets,
                                     double max_distance, Answer by) {
  std::vector<double> result;
  result.reserve(targets.size());
  if (targets.only_vertices()) {
    const auto all = field(sources, max_distance, by, 1);
    for (const SurfacePoint& target : targets) result.push_back(all[target.vertex]);
    return result;
  }
  const auto distance_of = field_at_points(sources, max_distance, by);
  for (const SurfacePoint& target : targets) result.push_back(distance_of(target));
  return result;
}

std::function<double(const SurfacePoint&)> Query::field_at_points(std::span<const ExactSource> sources,
                                                                  double max_distance, Answer by) {
  const auto from = std::make_shared<const Levelled>(*surface_.mesh(), sources, max_distance);
  const auto read = [from](const auto& solver) {
    return
        [from, &solver](const SurfacePoint& point) { return from->distance(point, solver.distance(point)); };
  };
  if (by == Answer::index) return read(index_field(sources, max_distance, 1, false));
  return read(solved(from->sources, from->max_distance, by, 1, false));
}

double Query::distance(const SurfacePoint& source, const SurfacePoint& target, Answer by) {
  if (by == Answer::index && source.is_vertex() && target.is_vertex()) {
    if (!index_pairs_) index_pairs_.emplace(surface_.index()->data());
    return index_pairs_->distance(source.vertex, target.vertex);
  }
  return path(source, target, by, false, true).path.length;
}

namespace {

/// Adds the rise of a potential to the length of a path, which is that of a solver.
ExactPath raised(const Mesh& mesh, const SurfacePoint& source, const SurfacePoint& target, ExactPath path) {
  if (path.path.length < unreachable)
    path.path.length += potential_at(mesh, target) - potential_at(mesh, source);
  return path;
}

}  // namespace

ExactPath Query::path(const SurfacePoint& source, const SurfacePoint& target, Answer by, bool exact,
                      bool certify) {
  if (by != Answer::index) {
    return raised(*surface_.mesh(), source, target, mesh_paths().exact_path(source, target));
  }
  if (!index_paths_) index_paths_.emplace(surface_.index());
  if (!exact) return {index_paths_->path(source, target), false};
  const auto landmarks = surface_.landmarks();
  return index_paths_->exact_path(source, target, certify, landmarks.get());
}

namespace {

/// The user's frame on the inner surface: its faces have other numbers, so angles begin elsewhere.
class InnerFrame {
 public:
  InnerFrame(const IndexData& data, const TangentFrame& user)
      : frame_(*data.geometry->windows, data.surface.inner_point(user.point())) {
    const Index side = user.views().front().halfedge;
    const Index face = Mesh::face_of(side), inner_face = data.surface.face[face];
    const Index inner_side = 3 * inner_face + side % 3;
    sign_ = user.orientation(face) * frame_.orientation(inner_face);
    turned_ = user.angle_to(face, user.geometry().mesh->tail(side)) -
              sign_ * frame_.angle_to(inner_face, frame_.geometry().mesh->tail(inner_side));
  }

  const TangentFrame& frame() const { return frame_; }
  /// An angle of this frame in that of the user.
  double in_user_frame(double angle) const { return turned_ + sign_ * angle; }

 private:
  TangentFrame frame_;
  int sign_;
  double turned_;
};

/// The log map with vectors in a frame. leg(point): the angle at which the path to a target begins.
template <class Distance, class Leg>
LogMap vectors_to(const Mesh& mesh, const std::optional<PointList>& targets, const TangentFrame& frame,
                  const Distance& distance, const Leg& leg) {
  LogMap found;
  const auto add = [&](const auto& point) {
    found.distance.push_back(distance(point));
    found.vector.push_back(frame.vector(leg(point), found.distance.back()));
  };
  if (targets) {
    std::ranges::for_each(*targets, add);
  } else {
    for (Index v = 0; v < mesh.vertex_count(); ++v) add(v);
  }
  return found;
}

}  // namespace

LogMap Query::log_map(const TangentFrame& frame, const std::optional<PointList>& targets, double max_distance,
                      Answer by, int threads, const Progress& progress) {
  if (targets && targets->empty()) return {};
  const std::array source{ExactSource{frame.point()}};
  if (by == Answer::index) {
    const Watch watch(progress, "Geodesic directions");
    const InnerFrame inner(surface_.index()->data(), frame);
    const IndexField& field = index_field(source, max_distance, threads, false, &inner.frame());
    const auto distance = [&](const auto& point) {
      const double found = field.distance(point);
      return found <= max_distance ? found : unreachable;
    };
    return vectors_to(*surface_.mesh(), targets, frame, distance, [&](const auto& point) {
      return distance(point) < unreachable ? inner.in_user_frame(field.first_leg(point))
                                           : std::numeric_limits<double>::quiet_NaN();
    });
  }
  // Points in faces need windows there, which a run that ends at vertices may not have.
  const bool only_vertices = !targets || targets->only_vertices();
  const std::vector<Index> vertices = targets && only_vertices ? targets->vertices() : std::vector<Index>{};
  const LocalSolver& solver = solved(source, {.max_distance = max_distance,
                                              .targets = vertices,
                                              .distances_only = only_vertices,
                                              .threads = threads_for_field(*surface_.mesh(), threads),
                                              .directions = &frame,
                                              .progress = progress ? &progress : nullptr});
  return vectors_to(
      *surface_.mesh(), targets, frame, [&](const auto& point) { return solver.distance(point); },
      [&](const auto& point) { return solver.first_leg(point); });
}

std::vector<Turn> Query::first_turns(const PointList& targets) const {
  const auto geometry = surface_.geometry();
  // All paths through a vertex begin at the very angle at which the vertex was reached.
  std::vector<double> legs;
  for (const SurfacePoint& target : targets) legs.push_back(solver_->first_leg(target));
  std::vector<double> sorted = legs;
  std::erase_if(sorted, [](double leg) { return std::isnan(leg); });
  std::ranges::sort(sorted);
  std::vector<Turn> by_leg(sorted.size());
  for (Index v = 0; v < surface_.mesh()->vertex_count(); ++v) {
    const bool is_flat = geometry->windows->flat_height[v] > 0.0F;
    if (is_flat || geometry->windows->can_bend[v] == ExactGeometry::never) continue;
    const double distance = solver_->distance(v);
    if (!(distance > 0.0 && distance < unreachable)) continue;
    const auto leg = std::ranges::lower_bound(sorted, solver_->first_leg(v));
    if (leg == sorted.end() || *leg != solver_->first_leg(v)) continue;
    Turn& turn = by_leg[leg - sorted.begin()];
    if (distance < turn.distance) turn = {v, distance};
  }
  std::vector<Turn> turns(targets.size());
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const auto leg = std::ranges::lower_bound(sorted, legs[i]);
    if (std::isnan(legs[i]) || by_leg[leg - sorted.begin()].distance >= solver_->distance(targets[i]))
      continue;
    turns[i] = by_leg[leg - sorted.begin()];
  }
  return turns;
}

std::vector<Tangent> Query::gradient(std::span<const ExactSource> sources,
                                     const std::optional<PointList>& points, double max_distance,
                                     const Progress& progress) {
  const LocalSolver& solver = solved(sources, max_distance, Answer::exact, 1, false, progress);
  const auto geometry = surface_.geometry();
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const auto at = [&](const SurfacePoint& point) -> Tangent {
    if (!(solver.distance(point) < unreachable)) return {none, none};
    const TangentFrame frame(*geometry->windows, point);
    return frame.vector(solver.last_leg(frame) + 0.5 * frame.full_turn(), 1.0);
  };
  std::vector<Tangent> found;
  if (points) {
    for (const SurfacePoint& point : *points) found.push_back(at(point));
    return found;
  }
  const Mesh& mesh = *surface_.mesh();
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const Index known = mesh.representative(v);
    found.push_back(TangentFrame::exists_at(mesh, known) ? at(SurfacePoint::at_vertex(known))
                                                         : Tangent{none, none});
  }
  return found;
}

void Query::last_legs(const SurfacePoint& from, double max_distance, const Progress& progress,
                      const std::function<void(Index, const PointList&)>& visit) {
  const Mesh& mesh = *surface_.mesh();
  const LocalSolver& solver =
      solved(std::array{ExactSource{from}}, max_distance, Answer::exact, 1, false, progress.part(0.0, 0.7));
  std::vector<std::uint8_t> is_visited(mesh.vertex_count(), 0);
  if (from.is_vertex()) is_visited[mesh.representative(from.vertex)] = 1;
  std::vector<Index> order;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const bool is_one = mesh.representative(v) == v && is_visited[v] == 0;
    if (is_one && solver.distance(v) < unreachable) order.push_back(v);
  }
  std::ranges::sort(order, {}, [&](Index v) { return solver.distance(v); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i % 1024 == 0) {
      const double part = static_cast<double>(i) / static_cast<double>(order.size());
      progress.report(0.7 + 0.3 * part, "Tracing paths");
    }
    std::vector<SurfacePoint> leg = solver.last_leg_of(order[i]).points;
    if (leg.empty()) continue;
    // Among vertices at one position, equally far, the path may come from one that is visited later.
    const SurfacePoint& first = leg.back();
    if (first.is_vertex() && is_visited[mesh.representative(first.vertex)] == 0)
      leg = solver.path_to_source(SurfacePoint::at_vertex(order[i])).points;
    std::ranges::reverse(leg);
    for (SurfacePoint& point : leg) point = canonical(mesh, point);
    visit(order[i], leg);
    is_visited[order[i]] = 1;
  }
}

Ridge Query::ridge(std::span<const ExactSource> sources, double max_distance, const Progress& progress) {
  return solved(sources, max_distance, Answer::exact, 1, false, progress).ridge();
}

void Query::exact_paths(const SurfacePoint& source, std::span<const SurfacePoint> targets,
                        const std::function<void(std::size_t, ExactPath)>& found) {
  if (!propagation_) propagation_.emplace(surface_.geometry());
  propagation_->reset(source);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    found(i,
          raised(*surface_.mesh(), source, targets[i], mesh_paths().exact_path(*propagation_, targets[i])));
  }
}

}  // namespace vorogeo
