// The half-edge mesh, in flat arrays, on which everything in the core runs.
#include "mesh/mesh.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <sstream>
#include <string>
#include <tuple>

#include "mesh/vectors.h"
#include "support/disjoint_sets.h"
#include "support/error.h"
#include "support/parallel.h"
#include "support/progress.h"

namespace vorogeo {

// ---- Construction of the flat half-edge mesh, and what is refused

std::string vertex_range(Index vertex_count) {
  return vertex_count == 0 ? "no vertices" : "vertices 0 to " + std::to_string(vertex_count - 1);
}

namespace {

void require_finite(const std::vector<Point>& positions) {
  for (std::size_t v = 0; v < positions.size(); ++v) {
    for (double coordinate : positions[v]) {
      if (!std::isfinite(coordinate)) {
        throw InvalidInput("Vertex " + std::to_string(v) +
                           " has a coordinate that is not a finite number; repair or remove it.");
      }
    }
  }
}

void require_vertices(const std::vector<std::array<Index, 3>>& faces, Index vertex_count) {
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (Index v : faces[f]) {
      if (v >= 0 && v < vertex_count) continue;
      throw InvalidInput("Face " + std::to_string(f) + " names vertex " + std::to_string(v) +
                         ", but the mesh has " + vertex_range(vertex_count) + ".");
    }
  }
}

/// The number of points on each edge: the usual one if drifts are given without a number. \throw InvalidInput
/// for a number that is not possible, or drifts without the lengths they belong to.
Index checked_points_per_edge(const Metric& metric) {
  constexpr Index max_points = 1000;
  if (metric.points_per_edge < 0 || metric.points_per_edge > max_points) {
    throw InvalidInput("The number of points on each edge is " + std::to_string(metric.points_per_edge) +
                       "; give 1 to 1000.");
  }
  if (metric.drifts.empty()) return metric.points_per_edge;
  if (metric.sides.empty() || !metric.splits.empty()) {
    throw InvalidInput("Drifts need the lengths of the sides, in faces that are not split.");
  }
  return metric.points_per_edge == 0 ? usual_edge_points : metric.points_per_edge;
}

}  // namespace

Mesh::Mesh(std::vector<Point> positions, std::vector<std::array<Index, 3>> faces, const Metric& metric)
    : positions_(std::move(positions)),
      given_face_count_(static_cast<Index>(faces.size())),
      middle_of_(metric.splits.middle_of),
      points_per_edge_(checked_points_per_edge(metric)),
      has_metric_(!metric.sides.empty()) {
  if (metric.splits.empty()) {
    face_vertices_ = std::move(faces);
    connect(metric.sides, metric.drifts);
    return;
  }
  for (const auto& [a, b] : middle_of_) {
    positions_.push_back(moved(moved({}, 0.5, positions_[a]), 0.5, positions_[b]));
  }
  face_vertices_ = metric.splits.faces;
  connect(metric.splits.sides);
  count_given_faces(faces, metric.splits.given_face);
}

Mesh::Mesh(std::vector<Point> positions, std::vector<std::array<Index, 3>> faces, const GapBridges& bridges,
           const Metric& metric)
    : positions_(std::move(positions)),
      face_vertices_(std::move(faces)),
      given_face_count_(static_cast<Index>(face_vertices_.size())),
      same_as_(bridges.same_as),
      points_per_edge_(checked_points_per_edge(metric)),
      has_metric_(!metric.sides.empty()) {
  const auto count = static_cast<Index>(same_as_.size());
  for (auto& face : face_vertices_) {
    for (Index& v : face) {
      if (v >= 0 && v < count) v = same_as_[v];
    }
  }
  face_vertices_.insert(face_vertices_.end(), bridges.faces.begin(), bridges.faces.end());
  connect(metric.sides, metric.drifts);
  if (bridges.faces.empty()) return;
  const auto first = std::ranges::lower_bound(input_face_, given_face_count_);
  // `input_face_` is empty where no face was left out, and also where all were.
  first_bridge_ = input_face_.empty() ? std::min(given_face_count_, face_count())
                                      : static_cast<Index>(first - input_face_.begin());
}

