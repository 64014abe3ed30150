// Tasks on a surface: matrices, regions, samplings, lines; files of results.
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/pair.h>

#include <optional>
#include <span>

#include "bindings.h"
#include "mesh/outliers.h"
#include "support/file.h"
#include "support/memory.h"
#include "tasks/bands.h"
#include "tasks/clusters.h"
#include "tasks/curves.h"
#include "tasks/cut.h"
#include "tasks/cut_locus.h"
#include "tasks/directions.h"
#include "tasks/distance_gradient.h"
#include "tasks/distance_matrix.h"
#include "tasks/extent.h"
#include "tasks/girth.h"
#include "tasks/loops.h"
#include "tasks/means.h"
#include "tasks/neighbors.h"
#include "tasks/path_through.h"
#include "tasks/polygon.h"
#include "tasks/profile.h"
#include "tasks/region_areas.h"
#include "tasks/set_distances.h"
#include "tasks/signed_distance.h"
#include "tasks/spread_points.h"
#include "tasks/surface_lines.h"
#include "tasks/texture.h"
#include "tasks/voronoi_regions.h"

namespace vorogeo::python {

namespace {

// ---- Matrices and neighbours

template <class Entry>
std::span<Entry> entries_of(const OutArray<Entry>& out) {
  return {out.data(), out.shape(0) * out.shape(1)};
}

/// Without `columns`, the points of the rows serve as columns as well.
template <class Entry>
std::tuple<> fill_matrix(const TaskOptions& options, const PythonSurface& self, const PointArrays& rows,
                         const OptionalPoints& columns, int entries, const OutArray<Entry>& out) {
  const auto how = static_cast<MatrixMethod>(entries);
  if (columns) {
    distance_matrix(*self.surface, self.points(rows), self.points(*columns), how, entries_of(out), options);
  } else {
    distance_matrix(*self.surface, self.points(rows), how, entries_of(out), options);
  }
  return {};
}

template <class Entry>
std::tuple<> fill_fields(const TaskOptions& options, const PythonSurface& self, const PointArrays& sources,
                         double max_distance, const OutArray<Entry>& out) {
  distance_fields(*self.surface, self.points(sources), max_distance, entries_of(out), options);
  return {};
}

/// Returns where each row begins, columns and distances. Without `others`, the pairs are those of `points`.
auto within(const TaskOptions& options, const PythonSurface& self, const PointArrays& points,
            const OptionalPoints& others, double radius, std::int64_t max_bytes) {
  const PointList from = self.points(points);
  auto found = others ? pairs_within(*self.surface, from, self.points(*others), radius, max_bytes, options)
                      : pairs_within(*self.surface, from, radius, max_bytes, options);
  return std::tuple(std::move(found.row_begin), std::move(found.column), std::move(found.distance));
}

auto nearest(const TaskOptions& options, const PythonSurface& self, const PointArrays& set,
             const PointArrays& queries, std::size_t count) {
  auto found = nearest_of_set(*self.surface, self.points(set), self.points(queries), count, options);
  return std::tuple(std::move(found.position), std::move(found.distance));
}

// ---- Curves

/// The single path that `task` returns for a list of points.
template <auto task, class... Arguments>
auto path_by(const TaskOptions& options, const PythonSurface& self, const PointArrays& points,
             Arguments... arguments) {
  return paths_of(self, {task(*self.surface, self.points(points), arguments..., options)});
}

/// `curve` has no points if none is given.
auto loop_through(const TaskOptions& options, const PythonSurface& self, const PointArrays& point,
                  const PointArrays& curve) {
  return paths_of(self, {shortest_loop(*self.surface, self.points(point)[0], self.points(curve), options)});
}

/// Section and loop as paths, the normal, the tape and its length. (x, y, z): the normal, if `is_given`.
auto girth_at(const TaskOptions& options, const PythonSurface& self, const PointArrays& point, double x,
              double y, double z, bool is_given) {
  auto found = girth(*self.surface, self.points(point)[0],
                     is_given ? std::optional(Point{x, y, z}) : std::nullopt, options);
  return std::tuple_cat(paths_of(self, {{std::move(found.section), false}, {std::move(found.loop), false}}),
                        std::tuple(std::vector<double>(found.normal.begin(), found.normal.end()),
                                   std::move(found.tape), found.tape_length));
}

auto along(const TaskOptions&, const PythonSurface& self, const PointArrays& path,
           const ValueArray& fractions) {
  return std::tuple(columns_of(self, points_along(self.mesh(), self.points(path), values_of(fractions))));
}

/// The points of a path and others, at most `spacing` apart; 0: a quarter of the typical edge.
auto stepped(const TaskOptions&, const PythonSurface& self, const PointArrays& path, double spacing) {
  const Mesh& mesh = self.mesh();
  const double wanted = spacing > 0.0 ? spacing : 0.25 * mesh.typical_edge_length();
  return std::tuple(columns_of(self, steps_along(mesh, self.points(path), wanted)));
}

auto profile_of(const TaskOptions&, const PythonSurface& self, const PointArrays& path, double x, double y,
                double z) {
  const auto locate = [&]() -> const SurfaceLocator& { return self.python_mesh.located(); };
  auto found = profile(self.mesh(), locate, self.points(path), {x, y, z});
  return std::tuple(std::move(found.along), std::move(found.height), std::move(found.angle),
                    std::move(found.curvature), std::move(found.thickness));
}

// ---- Regions, samplings, lines and measures

/// Regions and distances of vertices, regions of faces, areas; points and edges of borders, with two regions.
auto voronoi(const TaskOptions& options, const PythonSurface& self, const PointArrays& points) {
  auto found = voronoi_regions(*self.surface, self.points(points), options);
  const InputMap map(self.mesh());
  return std::tuple(map.of_vertices(std::move(found.vertex_region)),
                    map.of_vertices(std::move(found.distance)), map.of_faces(found.face_region, no_index),
                    std::move(found.area), std::move(found.borders.points), std::move(found.borders.segments),
                    std::move(found.border_regions));
}

/// Points, edges, and the level at each point.
auto isolines_of(const TaskOptions& options, const PythonSurface& self, const ValueArray& field,
                 const ValueArray& levels, int interpolation) {
  Isolines found = isolines(self.mesh(), values_of(field), values_of(levels),
                            static_cast<Interpolation>(interpolation), options.progress);
  return std::tuple(std::move(found.lines.points), std::move(found.lines.segments),
                    std::move(found.level_of_point));
}

auto farthest(const TaskOptions& options, const PythonSurface& self, Index count, double radius,
              const PointArrays& start, std::uint64_t seed) {
  auto found = sample_farthest(*self.surface, {count, radius}, self.points(start), seed, options);
  return std::tuple(columns_of(self, found.points), std::move(found.radius), std::move(found.distance),
                    found.covering_radius);
}

auto poisson_disk(const TaskOptions& options, const PythonSurface& self, double radius, std::uint64_t seed) {
  return std::tuple(sample_poisson_disk(*self.surface, radius, seed, options));
}

auto disk(const TaskOptions& options, const PythonSurface& self, const PointArrays& sources, double radius) {
  auto found = geodesic_disk(*self.surface, self.points(sources), radius, options);
  return std::tuple(std::move(found.vertices), std::move(found.distance), std::move(found.faces));
}

auto area_within(const TaskOptions& options, const PythonSurface& self, const PointArrays& sources,
                 double width) {
  const Band found = band(*self.surface, self.points(sources), width, options);
  return std::tuple(found.area, found.border_length);
}

/// Positions, faces, the points of the new vertices; for each face its input face and its region; edges; for
/// each face its side.
auto cut_out(const PythonSurface& self, CutMesh&& cut) {
  const Mesh& mesh = self.mesh();
  std::vector<Point> positions = positions_of(mesh, cut.points);
  PointColumns added;
  for (std::size_t i = static_cast<std::size_t>(mesh.given_vertex_count()); i < cut.points.size(); ++i) {
    added.add(mesh, cut.points[i]);
  }
  for (Index& face : cut.face_of) face = mesh.input_face(face);
  return std::tuple(std::move(positions), std::move(cut.faces), std::move(added), std::move(cut.face_of),
                    std::move(cut.region), std::move(cut.edges), std::move(cut.side));
}

auto cut_at_levels_of(const TaskOptions& options, const PythonSurface& self, const ValueArray& field,
                      const ValueArray& levels, int interpolation) {
  return cut_out(self, cut_at_levels(self.mesh(), values_of(field), values_of(levels),
                                     static_cast<Interpolation>(interpolation), options.progress));
}

/// `begin`: where each line begins in the list of points, and where the last one ends.
std::vector<std::vector<SurfacePoint>> lines_of(const PythonSurface& self, const PointArrays& points,
                                                const IdArray& begin) {
  const PointList all = self.points(points);
  std::vector<std::vector<SurfacePoint>> lines;
  for (std::size_t k = 0; k + 1 < begin.shape(0); ++k) {
    lines.emplace_back(all.begin() + begin(k), all.begin() + begin(k + 1));
  }
  return lines;
}

auto cut_along_lines(const TaskOptions& options, const PythonSurface& self, const PointArrays& points,
                     const IdArray& begin) {
  return cut_out(self, cut_along(self.mesh(), lines_of(self, points, begin), options.progress));
}

/// Area, perimeter, corners, angles, curvature, the residual of Gauss-Bonnet, vertices, faces; then the legs
/// as paths.
template <auto task>
auto polygon_by(const TaskOptions& options, const PythonSurface& self, const PointArrays& points) {
  GeodesicPolygon found = task(*self.surface, self.points(points), options);
  return std::tuple_cat(
      std::tuple(found.area, found.perimeter, std::move(found.corners), std::move(found.angles),
                 found.curvature, found.gauss_bonnet, std::move(found.vertices), std::move(found.faces)),
      paths_of(self, found.legs));
}

/// Columns: areas, lengths of borders, volumes.
auto columns_of_areas(const std::vector<RegionArea>& found) {
  std::vector<double> area, border_length, volume;
  for (const RegionArea& region : found) {
    area.push_back(region.area);
    border_length.push_back(region.border_length);
    volume.push_back(region.volume);
  }
  return std::tuple(std::move(area), std::move(border_length), std::move(volume));
}

/// `label`: one for each input face.
auto areas_of_regions(const TaskOptions& options, const PythonSurface& self, const IdArray& label,
                      std::size_t regions) {
  return columns_of_areas(
      region_areas(self.mesh(), std::span(label.data(), label.shape(0)), regions, options));
}

auto area_inside(const TaskOptions& options, const PythonSurface& self, const PointArrays& curve) {
  return columns_of_areas({enclosed_area(self.mesh(), self.points(curve), options)});
}

auto distances_of_sets(const TaskOptions& options, const PythonSurface& self, const PointArrays& first,
                       const PointArrays& second) {
  auto found = set_distances(*self.surface, self.points(first), self.points(second), options);
  return std::tuple(std::move(found.to_second), std::move(found.to_first), found.nearest, found.mean,
                    found.hausdorff);
}

auto eccentricity(const TaskOptions& options, const PythonSurface& self, const PointArrays& points) {
  std::vector<double> distance;
  std::vector<Index> vertex;
  for (const Eccentricity& one : eccentricities(*self.surface, self.points(points), options)) {
    distance.push_back(one.distance);
    vertex.push_back(one.farthest);
  }
  return std::tuple(std::move(distance), std::move(vertex));
}

/// `start`: no_index for the largest component.
auto extent(const TaskOptions& options, const PythonSurface& self, Index start, Index max_fields) {
  const Index first = start == no_index ? largest_component(self.mesh()).first_vertex : start;
  const auto found = extent_of_component(*self.surface, first, max_fields, options);
  return std::tuple(std::pair(found.diameter.lower, found.diameter.upper),
                    std::pair(found.ends[0], found.ends[1]),
                    std::pair(found.radius.lower, found.radius.upper), found.centre, found.fields);
}

auto relax(const TaskOptions& options, const PythonSurface& self, const PointArrays& points, Index rounds) {
  auto found = relax_points(*self.surface, self.points(points), rounds, options);
  return std::tuple(columns_of(self, found.points), std::move(found.energy));
}

// ---- Directions

/// Three rows for each point: x axis, y axis and normal.
auto axes_at(const TaskOptions&, const PythonSurface& self, const PointArrays& points) {
  std::vector<Point> rows;
  for (const auto& axes : tangent_frames(*self.surface, self.points(points))) {
    rows.insert(rows.end(), axes.begin(), axes.end());
  }
  return std::tuple(std::move(rows));
}

/// Vectors and distances of `targets`; without these, of all vertices.
auto logarithms(const TaskOptions& options, const PythonSurface& self, const PointArrays& point,
                const OptionalPoints& targets, double max_distance) {
  auto found = log_map(*self.surface, self.points(point)[0], self.points(targets), max_distance, options);
  if (targets) return std::tuple(std::move(found.vector), std::move(found.distance));
  const InputMap map(self.mesh());
  return std::tuple(map.of_vertices(std::move(found.vector)), map.of_vertices(std::move(found.distance)));
}

/// The gradient at `points`; without these, at all vertices.
auto gradients(const TaskOptions& options, const PythonSurface& self, const PointArrays& sources,
               const OptionalPoints& points, double max_distance) {
  return std::tuple(
      gradient(*self.surface, self.points(sources), self.points(points), max_distance, options));
}

auto carried(const TaskOptions&, const PythonSurface& self, const PointArrays& path,
             const TangentArray& vectors) {
  return std::tuple(transport(*self.surface, self.points(path), rows_of<2>(vectors)));
}

auto carried_to_vertices(const TaskOptions& options, const PythonSurface& self, const PointArrays& point,
                         const TangentArray& vector, double max_distance) {
  return std::tuple(
      transport_from(*self.surface, self.points(point)[0], rows_of<2>(vector)[0], max_distance, options));
}

/// End points and lengths of straightest lines.
auto line_ends(const TaskOptions& options, const PythonSurface& self, const PointArrays& points,
               const TangentArray& vectors, bool slides) {
  PointColumns columns;
  std::vector<double> lengths;
  for (const TracedEnd& end : exp_map(*self.surface, self.points(points), rows_of<2>(vectors),
                                      slides ? AtBorder::slide : AtBorder::end, options)) {
    columns.add(self.mesh(), end.point);
    lengths.push_back(end.length);
  }
  return std::tuple(std::move(columns), std::move(lengths));
}

// ---- Means and clusters

/// `power`: two for a mean, one for a median.
auto centre(const TaskOptions& options, const PythonSurface& self, const PointArrays& points,
            const ValueArray& weights, int power) {
  return std::tuple(columns_of(self, {centre_of(*self.surface, self.points(points), values_of(weights),
                                                static_cast<Power>(power), options)
                                          .point}));
}

auto medoid_of(const TaskOptions& options, const PythonSurface& self, const PointArrays& points,
               const ValueArray& weights) {
  return std::tuple(medoid(*self.surface, self.points(points), values_of(weights), options));
}

/// Centres, labels, and the energy of each round. Without `points`, all vertices are clustered.
auto clusters(const TaskOptions& options, const PythonSurface& self, Index count,
              const OptionalPoints& points, const ValueArray& weights, int power, Index rounds,
              std::uint64_t seed) {
  auto found = clusters_of(*self.surface, count, self.points(points), values_of(weights),
                           static_cast<Power>(power), rounds, seed, options);
  return std::tuple(columns_of(self, found.centres), std::move(found.label), std::move(found.energy));
}

// ---- Sides, derivatives, where paths meet

auto signed_by_lines(const TaskOptions& options, const PythonSurface& self, const PointArrays& points,
                     const IdArray& begin, double max_distance) {
  return std::tuple(signed_distance(*self.surface, lines_of(self, points, begin), max_distance, options));
}

/// `in_region`: one flag for each input face.
auto signed_by_region(const TaskOptions& options, const PythonSurface& self, const FlagArray& in_region,
                      double max_distance) {
  return std::tuple(signed_distance(*self.surface, values_of(in_region), max_distance, options));
}

auto distance_gradients(const TaskOptions& options, const PythonSurface& self, const PointArrays& sources,
                        const PointArrays& targets) {
  auto found = distance_gradient(*self.surface, {self.points(sources), self.points(targets)}, options);
  return std::tuple(std::move(found.distance), std::move(found.pair), std::move(found.vertex),
                    std::move(found.gradient));
}

/// Positions, edges, distances and angles, then the points.
auto cut_locus_of(const TaskOptions& options, const PythonSurface& self, const PointArrays& sources,
                  double min_angle, double max_distance) {
  auto found = cut_locus(*self.surface, self.points(sources), min_angle, max_distance, options);
  return std::tuple(positions_of(self.mesh(), found.points), std::move(found.edges),
                    std::move(found.distance), std::move(found.angle), columns_of(self, found.points));
}

/// Coordinates of each vertex, stretch of each input face.
auto texture(const TaskOptions& options, const PythonSurface& self, const PointArrays& point, double radius,
             double rotation, double scale) {
  auto found = texture_coordinates(*self.surface, self.points(point)[0], {radius, rotation, scale}, options);
  return std::tuple(std::move(found.coordinates), std::move(found.stretch));
}

}  // namespace

void bind_tasks(nb::class_<PythonSurface>& surface) {
  bind_question(surface, "fill_matrix", &fill_matrix<double>);
  bind_question(surface, "fill_matrix", &fill_matrix<float>);
  bind_question(surface, "fill_fields", &fill_fields<double>);
  bind_question(surface, "fill_fields", &fill_fields<float>);
  bind_question(surface, "pairs_within", &within);
  bind_question(surface, "nearest", &nearest);
  bind_question(surface, "path_through", &path_by<path_through, bool>);
  bind_question(surface, "tighten", &path_by<tighten, bool>);
  bind_question(surface, "shortest_loop", &loop_through);
  bind_question(surface, "girth", &girth_at);
  bind_question(surface, "profile", &profile_of);
  bind_question(surface, "voronoi", &voronoi);
  bind_question(surface, "isolines", &isolines_of);
  bind_question(surface, "sample_farthest", &farthest);
  bind_question(surface, "sample_poisson_disk", &poisson_disk);
  bind_question(surface, "disk", &disk);
  bind_question(surface, "band", &area_within);
  bind_question(surface, "cut_at_levels", &cut_at_levels_of);
  bind_question(surface, "cut_along", &cut_along_lines);
  bind_question(surface, "region_areas", &areas_of_regions);
  bind_question(surface, "enclosed_area", &area_inside);
  bind_question(surface, "polygon", &polygon_by<geodesic_polygon>);
  bind_question(surface, "convex_hull", &polygon_by<convex_hull>);
  bind_question(surface, "set_distances", &distances_of_sets);
  bind_question(surface, "eccentricity", &eccentricity);
  bind_question(surface, "extent", &extent);
  bind_question(surface, "relax", &relax);
  bind_question(surface, "tangent_frames", &axes_at);
  bind_question(surface, "log_map", &logarithms);
  bind_question(surface, "exp_map", &line_ends);
  bind_question(surface, "gradient", &gradients);
  bind_question(surface, "transport", &carried);
  bind_question(surface, "transport_from", &carried_to_vertices);
  bind_question(surface, "points_along", &along);
  bind_question(surface, "steps_along", &stepped);
  bind_question(surface, "bezier", &path_by<bezier, Index>);
  bind_question(surface, "b_spline", &path_by<b_spline, bool, Index>);
  bind_question(surface, "spline", &path_by<spline, bool, Index>);
  bind_question(surface, "centre", &centre);
  bind_question(surface, "medoid", &medoid_of);
  bind_question(surface, "clusters", &clusters);
  bind_question(surface, "signed_distance", &signed_by_lines);
  bind_question(surface, "region_distance", &signed_by_region);
  bind_question(surface, "distance_gradient", &distance_gradients);
  bind_question(surface, "cut_locus", &cut_locus_of);
  bind_question(surface, "texture_coordinates", &texture);
}

// ---- The class _core.OutputFile: a file that Python maps and that replaces its target when complete

namespace {

/// Creates the file: `head`, followed by `size` reserved bytes.
OutputFile* make(const std::filesystem::path& file, const std::string& what, const nb::bytes& head,
                 std::uint64_t size) {
  nb::gil_scoped_release release;
  auto out = std::make_unique<OutputFile>(file, what);
  out->reserve(head.size() + size);
  out->write(std::as_bytes(std::span(head.c_str(), head.size())));
  return out.release();
}

}  // namespace

void bind_output(nb::module_& module) {
  module.def("require_memory", &require_memory);
  nb::class_<OutputFile>(module, "OutputFile")
      .def_static("make", &make)
      .def_prop_ro("temporary", &OutputFile::temporary)
      .def("finish", &OutputFile::finish, nb::call_guard<nb::gil_scoped_release>())
      .def("discard", &OutputFile::discard);
}

}  // namespace vorogeo::python
