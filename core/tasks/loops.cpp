// Curves pulled tight, and shortest loops through a point.
#include "tasks/loops.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <queue>
#include <string>
#include <utility>

#include "support/disjoint_sets.h"
#include "support/error.h"
#include "tasks/path_through.h"

namespace vorogeo {

// ---- Polylines pulled tight

namespace {

/// Adds faces around a point until the strip ends in `face`; both its last face and `face` hold the point.
bool go_on(const Mesh& mesh, const SurfacePoint& point, Index face, FaceStrip& strip) {
  if (point.is_vertex()) return turn_around(mesh, strip, point.vertex, face);
  std::array<double, 3> weights{};
  weights_in_face(mesh, point, strip.last(), weights);
  for (Index exit = 3 * strip.last(); strip.last() != face; ++exit) {
    if (Mesh::face_of(exit) != strip.last()) return false;
    if (weights[(exit + 2) % 3] > 0.0) continue;
    Index entry = mesh.next_around_edge(exit);
    while (entry != exit && Mesh::face_of(entry) != face) entry = mesh.next_around_edge(entry);
    if (entry == exit) continue;
    strip.crossings.push_back({exit, entry});
    return true;
  }
  return true;
}

/// A polyline whose consecutive points share a face, pulled tight; unchanged where unfolding leads to no
/// shorter one. It keeps the vertices at which its faces are not connected over edges. `looks_beside`: see
/// PathRefiner::refine. \throw InvalidInput if two points share no face.
SurfacePath pulled(const Mesh& mesh, PathRefiner& refiner, const std::vector<SurfacePoint>& line,
                   bool looks_beside) {
  SurfacePath path{{line.front()}, 0.0};
  for (std::size_t begin = 0, end = 0; end + 1 < line.size(); begin = end) {
    FaceStrip strip{line[begin], {}, no_index, {}};
    for (; end + 1 < line.size(); ++end) {
      const Index face = common_face(mesh, line[end], line[end + 1]);
      if (face == no_index) {
        throw InvalidInput("The curve leaves the surface between " + name_of(mesh, line[end]) + " and " +
                           name_of(mesh, line[end + 1]) + ".");
      }
      if (end == begin) strip.first = face;
      if (!go_on(mesh, line[end], face, strip)) break;
    }
    strip.target = line[end];
    looks_beside ? refiner.refine(strip) : refiner.tighten(strip);
    const SurfacePath piece = refiner.path();
    path.points.insert(path.points.end(), piece.points.begin() + 1, piece.points.end());
  }
  path.length = measured_length(mesh, path.points).length;
  const double before = measured_length(mesh, line).length;
  return path.length <= before ? path : SurfacePath{line, before};
}

// ---- Closed lines pulled tight

/// Shortening by less than this (relative) is rounding; the loop is tight after so many rounds without more.
constexpr double least_loop_gain = 1e-13;
constexpr int rounds_without_gain = 3;

/// Begins a closed line at another point: the vertex, or else the point, nearest to half-way along.
void begin_half_way(const Mesh& mesh, std::vector<SurfacePoint>& line) {
  std::vector<double> along{0.0};
  for (std::size_t i = 1; i < line.size(); ++i) {
    along.push_back(along.back() + measured_length(mesh, std::span(line).subspan(i - 1, 2)).length);
  }
  std::size_t begin = 0;
  auto worse = [&](std::size_t i) {
    return std::pair(!line[i].is_vertex(), std::abs(along[i] - 0.5 * along.back()));
  };
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    if (begin == 0 || worse(i) < worse(begin)) begin = i;
  }
  line.pop_back();
  std::ranges::rotate(line, line.begin() + static_cast<std::ptrdiff_t>(begin));
  line.push_back(line.front());
}

/// Whether a line stays on the faces around one vertex and touches none of the edges opposite to it.
bool is_around(const Mesh& mesh, const std::vector<SurfacePoint>& line, Index vertex) {
  return mesh.fan(vertex) != Mesh::Fan::non_manifold &&
         std::ranges::all_of(line, [&](const SurfacePoint& at) {
           if (at.is_vertex()) return at.vertex == vertex;
           const auto& corners = mesh.face_vertices(at.face);
           for (int k = 0; k < 3; ++k) {
             if (corners[k] == vertex) return at.barycentric[k] > 0.0;
           }
           return false;
         });
}

/// Where a closed line that has been pulled tight contracts to: its point, or the only vertex that it goes
/// around, on which it has no hold.
std::optional<SurfacePoint> contracts_to(const Mesh& mesh, const SurfacePath& loop) {
  const SurfacePoint& first = loop.points.front();
  if (!(loop.length > 0.0) || loop.points.size() < 3) return first;
  if (first.is_vertex())
    return is_around(mesh, loop.points, first.vertex) ? std::optional(first) : std::nullopt;
  for (const Index vertex : mesh.face_vertices(first.face)) {
    if (is_around(mesh, loop.points, vertex)) return SurfacePoint::at_vertex(vertex);
  }
  return std::nullopt;
}

std::string slip_at(const Mesh& mesh, const SurfacePoint& point) {
  return "slips off: pulled tight, it contracts to a point, at " + name_of(mesh, point);
}

}  // namespace