void Mesh::connect(const SideLengths& sides, const SideLengths& drifts) {
  constexpr auto max_count = static_cast<std::size_t>(std::numeric_limits<Index>::max());
  if (positions_.size() > max_count || face_vertices_.size() > max_count / 3) {
    throw InvalidInput("The mesh is too large: at most 2147483647 vertices and 715827882 faces.");
  }
  has_positions_ = !has_metric_ || positions_.empty() || !std::isnan(positions_[0][0]);
  if (has_positions_) require_finite(positions_);
  require_vertices(face_vertices_, vertex_count());
  list_corners();
  leave_out_faces(sides);
  link_edges();
  if (has_metric_) take_sides(sides);
  if (!drifts.empty()) take_drifts(drifts);
  measure_edges();
  sort_fans();
  if (has_metric_) bound_straight_lines();
  find_components();
  if (!face_sides_.empty()) find_jumps();
}

void Mesh::count_given_faces(const std::vector<std::array<Index, 3>>& given,
                             const std::vector<Index>& given_face) {
  std::vector<Index> number_of(face_count());
  for (Index f = 0; f < face_count(); ++f) {
    const Index number = number_of[f] = given_face[input_face(f)];
    const bool is_second_part =
        f > 0 && number == number_of[f - 1] && (split_faces_.empty() || split_faces_.back().given != number);
    if (is_second_part) split_faces_.push_back({number, given[number]});
  }
  input_face_ = std::move(number_of);
}

const std::array<Index, 3>& Mesh::given_corners(Index face) const {
  const auto found = std::ranges::lower_bound(split_faces_, input_face(face), {}, &SplitFace::given);
  const bool is_part = found != split_faces_.end() && found->given == input_face(face);
  return is_part ? found->corners : face_vertices_[face];
}

void Mesh::measure_edges() {
  constexpr double typical_per_median = 10.0;
  double total = 0.0;
  std::size_t positive = 0;
  for (const Index e : checked(edge_count())) {
    const double length = edge_length_[e];
    total += length;
    longest_edge_length_ = std::max(longest_edge_length_, length);
    positive += length > 0.0 ? 1 : 0;
  }
  has_zero_edges_ = positive < edge_length_.size();
  if (positive == 0) return;
  mean_edge_length_ = total / static_cast<double>(edge_length_.size());
  std::vector<double> lengths;
  lengths.reserve(positive);
  std::ranges::copy_if(edge_length_, std::back_inserter(lengths), [](double length) { return length > 0.0; });
  const auto median = lengths.begin() + static_cast<std::ptrdiff_t>(positive / 2);
  std::ranges::nth_element(lengths, median);
  const double greatest = typical_per_median * *median;
  double typical_total = 0.0;
  std::size_t count = 0;
  for (const Index e : checked(edge_count())) {
    const double length = edge_length_[e];
    if (length > greatest) continue;
    typical_total += length;
    ++count;
  }
  typical_edge_length_ = typical_total / static_cast<double>(count);
}

void Mesh::find_components() {
  DisjointSets sets(vertex_count());
  if (has_merged_vertices()) {
    for (Index v = 0; v < vertex_count(); ++v) sets.join_at_least(v, representative(v));
  }
  for (const Index e : checked(edge_count())) sets.join_at_least(edge_vertices_[e][0], edge_vertices_[e][1]);
  component_.assign(positions_.size(), no_index);
  for (const Index v : checked(vertex_count())) {
    const Index r = sets.root(v);
    component_[v] = r == v ? component_count_++ : component_[r];
  }
}

int Mesh::edge_face_count(Index edge) const {
  int count = 0;
  for_each_halfedge(edge, [&](Index) { ++count; });
  return count;
}

std::size_t Mesh::memory_bytes() const {
  auto bytes = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  return bytes(positions_) + bytes(face_vertices_) + bytes(input_face_) + bytes(same_as_) +
         bytes(middle_of_) + bytes(split_faces_) + bytes(halfedge_edge_) + bytes(next_around_edge_) +
         bytes(edge_vertices_) + bytes(edge_length_) + bytes(face_sides_) + bytes(face_drifts_) +
         bytes(edge_drift_) + bytes(potential_) + bytes(component_jumps_) + bytes(edge_halfedge_) +
         bytes(corner_begin_) + bytes(corners_) + bytes(fan_) + bytes(border_) + bytes(total_angle_) +
         bytes(component_);
}

