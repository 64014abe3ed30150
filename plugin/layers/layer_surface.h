// A layer that was read: its arrays, how it is measured, and the surface that answers questions on it.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "mesh/gaps.h"
#include "mesh/metric.h"
#include "mesh/surface_locator.h"
#include "mesh/vcg_adapter.h"
#include "query/surface.h"

namespace vorogeo::plugin {

/// What a path costs; the values of the parameter metric.
enum class LayerMetric { length, vertex_quality, slope, curvature, face_quality };

/// What decides, besides a layer's mesh, which distances it has.
struct LayerMeasure {
  LayerMetric metric = LayerMetric::length;
  double weight = 0.0;  ///< slope_penalty or curvature_weight; 0 in other metrics
  std::vector<double>
      cost;  ///< by quality: of each vertex or face that is not deleted; empty in other metrics
  GapLimit gap;

  friend bool operator==(const LayerMeasure&, const LayerMeasure&) = default;
};

/// Where a point lies in a layer of the host: the number of a vertex or of a face, and -1 for the other.
struct HostPlace {
  int vertex = -1;
  int face = -1;
};

/// A layer of the host as it was when it was read. A core vertex is a vertex that is not deleted. Nothing of
/// it changes but what is made when it is first asked for; may be used by several threads.
class LayerSurface {
 public:
  /// `arrays`: with the sides that the metric gives the faces. `remarks`: what reading the metric has to say.
  explicit LayerSurface(VcgMeshArrays arrays, LayerMeasure measure = {},
                        std::vector<std::string> remarks = {});

  const VcgMeshArrays& arrays() const { return arrays_; }
  const LayerMeasure& measure() const { return measure_; }
  const GapLimit& gap() const { return measure_.gap; }
  const std::vector<std::string>& remarks() const { return remarks_; }
  /// Whether reading this layer, to be measured like this, would give the same again.
  template <class VcgMesh>
  bool is_of(const VcgMesh& layer, const LayerMeasure& measure) const {
    return measure == measure_ && are_arrays_of(layer, arrays_);
  }

  /// The core vertex with this number in the host. \throw InvalidInput if there is none; the message names
  /// `parameter`, which gave the number.
  Index core_vertex(int host_vertex, const std::string& parameter) const;
  /// -1 for a vertex that the host does not have (Mesh::given_vertex_count).
  int host_vertex(Index vertex) const {
    const auto number = static_cast<std::size_t>(vertex);
    return number < arrays_.input_of_vertex.size() ? arrays_.input_of_vertex[number] : -1;
  }
  HostPlace host_place(const Mesh& mesh, const SurfacePoint& point) const;
  /// The host's number of a face of mesh(). \pre It is not a bridge over a gap.
  int host_face(const Mesh& mesh, Index face) const { return arrays_.input_of_face[mesh.input_face(face)]; }

  // Made when first asked for, which takes a while. \throw InvalidInput for a mesh that cannot be used.
  std::shared_ptr<Surface> surface();
  std::shared_ptr<const Mesh> mesh() { return surface()->mesh(); }
  std::shared_ptr<const SurfaceLocator> locator();
  /// What a user should know about the mesh before trusting distances on it, one sentence each.
  const std::vector<std::string>& warnings();

  // Without a wait:
  bool has_surface() const { return known_surface() != nullptr; }
  /// Null as long as there is none.
  std::shared_ptr<const GeodesicIndex> index() const;
  /// An index of mesh() that was built or loaded elsewhere: from now on answers come from it.
  void use(std::shared_ptr<const GeodesicIndex> index);
  /// Frees what queries hold between two questions; what is made from the mesh alone stays.
  void rest();
  /// Of the arrays, the mesh and the index.
  std::int64_t memory_bytes() const;

 private:
  std::shared_ptr<Surface> known_surface() const;

  const VcgMeshArrays arrays_;
  const LayerMeasure measure_;
  const std::vector<std::string> remarks_;
  std::mutex making_;         ///< held while something is made
  mutable std::mutex mutex_;  ///< of the pointers, held for moments
  std::shared_ptr<Surface> surface_;
  std::shared_ptr<const SurfaceLocator> locator_;     ///< by making_
  std::optional<std::vector<std::string>> warnings_;  ///< likewise; written once
};

}  // namespace vorogeo::plugin
