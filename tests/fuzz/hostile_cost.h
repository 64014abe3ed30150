// What a step costs in processor time and memory, relative to the same step on a scan without defects.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>

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

/// How many times the cost of a scan each step may take on a hostile mesh, in time and in memory; more is a
/// finding.
inline constexpr double most_of_a_scan = 10.0;

/// Runs a function and measures it.
Cost cost_of(const std::function<void()>& run);

/// What a mesh took, and how many second-layer patches its index has.
struct Measured {
  Costs costs{};
  Index patches = 0;
};

/// Costs of all steps on a scan that has at least as many vertices as a mesh, and at most somewhat more than
/// twice as many; measured once per process.
class ScanCosts {
 public:
  /// `measure`: runs all steps on a mesh.
  explicit ScanCosts(std::function<Measured(const HostileMesh&, const IndexOptions&)> measure)
      : measure_(std::move(measure)) {}
  /// `patches`: how many second-layer patches the mesh got. A small scan is coarse, so up to a larger size
  /// than a flat mesh it is one patch, without tables: it is then built with two where the mesh has several.
  const Costs& of(std::size_t vertices, Index patches, const IndexOptions& options);

 private:
  const Measured& measured(std::size_t size, const IndexOptions& options);

  std::function<Measured(const HostileMesh&, const IndexOptions&)> measure_;
  std::map<std::array<int, 4>, Measured> known_;
};

}  // namespace vorogeo::test
