// Short-term vector Dijkstra: edge paths measured by the vectors that a few edges add up to.
#include <cmath>
#include <numbers>
#include <queue>
#include <utility>

#include "exact/exact_geometry.h"
#include "methods/method_table.h"
#include "support/checkpoint.h"

namespace vorogeo {

namespace {

/// An edge seen from one of its ends.
struct Spoke {
  Index target;
  double length;
  double angle;  ///< around the vertex, scaled to 2 pi in all
  bool turned;   ///< whether angles there grow against the orientation of the edge's first face
};

/// Campen, Heistermann, Kobbelt 2013, section 4: the step from v to w is charged not by its own length but by
/// the least over i <= k of the distance of the i-th vertex back from w, plus the length of the sum of the
/// last i edges, unfolded into the plane at the vertices between. At a border of the mesh and at vertices
/// that are no disk the sum ends, as the straight line might leave the surface.
class ShortTermVectors final : public GeodesicMethod {
 public:
  ShortTermVectors(const std::shared_ptr<const Mesh>& mesh, int memory) : mesh_(mesh), memory_(memory) {
    const ExactGeometry geometry(mesh);
    begin_.push_back(0);
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      const bool disk = mesh->fan(v) == Mesh::Fan::closed && mesh->total_angle(v) > 0.0;
      is_disk_.push_back(disk ? 1 : 0);
      const double scale = disk ? 2.0 * std::numbers::pi / mesh->total_angle(v) : 0.0;
      for (Index corner : mesh->corners(v)) {
        const bool own = geometry.begins_at_own_edge[corner] != 0;
        const Index side = own ? corner : Mesh::previous_in_face(corner);
        add_spoke(v, side, disk ? geometry.corner_begin[corner] * scale : 0.0, own);
        if (!disk) add_spoke(v, own ? Mesh::previous_in_face(corner) : corner, 0.0, own);
      }
      begin_.push_back(spokes_.size());
    }
  }

  std::vector<double> field(std::span<const Index> sources, const Progress& progress) override {
    const Watch watch(progress, "Short-term vector Dijkstra");
    const auto count = static_cast<std::size_t>(mesh_->vertex_count());
    std::vector<double> distance(count, unreachable);
    // The spoke by which a vertex is reached from the one before: no_spoke at sources.
    std::vector<std::size_t> reached_by(count, no_spoke);
    std::vector<Index> before(count, no_index);
    std::vector<std::uint8_t> accepted(count, 0);
    using Item = std::pair<double, Index>;
    std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
    for (Index source : sources) {
      distance[source] = 0.0;
      queue.push({0.0, source});
    }
    Index taken = 0;
    while (!queue.empty()) {
      const Index v = queue.top().second;
      queue.pop();
      if (accepted[v] != 0) continue;
      accepted[v] = 1;
      if (++taken % elements_per_checkpoint == 0) checkpoint();
      for (std::size_t s = begin_[v]; s < begin_[v + 1]; ++s) {
        const Index w = spokes_[s].target;
        if (accepted[w] != 0) continue;
        const double found = over(v, spokes_[s], distance, before, reached_by);
        // Of paths equal up to rounding, the first is kept: it has the fewest edges, so the longest memory.
        if (found < distance[w] * (1.0 - 1e-12)) {
          distance[w] = found;
          before[w] = v;
          reached_by[w] = s;
          queue.push({found, w});
        }
      }
    }
    return distance;
  }
  std::size_t bytes() const override {
    return bytes_of(spokes_) + bytes_of(begin_) + bytes_of(is_disk_) +
           is_disk_.size() * (sizeof(double) + sizeof(std::size_t) + sizeof(Index) + 1);
  }

 private:
  static constexpr std::size_t no_spoke = static_cast<std::size_t>(-1);

  void add_spoke(Index v, Index side, double angle, bool own) {
    const Index edge = mesh_->edge_of(side);
    const auto [a, b] = mesh_->edge_vertices(edge);
    // Angles grow from the corner's own edge to the other one along the orientation of the corner's face; the
    // first face of the edge may be oriented the other way, which shows where both run along the edge alike.
    const Index first = mesh_->edge_halfedge(edge);
    const bool alike = first == side || mesh_->tail(first) != mesh_->tail(side);
    spokes_.push_back({a == v ? b : a, mesh_->edge_length(edge), angle, own != alike});
  }

  const Spoke* back(Index from, Index to) const {
    for (std::size_t s = begin_[from]; s < begin_[from + 1]; ++s) {
      if (spokes_[s].target == to) return &spokes_[s];
    }
    return nullptr;
  }

  double over(Index v, const Spoke& last, const std::vector<double>& distance,
              const std::vector<Index>& before, const std::vector<std::size_t>& reached_by) const {
    double least = distance[v] + last.length;
    // v in the origin, w on the x axis; the chain is laid backwards from there.
    double x = 0.0;
    double y = 0.0;
    double direction = 0.0;  // of the edge that leaves the vertex looked at, towards w
    double sense = 1.0;      // in which angles at it grow
    Index at = v;
    const Spoke* out = &last;
    for (int i = 1; i < memory_ && is_disk_[at] != 0 && before[at] != no_index; ++i) {
      const Index previous = before[at];
      const Spoke* in = back(at, previous);
      if (in == nullptr) break;
      direction += sense * (in->angle - out->angle);
      x += in->length * std::cos(direction);
      y += in->length * std::sin(direction);
      least = std::fmin(least, distance[previous] + std::hypot(last.length - x, y));
      const Spoke& forth = spokes_[reached_by[at]];
      if (forth.turned != in->turned) sense = -sense;
      direction += std::numbers::pi;
      out = &forth;
      at = previous;
    }
    return least;
  }

  std::shared_ptr<const Mesh> mesh_;
  int memory_;
  std::vector<Spoke> spokes_;
  std::vector<std::size_t> begin_;
  std::vector<std::uint8_t> is_disk_;
};

}  // namespace

MethodEntry stvd_entry() {
  return {{"stvd",
           "Short-term vector Dijkstra",
           "M. Campen, M. Heistermann, L. Kobbelt: Practical anisotropic geodesy. Computer Graphics Forum "
           "32(5), 2013",
           {{"k", 4.0, 1.0, 64.0, true, "edges whose vectors are added up; 1: edge paths"}},
           {"MSAD", "angles", "none", "any on vectors", "field k n log n"},
           false,
           false},
          [](const std::shared_ptr<const Mesh>& mesh, const MethodOptions& options, const Progress&) {
            return std::make_unique<ShortTermVectors>(mesh, static_cast<int>(options.at("k")));
          },
          {}};
}

}  // namespace vorogeo
