// The public interface over the core, which translates numbers, points and options in both
// directions.
#include <algorithm>
#include <optional>
#include <utility>

#include "public_interface.h"

namespace vorogeo {
inline namespace v0 {

namespace {

// ---- The mesh that is measured on

void require_count(std::size_t count, std::size_t wanted, const std::string& what, const char* element) {
  if (count == wanted) return;
  throw InvalidInput(what + " has " + std::to_string(count) + " values, but the mesh has " +
                     std::to_string(wanted) + " " + element + "; give one value for each.");
}

/// Makes masked faces name one vertex three times: Mesh leaves such faces out but keeps their numbers.
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

std::shared_ptr<const Mesh> mesh_of(std::vector<Point> positions, std::vector<std::array<int, 3>> faces,
                                    const SurfaceOptions& options) {
  leave_out_masked(options.mask, positions.size(), faces);
  Metric metric;
  std::string given;
  // Whether this metric is given; refuses a second one.
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
  if (!options.face_drift.empty()) {
    require_count(options.face_drift.size(), faces.size(), "face_drift", "faces");
    if (given.empty()) {
      metric = {sides_by_face_cost(positions, faces, std::vector<double>(faces.size(), 1.0)),
                usual_edge_points};
    }
    if (metric.points_per_edge == 0) {
      throw InvalidInput("Both " + given +
                         " and face_drift are given; give face_cost, face_tensor or neither.");
    }
    metric.drifts = drifts_by_face(positions, faces, metric.sides, options.face_drift);
    given = "face_drift";
  }
  if (is_given(options.side_lengths, "side_lengths", faces.size(), "faces")) metric = options.side_lengths;
  const GapLimit gap{options.gap, options.bridge_folds};
  return measured_mesh({std::move(positions), std::move(faces), std::move(metric), gap});
}

}  // namespace

const char* to_string(Answer answer) { return inner::name_of(answer); }

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

std::vector<double> slope_cost(const std::vector<Point>& positions,
                               const std::vector<std::array<int, 3>>& faces,
                               const std::function<double(double)>& cost, const Point& up) {
  return translated([&] {
    std::vector<double> values = grades_of(positions, faces, up);
    for (double& value : values) value = cost(value);
    return values;
  });
}

FaceMetric hiking_time(const std::vector<Point>& positions, const std::vector<std::array<int, 3>>& faces,
                       const std::function<double(double)>& pace, const Point& up) {
  return translated([&] {
    const auto by_grade = for_each_grade(pace ? pace : std::function<double(double)>(tobler));
    auto found = inner::hiking_time(positions, faces, by_grade, up);
    return FaceMetric{std::move(found.tensors), std::move(found.drifts)};
  });
}

FaceMetric travel_time(const std::vector<Point>& positions, const std::vector<std::array<int, 3>>& faces,
                       const std::vector<Point>& wind, const std::vector<double>& speed) {
  return translated([&] {
    require_count(wind.size(), faces.size(), "wind", "faces");
    require_count(speed.size(), faces.size(), "speed", "faces");
    auto found = inner::travel_time(positions, faces, wind, speed);
    return FaceMetric{std::move(found.tensors), std::move(found.drifts)};
  });
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
    state_->mesh = mesh_of(std::move(positions), std::move(faces), options);
    state_->options.threads = options.threads;
    state_->surface = std::make_shared<inner::Surface>(state_->mesh, state_->options);
  });
}

int Surface::vertex_count() const { return state_->mesh->given_vertex_count(); }
int Surface::face_count() const { return state_->mesh->given_face_count(); }

std::vector<double> Surface::distances_from(const PointList& sources) const {
  return field(sources).distance;
}