// ---- The scale that is advised for meshes that are too large or too small to compute with

void require_lengths(double mean, double longest, const std::string& what, const LengthLimits& limits) {
  if (limits.allow(mean, longest)) return;
  std::ostringstream message;
  message << "The mesh has a mean edge length of " << mean << " and a longest edge of " << longest << "; "
          << what << " lengths between " << limits.least_mean << " and " << limits.greatest
          << ": scale the mesh, for example by " << factor_to_unit(mean, longest) << ".";
  throw InvalidInput(message.str());
}

double factor_to_unit(double mean, double longest) {
  constexpr double least = std::numeric_limits<double>::denorm_min();
  constexpr double greatest = std::numeric_limits<double>::max();
  const double exponent = 0.5 * std::log10(std::clamp(mean, least, greatest)) +
                          0.5 * std::log10(std::clamp(longest, least, greatest));
  return std::pow(10.0, -std::clamp(std::round(exponent), -300.0, 300.0));
}

// ---- What faces share: corners at each vertex, faces that occur twice, and edges

/// Lists the half-edges that leave each vertex, ascending.
void Mesh::list_corners() {
  // A counting sort from behind: each count becomes the end of its vertex's part, then its beginning.
  corner_begin_.assign(positions_.size() + 1, 0);
  for (const Index f : checked(face_count())) {
    for (Index v : face_vertices_[f]) ++corner_begin_[v];
  }
  std::partial_sum(corner_begin_.begin(), corner_begin_.end(), corner_begin_.begin());
  corners_.resize(3 * face_vertices_.size());
  for (Index f = face_count(); f-- > 0;) {
    if (f % elements_per_checkpoint == 0) checkpoint();
    for (Index i = 3; i-- > 0;) corners_[--corner_begin_[face_vertices_[f][i]]] = 3 * f + i;
  }
}

/// Leaves out the faces that name a vertex twice, those that are impassable, and those over the same three
/// vertices as an earlier one.
void Mesh::leave_out_faces(const SideLengths& sides) {
  struct Keyed {
    Index middle, greatest, face;
    bool operator<(const Keyed& other) const {
      return std::tie(middle, greatest, face) < std::tie(other.middle, other.greatest, other.face);
    }
  };
  std::vector<std::uint8_t> left_out(face_vertices_.size(), 0);
  std::atomic<bool> any = false;
  parallel_ranges(vertex_count(), [&](Index begin, Index end) {
    std::vector<Keyed> keyed;
    for (Index v = begin; v < end; ++v) {
      // Each face is examined at its least vertex.
      keyed.clear();
      for (Index h : corners(v)) {
        const auto [middle, greatest] = std::minmax({head(h), apex(h)});
        if (middle < v) continue;
        const auto face = static_cast<std::size_t>(face_of(h));
        if (face < sides.size() && is_impassable(sides[face])) {
          left_out[face] = 1;
          any = true;
          continue;
        }
        keyed.push_back({middle, greatest, face_of(h)});
      }
      std::sort(keyed.begin(), keyed.end());
      for (std::size_t i = 0; i < keyed.size(); ++i) {
        const bool twice = keyed[i].middle == v || keyed[i].middle == keyed[i].greatest;
        const bool repeated =
            i > 0 && keyed[i].middle == keyed[i - 1].middle && keyed[i].greatest == keyed[i - 1].greatest;
        if (!twice && !repeated) continue;
        left_out[keyed[i].face] = 1;
        any = true;
      }
    }
  });
  if (!any) return;
  std::vector<std::array<Index, 3>> kept;
  kept.reserve(face_vertices_.size());
  input_face_.reserve(face_vertices_.size());
  for (Index f = 0; f < face_count(); ++f) {
    if (left_out[f] != 0) continue;
    input_face_.push_back(f);
    kept.push_back(face_vertices_[f]);
  }
  face_vertices_ = std::move(kept);
  list_corners();
}

Index Mesh::edge_between(Index a, Index b) const {
  for (const Index h : corners(a)) {
    if (head(h) == b) return edge_of(h);
    if (apex(h) == b) return edge_of(previous_in_face(h));
  }
  return no_index;
}

