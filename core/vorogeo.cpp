// The public interface over the core: numbers, points, options and errors are translated here, in both
// directions.
#include <algorithm>
#include <mutex>
#include <new>
#include <utility>

#include "index/build_cost.h"
#include "mesh/mesh_check.h"
#include "mesh/mesh_input.h"
#include "mesh/metric.h"
#include "mesh/outliers.h"
#include "mesh/surface_locator.h"
#include "query/surface.h"
#include "support/memory.h"
#include "support/parallel.h"
#include "tasks/curve_sources.h"
#include "tasks/distance_matrix.h"
#include "tasks/extent.h"
#include "tasks/neighbors.h"
#include "tasks/spread_points.h"
#include "tasks/surface_lines.h"
#include "tasks/voronoi_regions.h"

// The core's own names, before the header below declares public ones beside them.
namespace inner {
using vorogeo::Answered;
using vorogeo::AnswerMethod;
using vorogeo::Cancelled;
using vorogeo::check_mesh;
using vorogeo::Error;
using vorogeo::ExactPath;
using vorogeo::ExactSource;
using vorogeo::GapLimit;
using vorogeo::GeodesicIndex;
using vorogeo::IndexFileError;
using vorogeo::IndexOptions;
using vorogeo::InvalidInput;
using vorogeo::isolines;
using vorogeo::Mesh;
using vorogeo::NotEnoughMemory;
using vorogeo::PointList;
using vorogeo::Query;
using vorogeo::slope_cost;
using vorogeo::Surface;
using vorogeo::SurfaceLocator;
using vorogeo::SurfacePoint;
using vorogeo::TaskOptions;
using vorogeo::to_string;
}  // namespace inner

#include "vorogeo.h"

