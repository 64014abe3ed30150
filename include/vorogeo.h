// VoroGeo: geodesic distances and shortest paths on triangle meshes. The public interface of the C++ library.
//
//     #include <vorogeo.h>
//     vorogeo::Surface surface(positions, faces);
//     std::vector<double> distance = surface.distances_from(0);
//     vorogeo::Path path = surface.path(0, surface.snap({1, 2, 3}), {.exact = true});
//
// Vertices and faces are numbered from 0 as they were given, in arguments and in results; -1 stands for none.
// Every function throws the errors of vorogeo/errors.h and nothing else of its own.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <limits>
#include <memory>
#include <ranges>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "vorogeo/errors.h"
#include "vorogeo/results.h"

namespace vorogeo {
inline namespace v0 {

/// Coordinates in space.
using Point = std::array<double, 3>;
/// A symmetric 3 x 3 matrix, row by row.
using Tensor = std::array<double, 9>;
/// The distance where no path leads.
inline constexpr double unreachable = std::numeric_limits<double>::infinity();
/// Receives the fraction done in [0, 1] and what is being done; returns false to cancel. Called from the
/// thread that asked.
using ProgressFunction = std::function<bool(double fraction, const std::string& activity)>;

// ---- Points of a surface

/// A point of a surface: a vertex, or a place in a face. A vertex number converts to one.
struct SurfacePoint {
  int vertex = -1;
  int face = -1;
  /// Weights of the corners of `face`: not negative, sum 1.
  std::array<double, 3> weights{};

  SurfacePoint() = default;
  /// From a whole number of any type; one too large for a vertex becomes -1, which is refused.
  template <std::integral Number>
  SurfacePoint(Number vertex_number)  // NOLINT(google-explicit-constructor)
      : vertex(std::in_range<int>(vertex_number) ? static_cast<int>(vertex_number) : -1) {}
  SurfacePoint(int face_number, const std::array<double, 3>& corner_weights)
      : face(face_number), weights(corner_weights) {}

  friend bool operator==(const SurfacePoint&, const SurfacePoint&) = default;
};

/// One or several points: a point, a list in braces, or any range of points or of vertex numbers.
class PointList {
 public:
  PointList() = default;
  PointList(std::initializer_list<SurfacePoint> points) : points_(points) {}
  template <std::convertible_to<SurfacePoint> One>
  PointList(const One& point) : points_{SurfacePoint(point)} {}  // NOLINT(google-explicit-constructor)
  template <std::ranges::input_range Range>
  requires(std::convertible_to<std::ranges::range_value_t<Range>, SurfacePoint> &&
           !std::same_as<std::remove_cvref_t<Range>, PointList>) PointList(const Range& points)
      : points_(std::ranges::begin(points), std::ranges::end(points)) {}  // NOLINT

  std::size_t size() const { return points_.size(); }
  bool empty() const { return points_.empty(); }
  const SurfacePoint& operator[](std::size_t i) const { return points_[i]; }
  auto begin() const { return points_.begin(); }
  auto end() const { return points_.end(); }

 private:
  std::vector<SurfacePoint> points_;
};

/// A point of the surface and its distance in space from the position that it is the nearest to.
struct SnappedPoint {
  SurfacePoint point;
  double distance = 0.0;
};

// ---- Options and answers

/// The metric that distances are measured in, and the part of the mesh. Of the first four and side_lengths,
/// at most one is given.
struct SurfaceOptions {
  /// By vertex, above 0, linear over each face: what a unit of length costs. Infinite: no path enters the
  /// faces at the vertex.
  std::vector<double> vertex_cost = {};
  /// By vertex, linear over each face: the squared length of a step v is v' G v. Positive on the faces.
  std::vector<Tensor> vertex_tensor = {};
  /// By face, above 0: what a unit of length costs; paths refract at edges. Infinite: no path enters the
  /// face, but paths may run along its border.
  std::vector<double> face_cost = {};
  /// By face: the squared length of a step v in it is v' G v; paths refract at edges.
  std::vector<Tensor> face_tensor = {};
  /// By face, alone or with face_cost or face_tensor: a vector w of a norm below 1 in the metric of the face.
  /// A step v costs w . v more, the step back as much less. Answers are exact, without an index.
  std::vector<Point> face_drift = {};
  /// By face, each side opposite the corner of the same number: lengths instead of those in space.
  std::vector<std::array<double, 3>> side_lengths = {};
  /// By face or by vertex: false leaves the face, or all faces at the vertex, out of the surface.
  std::vector<bool> mask = {};
  /// Borders at most this far apart that face each other are joined. Bridges are as dear as the dearer
  /// border.
  double gap = 0.0;
  /// Borders are also joined where the surface turns back.
  bool bridge_folds = false;
  /// Threads used by an index build, a field or a task; 0: one per core. Results do not depend on it, except
  /// exact and quick fields of large meshes, which threads share: there, up to rounding, or the errors of
  /// quick fields.
  int threads = 0;
};

/// "automatic", "index", "exact" or "quick".
VOROGEO_API const char* to_string(Answer answer);

struct FieldOptions {
  double limit = unreachable;        ///< distances above it are `unreachable`
  bool labels = false;               ///< also say which source is the nearest
  std::vector<double> offsets = {};  ///< added to the distances from each source; empty: 0
  bool to = false;  ///< distances to the sources instead of from them; the same without face_drift
  Answer by = Answer::automatic;
  ProgressFunction progress = {};
};

struct Field {
  std::vector<double> distance = {};  ///< of every vertex
  std::vector<int> label = {};  ///< with labels, position of the nearest source in the list; -1 for none
  /// Mean relative error expected of the field: of an exact one 0 but for rounding, or an estimate where the
  /// metric jumps at edges; of others a bound on the errors measured on many meshes with default patches. NaN
  /// from an index where the metric jumps.
  double expected_error = std::numeric_limits<double>::quiet_NaN();
  int unreached = 0;  ///< vertices to which no path leads, whatever the limit
  Answer answered_by = Answer::exact;
  std::string remark;  ///< what a user should know about the choice; mostly empty
};

struct PathOptions {
  bool exact = false;   ///< the shortest path; otherwise an index may answer with one that is nearly so
  bool certify = true;  ///< with exact: proven to be the shortest; false is faster on large curved surfaces
  Answer by = Answer::automatic;
  ProgressFunction progress = {};
};

/// A polyline over the surface; without points where no path leads.
struct Path {
  std::vector<Point> points = {};  ///< positions in space
  std::vector<SurfacePoint> surface_points =
      {};  ///< the same points; vertex and face are -1 on a bridge over a gap
  double length = unreachable;
  bool certified = false;  ///< proven: no path is shorter
  Answer answered_by = Answer::exact;
  std::string remark;
};

struct IndexOptions {
  /// Where the index is kept: written while it is built, read if it is there, resumed if it is unfinished.
  std::filesystem::path file = {};
  int first_layer_patches = 0;   ///< 0: chosen
  int second_layer_patches = 0;  ///< in each of these; 0: chosen
  double delta = 0.0;            ///< mean relative error for which arcs may be pruned; above 0: a small index
  std::uint64_t seed = 0;        ///< of the random places of patches
  std::int64_t memory_budget = 0;  ///< in MiB; 0: 4096
  ProgressFunction progress = {};
};

/// What an index costs on this machine, if it has nothing else to do.
struct IndexEstimate {
  double build_seconds = 0.0;
  std::int64_t bytes = 0;            ///< in addition to the mesh
  double field_seconds = 0.0;        ///< of a field from the index
  double exact_field_seconds = 0.0;  ///< of an exact one, on one thread
};

struct IndexStatistics {
  int first_layer_patches = 0;
  int second_layer_patches = 0;
  std::int64_t bytes = 0;  ///< in addition to the mesh
  double seconds = 0.0;    ///< of the build; 0 if it was loaded
};

// ---- What is unusual about a mesh

struct MeshReport {
  bool usable = false;                 ///< a Surface can be made of it
  std::string summary;                 ///< sizes, components and borders
  std::vector<std::string> sentences;  ///< one for each kind of finding, naming its first element
};
/// Looks at a mesh before a Surface is made of it. Takes any arrays. \throw InvalidInput for a bad gap.
VOROGEO_API MeshReport check_mesh(const std::vector<Point>& positions,
                                  const std::vector<std::array<int, 3>>& faces, double gap = 0.0);

// ---- Metrics that follow from the shape of a surface

/// A vertex_cost that grows with the slope: 1 on level ground, 1 + penalty on a wall; the same uphill and
/// downhill. \throw InvalidInput for a penalty below 0, or `up` of length 0.
VOROGEO_API std::vector<double> slope_cost(const std::vector<Point>& positions,
                                           const std::vector<std::array<int, 3>>& faces, double penalty = 1.0,
                                           const Point& up = {0.0, 0.0, 1.0});
/// A face_cost that is a function of the grade: rise by length on the map where the face is steepest,
/// infinite for a wall. Faces where it is infinite, such as those too steep for a wheelchair, are barriers.
VOROGEO_API std::vector<double> slope_cost(const std::vector<Point>& positions,
                                           const std::vector<std::array<int, 3>>& faces,
                                           const std::function<double(double grade)>& cost,
                                           const Point& up = {0.0, 0.0, 1.0});
/// A vertex_tensor by which paths follow ridges, valleys and limbs: a step across them costs sqrt(1 + weight)
/// times its length where the surface is curved in one direction only. With a weight below 0, paths run
/// around them. Planes and spheres keep their lengths. \throw InvalidInput for a weight that is not finite.
VOROGEO_API std::vector<Tensor> curvature_tensor(const std::vector<Point>& positions,
                                                 const std::vector<std::array<int, 3>>& faces,
                                                 double weight = 3.0);

/// For SurfaceOptions::face_tensor and face_drift together: a metric by which a way back costs something
/// else.
struct FaceMetric {
  std::vector<Tensor> face_tensor;
  std::vector<Point> face_drift;
};
/// Time over terrain. `pace`: what a unit of length on the map costs at a grade (rise by length on the map,
/// below 0 downhill), infinite where none can go: steeper faces are climbed by zigzags. None: seconds per
/// metre by Tobler's hiking function. \throw InvalidInput for a cost that is not above 0, or infinite near 0.
VOROGEO_API FaceMetric hiking_time(const std::vector<Point>& positions,
                                   const std::vector<std::array<int, 3>>& faces,
                                   const std::function<double(double grade)>& pace = {},
                                   const Point& up = {0.0, 0.0, 1.0});
/// Travel time with an own `speed` in a wind or a current, both by face: Zermelo's problem.
/// \throw InvalidInput for a speed that is not above that of the wind; names the face.
VOROGEO_API FaceMetric travel_time(const std::vector<Point>& positions,
                                   const std::vector<std::array<int, 3>>& faces,
                                   const std::vector<Point>& wind, const std::vector<double>& speed);

// ---- The surface

class Query;

/// A mesh that answers questions about distances. Made once; copies are cheap and share everything. All const
/// functions may be called from several threads at a time.
class VOROGEO_API Surface {
 public:
  /// \param positions One for each vertex. All may be NaN if side lengths are given.
  /// \param faces Three vertices each; need be neither manifold nor oriented nor connected. Those that name a
  ///        vertex twice or repeat a face are left out.
  /// \throw InvalidInput for a face that names no vertex, a coordinate, cost or length that cannot be used.
  Surface(std::vector<Point> positions, std::vector<std::array<int, 3>> faces,
          const SurfaceOptions& options = {});

  int vertex_count() const;
  int face_count() const;

  /// The distance of every vertex from the nearest of the sources, `unreachable` where there is none.
  std::vector<double> distances_from(const PointList& sources) const;
  /// The same with options and labels. \throw InvalidInput for no source, or one that is not on the surface.
  Field field(const PointList& sources, const FieldOptions& options = {}) const;
  /// A curve along edges, each between two vertices, as sources: points at most `spacing` apart; 0: a quarter
  /// of an edge. Distances from them are at most half the spacing too long. \throw InvalidInput for two
  /// vertices without an edge between them.
  PointList along_edges(const std::vector<std::array<int, 2>>& edges, double spacing = 0.0) const;
  /// The distance of two points. \pre `by` is not quick.
  double distance(const SurfacePoint& from, const SurfacePoint& to, Answer by = Answer::automatic) const;
  /// The same for pairs of points: entry i of both lists, or one point with each of k. On all threads, from
  /// the index if there is one. \throw InvalidInput for lists of other sizes.
  std::vector<double> distances(const PointList& from, const PointList& to,
                                Answer by = Answer::automatic) const;
  Path path(const SurfacePoint& from, const SurfacePoint& to, const PathOptions& options = {}) const;
  /// The same for pairs, which are those of distances(), on all threads.
  std::vector<Path> paths(const PointList& from, const PointList& to, const PathOptions& options = {}) const;
  /// For many small questions of one thread; see Query. \pre `by` is not quick.
  Query query(Answer by = Answer::automatic) const;

  /// The nearest point of the surface. \throw InvalidInput for a coordinate that is not finite.
  SurfacePoint snap(const Point& position) const { return nearest(position).point; }
  SnappedPoint nearest(const Point& position) const;
  Point position(const SurfacePoint& point) const;

  /// Builds an index: later answers take milliseconds or less. Does nothing if there is one, except that a
  /// file is written. \throw InvalidInput for options that cannot be met, IndexFileError, Cancelled.
  void build_index(const IndexOptions& options = {});
  /// Estimates what a build would cost, in a few percent of its time.
  IndexEstimate estimate_index(const IndexOptions& options = {}) const;
  bool has_index() const;
  /// \pre There is an index. \throw InvalidInput otherwise.
  IndexStatistics index_statistics() const;
  void save_index(const std::filesystem::path& file) const;
  /// \throw IndexFileError if it is not the index of this surface.
  void load_index(const std::filesystem::path& file);

  /// What the library keeps for a surface; not for users.
  struct State;
  State& state() const { return *state_; }

 private:
  std::shared_ptr<State> state_;
};

/// Keeps the scratch memory of one thread between answers: for loops of many small questions. Answers are
/// those of the surface as it was when the query was made: by its index if it had one, but exact where the
/// question reaches a small part of the surface. For one thread at a time; make one for each.
class VOROGEO_API Query {
 public:
  Query(Query&&) noexcept;
  Query& operator=(Query&&) noexcept;
  ~Query();

  /// How questions without a limit are answered: by the index, or exactly.
  Answer answers_by() const;
  /// See Surface::distances_from. Distances above the limit are `unreachable`.
  std::vector<double> distances_from(const PointList& sources, double limit = unreachable);
  double distance(const SurfacePoint& from, const SurfacePoint& to);
  /// From one point to each of a list: one propagation, which ends at the limit, serves all of them.
  std::vector<double> distances(const SurfacePoint& from, const PointList& to, double limit = unreachable);
  /// `exact`: the shortest path, even with an index.
  Path path(const SurfacePoint& from, const SurfacePoint& to, bool exact = false);

 private:
  friend class Surface;
  struct State;
  explicit Query(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

// ---- Tasks: what is built on many distances, exactly or from the index, whichever is faster on this surface

struct TaskOptions {
  Answer by = Answer::automatic;  ///< not quick
  ProgressFunction progress = {};
  bool to = false;  ///< what is measured from points is measured to them; the same without face_drift
};

/// Row by row the distance from each row's point to each column's. The first form: of points from each other.
VOROGEO_API std::vector<double> distance_matrix(const Surface& surface, const PointList& points,
                                                const TaskOptions& options = {});
VOROGEO_API std::vector<double> distance_matrix(const Surface& surface, const PointList& rows,
                                                const PointList& columns, const TaskOptions& options = {});

/// Row by row the distances of all vertices from each source; those above the limit are `unreachable`.
VOROGEO_API std::vector<double> distance_fields(const Surface& surface, const PointList& sources,
                                                double limit = unreachable, const TaskOptions& options = {});

/// All pairs of points at most `radius` apart, from the row to the column. \throw NotEnoughMemory.
VOROGEO_API SparseDistances pairs_within(const Surface& surface, const PointList& points, double radius,
                                         const TaskOptions& options = {});

/// The `count` nearest points of a set for each query.
VOROGEO_API NearestOfSet nearest(const Surface& surface, const PointList& set, const PointList& queries,
                                 std::size_t count, const TaskOptions& options = {});

/// The shortest path through points in this order, each leg exact; `closed`: and back to the first. Where all
/// legs are certified, so is the path. `guides`: the points between its ends only guide it: it is the locally
/// shortest path to which the one through them is pulled; with `closed`, as by tighten(). \throw InvalidInput
/// for fewer than two points, or two that no path joins.
VOROGEO_API Path path_through(const Surface& surface, const PointList& points, bool closed = false,
                              bool guides = false, const TaskOptions& options = {});

/// The points at fractions of the length of a path. \throw InvalidInput for a fraction outside [0, 1], or
/// consecutive points that share no face.
VOROGEO_API std::vector<SurfacePoint> points_along(const Surface& surface, const PointList& path,
                                                   const std::vector<double>& fractions);
/// The Bezier curve of control points by de Casteljau's construction, with shortest paths as its straight
/// lines: at samples + 1 parameters from 0 to 1, which shortest paths join. \throw InvalidInput as
/// path_through(), and for fewer than one sample.
VOROGEO_API Path bezier(const Surface& surface, const PointList& points, int samples = 32,
                        const TaskOptions& options = {});
/// The uniform cubic B-spline curve of control points, all the way round if `closed`, else from the first to
/// the last, after `levels` levels of subdivision (Lane, Riesenfeld) with middles of shortest paths.
/// \throw InvalidInput likewise, and for fewer than three points of a closed curve.
VOROGEO_API Path b_spline(const Surface& surface, const PointList& points, bool closed = false,
                          int levels = 4, const TaskOptions& options = {});
/// A curve through all points, and back to the first if `closed`: between two neighbours a cubic Bezier curve
/// with so many samples. Its direction at a point is that from the previous point to the next (Catmull, Rom).
/// \throw InvalidInput likewise, and as log_map().
VOROGEO_API Path spline(const Surface& surface, const PointList& points, bool closed = false,
                        int samples = 16, const TaskOptions& options = {});

/// The closed geodesic that a closed curve through these points is pulled to, without crossing a border: the
/// shortest near it, which need not be the shortest of all that go round like it. Points that share no face
/// are joined by shortest paths. `remark` says if it was still becoming shorter after some thousand rounds.
/// \throw InvalidInput for a curve that slips off, naming where.
VOROGEO_API Path tighten(const Surface& surface, const PointList& curve, const TaskOptions& options = {});
/// The shortest loop through a point that cannot be contracted to it; with a curve, a shortest one near it
/// that goes round like the curve. \throw InvalidInput where every loop contracts.
VOROGEO_API Path shortest_loop(const Surface& surface, const SurfacePoint& point, const PointList& curve = {},
                               const TaskOptions& options = {});

/// Lengths round a limb. Those of section and tape are in space, whatever the metric.
struct Girth {
  Point normal{};           ///< of the plane
  Path section;             ///< where the plane cuts the surface, from the point round and back
  std::vector<Point> tape;  ///< corners of the section's convex hull, in order
  double tape_length = 0.0;
  Path loop;  ///< the section pulled tight; one point, of length 0, where it slips off, which `remark` says
};
/// The girth at a point, by the plane with this normal, of any length; without a normal, by the plane of the
/// shortest closed section among those through the normal of the surface. \throw InvalidInput for a section
/// that meets a border.
VOROGEO_API Girth girth(const Surface& surface, const SurfacePoint& point, const Point& normal,
                        const TaskOptions& options = {});
VOROGEO_API Girth girth(const Surface& surface, const SurfacePoint& point, const TaskOptions& options = {});

/// What lies along a path.
VOROGEO_API Profile profile(const Surface& surface, const Path& path, const Point& up = {0.0, 0.0, 1.0});

/// Geodesic Voronoi regions of sites.
VOROGEO_API VoronoiRegions voronoi(const Surface& surface, const PointList& sites,
                                   const TaskOptions& options = {});

/// Lines of equal value of a field at the vertices. `level` is the position of each segment's level. \throw
/// InvalidInput for a field of another mesh or a level that is not finite; NotEnoughMemory; Cancelled.
struct Isolines {
  SurfaceLines lines;
  std::vector<int> level;
};
VOROGEO_API Isolines isolines(const Surface& surface, const std::vector<double>& field,
                              const std::vector<double>& levels, const TaskOptions& options = {});

struct FarthestOptions {
  int count = 0;         ///< number of samples; 0: no such limit
  double radius = 0.0;   ///< ends once all vertices are this near to a sample; 0: no such limit
  PointList start = {};  ///< the first samples; empty: a random vertex
  std::uint64_t seed = 0;
  Answer by = Answer::automatic;
  ProgressFunction progress = {};
};
struct FarthestSamples {
  std::vector<SurfacePoint> points;
  std::vector<double> radius;    ///< distance of each from those before it
  std::vector<double> distance;  ///< of every vertex from the nearest sample
  double covering_radius = 0.0;
};
/// Farthest-point sampling: each sample is the vertex farthest from those before it.
VOROGEO_API FarthestSamples sample_farthest(const Surface& surface, const FarthestOptions& options);
/// Vertices at least `radius` apart, to which no vertex could be added.
VOROGEO_API std::vector<int> sample_poisson_disk(const Surface& surface, double radius,
                                                 std::uint64_t seed = 0, const TaskOptions& options = {});

/// Points moved to the middles of their Voronoi regions, and the energy before the first and after each
/// round.
struct RelaxedPoints {
  std::vector<SurfacePoint> points;
  std::vector<double> energy;
};
/// Lloyd relaxation: ends after `rounds`, or when no point finds a better vertex. `by` may be quick.
VOROGEO_API RelaxedPoints relax(const Surface& surface, const PointList& points, int rounds = 10,
                                const TaskOptions& options = {});

/// The vertices and faces within a radius of the nearest of some sources.
VOROGEO_API Disk disk(const Surface& surface, const PointList& sources, double radius,
                      const TaskOptions& options = {});

/// The area within a distance. Its border is a circular arc in each part of a face, whose sides are at most
/// width / 16 long: exact for points in a plane but for the few arcs that leave such a part and come back.
/// Sources may be points of along_edges().
VOROGEO_API Band band(const Surface& surface, const PointList& sources, double width,
                      const TaskOptions& options = {});
/// The area within a radius of a point.
inline double disk_area(const Surface& surface, const SurfacePoint& centre, double radius,
                        const TaskOptions& options = {}) {
  return band(surface, centre, radius, options).area;
}

/// A mesh cut along lines. Its vertices are those of the surface, then new ones on the lines; parts of
/// neighbouring faces share these, so it is as watertight as it was. Faces that are left out of the surface
/// are missing here, too.
struct CutMesh {
  std::vector<Point> positions;
  std::vector<std::array<int, 3>> faces;
  std::vector<SurfacePoint> points;       ///< by vertex, where on the surface it is: to carry attributes over
  std::vector<int> face_of;               ///< by face, the one of the surface that it is a part of
  std::vector<int> region;                ///< by face; see the functions
  std::vector<std::array<int, 2>> edges;  ///< along the lines, in their direction
  /// By face: 1 to the left of a line (as most faces are turned), -1 to its right, 0 on neither or both.
  std::vector<int> side;
};
/// Cuts along isolines of a field at the vertices, which have greater values to their left. Region: how many
/// different levels are not above the values there; -1 where these are not finite.
VOROGEO_API CutMesh cut_at_levels(const Surface& surface, const std::vector<double>& field,
                                  const std::vector<double>& levels, const TaskOptions& options = {});
/// Cuts along lines whose consecutive points share a face, such as the `surface_points` of paths. Region: the
/// connected part, numbered from 0. \throw InvalidInput for points that share no face.
VOROGEO_API CutMesh cut_along(const Surface& surface, const std::vector<std::vector<SurfacePoint>>& lines,
                              const TaskOptions& options = {});

/// Measures of the faces with each label from 0 on; faces with other labels belong to no region.
VOROGEO_API std::vector<RegionArea> region_areas(const Surface& surface,
                                                 const std::vector<int>& label_of_face,
                                                 const TaskOptions& options = {});
/// Measures of the side of a closed curve, such as a loop, that has no border of the surface, else of the
/// smaller side. Consecutive points share a face. \throw InvalidInput for a curve that is not closed, crosses
/// itself, or does not separate its two sides.
VOROGEO_API RegionArea enclosed_area(const Surface& surface, const PointList& curve,
                                     const TaskOptions& options = {});

/// A polygon of shortest paths.
struct Polygon {
  double area = 0.0;  ///< of the inside: the side without border of the surface, else the smaller
  double perimeter = 0.0;
  std::vector<int> corners;    ///< positions of its points in the list; of a hull, the points that span it
  std::vector<double> angles;  ///< of the inside at each corner, in radians
  double curvature = 0.0;      ///< sum of the angle defects of the vertices inside
  /// 2 pi times the Euler characteristic of the inside, minus its curvature and the turning of its border at
  /// points and vertices: 0 but for rounding (Gauss-Bonnet), where the metric does not jump and no edge has
  /// more than two faces.
  double gauss_bonnet = 0.0;
  std::vector<int> vertices;                    ///< inside, not on the border
  std::vector<int> faces;                       ///< that lie inside as a whole
  std::vector<std::vector<SurfacePoint>> legs;  ///< from each corner to the next; cut_along() takes them
};
/// From each point to the next by the shortest path, and back to the first. \throw InvalidInput for legs that
/// cross or touch, or that do not separate an inside from an outside.
VOROGEO_API Polygon polygon(const Surface& surface, const PointList& points, const TaskOptions& options = {});
/// The polygon of some of the points that has the others inside and no angle above pi. \throw InvalidInput
/// where they do not lie in a disk-like part in which any two have a unique shortest path.
VOROGEO_API Polygon convex_hull(const Surface& surface, const PointList& points,
                                const TaskOptions& options = {});

/// How far two sets of points are from each other.
VOROGEO_API SetDistances set_distances(const Surface& surface, const PointList& first,
                                       const PointList& second, const TaskOptions& options = {});

/// For each point, the vertex farthest from it.
VOROGEO_API std::vector<Eccentricity> eccentricities(const Surface& surface, const PointList& points,
                                                     const TaskOptions& options = {});

/// Bounds of the greatest and the least distance of a vertex from the vertex farthest from it.
struct Extent {
  std::array<double, 2> diameter{};
  std::array<int, 2> ends{};  ///< vertices as far apart as the lower bound of the diameter
  std::array<double, 2> radius{};
  int centre = -1;  ///< from which all vertices are within the upper bound of the radius
};
/// Bounds for the largest component, from at most `max_fields` fields.
VOROGEO_API Extent extent(const Surface& surface, int max_fields = 20, const TaskOptions& options = {});

// ---- Directions: the logarithmic and the exponential map

/// A vector in the tangent plane of a point, by its coordinates in the frame there. As in geometry-central,
/// the x axis runs, at a vertex, along the edge that leaves it in its last face (on a border, along the
/// border edge after which its faces follow), with angles scaled to sum to 2 pi (on a border, to pi); in a
/// face, it runs from the first corner to the second. Points on edges take the first of the edge's faces.
using Tangent = std::array<double, 2>;

/// The axes of a frame, in space and of unit length.
struct TangentFrame {
  Point x{}, y{}, normal{};
};
/// The frames at points. \throw InvalidInput with a metric, and where directions have no angles: at vertices
/// without a fan of faces, on edges of three faces or more, in faces without area; names the place.
VOROGEO_API std::vector<TangentFrame> tangent_frames(const Surface& surface, const PointList& points);

struct LogMapOptions {
  PointList targets = {};      ///< empty: all vertices
  double limit = unreachable;  ///< distances above it are `unreachable`
  Answer by = Answer::exact;   ///< or index: off by tenths of a degree in the mean
  ProgressFunction progress = {};
};
struct LogMap {
  std::vector<Tangent> vector;   ///< NaN where no path leads
  std::vector<double> distance;  ///< the lengths of these vectors
  int unreached = 0;             ///< vertices or targets to which no path leads, whatever the limit
};
/// Shortest paths from a point, as vectors in its frame: each has the direction in which the path begins, and
/// its length. \throw InvalidInput as tangent_frames(), where the metric jumps at edges, and for the method
/// quick.
VOROGEO_API LogMap log_map(const Surface& surface, const SurfacePoint& from,
                           const LogMapOptions& options = {});

struct GradientOptions {
  PointList points = {};       ///< empty: all vertices
  double limit = unreachable;  ///< beyond it there is no gradient
  ProgressFunction progress = {};
};
/// The gradient of the distance from the nearest source: vectors of length 1 in the frames of the points,
/// away from the source, exactly. NaN at sources, where no path leads, and at vertices without a frame.
VOROGEO_API std::vector<Tangent> gradient(const Surface& surface, const PointList& sources,
                                          const GradientOptions& options = {});
/// Carries vectors in the frame of a path's first point along the path in parallel, into the frame of its
/// last point. \throw InvalidInput for consecutive points without a common face, or a point without a frame.
VOROGEO_API std::vector<Tangent> transport(const Surface& surface, const PointList& path,
                                           const std::vector<Tangent>& vectors);

struct TransportOptions {
  double limit = unreachable;  ///< beyond it there are no vectors
  ProgressFunction progress = {};
};
/// Carries a vector in the frame of a point along the shortest paths to all vertices in parallel, exactly,
/// into their frames. NaN where no path leads, and where there is no frame. \throw InvalidInput as log_map().
VOROGEO_API std::vector<Tangent> transport_from(const Surface& surface, const SurfacePoint& from,
                                                const Tangent& vector, const TransportOptions& options = {});

struct ExpMapOptions {
  bool slide = false;  ///< at a border, go on along it; otherwise a line ends there
  ProgressFunction progress = {};
};
/// Where a line ends, and its length: less than was asked for where it met a border.
struct TracedEnd {
  SurfacePoint point;
  double length = 0.0;
};
/// Straightest lines from points along vectors in the frames there, on all threads: of pairs, or of one point
/// and each of the vectors. Through a vertex they go with half of its angle on either side. \throw
/// InvalidInput as log_map(), and for vectors that are not finite.
VOROGEO_API std::vector<TracedEnd> exp_map(const Surface& surface, const PointList& from,
                                           const std::vector<Tangent>& vectors,
                                           const ExpMapOptions& options = {});

// ---- Means and clusters of points

/// A point from which a sum over some points is least.
struct Centre {
  SurfacePoint point;
  double energy = 0.0;  ///< this sum
  std::string remark;   ///< if the centre is one of several, or was not found closely; mostly empty
};
/// The point with the least sum of weighted squared distances from some points, found exactly, by descent
/// from the best of these points; all weights are 1 if none are given. \pre `by` is neither index nor quick.
/// \throw InvalidInput for no point, weights that are negative, not finite or all 0, two points that no path
/// joins, and as log_map().
VOROGEO_API Centre frechet_mean(const Surface& surface, const PointList& points,
                                const std::vector<double>& weights = {}, const TaskOptions& options = {});
/// The same with the sum of weighted distances.
VOROGEO_API Centre geometric_median(const Surface& surface, const PointList& points,
                                    const std::vector<double>& weights = {}, const TaskOptions& options = {});
/// The position of the given point with the least sum of weighted distances. \throw InvalidInput likewise.
VOROGEO_API int medoid(const Surface& surface, const PointList& points,
                       const std::vector<double>& weights = {}, const TaskOptions& options = {});

struct ClusterOptions {
  PointList points = {};             ///< empty: all vertices with a face
  std::vector<double> weights = {};  ///< empty: 1 for each point; a third of its faces' area for a vertex
  int rounds = 100;                  ///< at most
  std::uint64_t seed = 0;            ///< of the random first centres
  Answer by = Answer::automatic;     ///< may be quick for all vertices
  ProgressFunction progress = {};
};
struct Clusters {
  std::vector<SurfacePoint> centres;
  std::vector<int> label;      ///< the nearest centre of each point or vertex; -1 for one without a face
  std::vector<double> energy;  ///< at the beginning and after each round; never rises
};
/// Clusters whose centres are their means (vertices near the means where all vertices are clustered, see
/// relax()), so that the sum of weighted squared distances from the nearest centre falls. \throw InvalidInput
/// for a count below 1, above the number of different points or below that of the components they lie on, and
/// as frechet_mean().
VOROGEO_API Clusters k_means(const Surface& surface, int count, const ClusterOptions& options = {});
/// The same with the sum of weighted distances; centres are points of the list.
VOROGEO_API Clusters k_medoids(const Surface& surface, int count, const ClusterOptions& options = {});

// ---- Sides, derivatives, and where paths meet

struct SignedDistanceOptions {
  double limit = unreachable;  ///< distances beyond it are infinite, with their sign
  ProgressFunction progress = {};
};
/// The distance of every vertex from closed curves, at most 1.3e-6 of a typical edge too long: negative
/// inside, on the side without border of the surface, else on the smaller side. A curve is a line whose
/// consecutive points share a face and which ends where it begins, such as the `surface_points` of a closed
/// path. \throw InvalidInput for curves that are open, cross or touch, or do not separate the surface, and
/// where the metric jumps at edges.
VOROGEO_API std::vector<double> signed_distance(const Surface& surface,
                                                const std::vector<std::vector<SurfacePoint>>& curves,
                                                const SignedDistanceOptions& options = {});
/// The same from the border of a region, negative in it; `in_region` says of each face whether it is in it.
VOROGEO_API std::vector<double> signed_distance(const Surface& surface, const std::vector<bool>& in_region,
                                                const SignedDistanceOptions& options = {});

/// The gradient of exact distances of pairs, which are those of Surface::distances(), between points that
/// keep their weights in their faces. Where several paths are shortest, it is that of one of them; it has no
/// entries where both points are one, or no path leads. \throw InvalidInput with a metric.
VOROGEO_API DistanceGradient distance_gradient(const Surface& surface, const PointList& from,
                                               const PointList& to, const TaskOptions& options = {});

struct CutLocusOptions {
  double min_angle = 0.0;      ///< ends of lines are cut back to where directions differ by so much
  double limit = unreachable;  ///< only within this distance
  ProgressFunction progress = {};
};
/// Where several shortest paths end. From one source, its cut locus: without it, the surface can be laid out
/// from there. From several, also the borders of their Voronoi regions: the ridge of the field.
struct CutLocus {
  std::vector<SurfacePoint> points;
  std::vector<Point> positions;  ///< of the points, in space
  std::vector<std::array<int, 2>> edges;
  std::vector<double> distance;  ///< by point
  std::vector<double> angle;     ///< by point: between the directions in which its shortest paths arrive
};
/// Exact where it crosses edges, straight in faces. On a polyhedron it has a line to each convex vertex;
/// `min_angle` leaves out those that a smooth surface does not have. \throw InvalidInput for no source, an
/// angle that is not from 0 to pi, and where the metric jumps at edges.
VOROGEO_API CutLocus cut_locus(const Surface& surface, const PointList& sources,
                               const CutLocusOptions& options = {});

struct TextureOptions {
  double rotation = 0.0;  ///< of the picture about the point, in radians, as angles grow in the frame there
  double scale = 1.0;     ///< of the picture; at 1 its side is twice the radius
  ProgressFunction progress = {};
};
/// A picture laid around a point: lines through its middle become shortest paths of their true length. \throw
/// InvalidInput as log_map(), and for a radius or a scale that is not above 0.
VOROGEO_API TextureCoordinates texture_coordinates(const Surface& surface, const SurfacePoint& point,
                                                   double radius, const TextureOptions& options = {});

}  // namespace v0
}  // namespace vorogeo