Field Surface::field(const PointList& sources, const FieldOptions& options) const {
  return ask(*this, options, [&](Asked& at) {
    if (!options.offsets.empty() && options.offsets.size() != sources.size()) {
      throw InvalidInput("There are " + std::to_string(sources.size()) + " sources and " +
                         std::to_string(options.offsets.size()) + " offsets; give one for each source.");
    }
    const inner::PointList points = points_on(at.mesh, at.in(sources), "Source");
    std::vector<ExactSource> from;
    for (std::size_t i = 0; i < points.size(); ++i) {
      from.push_back({points[i], options.offsets.empty() ? 0.0 : options.offsets[i]});
    }
    auto found = at.surface.field(from, options.limit, at.options.by, at.answered, at.options.progress);
    Field field;
    field.distance = InputMap(at.mesh).of_vertices(std::move(found.distance));
    if (options.labels) field.label = InputMap(at.mesh).of_vertices(std::move(found.source));
    field.expected_error = at.answered.expected_error;
    field.unreached = at.answered.unreached;
    field.answered_by = at.answered.by;
    field.remark = std::move(at.answered.remark);
    return field;
  });
}

PointList Surface::along_edges(const std::vector<std::array<int, 2>>& edges, double spacing) const {
  return translated([&] {
    const Mesh& mesh = *state_->mesh;
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
  return ask(*this, TaskOptions{by}, [&](Asked& at) {
    return at.surface.distance(at.in(from), at.in(to), at.options.by, at.answered);
  });
}

std::vector<double> Surface::distances(const PointList& from, const PointList& to, Answer by) const {
  return ask(*this, TaskOptions{by}, [&](Asked& at) {
    return at.surface.distances(Pairs(at, from, to).pairs(), at.options.by, at.answered);
  });
}

Path Surface::path(const SurfacePoint& from, const SurfacePoint& to, const PathOptions& options) const {
  return ask(*this, options, [&](Asked& at) {
    const auto found = at.surface.path(at.in(from), at.in(to), at.options.by,
                                       {.exact = options.exact, .certify = options.certify}, at.answered,
                                       at.options.progress);
    return path_out(at.mesh, found, at.answered);
  });
}

std::vector<Path> Surface::paths(const PointList& from, const PointList& to,
                                 const PathOptions& options) const {
  return ask(*this, options, [&](Asked& at) {
    const Pairs ends(at, from, to);
    std::vector<Path> paths;
    for (const auto& one :
         at.surface.paths(ends.pairs(), at.options.by, {.exact = options.exact, .certify = options.certify},
                          at.answered, at.options.progress)) {
      paths.push_back(path_out(at.mesh, one, at.answered));
    }
    return paths;
  });
}

SnappedPoint Surface::nearest(const Point& position) const {
  return translated([&] {
    const auto found = state_->located().nearest(position);
    return SnappedPoint{point_out(*state_->mesh, found.point), found.distance};
  });
}

Point Surface::position(const SurfacePoint& point) const {
  return translated([&] {
    const Mesh& mesh = *state_->mesh;
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
    const auto estimate =
        estimate_build(state_->mesh, core_options(state_->options, options), Progress(options.progress));
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
                     ? GeodesicIndex::build(state_->mesh, wanted, progress)
                     : GeodesicIndex::build_in_file(options.file, state_->mesh, wanted, progress);
        },
        Progress(options.progress));
    if (!is_new && !options.file.empty()) index->save(options.file);
  });
}

bool Surface::has_index() const { return state_->current()->index() != nullptr; }

namespace {

std::shared_ptr<const GeodesicIndex> index_of(Surface::State& state) {
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
  translated([&] { state_->adopt(GeodesicIndex::load(file, state_->mesh)); });
}

// ---- The questions of one thread

struct Query::State {
  State(std::shared_ptr<inner::Surface> asked_surface, Answer method, bool is_chosen)
      : surface(std::move(asked_surface)), by(method), is_automatic(is_chosen), query(*surface) {}
  inner::SurfacePoint in(const SurfacePoint& point) const {
    const Mesh& mesh = *surface->mesh();
    return canonical(mesh, validated(mesh, point_in(mesh, point)));
  }
  inner::PointList in(const PointList& points, const char* what) const {
    return points_on(*surface->mesh(), points_in(*surface->mesh(), points), what);
  }
  /// Like Surface, answers exactly what reaches a small part of the surface.
  Answer within(double limit, std::size_t sources) const {
    if (!is_automatic || by == Answer::exact) return by;
    return surface->is_as_fast_exact(sources, limit) ? Answer::exact : by;
  }

