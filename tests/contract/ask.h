// Every public question as contract tests ask it: the only file of this folder that knows the core's classes.
#pragma once

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "mesh/mesh_input.h"
#include "mesh/metric.h"
#include "query/surface.h"
#include "support/error.h"
#include "support/indexes.h"
#include "support/refusal.h"
#include "support/shapes.h"
#include "tasks/bands.h"
#include "tasks/cut.h"
#include "tasks/distance_matrix.h"
#include "tasks/extent.h"
#include "tasks/neighbors.h"
#include "tasks/polygon.h"
#include "tasks/set_distances.h"
#include "tasks/spread_points.h"
#include "tasks/surface_lines.h"
#include "tasks/voronoi_regions.h"

namespace vorogeo::contract {

/// What answers a question.
enum class By { exact, index, quick };
inline const char* to_string(By by) {
  return by == By::exact ? "exact" : by == By::index ? "from the index" : "quick";
}

// Metrics, each with a value for each vertex or face. EdgeLengths: of the sides opposite each corner.
struct EdgeLengths {
  SideLengths sides;
};
struct VertexCost {
  std::vector<double> cost;
};
struct VertexTensor {
  std::vector<Tensor> tensors;
};
struct FaceCost {
  std::vector<double> cost;
};
struct FaceTensor {
  std::vector<Tensor> tensors;
};
using Metric = std::variant<std::monostate, EdgeLengths, VertexCost, VertexTensor, FaceCost, FaceTensor>;

/// A surface as a user has it.
struct Input {
  test::Soup soup;
  Metric metric{};
  double gap = 0.0;
  bool folds = false;
};

/// How the index is built: patches of the first layer, and of the second in each of these; 0: automatic.
struct Build {
  Index patches = 0;
  Index patches_in_each = 0;
  int threads = 1;
  bool small = false;  ///< the form that takes little memory
  double delta = 0.0;
};

using Source = ExactSource;
using Field = LabelledField;
using Regions = VoronoiRegions;
using Samples = FarthestSamples;
using Sparse = SparseDistances;
using Nearest = NearestOfSet;

/// A path from the first point asked for to the second.
struct Path {
  SurfacePath line;
  bool certified = false;

  double length() const { return line.length; }
};

/// A surface that answers. Vertices, faces and points are numbered as in the input, in questions and in
/// answers.
class Ask {
 public:
  explicit Ask(Input input, const Build& build = {})
      : input_(std::move(input)), mesh_(mesh_of(input_)), options_(options_of(build)) {
    surface_ = std::make_unique<vorogeo::Surface>(mesh_, options_);
  }
  explicit Ask(const test::Soup& soup, const Build& build = {}) : Ask(Input{soup}, build) {}
  /// With the index loaded from a file.
  static Ask loaded(const std::filesystem::path& file, const Input& input, const Build& build = {}) {
    Ask ask(input, build);
    ask.surface_ = std::make_unique<vorogeo::Surface>(ask.mesh_, GeodesicIndex::load(file, ask.mesh_),
                                                      RentOrBuy(ask.mesh_->vertex_count()), ask.options_);
    return ask;
  }
  void save(const std::filesystem::path& file) const { index()->save(file); }

  const Input& input() const { return input_; }
  const test::Soup& soup() const { return input_.soup; }
  Index vertex_count() const { return static_cast<Index>(input_.soup.positions.size()); }
  double longest_edge() const { return mesh_->longest_edge_length(); }

  Field field(const std::vector<Source>& sources, By by, double limit = unreachable) const {
    std::vector<Source> inside;
    for (const auto& [point, offset] : sources) inside.push_back({into(point), offset});
    Answered answered;
    Field found = surface_->field(inside, limit, method(by), answered);
    found.distance.resize(input_.soup.positions.size());
    found.source.resize(input_.soup.positions.size());
    return found;
  }
  double distance(const SurfacePoint& a, const SurfacePoint& b, By by) const {
    Answered answered;
    return surface_->distance(into(a), into(b), method(by), answered);
  }
  /// The refined path, if it is answered by the index.
  Path path(const SurfacePoint& a, const SurfacePoint& b, By by) const { return path(a, b, by, false); }
  /// The path that is proven to be shortest.
  Path exact_path(const SurfacePoint& a, const SurfacePoint& b, By by) const { return path(a, b, by, true); }