SurfacePoint point_of_loop(const Mesh& mesh, const SurfacePoint& given) {
  const SurfacePoint point = canonical(mesh, validated(mesh, given));
  if (point.is_vertex() && mesh.fan(point.vertex) == Mesh::Fan::isolated) {
    throw InvalidInput("No loop passes through " + name_of(mesh, point) +
                       ", as no face has it; give a point on a face.");
  }
  return point;
}

TightLoop tightened(const ExactGeometry& geometry, std::vector<SurfacePoint> curve, int max_rounds) {
  const Mesh& mesh = *geometry.mesh;
  PathRefiner refiner(geometry);
  const double length = measured_length(mesh, curve).length;
  SurfacePath loop{std::move(curve), length};
  int without_gain = 0;
  for (int round = 0; round < max_rounds && without_gain < rounds_without_gain; ++round) {
    checkpoint();
    if (const auto point = contracts_to(mesh, loop)) return {{{*point}, 0.0}, slip_at(mesh, *point)};
    std::vector<SurfacePoint> line = loop.points;
    begin_half_way(mesh, line);
    SurfacePath next = pulled(mesh, refiner, line, false);
    without_gain = next.length < loop.length * (1.0 - least_loop_gain) ? 0 : without_gain + 1;
    loop = std::move(next);
  }
  if (without_gain == rounds_without_gain) return {std::move(loop), ""};
  return {std::move(loop),
          "was still becoming shorter after " + std::to_string(max_rounds) + " rounds: tighten it again"};
}

namespace {

/// A question about a loop: what answers it, the checks, and the time it takes.
class LoopTask {
 public:
  LoopTask(Surface& surface, const TaskOptions& options, bool closed = true)
      : mesh(*surface.mesh()), surface_(surface), options_(options), watch_(options.progress, "Loop") {
    const std::string what = closed ? "loops" : "paths by guides";
    require_agreeing_faces(mesh, closed ? "Loops" : "Paths by guides");
    if (options.by == Answer::quick) {
      throw InvalidInput("The quick method has no " + what + "; choose automatic, index or exact.");
    }
  }

