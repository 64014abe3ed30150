// A layer that was read: its arrays, how it is measured, and the surface that answers questions on it.
#include "layers/layer_surface.h"

#include <utility>

#include "mesh/mesh_check.h"
#include "mesh/mesh_input.h"
#include "support/error.h"

namespace vorogeo::plugin {

LayerSurface::LayerSurface(VcgMeshArrays arrays, LayerMeasure measure, std::vector<std::string> remarks)
    : arrays_(std::move(arrays)), measure_(std::move(measure)), remarks_(std::move(remarks)) {}

Index LayerSurface::core_vertex(int host_vertex, const std::string& parameter) const {
  const auto& map = arrays_.vertex_of_input;
  if (host_vertex < 0 || static_cast<std::size_t>(host_vertex) >= map.size()) {
    throw InvalidInput(parameter + " is " + std::to_string(host_vertex) +
                       ", but the vertices of the current layer are numbered from 0 to " +
                       std::to_string(map.size() - 1) + ". Give a number in this range.");
  }
  if (map[static_cast<std::size_t>(host_vertex)] == no_index) {
    throw InvalidInput(parameter + " is " + std::to_string(host_vertex) +
                       ", but this vertex was deleted. Give the number of another vertex.");
  }
  return map[static_cast<std::size_t>(host_vertex)];
}

HostPlace LayerSurface::host_place(const Mesh& mesh, const SurfacePoint& point) const {
  const Index face = InputMap(mesh).face_at(point);
  return face == no_index ? HostPlace{host_vertex(point.vertex)} : HostPlace{-1, arrays_.input_of_face[face]};
}

std::shared_ptr<Surface> LayerSurface::known_surface() const {
  const std::lock_guard lock(mutex_);
  return surface_;
}

std::shared_ptr<Surface> LayerSurface::surface() {
  if (auto surface = known_surface()) return surface;
  const std::lock_guard one(making_);
  if (auto surface = known_surface()) return surface;
  auto made =
      std::make_shared<Surface>(measured_mesh({arrays_.positions, arrays_.faces, arrays_.metric, gap()}));
  const std::lock_guard lock(mutex_);
  surface_ = std::move(made);
  return surface_;
}

std::shared_ptr<const SurfaceLocator> LayerSurface::locator() {
  const auto mesh = this->mesh();
  const std::lock_guard one(making_);
  if (!locator_) locator_ = std::make_shared<const SurfaceLocator>(mesh);
  return locator_;
}

const std::vector<std::string>& LayerSurface::warnings() {
  const std::lock_guard one(making_);
  if (!warnings_) warnings_ = check_mesh(arrays_.positions, arrays_.faces, gap()).sentences();
  return *warnings_;
}

std::shared_ptr<const GeodesicIndex> LayerSurface::index() const {
  const auto surface = known_surface();
  return surface ? surface->index() : nullptr;
}

void LayerSurface::use(std::shared_ptr<const GeodesicIndex> index) {
  const auto mesh = index->mesh();
  const auto known = known_surface();
  auto made = std::make_shared<Surface>(mesh, std::move(index),
                                        known ? known->spent() : RentOrBuy(mesh->vertex_count()));
  const std::lock_guard lock(mutex_);
  surface_ = std::move(made);
}

void LayerSurface::rest() {
  if (const auto known = known_surface()) known->free_queries();
}

std::int64_t LayerSurface::memory_bytes() const {
  std::size_t bytes = arrays_.positions.size() * sizeof(Point) +
                      arrays_.faces.size() * sizeof(arrays_.faces[0]) +
                      arrays_.metric.sides.size() * sizeof(double[3]) + measure_.cost.size() * sizeof(double);
  if (const auto surface = known_surface()) {
    bytes += surface->mesh()->memory_bytes();
    if (const auto index = surface->index()) bytes += static_cast<std::size_t>(index->statistics().bytes);
  }
  return static_cast<std::int64_t>(bytes);
}

}  // namespace vorogeo::plugin
