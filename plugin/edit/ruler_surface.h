// A mesh that is measured: paths and fields between points that were picked, by whatever answers them now.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "edit/picked.h"
#include "exact/paths_from_point.h"
#include "exact/surface_path.h"
#include "field/geodesic_query.h"
#include "index/geodesic_index.h"
#include "mesh/surface_locator.h"
#include "mesh/vcg_adapter.h"
#include "methods/method.h"
#include "path/path_query.h"
#include "support/progress.h"
#include "tasks/isolines.h"

namespace vorogeo::plugin {

/// How an answer was found.
enum class Answered {
  exactly,   ///< the shortest paths, by propagation
  by_index,  ///< refined paths, and distances from the index
  quickly    ///< distances by virtual sources, from the nearest vertex
};
/// As the dock and tables say it: "exact", "refined" for paths of the index, ...
const char* name_of(Answered how, bool is_path);

/// Without an index, fields of meshes with more vertices than this are computed quickly, not exactly.
inline constexpr Index max_exact_vertices = 50000;

/// Values for isolines: multiples of a round step, 1, 2 or 5 times a power of ten, some ten to twenty of
/// them.
std::vector<double> round_values(double largest);

/// Both ends lie on the surface, or `path` is not meant to be read.
struct PathAnswer {
  bool starts_on_surface = false;
  bool ends_on_surface = false;
  Point from{};
  Point to{};
  SurfacePath path;  ///< without points if the ends lie in different components
  Answered how = Answered::exactly;
};

struct FieldAnswer {
  bool starts_on_surface = false;
  std::vector<double> distances;  ///< of all vertices
  double largest = 0.0;           ///< of those that a path leads to
  Isolines lines;
  Answered how = Answered::exactly;
};

/// The mesh of a layer as it was when it was read. The answers and what they need are made by the worker when
/// they are first asked for. Holds no algorithm: it chooses among those of the core.
class RulerSurface {
 public:
  /// `index`: of exactly this mesh, or nothing.
  RulerSurface(VcgMeshArrays arrays, std::shared_ptr<const GeodesicIndex> index);

  const VcgMeshArrays& arrays() const { return arrays_; }
  /// May be called by any thread.
  std::shared_ptr<const Mesh> mesh() const;
  std::shared_ptr<const GeodesicIndex> index() const;
  /// From now on answers come from it.
  void use(std::shared_ptr<const GeodesicIndex> index);

  /// Both only by the worker. \throw Cancelled, InvalidInput for a mesh that cannot be used.
  PathAnswer path(const Picked& from, const Picked& to, const Progress& progress);
  FieldAnswer field(const Picked& from, const Progress& progress);

 private:
  bool snap(const Picked& picked, SurfacePoint& point);

  const VcgMeshArrays arrays_;
  mutable std::mutex mutex_;
  mutable std::shared_ptr<const Mesh> mesh_;
  std::shared_ptr<const GeodesicIndex> index_;

  // The worker's.
  std::unique_ptr<SurfaceLocator> locator_;
  std::unique_ptr<PathsFromPoint> exact_paths_;
  SurfacePoint exact_source_;
  std::unique_ptr<PathQuery> index_paths_;
  std::unique_ptr<GeodesicQuery> index_fields_;
  std::unique_ptr<GeodesicMethod> quick_fields_;
};

}  // namespace vorogeo::plugin