/// Numbers the edges by their lower ends, then by their upper ends, and links their half-edges in rings.
void Mesh::link_edges() {
  // A key is the upper end of an edge, then a half-edge: sorted, the half-edges of an edge stand together.
  // The first key of each edge is marked afterwards.
  using Key = std::uint64_t;
  constexpr Key mark = Key{1} << 63;
  auto halfedge = [](Key key) { return static_cast<Index>(key & 0xffffffff); };
  auto upper_end = [](Key key) { return static_cast<Index>((key & ~mark) >> 32); };
  std::vector<std::vector<Key>> keys_of(range_count(vertex_count()));
  std::vector<Index> edge_end(positions_.size(), 0);
  parallel_ranges(vertex_count(), [&](Index begin, Index end) {
    std::vector<Key> keys;
    keys.reserve(static_cast<std::size_t>(corner_begin_[end] - corner_begin_[begin]));
    for (Index v = begin; v < end; ++v) {
      const auto first = static_cast<std::ptrdiff_t>(keys.size());
      for_each_side_at(v, [&](Index h, Index other) {
        if (other > v) keys.push_back(static_cast<Key>(other) << 32 | static_cast<Key>(h));
      });
      std::sort(keys.begin() + first, keys.end());
      Index previous = no_index;
      for (auto key = keys.begin() + first; key != keys.end(); ++key) {
        const Index other = upper_end(*key);
        if (other == previous) continue;
        *key |= mark;
        ++edge_end[v];
        previous = other;
      }
    }
    keys_of[range_of(begin)] = std::move(keys);
  });
  std::partial_sum(edge_end.begin(), edge_end.end(), edge_end.begin());
  const Index edges = edge_end.empty() ? 0 : edge_end.back();
  edge_vertices_.resize(edges);
  edge_length_.resize(edges);
  edge_halfedge_.resize(edges);
  halfedge_edge_.resize(corners_.size());
  next_around_edge_.resize(corners_.size());
  parallel_ranges(vertex_count(), [&](Index begin, Index end) {
    const std::vector<Key> keys = std::move(keys_of[range_of(begin)]);
    std::size_t at = 0;
    Index edge = begin == 0 ? 0 : edge_end[begin - 1];
    for (Index v = begin; v < end; ++v) {
      for (; edge < edge_end[v]; ++edge) {
        const std::size_t first = at;
        const Index other = upper_end(keys[first]);
        edge_vertices_[edge] = {v, other};
        edge_length_[edge] = distance_between(positions_[v], positions_[other]);
        edge_halfedge_[edge] = halfedge(keys[first]);
        do {
          halfedge_edge_[halfedge(keys[at])] = edge;
          const bool is_last = at + 1 == keys.size() || (keys[at + 1] & mark) != 0;
          next_around_edge_[halfedge(keys[at])] = halfedge(keys[is_last ? first : at + 1]);
        } while (++at < keys.size() && (keys[at] & mark) == 0);
      }
    }
  });
}

// ---- How the faces lie around each vertex: corners sorted by walking around it

void Mesh::sort_fans() {
  fan_.resize(positions_.size());
  border_.resize(positions_.size());
  total_angle_.resize(positions_.size());
  parallel_ranges(vertex_count(), [&](Index begin, Index end) {
    std::vector<Index> chain;
    for (Index v = begin; v < end; ++v) {
      total_angle_[v] = angle_around(v);
      fan_[v] = sort_fan(v, chain);
    }
  });
}

/// Brings the corners of a vertex into the order of its fan, if it has one. `chain` is scratch memory.
Mesh::Fan Mesh::sort_fan(Index vertex, std::vector<Index>& chain) {
  const auto own = corners(vertex);
  if (own.empty()) return Fan::isolated;
  bool manifold = true;
  Index start = own[0];
  for (Index h : own) {
    for (Index side : {h, previous_in_face(h)}) {
      // Around an edge of length zero the angles do not tell how the faces at its two ends lie relative to
      // each other, so straight on cannot be told from a turn: paths may turn at both ends.
      if (has_zero_edges_ && edge_length_[halfedge_edge_[side]] == 0.0) manifold = false;
      const Index other = next_around_edge_[side];
      if (other == side) {
        border_[vertex] = 1;
        start = h;
      } else if (next_around_edge_[other] != side) {
        manifold = false;
      }
    }
  }
  if (!manifold) return Fan::non_manifold;
  // Walk from the start corner, entering by a border edge if it has one, until the chain closes or ends.
  chain.clear();
  Index corner = start;
  Index entered = start;
  if (is_border(vertex) && next_around_edge_[start] != start) entered = previous_in_face(start);
  do {
    chain.push_back(corner);
    const Index leaving = entered == corner ? previous_in_face(corner) : corner;
    entered = next_around_edge_[leaving];
    if (entered == leaving) break;
    corner = tail(entered) == vertex ? entered : next_in_face(entered);
  } while (corner != start);
  if (chain.size() != own.size()) return Fan::non_manifold;
  std::copy(chain.begin(), chain.end(), corners_.begin() + corner_begin_[vertex]);
  return is_border(vertex) ? Fan::open : Fan::closed;
}