  std::vector<double> matrix(const std::vector<SurfacePoint>& rows, const std::vector<SurfacePoint>& columns,
                             By by) const {
    std::vector<double> result(rows.size() * columns.size());
    distance_matrix(*surface_, into(rows), into(columns), MatrixMethod::automatic, std::span(result),
                    task(by));
    return result;
  }
  /// Between the points of one list.
  std::vector<double> matrix(const std::vector<SurfacePoint>& points, By by) const {
    std::vector<double> result(points.size() * points.size());
    distance_matrix(*surface_, into(points), MatrixMethod::automatic, std::span(result), task(by));
    return result;
  }
  Sparse pairs_within(const std::vector<SurfacePoint>& points, double radius, By by) const {
    return vorogeo::pairs_within(*surface_, into(points), radius, 0, task(by));
  }
  Sparse pairs_within(const std::vector<SurfacePoint>& points, const std::vector<SurfacePoint>& others,
                      double radius, By by) const {
    return vorogeo::pairs_within(*surface_, into(points), into(others), radius, 0, task(by));
  }
  Nearest nearest(const std::vector<SurfacePoint>& set, const std::vector<SurfacePoint>& queries,
                  std::size_t count, By by) const {
    return nearest_of_set(*surface_, into(set), into(queries), count, task(by));
  }
  Regions regions(const std::vector<SurfacePoint>& sites, By by) const {
    Regions found = voronoi_regions(*surface_, into(sites), task(by));
    found.vertex_region.resize(input_.soup.positions.size());
    found.distance.resize(input_.soup.positions.size());
    return found;
  }
  Samples farthest_points(Index count, double radius, const std::vector<SurfacePoint>& start, By by,
                          std::uint64_t seed = 0) const {
    Samples found = sample_farthest(*surface_, {count, radius}, into(start), seed, task(by));
    found.distance.resize(input_.soup.positions.size());
    return found;
  }
  std::vector<Index> poisson_disk(double radius, By by, std::uint64_t seed = 0) const {
    return sample_poisson_disk(*surface_, radius, seed, task(by));
  }
  RelaxedPoints relaxed(const std::vector<SurfacePoint>& points, Index rounds, By by) const {
    return relax_points(*surface_, into(points), rounds, task(by));
  }
  std::vector<Eccentricity> eccentricities(const std::vector<SurfacePoint>& points, By by) const {
    return vorogeo::eccentricities(*surface_, into(points), task(by));
  }
  Extent extent(Index start, Index fields, By by) const {
    return extent_of_component(*surface_, start, fields, task(by));
  }
  Disk disk(const std::vector<SurfacePoint>& sources, double radius, By by) const {
    return geodesic_disk(*surface_, into(sources), radius, task(by));
  }
  Band band(const std::vector<SurfacePoint>& sources, double width, By by) const {
    return vorogeo::band(*surface_, into(sources), width, task(by));
  }
  SetDistances set_distances(const std::vector<SurfacePoint>& first, const std::vector<SurfacePoint>& second,
                             By by) const {
    return vorogeo::set_distances(*surface_, into(first), into(second), task(by));
  }
  GeodesicPolygon polygon(const std::vector<SurfacePoint>& points, By by) const {
    return geodesic_polygon(*surface_, into(points), task(by));
  }
  GeodesicPolygon convex_hull(const std::vector<SurfacePoint>& points, By by) const {
    return vorogeo::convex_hull(*surface_, into(points), task(by));
  }
  /// \pre No face is split.
  CutMesh cut_at_levels(const std::vector<double>& values, const std::vector<double>& levels,
                        Interpolation interpolation = Interpolation::distance) const {
    return vorogeo::cut_at_levels(*mesh_, values, levels, interpolation);
  }
  /// \pre No face is split.
  CutMesh cut_along(const std::vector<std::vector<SurfacePoint>>& lines) const {
    std::vector<std::vector<SurfacePoint>> inside;
    for (const auto& line : lines) inside.push_back(into(line));
    return vorogeo::cut_along(*mesh_, inside);
  }
  /// The mesh that is measured on, without the faces that are left out. \pre No face is split.
  const Mesh& mesh() const { return *mesh_; }
  /// Of a field of distances. \pre No face is split.
  Isolines isolines(const std::vector<double>& values, const std::vector<double>& levels) const {
    return vorogeo::isolines(*mesh_, values, levels, Interpolation::distance);
  }
  /// Of any field, linear between the values of vertices. \pre No face is split.
  Isolines isolines_of_any(const std::vector<double>& values, const std::vector<double>& levels) const {
    return vorogeo::isolines(*mesh_, values, levels, Interpolation::linear);
  }

