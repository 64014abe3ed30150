// What a step costs in processor time and memory, relative to the same step on a scan without defects.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <string>

#include "index/index_options.h"
#include "support/hostile_meshes.h"

namespace vorogeo::test {

/// Processor time of this process in seconds.
double processor_seconds();
/// Whether allocated bytes are counted; not under sanitizers, which do their own bookkeeping.
bool counts_memory();
/// Bytes held now, and the most held since the last call of reset_peak_bytes().
std::size_t held_bytes();
std::size_t peak_bytes();
void reset_peak_bytes();

enum class Step : std::uint8_t { exact_field, build, field, pairs, paths, voronoi };
inline constexpr int step_count = 6;
inline constexpr std::array<const char*, step_count> step_names{
    "exact field", "build", "field", "pairs", "exact paths", "Voronoi regions"};

struct Cost {
  double seconds = 0.0;
  double bytes = 0.0;
};
using Costs = std::array<Cost, step_count>;

/// Runs a function and measures it.
Cost cost_of(const std::function<void()>& run);

/// Costs of all steps on a scan of about this size (a power of two), measured once per process.
class ScanCosts {
 public:
  /// `measure`: runs all steps on a mesh; the costs are then those per vertex.
  explicit ScanCosts(std::function<Costs(const HostileMesh&, const IndexOptions&)> measure)
      : measure_(std::move(measure)) {}
  const Costs& of(std::size_t vertices, const IndexOptions& options);

 private:
  std::function<Costs(const HostileMesh&, const IndexOptions&)> measure_;
  std::map<std::array<int, 4>, Costs> known_;
};

}  // namespace vorogeo::test