// ---- Angles and areas of faces, by the cross product of two sides, and the mean angle defect

namespace {

double cross_length(const Point& a, const Point& b) {
  const Point across = cross(a, b);
  const double square = dot(across, across);
  // Outside this range, squares lose digits or overflow.
  const bool in_range = square > 1e-270 && square < 1e270;
  return in_range ? std::sqrt(square) : length_of(across);
}

}  // namespace

double Mesh::corner_angle(Index halfedge) const {
  const auto corners = face_corners(face_of(halfedge));
  const Point& corner = corners[halfedge % 3];
  const Point to_next = minus(corners[next_in_face(halfedge) % 3], corner);
  const Point to_previous = minus(corners[previous_in_face(halfedge) % 3], corner);
  return std::atan2(cross_length(to_next, to_previous), dot(to_next, to_previous));
}

/// The sum of the angles of the corners at a vertex. Complex numbers are multiplied, which adds their angles,
/// so one arctangent serves all corners; half turns are counted.
double Mesh::angle_around(Index vertex) const {
  double cosine = 1.0, sine = 0.0;  // of the sum less its half turns, in [0, pi), times a positive number
  double others = 0.0;
  int half_turns = 0;
  for (Index h : corners(vertex)) {
    Point to_next, to_previous;
    if (has_metric_) {
      const auto corner = face_corners(face_of(h));
      to_next = minus(corner[next_in_face(h) % 3], corner[h % 3]);
      to_previous = minus(corner[previous_in_face(h) % 3], corner[h % 3]);
    } else {
      to_next = minus(positions_[head(h)], positions_[vertex]);
      to_previous = minus(positions_[apex(h)], positions_[vertex]);
    }
    double along = dot(to_next, to_previous);
    double across = cross_length(to_next, to_previous);
    const double size = std::abs(along) + across;
    if (!(size > 0.0 && size < unreachable)) {
      others += std::atan2(across, along);
      continue;
    }
    along /= size;
    across /= size;
    const bool beyond_half = cosine < 0.0 && along < 0.0;
    const double turned = cosine * along - sine * across;
    sine = sine * along + cosine * across;
    cosine = turned;
    if (beyond_half || sine < 0.0 || (sine == 0.0 && cosine < 0.0)) {
      cosine = -cosine;
      sine = -sine;
      ++half_turns;
    }
    if (std::abs(cosine) + std::abs(sine) < 1e-100) {
      cosine *= 1e100;
      sine *= 1e100;
    }
  }
  return half_turns * std::numbers::pi + std::atan2(sine, cosine) + others;
}

double Mesh::face_area(Index face) const {
  // Cross product of the two shorter sides: relative to them, the rounding of a product is small even in
  // needles.
  int longest = 0;
  for (int i = 1; i < 3; ++i) {
    if (edge_length_[halfedge_edge_[3 * face + i]] > edge_length_[halfedge_edge_[3 * face + longest]])
      longest = i;
  }
  const Index opposite = 3 * face + longest;
  const auto corners = face_corners(face);
  const Point& corner = corners[previous_in_face(opposite) % 3];
  return 0.5 * cross_length(minus(corners[opposite % 3], corner),
                            minus(corners[next_in_face(opposite) % 3], corner));
}

double Mesh::mean_angle_defect() const {
  double sum = 0.0;
  Index count = 0;
  for (Index v = 0; v < vertex_count(); ++v) {
    if (fan_[v] != Fan::closed) continue;
    sum += std::abs(total_angle_[v] - 2.0 * std::numbers::pi);
    ++count;
  }
  return count == 0 ? 0.0 : sum / count;
}