 private:
  static std::shared_ptr<const Mesh> mesh_of(const Input& input) {
    const auto& [positions, faces] = input.soup;
    auto measured = [&](const vorogeo::Metric& metric) {
      return measured_mesh({positions, faces, metric, {input.gap, input.folds}});
    };
    if (const auto* given = std::get_if<EdgeLengths>(&input.metric)) return measured(given->sides);
    if (const auto* given = std::get_if<VertexCost>(&input.metric)) {
      return measured(lengths_by_cost(positions, faces, given->cost));
    }
    if (const auto* given = std::get_if<VertexTensor>(&input.metric)) {
      return measured(lengths_by_tensor(positions, faces, given->tensors));
    }
    if (const auto* given = std::get_if<FaceCost>(&input.metric)) {
      return measured({sides_by_face_cost(positions, faces, given->cost), usual_edge_points});
    }
    if (const auto* given = std::get_if<FaceTensor>(&input.metric)) {
      const SideLengths sides = sides_by_face_tensor(positions, faces, given->tensors);
      return measured({sides, edge_points_for(positions, faces, sides)});
    }
    return measured({});
  }
  static IndexOptions options_of(const Build& build) {
    IndexOptions options;
    options.first_layer_patches = build.patches;
    options.second_layer_patches = build.patches_in_each;
    options.threads = build.threads;
    options.delta = build.delta;
    if (build.small) options.delta = std::max(build.delta, test::lossless_delta);
    return options;
  }
  static Answer method(By by) {
    return by == By::exact ? Answer::exact : by == By::index ? Answer::index : Answer::quick;
  }
  std::shared_ptr<const GeodesicIndex> index() const { return surface_->build_index(); }
  static TaskOptions task(By by) { return {.by = method(by)}; }
  Path path(const SurfacePoint& a, const SurfacePoint& b, By by, bool exact) const {
    Answered answered;
    ExactPath found = surface_->path(into(a), into(b), method(by), {.exact = exact}, answered);
    for (SurfacePoint& point : found.path.points) point = out_of(point);
    return {std::move(found.path), found.certified};
  }

  /// A point of the input as one of the mesh that is measured on; if it is not on it, it is refused there.
  SurfacePoint into(const SurfacePoint& point) const {
    if (point.is_vertex() || point.face < 0 || point.face >= static_cast<Index>(input_.soup.faces.size())) {
      return point;
    }
    return InputMap(*mesh_).in_face(point.face, point.barycentric).value_or(point);
  }
  std::vector<SurfacePoint> into(const std::vector<SurfacePoint>& points) const {
    std::vector<SurfacePoint> inside;
    for (const SurfacePoint& point : points) inside.push_back(into(point));
    return inside;
  }
  /// The inverse of into(). Bridges over gaps are numbered after the faces of the input.
  SurfacePoint out_of(const SurfacePoint& point) const {
    if (point.is_vertex() && point.vertex < vertex_count()) return point;
    if (!point.is_vertex() && mesh_->is_bridge(point.face)) {
      const auto faces = static_cast<Index>(input_.soup.faces.size());
      return SurfacePoint::in_face(faces + point.face - mesh_->first_bridge(), point.barycentric);
    }
    const InputPoint out = InputMap(*mesh_).point_out(point);
    return SurfacePoint::in_face(out.face, out.weights);
  }

  Input input_;
  std::shared_ptr<const Mesh> mesh_;
  IndexOptions options_;
  std::unique_ptr<vorogeo::Surface> surface_;
};

/// The sentence with which a question is refused; empty if it is answered.
template <class Question>
std::string refusal(Question&& question) {
  return test::refusal<Error>(question);
}

}  // namespace vorogeo::contract