namespace vorogeo {
inline namespace v0 {

struct Surface::State {
  std::shared_ptr<const inner::Mesh> mesh;
  std::size_t face_count = 0;  ///< of the faces given
  inner::IndexOptions options;

  std::mutex mutex;  ///< of the surface, held for moments
  std::shared_ptr<inner::Surface> surface;
  std::once_flag locator_made;
  std::unique_ptr<const inner::SurfaceLocator> locator;

  std::shared_ptr<inner::Surface> current() {
    const std::lock_guard lock(mutex);
    return surface;
  }
  void adopt(std::shared_ptr<const inner::GeodesicIndex> index) {
    const std::lock_guard lock(mutex);
    surface = std::make_shared<inner::Surface>(mesh, std::move(index), surface->spent(), options);
  }
};

namespace {

/// Runs a piece of the core, whose errors leave as those of the public header.
template <class Body>
auto translated(Body&& body) {
  try {
    return body();
  } catch (const inner::Cancelled& error) {
    throw Cancelled(error.what());
  } catch (const inner::InvalidInput& error) {
    throw InvalidInput(error.what());
  } catch (const inner::IndexFileError& error) {
    throw IndexFileError(error.what());
  } catch (const inner::NotEnoughMemory& error) {
    throw NotEnoughMemory(error.what());
  } catch (const inner::Error& error) {
    throw Error(error.what());
  } catch (const std::bad_alloc&) {
    throw NotEnoughMemory(out_of_memory_sentence);
  }
}

// ---- Points in and out

inner::SurfacePoint point_in(const inner::Mesh& mesh, const SurfacePoint& point) {
  return InputMap(mesh).point_in({point.vertex, point.face, point.weights});
}

inner::PointList points_in(const inner::Mesh& mesh, const PointList& points) {
  std::vector<inner::SurfacePoint> list;
  list.reserve(points.size());
  for (const SurfacePoint& point : points) list.push_back(point_in(mesh, point));
  return list;
}

/// A point over a gap lies in no face that was given.
SurfacePoint point_out(const inner::Mesh& mesh, const inner::SurfacePoint& point) {
  const InputPoint out = InputMap(mesh).point_out(point);
  return out.vertex >= 0 ? SurfacePoint(out.vertex) : SurfacePoint(out.face, out.weights);
}

std::vector<SurfacePoint> points_out(const inner::Mesh& mesh,
                                     const std::vector<inner::SurfacePoint>& points) {
  std::vector<SurfacePoint> out;
  out.reserve(points.size());
  for (const auto& point : points) out.push_back(point_out(mesh, point));
  return out;
}

// ---- The mesh that is measured on

void require_count(std::size_t count, std::size_t wanted, const std::string& what, const char* element) {
  if (count == wanted) return;
  throw InvalidInput(what + " has " + std::to_string(count) + " values, but the mesh has " +
                     std::to_string(wanted) + " " + element + "; give one value for each.");
}

/// Faces that the mask leaves out name one vertex three times: a Mesh leaves these out and goes on counting.
void leave_out_masked(const std::vector<bool>& mask, std::size_t vertices,
                      std::vector<std::array<int, 3>>& faces) {
  if (mask.empty()) return;
  const bool of_faces = mask.size() == faces.size();
  if (!of_faces && mask.size() != vertices) {
    throw InvalidInput("The mask has " + std::to_string(mask.size()) + " values; give one for each of the " +
                       std::to_string(faces.size()) + " faces or " + std::to_string(vertices) + " vertices.");
  }
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const bool stays = of_faces ? mask[f] : std::ranges::all_of(faces[f], [&](int v) {
      return v < 0 || static_cast<std::size_t>(v) >= vertices || mask[static_cast<std::size_t>(v)];
    });
    if (!stays) faces[f] = {0, 0, 0};
  }
}

std::shared_ptr<const inner::Mesh> mesh_of(std::vector<Point> positions,
                                           std::vector<std::array<int, 3>> faces,
                                           const SurfaceOptions& options) {
  leave_out_masked(options.mask, positions.size(), faces);
  Metric metric;
  std::string given;
  // What is given of one metric: true if it is this one.
  const auto is_given = [&](const auto& values, const char* name, std::size_t wanted, const char* element) {
    if (values.empty()) return false;
    if (!given.empty()) throw InvalidInput("Both " + given + " and " + name + " are given; give one metric.");
    given = name;
    require_count(values.size(), wanted, name, element);
    return true;
  };
  if (is_given(options.vertex_cost, "vertex_cost", positions.size(), "vertices")) {
    metric = lengths_by_cost(positions, faces, options.vertex_cost);
  }
  if (is_given(options.vertex_tensor, "vertex_tensor", positions.size(), "vertices")) {
    metric = lengths_by_tensor(positions, faces, options.vertex_tensor);
  }
  if (is_given(options.face_cost, "face_cost", faces.size(), "faces")) {
    metric = {sides_by_face_cost(positions, faces, options.face_cost), usual_edge_points};
  }
  if (is_given(options.face_tensor, "face_tensor", faces.size(), "faces")) {
    const auto sides = sides_by_face_tensor(positions, faces, options.face_tensor);
    metric = {sides, edge_points_for(positions, faces, sides)};
  }
  if (is_given(options.side_lengths, "side_lengths", faces.size(), "faces")) metric = options.side_lengths;
  const inner::GapLimit gap{options.gap, options.bridge_folds};
  return measured_mesh({std::move(positions), std::move(faces), std::move(metric), gap});
}

}  // namespace

const char* to_string(Answer answer) { return inner::to_string(static_cast<inner::AnswerMethod>(answer)); }

MeshReport check_mesh(const std::vector<Point>& positions, const std::vector<std::array<int, 3>>& faces,
                      double gap) {
  return translated([&] {
    const auto report = inner::check_mesh(positions, faces, {gap, false});
    return MeshReport{report.usable(), report.summary(), report.sentences()};
  });
}

std::vector<double> slope_cost(const std::vector<Point>& positions,
                               const std::vector<std::array<int, 3>>& faces, double penalty,
                               const Point& up) {
  return translated([&] { return inner::slope_cost(positions, faces, up, penalty); });
}

std::vector<Tensor> curvature_tensor(const std::vector<Point>& positions,
                                     const std::vector<std::array<int, 3>>& faces, double weight) {
  return translated([&] { return curvature_tensors(positions, faces, weight); });
}

// ---- The surface

Surface::Surface(std::vector<Point> positions, std::vector<std::array<int, 3>> faces,
                 const SurfaceOptions& options)
    : state_(std::make_shared<State>()) {
  translated([&] {
    state_->face_count = faces.size();
    state_->mesh = mesh_of(std::move(positions), std::move(faces), options);
    state_->options.threads = options.threads;
    state_->surface = std::make_shared<inner::Surface>(state_->mesh, state_->options);
  });
}

int Surface::vertex_count() const { return state_->mesh->given_vertex_count(); }
int Surface::face_count() const { return static_cast<int>(state_->face_count); }

std::vector<double> Surface::distances_from(const PointList& sources) const {
  return field(sources).distance;
}

Field Surface::field(const PointList& sources, const FieldOptions& options) const {
  return translated([&] {
    const inner::Mesh& mesh = *state_->mesh;
    if (!options.offsets.empty() && options.offsets.size() != sources.size()) {
      throw InvalidInput("There are " + std::to_string(sources.size()) + " sources and " +
                         std::to_string(options.offsets.size()) + " offsets; give one for each source.");
    }
    const inner::PointList points = points_on(mesh, points_in(mesh, sources), "Source");
    std::vector<inner::ExactSource> from;
    for (std::size_t i = 0; i < points.size(); ++i) {
      from.push_back({points[i], options.offsets.empty() ? 0.0 : options.offsets[i]});
    }
    inner::Answered answered;
    auto found = state_->current()->field(from, options.limit, static_cast<inner::AnswerMethod>(options.by),
                                          answered, Progress(options.progress));
    Field field;
    field.distance = InputMap(mesh).of_vertices(std::move(found.distance));
    if (options.labels) field.label = InputMap(mesh).of_vertices(std::move(found.source));
    field.answered_by = static_cast<Answer>(answered.by);
    field.remark = std::move(answered.remark);
    return field;
  });
}

PointList Surface::along_edges(const std::vector<std::array<int, 2>>& edges, double spacing) const {
  return translated([&] {
    const inner::Mesh& mesh = *state_->mesh;
    for (const auto& ends : edges) points_in(mesh, {ends[0], ends[1]});
    if (spacing == 0.0) spacing = 0.25 * mesh.typical_edge_length();
    std::vector<SurfacePoint> points;
    for (const auto& source : sources_along_edges(mesh, edges_of_curve(mesh, edges), spacing)) {
      points.push_back(point_out(mesh, source.point));
    }
    return PointList(points);
  });
}

double Surface::distance(const SurfacePoint& from, const SurfacePoint& to, Answer by) const {
  return translated([&] {
    const inner::Mesh& mesh = *state_->mesh;
    inner::Answered answered;
    return state_->current()->distance(point_in(mesh, from), point_in(mesh, to),
                                       static_cast<inner::AnswerMethod>(by), answered);
  });
}

namespace {

/// \throw InvalidInput unless as many points are to be started from as gone to.
void require_pairs(const PointList& from, const PointList& to) {
  if (from.size() == to.size()) return;
  throw InvalidInput("There are " + std::to_string(from.size()) + " points to start from and " +
                     std::to_string(to.size()) + " to go to; give as many of both.");
}

Path path_out(const inner::Mesh& mesh, const inner::ExactPath& found, inner::AnswerMethod by) {
  Path path;
  for (const auto& point : found.path.points) path.points.push_back(position_of(mesh, point));
  path.surface_points = points_out(mesh, found.path.points);
  path.length = found.path.length;
  path.certified = found.certified;
  path.answered_by = static_cast<Answer>(by);
  return path;
}

}  // namespace

std::vector<double> Surface::distances(const PointList& from, const PointList& to, Answer by) const {
  return translated([&] {
    const inner::Mesh& mesh = *state_->mesh;
    require_pairs(from, to);
    inner::Answered answered;
    return state_->current()->distances({points_in(mesh, from), points_in(mesh, to)},
                                        static_cast<inner::AnswerMethod>(by), answered);
  });
}

Path Surface::path(const SurfacePoint& from, const SurfacePoint& to, const PathOptions& options) const {
  return translated([&] {
    const inner::Mesh& mesh = *state_->mesh;
    inner::Answered answered;
    const auto found = state_->current()->path(
        point_in(mesh, from), point_in(mesh, to), static_cast<inner::AnswerMethod>(options.by),
        {.exact = options.exact, .certify = options.certify}, answered, Progress(options.progress));
    Path path = path_out(mesh, found, answered.by);
    path.remark = std::move(answered.remark);
    return path;
  });
}

std::vector<Path> Surface::paths(const PointList& from, const PointList& to,
                                 const PathOptions& options) const {
  return translated([&] {
    const inner::Mesh& mesh = *state_->mesh;
    require_pairs(from, to);
    inner::Answered answered;
    const auto found = state_->current()->paths(
        {points_in(mesh, from), points_in(mesh, to)}, static_cast<inner::AnswerMethod>(options.by),
        {.exact = options.exact, .certify = options.certify}, answered, Progress(options.progress));
    std::vector<Path> paths;
    paths.reserve(found.size());
    for (const auto& one : found) {
      paths.push_back(path_out(mesh, one, answered.by));
      paths.back().remark = answered.remark;
    }
    return paths;
  });
}

SnappedPoint Surface::nearest(const Point& position) const {
  return translated([&] {
    State& state = *state_;
    std::call_once(state.locator_made,
                   [&] { state.locator = std::make_unique<inner::SurfaceLocator>(state.mesh); });
    const auto found = state.locator->nearest(position);
    return SnappedPoint{point_out(*state_->mesh, found.point), found.distance};
  });
}

Point Surface::position(const SurfacePoint& point) const {
  return translated([&] {
    const inner::Mesh& mesh = *state_->mesh;
    return position_of(mesh, validated(mesh, point_in(mesh, point)));
  });
}

// ---- Its index

namespace {

inner::IndexOptions core_options(inner::IndexOptions wanted, const IndexOptions& options) {
  wanted.first_layer_patches = options.first_layer_patches;
  wanted.second_layer_patches = options.second_layer_patches;
  wanted.delta = options.delta;
  wanted.seed = options.seed;
  wanted.memory_budget = options.memory_budget;
  return wanted;
}

}  // namespace

IndexEstimate Surface::estimate_index(const IndexOptions& options) const {
  return translated([&] {
    const auto estimate = estimate_build(state_->mesh, core_options(state_->options, options), true,
                                         Progress(options.progress));
    return IndexEstimate{estimate.build_seconds, estimate.bytes, estimate.field_seconds,
                         estimate.exact_field_seconds};
  });
}

void Surface::build_index(const IndexOptions& options) {
  translated([&] {
    const inner::IndexOptions wanted = core_options(state_->options, options);
    bool is_new = false;
    const auto index = state_->current()->build_index(
        [&](const Progress& progress) {
          is_new = true;
          return options.file.empty()
                     ? inner::GeodesicIndex::build(state_->mesh, wanted, progress)
                     : inner::GeodesicIndex::build_in_file(options.file, state_->mesh, wanted, progress);
        },
        Progress(options.progress));
    if (!is_new && !options.file.empty()) index->save(options.file);
  });
}

bool Surface::has_index() const { return state_->current()->index() != nullptr; }

namespace {

std::shared_ptr<const inner::GeodesicIndex> index_of(Surface::State& state) {
  if (auto index = state.current()->index()) return index;
  throw InvalidInput("The surface has no index; call build_index() or load_index() first.");
}

}  // namespace

IndexStatistics Surface::index_statistics() const {
  const auto index = index_of(*state_);
  const auto& statistics = index->statistics();
  return {statistics.first_layer_patches, statistics.second_layer_patches, statistics.bytes,
          statistics.seconds};
}

void Surface::save_index(const std::filesystem::path& file) const {
  translated([&] { index_of(*state_)->save(file); });
}

void Surface::load_index(const std::filesystem::path& file) {
  translated([&] { state_->adopt(inner::GeodesicIndex::load(file, state_->mesh)); });
}

// ---- The questions of one thread

struct Query::State {
  explicit State(std::shared_ptr<inner::Surface> asked_surface, inner::AnswerMethod method)
      : surface(std::move(asked_surface)), by(method), query(*surface) {}
  inner::SurfacePoint in(const SurfacePoint& point) const {
    const inner::Mesh& mesh = *surface->mesh();
    return canonical(mesh, validated(mesh, point_in(mesh, point)));
  }
  inner::PointList in(const PointList& points, const char* what) const {
    return points_on(*surface->mesh(), points_in(*surface->mesh(), points), what);
  }