  std::shared_ptr<inner::Surface> surface;
  Answer by;
  bool is_automatic;
  inner::Query query;
};

Query Surface::query(Answer by) const {
  if (by == Answer::quick) {
    throw InvalidInput("A query answers by the index or exactly; for quick fields call field().");
  }
  if (by == Answer::index) index_of(*state_);
  const auto surface = state_->current();
  const bool is_automatic = by == Answer::automatic;
  if (is_automatic) by = surface->index() ? Answer::index : Answer::exact;
  return Query(std::make_unique<Query::State>(surface, by, is_automatic));
}

Query::Query(std::unique_ptr<State> state) : state_(std::move(state)) {}
Query::Query(Query&&) noexcept = default;
Query& Query::operator=(Query&&) noexcept = default;
Query::~Query() = default;

Answer Query::answers_by() const { return state_->by; }

std::vector<double> Query::distances_from(const PointList& sources, double limit) {
  return translated([&] {
    if (sources.empty()) throw InvalidInput("There is no source: give at least one.");
    require_limit(limit);
    std::vector<ExactSource> from;
    for (const auto& point : state_->in(sources, "Source")) from.push_back({point});
    const Answer by = state_->within(limit, from.size());
    return InputMap(*state_->surface->mesh()).of_vertices(state_->query.field(from, limit, by, 1));
  });
}

double Query::distance(const SurfacePoint& from, const SurfacePoint& to) {
  return translated([&] { return state_->query.distance(state_->in(from), state_->in(to), state_->by); });
}

std::vector<double> Query::distances(const SurfacePoint& from, const PointList& to, double limit) {
  return translated([&] {
    require_limit(limit);
    const ExactSource source{state_->in(from)};
    return state_->query.distances(std::span(&source, 1), state_->in(to, "Target"), limit,
                                   state_->within(limit, 1));
  });
}

Path Query::path(const SurfacePoint& from, const SurfacePoint& to, bool exact) {
  return translated([&] {
    const auto found = state_->query.path(state_->in(from), state_->in(to), state_->by, exact, true);
    Answered answered;
    answered.by = state_->by;
    return path_out(*state_->surface->mesh(), found, answered);
  });
}

// ---- Tasks

namespace {

/// Zeros for so many rows of distances. \throw NotEnoughMemory before anything is allocated.
std::vector<double> rows_of_distances(std::size_t rows, std::size_t width) {
  require_memory(static_cast<double>(rows) * static_cast<double>(width) * sizeof(double), 0,
                 "The matrix of the distances", "Ask for fewer points at a time.");
  return std::vector<double>(rows * width);
}

}  // namespace

std::vector<double> distance_matrix(const Surface& surface, const PointList& points,
                                    const TaskOptions& options) {
  return ask(surface, options, [&](const Asked& at) {
    const inner::PointList all = at.in(points);
    std::vector<double> matrix = rows_of_distances(all.size(), all.size());
    distance_matrix(at.surface, all, MatrixMethod::automatic, std::span(matrix), at.options);
    return matrix;
  });
}

std::vector<double> distance_matrix(const Surface& surface, const PointList& rows, const PointList& columns,
                                    const TaskOptions& options) {
  return ask(surface, options, [&](const Asked& at) {
    const inner::PointList from = at.in(rows);
    const inner::PointList to = at.in(columns);
    std::vector<double> matrix = rows_of_distances(from.size(), to.size());
    distance_matrix(at.surface, from, to, MatrixMethod::automatic, std::span(matrix), at.options);
    return matrix;
  });
}

std::vector<double> distance_fields(const Surface& surface, const PointList& sources, double limit,
                                    const TaskOptions& options) {
  return ask(surface, options, [&](const Asked& at) {
    const inner::PointList from = at.in(sources);
    std::vector<double> rows =
        rows_of_distances(from.size(), static_cast<std::size_t>(surface.vertex_count()));
    distance_fields(at.surface, from, limit, std::span(rows), at.options);
    return rows;
  });
}

SparseDistances pairs_within(const Surface& surface, const PointList& points, double radius,
                             const TaskOptions& options) {
  return ask(surface, options,
             [&](const Asked& at) { return pairs_within(at.surface, at.in(points), radius, 0, at.options); });
}

NearestOfSet nearest(const Surface& surface, const PointList& set, const PointList& queries,
                     std::size_t count, const TaskOptions& options) {
  return ask(surface, options, [&](const Asked& at) {
    return nearest_of_set(at.surface, at.in(set), at.in(queries), count, at.options);
  });
}

Path path_through(const Surface& surface, const PointList& points, bool closed, bool guides,
                  const TaskOptions& options) {
  return ask(surface, options, [&](const Asked& at) {
    const auto found =
        (guides ? inner::tighten : inner::path_through)(at.surface, at.in(points), closed, at.options);
    return path_out(at.mesh, found, at.answered);
  });
}

Path tighten(const Surface& surface, const PointList& curve, const TaskOptions& options) {
  return path_through(surface, curve, true, true, options);
}

Path shortest_loop(const Surface& surface, const SurfacePoint& point, const PointList& curve,
                   const TaskOptions& options) {
  return ask(surface, options, [&](const Asked& at) {
    return path_out(at.mesh, shortest_loop(at.surface, at.in(point), at.in(curve), at.options), at.answered);
  });
}

namespace {

Girth girth_of(const Surface& surface, const SurfacePoint& point, const std::optional<Point>& normal,
               const TaskOptions& options) {
  return ask(surface, options, [&](const Asked& at) {
    auto found = girth(at.surface, at.in(point), normal, at.options);
    return Girth{found.normal, path_out(at.mesh, {std::move(found.section), false}, {}),
                 std::move(found.tape), found.tape_length,
                 path_out(at.mesh, {std::move(found.loop), false}, at.answered)};
  });
}

}  // namespace

Girth girth(const Surface& surface, const SurfacePoint& point, const Point& normal,
            const TaskOptions& options) {
  return girth_of(surface, point, normal, options);
}

Girth girth(const Surface& surface, const SurfacePoint& point, const TaskOptions& options) {
  return girth_of(surface, point, std::nullopt, options);
}

Profile profile(const Surface& surface, const Path& path, const Point& up) {
  return translated([&] {
    const Mesh& mesh = *surface.state().mesh;
    const auto locate = [&]() -> const SurfaceLocator& { return surface.state().located(); };
    return profile(mesh, locate, points_in(mesh, path.surface_points), up);
  });
}

VoronoiRegions voronoi(const Surface& surface, const PointList& sites, const TaskOptions& options) {
  return ask(surface, options, [&](const Asked& at) {
    auto found = voronoi_regions(at.surface, at.in(sites), at.options);
    const InputMap map(at.mesh);
    found.vertex_region = map.of_vertices(std::move(found.vertex_region));
    found.distance = map.of_vertices(std::move(found.distance));
    found.face_region = map.of_faces(found.face_region, no_index);
    return found;
  });
}

Isolines isolines(const Surface& surface, const std::vector<double>& field, const std::vector<double>& levels,
                  const TaskOptions& options) {
  return ask(surface, options, [&](const Asked& at) {
    auto found = isolines(at.mesh, field, levels, Interpolation::distance, at.options.progress);
    return Isolines{std::move(found.lines), std::move(found.level_of_segment)};
  });
}

FarthestSamples sample_farthest(const Surface& surface, const FarthestOptions& options) {
  return ask(surface, options, [&](const Asked& at) {
    auto found = sample_farthest(at.surface, FarthestStop{options.count, options.radius},
                                 at.in(options.start), options.seed, at.options);
    return FarthestSamples{points_out(at.mesh, found.points), std::move(found.radius),
                           std::move(found.distance), found.covering_radius};
  });
}

std::vector<int> sample_poisson_disk(const Surface& surface, double radius, std::uint64_t seed,
                                     const TaskOptions& options) {
  return ask(surface, options,
             [&](const Asked& at) { return sample_poisson_disk(at.surface, radius, seed, at.options); });
}

RelaxedPoints relax(const Surface& surface, const PointList& points, int rounds, const TaskOptions& options) {
  return ask(surface, options, [&](const Asked& at) {
    auto found = relax_points(at.surface, at.in(points), rounds, at.options);
    return RelaxedPoints{points_out(at.mesh, found.points), std::move(found.energy)};
  });
}

Disk disk(const Surface& surface, const PointList& sources, double radius, const TaskOptions& options) {
  return ask(surface, options,
             [&](const Asked& at) { return geodesic_disk(at.surface, at.in(sources), radius, at.options); });
}

Band band(const Surface& surface, const PointList& sources, double width, const TaskOptions& options) {
  return ask(surface, options,
             [&](const Asked& at) { return band(at.surface, at.in(sources), width, at.options); });
}

namespace {

CutMesh cut_out(const Mesh& mesh, inner::CutMesh found) {
  CutMesh cut;
  cut.positions = positions_of(mesh, found.points);
  cut.points = points_out(mesh, found.points);
  for (const Index face : found.face_of) cut.face_of.push_back(mesh.input_face(face));
  cut.faces = std::move(found.faces);
  cut.region = std::move(found.region);
  cut.edges = std::move(found.edges);
  cut.side = std::move(found.side);
  return cut;
}

}  // namespace

CutMesh cut_at_levels(const Surface& surface, const std::vector<double>& field,
                      const std::vector<double>& levels, const TaskOptions& options) {
  return ask(surface, options, [&](const Asked& at) {
    return cut_out(at.mesh,
                   cut_at_levels(at.mesh, field, levels, Interpolation::distance, at.options.progress));
  });
}

CutMesh cut_along(const Surface& surface, const std::vector<std::vector<SurfacePoint>>& lines,
                  const TaskOptions& options) {
  return ask(surface, options, [&](const Asked& at) {
    return cut_out(at.mesh, cut_along(at.mesh, at.in(lines), at.options.progress));
  });
}

namespace {

Polygon polygon_out(const Mesh& mesh, GeodesicPolygon found) {
  Polygon out{found.area,
              found.perimeter,
              std::move(found.corners),
              std::move(found.angles),
              found.curvature,
              found.gauss_bonnet,
              std::move(found.vertices),
              std::move(found.faces),
              {}};
  for (const auto& leg : found.legs) out.legs.push_back(points_out(mesh, leg.path.points));
  return out;
}

}  // namespace

Polygon polygon(const Surface& surface, const PointList& points, const TaskOptions& options) {
  return ask(surface, options, [&](const Asked& at) {
    return polygon_out(at.mesh, geodesic_polygon(at.surface, at.in(points), at.options));
  });
}

Polygon convex_hull(const Surface& surface, const PointList& points, const TaskOptions& options) {
  return ask(surface, options, [&](const Asked& at) {
    return polygon_out(at.mesh, convex_hull(at.surface, at.in(points), at.options));
  });
}

std::vector<RegionArea> region_areas(const Surface& surface, const std::vector<int>& label,
                                     const TaskOptions& options) {
  return ask(surface, options, [&](const Asked& at) {
    require_count(label.size(), static_cast<std::size_t>(surface.face_count()), "label", "faces");
    const int last = label.empty() ? -1 : std::ranges::max(label);
    return region_areas(at.mesh, label, static_cast<std::size_t>(std::max(last, -1) + 1), at.options);
  });
}

RegionArea enclosed_area(const Surface& surface, const PointList& curve, const TaskOptions& options) {
  return ask(surface, options,
             [&](const Asked& at) { return enclosed_area(at.mesh, at.in(curve), at.options); });
}

SetDistances set_distances(const Surface& surface, const PointList& first, const PointList& second,
                           const TaskOptions& options) {
  return ask(surface, options, [&](const Asked& at) {
    return set_distances(at.surface, at.in(first), at.in(second), at.options);
  });
}

std::vector<Eccentricity> eccentricities(const Surface& surface, const PointList& points,
                                         const TaskOptions& options) {
  return ask(surface, options,
             [&](const Asked& at) { return eccentricities(at.surface, at.in(points), at.options); });
}

Extent extent(const Surface& surface, int max_fields, const TaskOptions& options) {
  return ask(surface, options, [&](const Asked& at) {
    const auto found =
        extent_of_component(at.surface, largest_component(at.mesh).first_vertex, max_fields, at.options);
    return Extent{{found.diameter.lower, found.diameter.upper},
                  {found.ends[0], found.ends[1]},
                  {found.radius.lower, found.radius.upper},
                  found.centre};
  });
}

// ---- Directions

std::vector<TangentFrame> tangent_frames(const Surface& surface, const PointList& points) {
  return ask(surface, TaskOptions{}, [&](const Asked& at) {
    std::vector<TangentFrame> out;
    for (const auto& [x, y, normal] : tangent_frames(at.surface, at.in(points))) {
      out.push_back({x, y, normal});
    }
    return out;
  });
}

LogMap log_map(const Surface& surface, const SurfacePoint& from, const LogMapOptions& options) {
  return ask(surface, TaskOptions{options.by, options.progress}, [&](const Asked& at) {
    std::optional<inner::PointList> targets;
    if (!options.targets.empty()) targets = at.in(options.targets);
    auto found = log_map(at.surface, at.in(from), targets, options.limit, at.options);
    const int unreached = at.answered.unreached;
    if (targets) return LogMap{std::move(found.vector), std::move(found.distance), unreached};
    const InputMap map(at.mesh);
    return LogMap{map.of_vertices(std::move(found.vector)), map.of_vertices(std::move(found.distance)),
                  unreached};
  });
}

std::vector<Tangent> gradient(const Surface& surface, const PointList& sources,
                              const GradientOptions& options) {
  return ask(surface, TaskOptions{Answer::exact, options.progress}, [&](const Asked& at) {
    std::optional<inner::PointList> points;
    if (!options.points.empty()) points = at.in(options.points);
    return gradient(at.surface, at.in(sources), points, options.limit, at.options);
  });
}

std::vector<Tangent> transport(const Surface& surface, const PointList& path,
                               const std::vector<Tangent>& vectors) {
  return ask(surface, TaskOptions{},
             [&](const Asked& at) { return transport(at.surface, at.in(path), vectors); });
}

std::vector<Tangent> transport_from(const Surface& surface, const SurfacePoint& from, const Tangent& vector,
                                    const TransportOptions& options) {
  return ask(surface, TaskOptions{Answer::exact, options.progress}, [&](const Asked& at) {
    return transport_from(at.surface, at.in(from), vector, options.limit, at.options);
  });
}

std::vector<TracedEnd> exp_map(const Surface& surface, const PointList& from,
                               const std::vector<Tangent>& vectors, const ExpMapOptions& options) {
  return ask(surface, TaskOptions{Answer::exact, options.progress}, [&](const Asked& at) {
    std::vector<TracedEnd> out;
    for (const auto& end : exp_map(at.surface, at.in(from), vectors,
                                   options.slide ? AtBorder::slide : AtBorder::end, at.options)) {
      out.push_back({point_out(at.mesh, end.point), end.length});
    }
    return out;
  });
}

}  // namespace v0
}  // namespace vorogeo
