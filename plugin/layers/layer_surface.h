// A layer that was read: its arrays, how it is measured, and the surface that answers questions on it; and
// the layers that a user is working with, so that a second question pays for its answer only.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "layers/placement.h"
#include "mesh/gaps.h"
#include "mesh/metric.h"
#include "mesh/surface_locator.h"
#include "mesh/vcg_adapter.h"
#include "query/surface.h"

namespace vorogeo::plugin {

/// What a path costs; the values of the parameter metric.
enum class LayerMetric { length, vertex_quality, slope, curvature, face_quality, hiking, climbing, wind };
/// Names in dialogs and tables; the ruler has the metrics in which both ways cost the same.
inline constexpr std::array<const char*, 5> ruler_metrics{"Length", "Vertex quality as cost", "Slope penalty",
                                                          "Along curvature", "Face quality as cost"};
/// The one-way metrics, after these.
inline constexpr std::array<const char*, 3> one_way_metrics{"Hiking time", "Uphill and downhill cost",
                                                            "Wind"};
/// slope_penalty and curvature_weight by default; 0 in other metrics of the ruler.
inline constexpr std::array usual_weights{0.0, 0.0, 1.0, 3.0, 0.0};

/// What decides, besides a layer's mesh, which distances it has.
struct LayerMeasure {
  LayerMetric metric = LayerMetric::length;
  double weight = 0.0;      ///< slope_penalty, curvature_weight, uphill_cost or own_speed; 0 in other metrics
  double steepest = 0.0;    ///< steepest_grade: faces above it are barriers; 0: none
  double downhill = 0.0;    ///< downhill_cost; 0 in other metrics
  std::vector<Point> wind;  ///< in the scene, of each face that is not deleted; empty in other metrics
  std::vector<double>
      cost;  ///< by quality: of each vertex or face that is not deleted; empty in other metrics
  GapLimit gap;
  Placement placement;  ///< of the layer in the scene: where it is measured

  friend bool operator==(const LayerMeasure&, const LayerMeasure&) = default;
};

/// Where a point lies in a layer of the host: the number of a vertex or of a face, and -1 for the other.
struct HostPlace {
  int vertex = -1;
  int face = -1;
};

/// A layer of the host as it stood in the scene when it was read. A core vertex is a vertex that is not
/// deleted. It never changes, but parts of it are made when first asked for; may be used by several threads.
class LayerSurface {
 public:
  /// `arrays`: with the sides that the metric gives the faces. `remarks`: sentences for the log.
  explicit LayerSurface(VcgMeshArrays arrays, LayerMeasure measure = {},
                        std::vector<std::string> remarks = {});

  const VcgMeshArrays& arrays() const { return arrays_; }
  const LayerMeasure& measure() const { return measure_; }
  const GapLimit& gap() const { return measure_.gap; }
  const Placement& placement() const { return measure_.placement; }
  const std::vector<std::string>& remarks() const { return remarks_; }
  /// Whether reading this layer, to be measured like this, would give the same again.
  template <class VcgMesh>
  bool is_of(const VcgMesh& layer, const LayerMeasure& measure) const {
    return measure == measure_ &&
           are_arrays_of(layer, arrays_, [&](const Point& at) { return measure.placement.to_scene(at); });
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
  /// A sentence of the core, which counts vertices and faces without those that are deleted, with the host's
  /// numbers: those after "vertex", "face" and their plurals.
  std::string in_host_numbers(const std::string& sentence) const;
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
  /// Frees the memory that queries hold between two questions; what is made from the mesh alone stays.
  void rest();
  /// Of the arrays, the mesh and the index.
  std::int64_t memory_bytes() const;

 private:
  std::shared_ptr<Surface> known_surface() const;

  const VcgMeshArrays arrays_;
  const LayerMeasure measure_;
  const std::vector<std::string> remarks_;
  std::mutex making_;         ///< held while something is made
  mutable std::mutex mutex_;  ///< for the pointers, held for moments
  std::shared_ptr<Surface> surface_;
  std::shared_ptr<const SurfaceLocator> locator_;     ///< guarded by making_
  std::optional<std::vector<std::string>> warnings_;  ///< likewise; written once
};

/// The few surfaces used last: up to four with an index, and as many without one.
///
/// A surface is found by comparing the whole layer, all positions, faces, costs and parameters, not a name or
/// a hash of it: after any edit there is none until the layer is read again, and when the edit is undone the
/// old one is found again. A surface belongs to the documents that used it and is freed with the last of
/// them. Only the one used last keeps queries, which hold memory for the whole mesh. May be used by several
/// threads.
class LayerCache {
 public:
  /// `max_bytes`: what the surfaces may take together; the one used last is kept, however large it is.
  explicit LayerCache(std::int64_t max_bytes = default_memory_budget << 20) : max_bytes_(max_bytes) {}

  /// The surface of a layer exactly as it is now, to be measured like this, or nothing. From now on it
  /// belongs to this document, too (if one is named).
  template <class VcgMesh>
  std::shared_ptr<LayerSurface> find(const VcgMesh& layer, const LayerMeasure& measure,
                                     const void* document = nullptr) {
    return find_if([&](const LayerSurface& surface) { return surface.is_of(layer, measure); }, document);
  }
  /// Keeps a surface, which displaces those used longest ago: first those without an index. Without a
  /// document it stays until it is displaced.
  void put(std::shared_ptr<LayerSurface> surface, const void* document = nullptr);
  /// Frees the surfaces that belong to this document only.
  void forget(const void* document);

 private:
  struct Entry {
    std::shared_ptr<LayerSurface> surface;
    std::set<const void*> documents;
  };
  /// For surfaces with an index, and for those without one.
  static constexpr std::size_t capacity = 4;

  std::shared_ptr<LayerSurface> find_if(const std::function<bool(const LayerSurface&)>& fits,
                                        const void* document);
  void move_to_front(std::list<Entry>::iterator entry);
  bool drop_one();

  const std::int64_t max_bytes_;
  std::mutex mutex_;
  std::list<Entry> entries_;  ///< most recently used first
};

}  // namespace vorogeo::plugin
