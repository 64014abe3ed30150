// Changes of the list reach all who show it.
#include "edit/document_measurements.h"

#include <utility>

namespace vorogeo::plugin {

bool is_same_mesh(const VcgMeshArrays& a, const VcgMeshArrays& b) {
  return a.positions == b.positions && a.faces == b.faces;
}

int DocumentMeasurements::add(Measurement measurement, const VcgMeshArrays& mesh) {
  measured_[measurement.layer] = mesh;
  const int number = list_.add(std::move(measurement));
  tell();
  return number;
}

void DocumentMeasurements::remove(const std::vector<int>& numbers) {
  for (int number : numbers) list_.remove(number);
  tell();
}

void DocumentMeasurements::compare(int layer, const VcgMeshArrays& mesh) {
  const auto measured = measured_.find(layer);
  if (measured == measured_.end() || is_same_mesh(measured->second, mesh)) return;
  list_.mesh_has_changed(layer);
  measured_.erase(measured);
  tell();
}

void DocumentMeasurements::watch(const void* who, std::function<void()> changed) {
  watchers_[who] = changed;
  changed();
}

void DocumentMeasurements::tell() const {
  for (const auto& [who, changed] : watchers_) changed();
}

}  // namespace vorogeo::plugin
