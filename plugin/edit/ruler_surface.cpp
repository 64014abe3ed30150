// Which part of the core answers: the index if there is one, else exact propagation or virtual sources.
#include "edit/ruler_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "exact/exact_solver.h"
#include "methods/method_table.h"

namespace vorogeo::plugin {

namespace {

/// About how many isolines there are.
constexpr double isolines_wanted = 15.0;

Index nearest_corner(const Mesh& mesh, const SurfacePoint& point) {
  if (point.is_vertex()) return point.vertex;
  const auto heaviest = std::max_element(point.barycentric.begin(), point.barycentric.end());
  return mesh.face_vertices(point.face)[heaviest - point.barycentric.begin()];
}

}  // namespace

const char* name_of(Answered how, bool is_path) {
  if (how == Answered::exactly) return "exact";
  if (how == Answered::quickly) return "quick";
  return is_path ? "refined" : "index";
}

std::vector<double> round_values(double largest) {
  std::vector<double> values;
  if (!(largest > 0.0) || !std::isfinite(largest)) return values;
  const double least_step = largest / isolines_wanted;
  const double power = std::pow(10.0, std::floor(std::log10(least_step)));
  double step = 10.0 * power;
  for (double factor : {5.0, 2.0, 1.0}) {
    if (factor * power >= least_step * (1.0 - 1e-9)) step = factor * power;
  }
  for (int i = 1; i * step < largest; ++i) values.push_back(i * step);
  return values;
}

RulerSurface::RulerSurface(VcgMeshArrays arrays, std::shared_ptr<const GeodesicIndex> index)
    : arrays_(std::move(arrays)), index_(std::move(index)) {}

std::shared_ptr<const Mesh> RulerSurface::mesh() const {
  const std::lock_guard lock(mutex_);
  if (!mesh_) {
    mesh_ = index_ ? index_->mesh() : std::make_shared<const Mesh>(arrays_.positions, arrays_.faces);
  }
  return mesh_;
}

std::shared_ptr<const GeodesicIndex> RulerSurface::index() const {
  const std::lock_guard lock(mutex_);
  return index_;
}

void RulerSurface::use(std::shared_ptr<const GeodesicIndex> index) {
  const std::lock_guard lock(mutex_);
  index_ = std::move(index);
}

bool RulerSurface::snap(const Picked& picked, SurfacePoint& point) {
  if (!locator_) locator_ = std::make_unique<SurfaceLocator>(mesh());
  const SnappedPoint found = locator_->nearest(picked.at);
  point = found.point;
  return found.distance <= picked.tolerance;
}

PathAnswer RulerSurface::path(const Picked& from, const Picked& to, const Progress& progress) {
  PathAnswer answer;
  SurfacePoint source;
  SurfacePoint target;
  answer.starts_on_surface = snap(from, source);
  answer.ends_on_surface = snap(to, target);
  if (!answer.starts_on_surface || !answer.ends_on_surface) return answer;
  const auto surface = mesh();
  answer.from = position_of(*surface, source);
  answer.to = position_of(*surface, target);
  if (const auto found = index()) {
    if (!index_paths_) index_paths_ = std::make_unique<PathQuery>(found);
    answer.how = Answered::by_index;
    answer.path = index_paths_->path(source, target);
    return answer;
  }
  if (!exact_paths_) exact_paths_ = std::make_unique<PathsFromPoint>(surface);
  if (exact_source_ != source) {
    exact_paths_->reset(source);
    exact_source_ = source;
  }
  answer.path = exact_paths_->path_to(target, progress);
  return answer;
}

FieldAnswer RulerSurface::field(const Picked& from, const Progress& progress) {
  FieldAnswer answer;
  SurfacePoint source;
  answer.starts_on_surface = snap(from, source);
  if (!answer.starts_on_surface) return answer;
  const auto surface = mesh();
  const std::array sources{ExactSource{source}};
  if (const auto found = index()) {
    if (!index_fields_) index_fields_ = std::make_unique<GeodesicQuery>(found);
    answer.how = Answered::by_index;
    answer.distances = index_fields_->distance_field(sources);
  } else if (surface->vertex_count() <= max_exact_vertices) {
    ExactSolver solver(surface);
    ExactLimits limits;
    limits.distances_only = true;
    limits.progress = &progress;
    solver.run(sources, limits);
    for (Index v = 0; v < surface->vertex_count(); ++v) answer.distances.push_back(solver.distance(v));
  } else {
    if (!quick_fields_) quick_fields_ = prepare_method("gsp", surface, {}, progress);
    answer.how = Answered::quickly;
    const std::array vertex{nearest_corner(*surface, source)};
    answer.distances = quick_fields_->field(vertex, progress);
  }
  for (double distance : answer.distances) {
    if (std::isfinite(distance)) answer.largest = std::max(answer.largest, distance);
  }
  answer.lines = isolines(*surface, answer.distances, round_values(answer.largest), Interpolation::distance);
  return answer;
}

}  // namespace vorogeo::plugin