// ---- A mesh whose edges have other lengths than in space

namespace {

/// Lengths of one edge in two faces, and the sums in the triangle inequality, may differ by rounding.
constexpr double length_rounding = 1e-9;

/// Faces agree on an edge if its lengths in them differ by no more than this part of the shortest.
constexpr double agreement_rounding = 1e-12;

/// The bound of straight lines must hold after rounding.
constexpr double straight_slack = 1.0 - 1e-6;

std::string listed(const std::array<double, 3>& sides) {
  std::ostringstream text;
  text.precision(9);
  text << sides[0] << ", " << sides[1] << ", " << sides[2];
  return text.str();
}

/// Squares and product of two sides of a face, from its first corner.
struct Gram {
  explicit Gram(const std::array<Point, 3>& corner) {
    for (int k = 0; k < 3; ++k) {
      const double a = corner[1][k] - corner[0][k];
      const double b = corner[2][k] - corner[0][k];
      aa += a * a;
      ab += a * b;
      bb += b * b;
    }
  }
  double determinant() const { return std::max(0.0, aa * bb - ab * ab); }
  double aa = 0.0;
  double ab = 0.0;
  double bb = 0.0;
};

}  // namespace

std::shared_ptr<const Mesh> mesh_in_metric_of(const Mesh& mesh, std::vector<Point> positions,
                                              std::vector<std::array<Index, 3>> faces, SideLengths sides) {
  const Metric metric = mesh.has_metric() ? Metric{std::move(sides), mesh.points_per_edge()} : Metric{};
  return std::make_shared<const Mesh>(std::move(positions), std::move(faces), metric);
}

void require_agreeing_faces(const Mesh& mesh, const std::string& what) {
  require_both_ways_alike(mesh, what);
  if (!mesh.metric_jumps()) return;
  throw InvalidInput(what +
                     " need edges on whose length both faces agree, and this metric jumps at edges: take the "
                     "index or exact distances, or values at vertices.");
}

void require_both_ways_alike(const Mesh& mesh, const std::string& what) {
  if (!mesh.is_one_way()) return;
  throw InvalidInput(
      what +
      " need ways back that cost the same, and this metric goes one way: ask for exact fields, "
      "matrices, nearest points, regions, disks or paths, from points or to them.");
}

Mesh Mesh::reversed() const {
  Mesh mesh = *this;
  for (auto& face : mesh.face_drifts_) {
    for (double& drift : face) drift = -drift;
  }
  for (double& drift : mesh.edge_drift_) drift = -drift;
  for (double& height : mesh.potential_) height = -height;
  return mesh;
}

void Mesh::take_sides(const SideLengths& sides) {
  const auto rows = sides.size();
  for (Index f = 0; f < face_count(); ++f) {
    const Index row = input_face(f);
    const std::string number = std::to_string(row);
    if (static_cast<std::size_t>(row) >= rows) {
      throw InvalidInput("Face " + number + " has no side lengths: there are " + std::to_string(rows) +
                         " rows of lengths; give one row of three for each face.");
    }
    const auto& side = sides[row];
    for (double length : side) {
      if (length >= 0.0 && std::isfinite(length)) continue;
      throw InvalidInput("Face " + number + " has the side lengths " + listed(side) +
                         "; lengths must be finite and not negative.");
    }
    const double longest = *std::ranges::max_element(side);
    const double others = side[0] + side[1] + side[2] - longest;
    if (longest > others + length_rounding * longest) {
      throw InvalidInput("Face " + number + " has the side lengths " + listed(side) +
                         ", which break the triangle inequality: no side may be longer than the other two "
                         "together.");
    }
  }
  const bool may_jump = points_per_edge_ > 0;
  face_sides_.resize(may_jump ? face_count() : 0);
  for (std::size_t f = 0; f < face_sides_.size(); ++f)
    face_sides_[f] = sides[input_face(static_cast<Index>(f))];
  for (const Index e : checked(edge_count())) {
    // Side k is opposite corner k, so half-edge 3 f + i is side i + 2.
    auto length_at = [&](Index h) { return sides[input_face(face_of(h))][(h + 2) % 3]; };
    double& length = edge_length_[e] = length_at(edge_halfedge_[e]);
    if (may_jump) {
      for_each_halfedge(e, [&](Index h) { length = std::min(length, length_at(h)); });
    } else {
      require_agreement(e, sides);
    }
  }
}

