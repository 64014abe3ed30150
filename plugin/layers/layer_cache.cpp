// A list in the order of use; a handful of entries, so it is searched from the front.
#include "layers/layer_cache.h"

#include <algorithm>
#include <utility>

namespace vorogeo::plugin {

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
