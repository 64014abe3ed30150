// A list in the order of use; a handful of entries, so it is searched from the front.
#include "layers/index_cache.h"

#include <algorithm>
#include <span>
#include <utility>

namespace vorogeo::plugin {

namespace {

bool are_equal(const FaceSplits& a, const FaceSplits& b) {
  return a.middle_of == b.middle_of && a.faces == b.faces && a.given_face == b.given_face &&
         a.sides == b.sides;
}

}  // namespace

bool IndexCache::Entry::fits(const VcgMeshArrays& arrays, const GapLimit& asked) const {
  const Mesh& mesh = *index->mesh();
  return gap == asked && faces == arrays.faces && sides == arrays.sides &&
         mesh.points_per_edge() == arrays.points_per_edge && are_equal(splits, arrays.splits) &&
         std::ranges::equal(std::span(mesh.positions()).first(mesh.given_vertex_count()), arrays.positions);
}

std::shared_ptr<const GeodesicIndex> IndexCache::find(const VcgMeshArrays& arrays, const GapLimit& gap,
                                                      const void* document) {
  const std::lock_guard lock(mutex_);
  const auto entry =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.fits(arrays, gap); });
  if (entry == entries_.end()) return nullptr;
  entries_.splice(entries_.begin(), entries_, entry);
  if (document != nullptr) entry->documents.insert(document);
  return entries_.front().index;
}

void IndexCache::put(const VcgMeshArrays& arrays, const GapLimit& gap,
                     std::shared_ptr<const GeodesicIndex> index, const void* document) {
  const std::lock_guard lock(mutex_);
  Entry entry{arrays.faces, arrays.sides, arrays.splits, std::move(index), {}, gap};
  if (document != nullptr) entry.documents.insert(document);
  for (const Entry& e : entries_) {  // other documents that used the replaced index now use this one
    if (e.fits(arrays, gap)) entry.documents.insert(e.documents.begin(), e.documents.end());
  }
  entries_.remove_if([&](const Entry& e) { return e.fits(arrays, gap); });
  entries_.push_front(std::move(entry));
  while (entries_.size() > 1 && (entries_.size() > capacity || bytes() > max_bytes_)) entries_.pop_back();
}

RentOrBuy IndexCache::spent(const Fingerprint& mesh, Index vertices) {
  const std::lock_guard lock(mutex_);
  for (const auto& [of, spent] : spent_) {
    if (of == mesh) return spent;
  }
  return RentOrBuy(vertices);
}

void IndexCache::keep_spent(const Fingerprint& mesh, const RentOrBuy& spent) {
  const std::lock_guard lock(mutex_);
  spent_.remove_if([&](const auto& entry) { return entry.first == mesh; });
  spent_.emplace_front(mesh, spent);
  if (spent_.size() > max_spent) spent_.pop_back();
}

void IndexCache::forget(const void* document) {
  const std::lock_guard lock(mutex_);
  entries_.remove_if([&](Entry& e) { return e.documents.erase(document) > 0 && e.documents.empty(); });
}

std::int64_t IndexCache::bytes() const {
  std::int64_t sum = 0;
  for (const Entry& entry : entries_) sum += entry.index->statistics().bytes;
  return sum;
}

}  // namespace vorogeo::plugin