void Mesh::take_drifts(const SideLengths& drifts) {
  face_drifts_.resize(face_count());
  for (Index f = 0; f < face_count(); ++f) {
    const auto row = static_cast<std::size_t>(input_face(f));
    if (row >= drifts.size()) {
      throw InvalidInput("Face " + std::to_string(row) + " has no drifts: there are " +
                         std::to_string(drifts.size()) +
                         " rows of them; give one row of three for each face.");
    }
    face_drifts_[f] = drifts[row];
    const auto& [a, b, c] = drifts[row];
    if (!(std::abs(a + b + c) <= 1e-9 * (face_sides_[f][0] + face_sides_[f][1] + face_sides_[f][2]))) {
      throw InvalidInput("Face " + std::to_string(row) + " has the drifts " + listed(drifts[row]) +
                         ", which do not sum to 0 round the face; give those of one vector.");
    }
    for (int i = 0; i < 3; ++i) {
      if (std::abs(drifts[row][i]) < face_sides_[f][i] ||
          (drifts[row][i] == 0.0 && face_sides_[f][i] == 0.0)) {
        continue;
      }
      throw InvalidInput("Face " + std::to_string(row) + " has the drifts " + listed(drifts[row]) +
                         " along sides of lengths " + listed(face_sides_[f]) +
                         ": a step against them would cost nothing or less; give a smaller drift.");
    }
  }
  take_potentials();
  if (std::ranges::all_of(face_drifts_, [](const auto& d) { return d == std::array{0.0, 0.0, 0.0}; })) {
    face_drifts_.clear();
    return;
  }
  drift_along_edges();
}

/// Replaces drifts by a potential in each component in which they sum to 0 round every loop.
void Mesh::take_potentials() {
  std::vector<double> height(positions_.size(), 0.0);
  std::vector<std::uint8_t> is_reached(positions_.size(), 0);
  std::vector<Index> reached;
  double greatest = 0.0;
  auto reach = [&](Index vertex, double there) {
    if (is_reached[vertex] != 0) return;
    is_reached[vertex] = 1;
    height[vertex] = there;
    reached.push_back(vertex);
  };
  for (const Index first : checked(vertex_count())) {
    if (is_reached[first] != 0) continue;
    reached.clear();
    reach(first, 0.0);
    double scale = 0.0;
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const Index v = reached[i];
      scale = std::max(scale, std::abs(height[v]));
      for (const Index h : corners(v)) {
        reach(head(h), height[v] + drift(h));
        reach(apex(h), height[v] - drift(previous_in_face(h)));
      }
    }
    auto fits = [&](Index v) {
      return std::ranges::all_of(corners(v), [&](Index h) {
        const double rise = height[head(h)] - height[v];
        return std::abs(rise - drift(h)) <= agreement_rounding * (side_length(h) + scale);
      });
    };
    const bool is_potential = std::ranges::all_of(reached, fits);
    for (const Index v : reached) {
      if (!is_potential) height[v] = 0.0;
      for (const Index h : corners(v)) {
        if (is_potential) face_drifts_[face_of(h)] = {};
      }
    }
    if (is_potential) greatest = std::max(greatest, scale);
  }
  if (greatest > 0.0) potential_ = std::move(height);
}

/// Along an edge, each way costs what it does in the face where it is cheapest.
void Mesh::drift_along_edges() {
  edge_drift_.resize(edge_count());
  for (const Index e : checked(edge_count())) {
    double forth = unreachable;
    double back = unreachable;
    for_each_halfedge(e, [&](Index h) {
      const double along = tail(h) == edge_vertices_[e][0] ? drift(h) : -drift(h);
      forth = std::min(forth, side_length(h) + along);
      back = std::min(back, side_length(h) - along);
    });
    edge_length_[e] = 0.5 * (forth + back);
    edge_drift_[e] = 0.5 * (forth - back);
  }
}

