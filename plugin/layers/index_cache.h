// The indexes of the meshes that a user is working with, so that a second query does not build again.
#pragma once

#include <array>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <set>
#include <utility>
#include <vector>

#include "index/geodesic_index.h"
#include "mesh/gaps.h"
#include "mesh/vcg_adapter.h"
#include "query/rent_or_buy.h"

namespace vorogeo::plugin {

/// The few indexes used last, each with the mesh it was built for.
///
/// An index is found by comparing the whole mesh, all positions, faces and lengths, not a name or a hash of
/// it: after any edit there is no index until one is built again, and when the edit is undone the old one is
/// found again. An index belongs to the documents that used it and is freed with the last of them. May be
/// used by several threads.
class IndexCache {
 public:
  /// `max_bytes`: what the indexes may take together; the newest is kept, however large it is.
  explicit IndexCache(std::int64_t max_bytes = default_memory_budget << 20) : max_bytes_(max_bytes) {}

  /// The index of exactly this mesh with these gaps bridged, or nothing. From now on it belongs to this
  /// document, too (if one is named).
  std::shared_ptr<const GeodesicIndex> find(const VcgMeshArrays& arrays, const GapLimit& gap,
                                            const void* document = nullptr);
  /// Keeps an index, which replaces one of the same mesh, or else displaces those used longest ago. Without a
  /// document it stays until it is displaced.
  void put(const VcgMeshArrays& arrays, const GapLimit& gap, std::shared_ptr<const GeodesicIndex> index,
           const void* document = nullptr);
  /// What exact answers on a mesh have taken so far; nothing for one that is not known. Only the choice of
  /// what answers depends on it, so a fingerprint is enough.
  RentOrBuy spent(const Fingerprint& mesh, Index vertices);
  void keep_spent(const Fingerprint& mesh, const RentOrBuy& spent);
  /// Frees the indexes that belong to this document only.
  void forget(const void* document);

 private:
  struct Entry {
    /// All faces given, including those that a Mesh leaves out: an edit may turn one of them into a proper
    /// face.
    std::vector<std::array<Index, 3>> faces;
    SideLengths sides;
    FaceSplits splits;  ///< sides are those of whole faces, which may be equal in two metrics
    std::shared_ptr<const GeodesicIndex> index;
    std::set<const void*> documents;
    GapLimit gap;

    bool fits(const VcgMeshArrays& arrays, const GapLimit& asked) const;
  };
  static constexpr std::size_t capacity = 4;
  static constexpr std::size_t max_spent = 64;

  std::int64_t bytes() const;

  const std::int64_t max_bytes_;
  std::mutex mutex_;
  std::list<Entry> entries_;                            ///< most recently used first
  std::list<std::pair<Fingerprint, RentOrBuy>> spent_;  ///< likewise
};

}  // namespace vorogeo::plugin
