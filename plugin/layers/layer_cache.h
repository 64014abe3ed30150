// The layers that a user is working with, as surfaces, so that a second question pays for its answer only.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <set>

#include "layers/layer_surface.h"

namespace vorogeo::plugin {

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
  /// With an index, and without one.
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