  const ExactGeometry& geometry() { return *surface_.geometry()->windows; }
  SurfacePath leg(const SurfacePoint& from, const SurfacePoint& to) {
    Answered answered;
    return surface_.path(from, to, options_.by, {.exact = true, .certify = false}, answered).path;
  }
  /// A polyline through points; `closed`: back to the first.
  std::vector<SurfacePoint> line_through(const PointList& given, bool closed = true) {
    if (given.size() < 2) {
      throw InvalidInput("The curve has " + std::to_string(given.size()) +
                         " points; give at least two, in order.");
    }
    const PointList points = points_on(mesh, given, "Point");
    std::vector<SurfacePoint> line{points[0]};
    for (std::size_t i = 0; i + (closed ? 0 : 1) < points.size(); ++i) {
      const std::size_t next = (i + 1) % points.size();
      if (points[i] == points[next]) continue;
      if (common_face(mesh, points[i], points[next]) != no_index) {
        line.push_back(points[next]);
        continue;
      }
      const SurfacePath found = leg(points[i], points[next]);
      if (found.points.empty()) refuse_leg(mesh, i, points[i], next, points[next]);
      line.insert(line.end(), found.points.begin() + 1, found.points.end());
    }
    return line;
  }
  /// A loop is not proven to be shortest.
  ExactPath answer(SurfacePath path, const std::string& remark = {}) const {
    report_exact(options_, stopwatch_);
    if (options_.answered != nullptr && !remark.empty())
      options_.answered->remark = "The loop " + remark + ".";
    return {std::move(path), false};
  }

  const Mesh& mesh;

 private:
  Surface& surface_;
  const TaskOptions& options_;
  const Watch watch_;
  const Stopwatch stopwatch_;
};

[[noreturn]] void refuse_slip(const Mesh& mesh, const SurfacePoint& point) {
  throw InvalidInput("The curve " + slip_at(mesh, point) +
                     ". Give one that goes round a handle, a border, or a limb behind a neck.");
}

}  // namespace

ExactPath tighten(Surface& surface, const PointList& curve, bool closed, const TaskOptions& options) {
  LoopTask task(surface, options, closed);
  std::vector<SurfacePoint> line = task.line_through(curve, closed);
  if (closed) {
    TightLoop loop = tightened(task.geometry(), std::move(line));
    if (loop.path.points.size() == 1) refuse_slip(task.mesh, loop.path.points[0]);
    return task.answer(std::move(loop.path), loop.remark);
  }
  PathRefiner refiner(task.geometry());
  SurfacePath path = pulled(task.mesh, refiner, line, false);
  if (!(path.length > 0.0)) path.points.resize(1);
  return task.answer(std::move(path));
}

// ---- Loops through a point

namespace {

/// The edges across which loops close that lead from a point and cannot be contracted. A tree of vertices
/// grows from the point in order of distance. Faces are joined across the edges outside the tree, and to the
/// hole at each border; where a face has one such edge left, a loop across it contracts: it is removed.
class LoopClasses {
 public:
  LoopClasses(const Mesh& mesh, const SurfacePoint& point, std::span<const double> distance)
      : mesh_(mesh), point_(point), distance_(distance), by_edge_(mesh.vertex_count(), no_index) {
    grow_tree();
    prune();
  }

  struct Class {
    double length = unreachable;  ///< of its shortest loop through the ends of an edge
    Index edge = no_index;
    double least = unreachable;  ///< lower bound of the lengths of its loops
  };
  /// Shortest first.
  std::vector<Class> classes();
  /// Along the tree to one end of an edge, across it, and back.
  std::vector<SurfacePoint> loop_across(Index edge) const;

 private:
  void grow_tree();
  void prune();
  bool is_open(Index edge) const { return state_[edge] == open; }

