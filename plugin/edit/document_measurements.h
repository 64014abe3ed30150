// The measurements of a document, which all its views show.
#pragma once

#include <functional>
#include <map>
#include <vector>

#include "edit/measurements.h"
#include "mesh/vcg_adapter.h"

namespace vorogeo::plugin {

/// A list with the meshes that were measured, and who shows it. All functions are called from one thread.
class DocumentMeasurements {
 public:
  const Measurements& list() const { return list_; }

  /// \return the number of the measurement, which was taken on this mesh.
  int add(Measurement measurement, const VcgMeshArrays& mesh);
  void remove(const std::vector<int>& numbers);
  /// The mesh of a layer as it is now: measurements of another one are kept, but say so.
  void compare(int layer, const VcgMeshArrays& mesh);

  /// `changed` is called now and after every change, until unwatch(who).
  void watch(const void* who, std::function<void()> changed);
  void unwatch(const void* who) { watchers_.erase(who); }

 private:
  void tell() const;

  Measurements list_;
  std::map<int, VcgMeshArrays> measured_;  ///< by layer, the mesh of its measurements
  std::map<const void*, std::function<void()>> watchers_;
};

/// Whether both have the same positions and faces.
bool is_same_mesh(const VcgMeshArrays& a, const VcgMeshArrays& b);

}  // namespace vorogeo::plugin
