// Virtual sources handed from face to face, one for each face.
#include <array>
#include <cmath>

#include "methods/method_table.h"
#include "support/bucket_queue.h"
#include "support/checkpoint.h"

namespace vorogeo {

namespace {

/// Width of a bucket of the queue, in typical edges.
constexpr double bucket_width = 0.5;

/// What a face knows (section 3.1): its virtual source, as squared distances of its corners, how far that is
/// from the real one, and the distance of its centroid, by which face values are compared.
struct FaceSource {
  std::array<double, 3> square{};
  double sigma = unreachable;
  double distance = unreachable;
};

class VirtualSources final : public GeodesicMethod {
 public:
  explicit VirtualSources(const std::shared_ptr<const Mesh>& mesh) : mesh_(mesh), faces_(mesh->face_count()) {
    // A face over each of its edges: the edge on the x axis from the half-edge's tail, the apex above.
    apexes_.reserve(3 * faces_.size());
    for (Index h = 0; h < 3 * mesh->face_count(); ++h) {
      const double edge = length(h);
      const double to_head = length(Mesh::next_in_face(h));
      const double to_tail = length(Mesh::previous_in_face(h));
      const double x = edge > 0.0 ? 0.5 * (edge + (to_tail - to_head) * (to_tail + to_head) / edge) : 0.0;
      const double y = edge > 0.0 ? 2.0 * mesh->face_area(Mesh::face_of(h)) / edge : to_tail;
      apexes_.push_back({x, y});
    }
    queue_.resize(faces_.size());
  }

  std::vector<double> field(std::span<const Index> sources, const Progress& progress) override {
    const Watch watch(progress, "Virtual sources");
    faces_.assign(faces_.size(), {});
    queue_.reset(bucket_width * mesh_->typical_edge_length());
    for (Index source : sources) start_at(source);
    Index taken = 0;
    for (Index face = queue_.pop(); face != no_index; face = queue_.pop()) {
      if (++taken % elements_per_checkpoint == 0) checkpoint();
      for (Index h = 3 * face; h < 3 * face + 3; ++h) {
        for (Index g = mesh_->next_around_edge(h); g != h; g = mesh_->next_around_edge(g)) hand_on(h, g);
      }
    }
    std::vector<double> distances(mesh_->vertex_count(), unreachable);
    for (Index h = 0; h < 3 * mesh_->face_count(); ++h) {
      const FaceSource& face = faces_[Mesh::face_of(h)];
      double& distance = distances[mesh_->tail(h)];
      distance = std::fmin(distance, face.sigma + std::sqrt(face.square[h % 3]));
    }
    for (Index source : sources) distances[source] = 0.0;
    return distances;
  }
  std::size_t bytes() const override {
    return bytes_of(faces_) + bytes_of(apexes_) + faces_.size() * sizeof(std::int64_t);
  }

 private:
  struct Apex {
    double x, y;
  };

  double length(Index halfedge) const { return mesh_->edge_length(mesh_->edge_of(halfedge)); }

  void start_at(Index source) {
    for (Index corner : mesh_->corners(source)) {
      const double side = length(corner);
      const Apex& apex = apexes_[corner];
      const double other = length(Mesh::previous_in_face(corner));
      const double distance = std::hypot(side + apex.x, apex.y) / 3.0;
      FaceSource& face = faces_[Mesh::face_of(corner)];
      if (!(distance < face.distance)) continue;
      face.square[corner % 3] = 0.0;
      face.square[Mesh::next_in_face(corner) % 3] = side * side;
      face.square[Mesh::previous_in_face(corner) % 3] = other * other;
      face.sigma = 0.0;
      face.distance = distance;
      queue_.push(Mesh::face_of(corner), distance);
    }
  }

  /// From the face of half-edge h into that of g, over their common edge.
  void hand_on(Index h, Index g) {
    const FaceSource& from = faces_[Mesh::face_of(h)];
    FaceSource& to = faces_[Mesh::face_of(g)];
    if (from.distance >= to.distance) return;
    const double edge = length(g);
    if (!(edge > 0.0)) return;
    const bool same = mesh_->tail(g) == mesh_->tail(h);
    const double tail_square = from.square[(same ? h : Mesh::next_in_face(h)) % 3];
    const double head_square = from.square[(same ? Mesh::next_in_face(h) : h) % 3];
    // The virtual source below the edge.
    const double x = 0.5 * (edge + (tail_square - head_square) / edge);
    const double depth = std::sqrt(std::fmax(0.0, tail_square - x * x));
    const Apex& apex = apexes_[g];
    const double centre_x = (edge + apex.x) / 3.0;
    const double centre_y = apex.y / 3.0;
    // Whether the source is seen through the edge is decided for the centroid, for which faces are compared.
    const double height = centre_y + depth;
    const double crossing = height > 0.0 ? x + (centre_x - x) * (depth / height) : x;
    FaceSource found;
    std::array<double, 3> square{tail_square, head_square, 0.0};
    if (crossing >= 0.0 && crossing <= edge) {
      found.sigma = from.sigma;
      square[2] = (apex.x - x) * (apex.x - x) + (apex.y + depth) * (apex.y + depth);
      found.distance = found.sigma + std::hypot(centre_x - x, centre_y + depth);
    } else {
      // Out of sight: the path bends at the end of the edge on that side, the new virtual source.
      const bool at_tail = crossing < 0.0;
      const double end = at_tail ? 0.0 : edge;
      found.sigma = from.sigma + std::sqrt(at_tail ? tail_square : head_square);
      square = {end * end, (edge - end) * (edge - end), (apex.x - end) * (apex.x - end) + apex.y * apex.y};
      found.distance = found.sigma + std::hypot(centre_x - end, centre_y);
    }
    // Without this threshold, negligible gains would circle a vertex forever.
    if (!(found.distance < to.distance * (1.0 - 1e-12))) return;
    found.square[g % 3] = square[0];
    found.square[Mesh::next_in_face(g) % 3] = square[1];
    found.square[Mesh::previous_in_face(g) % 3] = square[2];
    to = found;
    queue_.push(Mesh::face_of(g), found.distance);
  }

  std::shared_ptr<const Mesh> mesh_;
  std::vector<FaceSource> faces_;
  std::vector<Apex> apexes_;
  BucketQueue queue_;
};

}  // namespace

MethodEntry gsp_entry() {
  return {{"gsp",
           "Virtual sources (GSP)",
           "P. Trettner, D. Bommes, L. Kobbelt: Geodesic distance computation via virtual source "
           "propagation. Computer "
           "Graphics Forum 40(5), 2021",
           {},
           {"MSAD", "none", "none", "none", "field about n"},
           false,
           false},
          [](const std::shared_ptr<const Mesh>& mesh, const MethodOptions&, const Progress&) {
            return std::make_unique<VirtualSources>(mesh);
          },
          {}};
}

}  // namespace vorogeo
