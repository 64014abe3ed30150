// Choice of the form of an index by the memory it may take.
#pragma once

#include <cstdint>

#include "index/index_data.h"

namespace vorogeo {

/// The memory an index may take, and the form that suits it. Entries in a file take none; then there is no
/// limit unless one is given.
class MemoryBudget {
 public:
  explicit MemoryBudget(const IndexOptions& options, bool tables_in_file = false)
      : options_(options), tables_in_file_(tables_in_file) {}

  /// The form for an index that is laid out but has no tables yet: the sizes of all tables follow from the
  /// layout. \throw InvalidInput if not even the tables that both forms need fit, or if those of the
  /// requested form do not.
  IndexForm form_of(const IndexData& data) const;
  /// \throw InvalidInput if a finished index of this many bytes is larger than the budget.
  void require(std::int64_t bytes) const;
  bool fits(std::int64_t bytes) const;

 private:
  [[noreturn]] void refuse(std::int64_t bytes, const char* comparison) const;

  std::int64_t mib() const;

  const IndexOptions& options_;
  bool tables_in_file_;
};

/// Memory that the tables of a laid out layer take, in bytes.
std::int64_t table_bytes(const PatchLayer& layer);
/// The same of its transit table; with the entries in a file, of the rest: its groups and their least
/// distances.
std::int64_t transit_bytes(const PatchLayer& first, bool entries_in_file);

}  // namespace vorogeo