  enum State : std::uint8_t { elsewhere, tree, open, removed };
  const Mesh& mesh_;
  const SurfacePoint& point_;
  std::span<const double> distance_;
  std::vector<Index> by_edge_;  ///< by vertex, the edge by which the tree reaches it
  std::vector<Index> roots_;    ///< the point, or the corners of its faces
  std::vector<State> state_;    ///< by edge
};

void LoopClasses::grow_tree() {
  state_.assign(mesh_.edge_count(), elsewhere);
  std::vector<std::uint8_t> is_reached(mesh_.vertex_count(), 0);
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> next;
  auto reach = [&](Index vertex) {
    is_reached[vertex] = 1;
    mesh_.for_each_side_at(vertex, [&](Index h, Index other) {
      State& state = state_[mesh_.edge_of(h)];
      if (state == elsewhere) state = open;
      if (!is_reached[other]) next.emplace(distance_[other], other);
    });
  };
  if (point_.is_vertex()) {
    roots_.push_back(point_.vertex);
  } else {
    for_each_face_at(mesh_, point_, [&](Index face, const std::array<double, 3>&) {
      for (const Index corner : mesh_.face_vertices(face)) roots_.push_back(corner);
    });
  }
  for (const Index root : roots_) is_reached[root] = 1;
  for (const Index root : roots_) reach(root);
  for (Index visited = 0; !next.empty(); ++visited) {
    if (visited % elements_per_checkpoint == 0) checkpoint();
    const Index vertex = next.top().second;
    next.pop();
    if (is_reached[vertex]) continue;
    double least = unreachable;
    mesh_.for_each_side_at(vertex, [&](Index h, Index other) {
      const double by = distance_[other] + mesh_.edge_length(mesh_.edge_of(h));
      if (!is_reached[other] || !(by < least)) return;
      least = by;
      by_edge_[vertex] = mesh_.edge_of(h);
    });
    reach(vertex);
    state_[by_edge_[vertex]] = tree;
  }
}

void LoopClasses::prune() {
  std::vector<std::uint8_t> open_edges(mesh_.face_count(), 0);
  for (const Index edge : checked(mesh_.edge_count())) {
    if (!is_open(edge)) continue;
    const Index h = mesh_.edge_halfedge(edge);
    if (mesh_.edge_face_count(edge) > 2) {
      const auto& [a, b] = mesh_.edge_vertices(edge);
      throw InvalidInput("The edge between " + name_of(mesh_, SurfacePoint::at_vertex(a)) + " and " +
                         name_of(mesh_, SurfacePoint::at_vertex(b)) + " has " +
                         std::to_string(mesh_.edge_face_count(edge)) +
                         " faces, so loops have no classes there; mask some of them, or give a curve.");
    }
    ++open_edges[Mesh::face_of(h)];
    if (const Index other = mesh_.next_around_edge(h); other != h) ++open_edges[Mesh::face_of(other)];
  }
  // Faces at a point that is no vertex are divided by lines to their corners: loops across an edge contract.
  std::vector<Index> ends;
  auto remove = [&](Index edge) {
    state_[edge] = removed;
    mesh_.for_each_halfedge(edge, [&](Index h) {
      if (--open_edges[Mesh::face_of(h)] == 1) ends.push_back(Mesh::face_of(h));
    });
  };
  if (!point_.is_vertex()) {
    for_each_face_at(mesh_, point_, [&](Index face, const std::array<double, 3>&) {
      for (Index h = 3 * face; h < 3 * face + 3; ++h) {
        if (is_open(mesh_.edge_of(h))) remove(mesh_.edge_of(h));
      }
    });
  }
  for (Index face = 0; face < mesh_.face_count(); ++face) {
    if (open_edges[face] == 1) ends.push_back(face);
  }
  while (!ends.empty()) {
    const Index face = ends.back();
    ends.pop_back();
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      if (is_open(mesh_.edge_of(h))) remove(mesh_.edge_of(h));
    }
  }
}

std::vector<LoopClasses::Class> LoopClasses::classes() {
  DisjointSets same(mesh_.edge_count());
  for (const Index face : checked(mesh_.face_count())) {
    std::vector<Index> edges;
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      if (is_open(mesh_.edge_of(h))) edges.push_back(mesh_.edge_of(h));
    }
    if (edges.size() == 2) same.join(edges[0], edges[1]);
  }
  std::vector<Class> classes;
  std::vector<Index> place(mesh_.edge_count(), no_index);
  for (const Index edge : checked(mesh_.edge_count())) {
    if (!is_open(edge)) continue;
    Index& at = place[same.root(edge)];
    if (at == no_index) {
      at = static_cast<Index>(classes.size());
      classes.push_back({});
    }
    Class& of = classes[at];
    const auto& [a, b] = mesh_.edge_vertices(edge);
    const double sum = distance_[a] + distance_[b], across = mesh_.edge_length(edge);
    if (sum + across < of.length) {
      of.length = sum + across;
      of.edge = edge;
    }
    of.least = std::min(of.least, sum - across);
  }
  std::ranges::sort(classes, {}, [](const Class& one) { return std::pair(one.length, one.edge); });
  return classes;
}