/// Finds the components in which faces disagree on an edge or have drifts; windows solve the others exactly.
void Mesh::find_jumps() {
  component_jumps_.assign(component_count_, 0);
  for (const Index h : checked(3 * face_count())) {
    const double least = edge_length_[halfedge_edge_[h]];
    const bool jumps = side_length(h) > least * (1.0 + agreement_rounding) || drift(h) != 0.0;
    if (jumps) component_jumps_[component_[tail(h)]] = 1;
  }
  agrees_somewhere_ = false;
  for (Index f = 0; f < face_count() && !agrees_somewhere_; ++f) {
    agrees_somewhere_ = component_jumps_[component_[face_vertices_[f][0]]] == 0;
  }
  if (std::ranges::find(component_jumps_, 1) != component_jumps_.end()) return;
  component_jumps_.clear();
  face_sides_.clear();
}

void Mesh::require_agreement(Index edge, const SideLengths& sides) const {
  const Index first = edge_halfedge_[edge];
  const double length = edge_length_[edge];
  for (Index h = next_around_edge_[first]; h != first; h = next_around_edge_[h]) {
    const Index one = input_face(face_of(first));
    const Index other = input_face(face_of(h));
    if (std::abs(sides[other][(h + 2) % 3] - length) <= length_rounding * length) continue;
    throw InvalidInput("Faces " + std::to_string(one) + " and " + std::to_string(other) +
                       " disagree on the length of their edge from vertex " +
                       std::to_string(edge_vertices_[edge][0]) + " to " +
                       std::to_string(edge_vertices_[edge][1]) + ": their side lengths are " +
                       listed(sides[one]) + " and " + listed(sides[other]) +
                       "; give the same length in both (each side stands opposite its corner).");
  }
}

std::array<double, 3> Mesh::side_lengths(Index face) const {
  std::array<double, 3> side{};
  for (int i = 0; i < 3; ++i) side[(i + 2) % 3] = side_length(3 * face + i);
  return side;
}

/// The corners of a face, laid into the plane by the lengths of its sides.
std::array<Point, 3> Mesh::corners_by_lengths(Index face) const {
  // The longest side lies on the x axis and begins where the shorter of the other two ends, so the difference
  // below is one of given lengths, which have all their digits.
  const auto side = side_lengths(face);
  const auto apex = static_cast<int>(std::ranges::max_element(side) - side.begin());
  int origin = (apex + 1) % 3;
  int end = (apex + 2) % 3;
  if (side[origin] < side[end]) std::swap(origin, end);
  const double longest = side[apex];
  const double to_origin = side[end];
  const double to_end = side[origin];
  std::array<Point, 3> corner{};
  if (!(longest > 0.0)) return corner;
  corner[end][0] = longest;
  const double more = longest - to_end;
  corner[apex][0] = (to_origin * to_origin + more * (longest + to_end)) / (2.0 * longest);
  corner[apex][1] = twice_area(side) / longest;
  return corner;
}

/// The least singular value of the maps from the faces in space to the faces in the metric.
void Mesh::bound_straight_lines() {
  straight_scale_ = 0.0;
  if (!has_positions_) return;
  double least = unreachable;
  for (const Index f : checked(face_count())) {
    const auto& v = face_vertices_[f];
    const Gram space({positions_[v[0]], positions_[v[1]], positions_[v[2]]});
    const Gram metric(face_corners(f));
    const double area = space.determinant();
    if (!(area > 0.0)) return;
    const double sum = (space.bb * metric.aa - 2.0 * space.ab * metric.ab + space.aa * metric.bb) / area;
    const double product = metric.determinant() / area;
    const double root = std::sqrt(std::max(0.0, sum * sum - 4.0 * product));
    if (!(sum + root > 0.0)) return;
    // The cheapest step costs its length times 1 minus the norm of the drift.
    const double a = drift(3 * f);
    const double b = -drift(3 * f + 2);
    const double drift_squared = metric.bb * a * a - 2.0 * metric.ab * a * b + metric.aa * b * b;
    const double share = has_drifts() ? 1.0 - std::sqrt(drift_squared / metric.determinant()) : 1.0;
    if (!(share > 0.0)) return;
    least = std::min(least, 2.0 * product / (sum + root) * share * share);
  }
  if (least < unreachable) straight_scale_ = straight_slack * std::sqrt(least);
}

}  // namespace vorogeo