  std::shared_ptr<inner::Surface> surface;
  inner::AnswerMethod by;
  inner::Query query;
};

Query Surface::query(Answer by) const {
  if (by == Answer::quick) {
    throw InvalidInput("A query answers by the index or exactly; for quick fields call field().");
  }
  if (by == Answer::index) index_of(*state_);
  const auto surface = state_->current();
  if (by == Answer::automatic) by = surface->index() ? Answer::index : Answer::exact;
  return Query(std::make_unique<Query::State>(surface, static_cast<inner::AnswerMethod>(by)));
}

Query::Query(std::unique_ptr<State> state) : state_(std::move(state)) {}
Query::Query(Query&&) noexcept = default;
Query& Query::operator=(Query&&) noexcept = default;
Query::~Query() = default;

Answer Query::answers_by() const { return static_cast<Answer>(state_->by); }

std::vector<double> Query::distances_from(const PointList& sources, double limit) {
  return translated([&] {
    if (sources.empty()) throw InvalidInput("There is no source: give at least one.");
    require_limit(limit);
    std::vector<inner::ExactSource> from;
    for (const auto& point : state_->in(sources, "Source")) from.push_back({point});
    return InputMap(*state_->surface->mesh()).of_vertices(state_->query.field(from, limit, state_->by, 1));
  });
}

double Query::distance(const SurfacePoint& from, const SurfacePoint& to) {
  return translated([&] { return state_->query.distance(state_->in(from), state_->in(to), state_->by); });
}

std::vector<double> Query::distances(const SurfacePoint& from, const PointList& to, double limit) {
  return translated([&] {
    require_limit(limit);
    return state_->query.distances(state_->in(from), state_->in(to, "Target"), limit, state_->by);
  });
}

Path Query::path(const SurfacePoint& from, const SurfacePoint& to, bool exact) {
  return translated([&] {
    const auto found = state_->query.path(state_->in(from), state_->in(to), state_->by, exact, true);
    return path_out(*state_->surface->mesh(), found, state_->by);
  });
}

// ---- Tasks

namespace {

/// The part that tasks of the core take of TaskOptions and of FarthestOptions.
template <class Options>
inner::TaskOptions core_options(const Options& options) {
  return {.by = static_cast<inner::AnswerMethod>(options.by), .progress = Progress(options.progress)};
}

/// Runs a task: body(surface, mesh).
template <class Body>
auto run_task(const Surface& surface, Body&& body) {
  return translated([&] {
    const auto current = surface.state().current();
    return body(*current, *current->mesh());
  });
}

/// For so many rows of distances. \throw NotEnoughMemory before anything is allocated.
std::vector<double> rows_of_distances(std::size_t rows, std::size_t width) {
  require_memory(static_cast<double>(rows) * static_cast<double>(width) * sizeof(double), 0,
                 "The matrix of the distances", "Ask for fewer points at a time.");
  return std::vector<double>(rows * width);
}

SparseDistances sparse_out(inner::Surface& surface, const inner::PointList& points, double radius,
                           const inner::TaskOptions& options) {
  auto found = pairs_within(surface, points, radius, 0, options);
  return {std::move(found.row_begin), std::move(found.column), std::move(found.distance)};
}

}  // namespace

std::vector<double> distance_matrix(const Surface& surface, const PointList& points,
                                    const TaskOptions& options) {
  return run_task(surface, [&](inner::Surface& asked, const inner::Mesh& mesh) {
    const inner::PointList all = points_in(mesh, points);
    std::vector<double> matrix = rows_of_distances(all.size(), all.size());
    distance_matrix(asked, all, MatrixMethod::automatic, std::span(matrix), core_options(options));
    return matrix;
  });
}

std::vector<double> distance_matrix(const Surface& surface, const PointList& rows, const PointList& columns,
                                    const TaskOptions& options) {
  return run_task(surface, [&](inner::Surface& asked, const inner::Mesh& mesh) {
    const inner::PointList from = points_in(mesh, rows);
    const inner::PointList to = points_in(mesh, columns);
    std::vector<double> matrix = rows_of_distances(from.size(), to.size());
    distance_matrix(asked, from, to, MatrixMethod::automatic, std::span(matrix), core_options(options));
    return matrix;
  });
}

std::vector<double> distance_fields(const Surface& surface, const PointList& sources, double limit,
                                    const TaskOptions& options) {
  return run_task(surface, [&](inner::Surface& asked, const inner::Mesh& mesh) {
    const inner::PointList from = points_in(mesh, sources);
    std::vector<double> rows =
        rows_of_distances(from.size(), static_cast<std::size_t>(surface.vertex_count()));
    distance_fields(asked, from, limit, std::span(rows), core_options(options));
    return rows;
  });
}

SparseDistances pairs_within(const Surface& surface, const PointList& points, double radius,
                             const TaskOptions& options) {
  return run_task(surface, [&](inner::Surface& asked, const inner::Mesh& mesh) {
    return sparse_out(asked, points_in(mesh, points), radius, core_options(options));
  });
}

NearestOfSet nearest(const Surface& surface, const PointList& set, const PointList& queries,
                     std::size_t count, const TaskOptions& options) {
  return run_task(surface, [&](inner::Surface& asked, const inner::Mesh& mesh) {
    auto found =
        nearest_of_set(asked, points_in(mesh, set), points_in(mesh, queries), count, core_options(options));
    return NearestOfSet{std::move(found.position), std::move(found.distance)};
  });
}

VoronoiRegions voronoi(const Surface& surface, const PointList& sites, const TaskOptions& options) {
  return run_task(surface, [&](inner::Surface& asked, const inner::Mesh& mesh) {
    auto found = voronoi_regions(asked, points_in(mesh, sites), core_options(options));
    VoronoiRegions regions;
    regions.face_region =
        InputMap(mesh).of_faces(found.face_region, static_cast<std::size_t>(surface.face_count()));
    regions.vertex_region = InputMap(mesh).of_vertices(std::move(found.vertex_region));
    regions.distance = InputMap(mesh).of_vertices(std::move(found.distance));
    regions.area = std::move(found.area);
    regions.borders = {std::move(found.borders.points), std::move(found.borders.segments)};
    regions.border_regions = std::move(found.border_regions);
    return regions;
  });
}

Isolines isolines(const Surface& surface, const std::vector<double>& field,
                  const std::vector<double>& levels) {
  return translated([&] {
    auto found = inner::isolines(*surface.state().mesh, field, levels, Interpolation::distance);
    return Isolines{{std::move(found.lines.points), std::move(found.lines.segments)},
                    std::move(found.level_of_segment)};
  });
}

FarthestSamples sample_farthest(const Surface& surface, const FarthestOptions& options) {
  return run_task(surface, [&](inner::Surface& asked, const inner::Mesh& mesh) {
    FarthestStop stop;
    stop.count = options.count;
    stop.radius = options.radius;
    auto found =
        sample_farthest(asked, stop, points_in(mesh, options.start), options.seed, core_options(options));
    return FarthestSamples{points_out(mesh, found.points), std::move(found.radius), std::move(found.distance),
                           found.covering_radius};
  });
}

std::vector<int> sample_poisson_disk(const Surface& surface, double radius, std::uint64_t seed,
                                     const TaskOptions& options) {
  return run_task(surface, [&](inner::Surface& asked, const inner::Mesh&) {
    return sample_poisson_disk(asked, radius, seed, core_options(options));
  });
}

RelaxedPoints relax(const Surface& surface, const PointList& points, int rounds, const TaskOptions& options) {
  return run_task(surface, [&](inner::Surface& asked, const inner::Mesh& mesh) {
    auto found = relax_points(asked, points_in(mesh, points), rounds, core_options(options));
    return RelaxedPoints{points_out(mesh, found.points), std::move(found.energy)};
  });
}

Disk disk(const Surface& surface, const PointList& sources, double radius, const TaskOptions& options) {
  return run_task(surface, [&](inner::Surface& asked, const inner::Mesh& mesh) {
    auto found = geodesic_disk(asked, points_in(mesh, sources), radius, core_options(options));
    for (int& face : found.faces) face = mesh.input_face(face);
    return Disk{std::move(found.vertices), std::move(found.distance), std::move(found.faces)};
  });
}

std::vector<Eccentricity> eccentricities(const Surface& surface, const PointList& points,
                                         const TaskOptions& options) {
  return run_task(surface, [&](inner::Surface& asked, const inner::Mesh& mesh) {
    std::vector<Eccentricity> out;
    for (const auto& one : eccentricities(asked, points_in(mesh, points), core_options(options))) {
      out.push_back({one.distance, one.farthest});
    }
    return out;
  });
}

Extent extent(const Surface& surface, int max_fields, const TaskOptions& options) {
  return run_task(surface, [&](inner::Surface& asked, const inner::Mesh& mesh) {
    const auto found =
        extent_of_component(asked, largest_component(mesh).first_vertex, max_fields, core_options(options));
    return Extent{{found.diameter.lower, found.diameter.upper},
                  {found.ends[0], found.ends[1]},
                  {found.radius.lower, found.radius.upper},
                  found.centre};
  });
}

}  // namespace v0
}  // namespace vorogeo