std::vector<SurfacePoint> LoopClasses::loop_across(Index edge) const {
  auto line_to = [&](Index vertex) {
    std::vector<SurfacePoint> line{SurfacePoint::at_vertex(vertex)};
    while (by_edge_[vertex] != no_index) {
      const auto& [a, b] = mesh_.edge_vertices(by_edge_[vertex]);
      vertex = a == vertex ? b : a;
      line.push_back(SurfacePoint::at_vertex(vertex));
    }
    if (!point_.is_vertex()) line.push_back(point_);
    return line;
  };
  const auto& [a, b] = mesh_.edge_vertices(edge);
  std::vector<SurfacePoint> loop = line_to(a), back = line_to(b);
  std::ranges::reverse(loop);
  loop.insert(loop.end(), back.begin(), back.end());
  return loop;
}

/// The shortest loop of all classes.
SurfacePath shortest_of_classes(Surface& surface, LoopTask& task, const SurfacePoint& point) {
  const ExactSource source{point};
  Answered answered;
  const auto field = surface.field(std::span(&source, 1), unreachable, Answer::exact, answered);
  LoopClasses around(task.mesh, point, field.distance);
  PathRefiner refiner(task.geometry());
  SurfacePath shortest{{}, unreachable};
  for (const auto& [length, edge, least] : around.classes()) {
    if (!(least < shortest.length)) continue;
    checkpoint();
    SurfacePath loop = pulled(task.mesh, refiner, around.loop_across(edge), true);
    if (loop.length < shortest.length) shortest = std::move(loop);
  }
  return shortest;
}

/// The loop from the point to a closed line, round it and back, pulled tight.
SurfacePath loop_like(Surface& surface, LoopTask& task, const SurfacePoint& point,
                      std::vector<SurfacePoint> line) {
  const ExactSource source{point};
  const auto apart = surface.lend([&](Query& query) {
    return query.distances(std::span(&source, 1), PointList(line), unreachable, Answer::exact);
  });
  const auto nearest = std::ranges::min_element(apart) - apart.begin();
  const SurfacePath leg = task.leg(point, line[nearest]);
  if (leg.points.empty()) {
    throw InvalidInput("No path leads from " + name_of(task.mesh, point) +
                       " to the curve: they are on two components.");
  }
  if (line.size() == 1) refuse_slip(task.mesh, line[0]);
  line.pop_back();
  std::ranges::rotate(line, line.begin() + (nearest < std::ssize(line) ? nearest : 0));
  std::vector<SurfacePoint> loop = leg.points;
  loop.insert(loop.end(), line.begin() + 1, line.end());
  loop.insert(loop.end(), leg.points.rbegin(), leg.points.rend());
  PathRefiner refiner(task.geometry());
  return pulled(task.mesh, refiner, loop, false);
}

}  // namespace

ExactPath shortest_loop(Surface& surface, const SurfacePoint& given, const PointList& curve,
                        const TaskOptions& options) {
  LoopTask task(surface, options);
  const SurfacePoint point = point_of_loop(task.mesh, given);
  SurfacePath loop = curve.empty() ? shortest_of_classes(surface, task, point)
                                   : loop_like(surface, task, point, task.line_through(curve));
  if (loop.points.empty()) {
    throw InvalidInput("Every loop through " + name_of(task.mesh, point) +
                       " contracts to it, as its component has no handle and at most one border; give a "
                       "curve to go round like.");
  }
  if (!(loop.length > 0.0)) refuse_slip(task.mesh, point);
  return task.answer(std::move(loop));
}

}  // namespace vorogeo
