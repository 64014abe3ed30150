// Counts of a run over hostile meshes, in memory that the processes of the run share.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "fuzz/hostile_cost.h"
#include "support/hostile_meshes.h"

namespace vorogeo::test {

/// Answers whose errors are collected.
enum class ErrorKind : std::uint8_t {
  field,
  pair,
  refined_path,
  uncertified_path,
  voronoi,
  quick,
  face_cost,
  reference
};
inline constexpr int error_kind_count = 8;
inline constexpr std::array<const char*, error_kind_count> error_kind_names{"field",
                                                                            "pair",
                                                                            "refined path",
                                                                            "uncertified path",
                                                                            "Voronoi distance",
                                                                            "quick field",
                                                                            "beyond the bounds of face costs",
                                                                            "tightened reference"};

/// Absolute values of relative errors, in bins of their logarithm, so that millions take no memory.
struct ErrorHistogram {
  static constexpr int bins_per_decade = 10;
  static constexpr int lowest_decade = -12;
  static constexpr int bins = 16 * bins_per_decade;
  std::array<std::uint64_t, bins> counts{};
  std::uint64_t count = 0;
  double sum = 0.0;
  double largest = 0.0;
  unsigned largest_seed = 0;

  void add(double error, unsigned seed) {
    const double size = std::abs(error);
    const double bin = (std::log10(std::max(size, 1e-30)) - lowest_decade) * bins_per_decade;
    ++counts[static_cast<int>(std::clamp(bin, 0.0, bins - 1.0))];
    ++count;
    sum += size;
    if (size <= largest) return;
    largest = size;
    largest_seed = seed;
  }
  double mean() const { return count == 0 ? 0.0 : sum / static_cast<double>(count); }
  /// Upper end of the bin in which this fraction of all errors is reached.
  double quantile(double share) const {
    std::uint64_t passed = 0;
    for (int i = 0; i < bins; ++i) {
      passed += counts[i];
      if (static_cast<double>(passed) >= share * static_cast<double>(count)) {
        return std::min(largest, std::pow(10.0, lowest_decade + (i + 1.0) / bins_per_decade));
      }
    }
    return largest;
  }
  void add(const ErrorHistogram& other) {
    for (int i = 0; i < bins; ++i) counts[i] += other.counts[i];
    count += other.count;
    sum += other.sum;
    if (other.largest > largest) {
      largest = other.largest;
      largest_seed = other.largest_seed;
    }
  }
};

/// How many times the cost on a scan a step took, in time or in memory.
struct CostRatios {
  unsigned meshes = 0;
  double largest = 0.0;
  unsigned largest_seed = 0;

  void add(double ratio, unsigned seed) {
    ++meshes;
    if (ratio <= largest) return;
    largest = ratio;
    largest_seed = seed;
  }
  void add(const CostRatios& other) {
    meshes += other.meshes;
    if (other.largest <= largest) return;
    largest = other.largest;
    largest_seed = other.largest_seed;
  }
};

/// What became of the meshes of a kind.
struct KindTally {
  unsigned meshes = 0;
  unsigned with_findings = 0;
  CostRatios dearest;  ///< step of a mesh, as a part of what it may cost

  void add(const KindTally& other) {
    meshes += other.meshes;
    with_findings += other.with_findings;
    dearest.add(other.dearest);
  }
};

/// The counts of one process of a run. It writes them; its parent reads them when it has ended or hangs.
struct HostileTally {
  std::atomic<unsigned> seed = 0;  ///< the mesh at work
  char size_argument[32]{};        ///< what is needed besides --seed to make the same mesh
  char question[160]{};            ///< the last question
  char sentence[512]{};            ///< the description of the mesh
  bool finished = false;           ///< all seeds done
  /// Processor time of the process when the mesh began, plus that of scans since; infinite during these.
  std::atomic<double> mesh_seconds = 0;
  std::atomic<int> vertices = 0;  ///< of the mesh; those asked for until it is there
  unsigned meshes = 0;
  unsigned refused = 0;  ///< meshes refused in a sentence, with reason
  unsigned findings = 0;
  unsigned meshes_with_findings = 0;
  std::array<ErrorHistogram, error_kind_count> errors{};
  std::array<CostRatios, step_count> times{};
  std::array<CostRatios, step_count> memories{};
  std::array<KindTally, hostile_kinds.size()> kinds{};
};

}  // namespace vorogeo::test
