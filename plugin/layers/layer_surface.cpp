// What a layer makes when it is first asked for, and a list of layers in the order of use; a handful of them,
// so it is searched from the front.
#include "layers/layer_surface.h"

#include <algorithm>
#include <regex>
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

std::string LayerSurface::in_host_numbers(const std::string& sentence) const {
  static const std::regex numbers(R"(\b(vert|face)(ex|ices|s|) (\d+)(?:( and | to )(\d+))?)");
  std::string result;
  auto rest = sentence.begin();
  for (std::sregex_iterator found(sentence.begin(), sentence.end(), numbers), end; found != end; ++found) {
    const std::smatch& words = *found;
    const auto& map = words[1] == "vert" ? arrays_.input_of_vertex : arrays_.input_of_face;
    const auto host = [&](const std::string& number) {
      const std::size_t own = std::stoul(number);
      return own < map.size() ? std::to_string(map[own]) : number;
    };
    result.append(rest, words[3].first).append(host(words[3]));
    if (words[5].matched) result.append(words[4]).append(host(words[5]));
    rest = words[0].second;
  }
  return result.append(rest, sentence.end());
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

// ---- The layers used last

std::shared_ptr<LayerSurface> LayerCache::find_if(const std::function<bool(const LayerSurface&)>& fits,
                                                  const void* document) {
  const std::lock_guard lock(mutex_);
  const auto entry = std::ranges::find_if(entries_, [&](const Entry& e) { return fits(*e.surface); });
  if (entry == entries_.end()) return nullptr;
  if (document != nullptr) entry->documents.insert(document);
  move_to_front(entry);
  return entries_.front().surface;
}

void LayerCache::put(std::shared_ptr<LayerSurface> surface, const void* document) {
  const std::lock_guard lock(mutex_);
  entries_.push_back({std::move(surface), {}});
  if (document != nullptr) entries_.back().documents.insert(document);
  move_to_front(std::prev(entries_.end()));
}

void LayerCache::forget(const void* document) {
  const std::lock_guard lock(mutex_);
  entries_.remove_if([&](Entry& e) { return e.documents.erase(document) > 0 && e.documents.empty(); });
}

void LayerCache::move_to_front(std::list<Entry>::iterator entry) {
  if (entry != entries_.begin()) {
    entries_.front().surface->rest();
    entries_.splice(entries_.begin(), entries_, entry);
  }
  while (drop_one()) {
  }
}

/// Drops the surface used longest ago of those that are too many; if all are too large together, one without
/// an index first, as it is soon made again. \return false if nothing had to be dropped.
bool LayerCache::drop_one() {
  std::array<std::size_t, 2> count{};  // without an index, with one
  std::int64_t bytes = 0;
  for (const Entry& entry : entries_) {
    ++count[entry.surface->index() ? 1 : 0];
    bytes += entry.surface->memory_bytes();
  }
  for (const bool has_index : {false, true}) {
    if (count[has_index ? 1 : 0] <= capacity && bytes <= max_bytes_) continue;
    for (auto entry = std::prev(entries_.end()); entry != entries_.begin(); --entry) {
      if ((entry->surface->index() != nullptr) != has_index) continue;
      entries_.erase(entry);
      return true;
    }
  }
  return false;
}

}  // namespace vorogeo::plugin
