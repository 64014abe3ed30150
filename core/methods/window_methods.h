// Exact and nearly exact methods that run our own solver: MMP, AMMP, GSP.
#pragma once

#include "exact/exact_solver.h"
#include "methods/method.h"

namespace vorogeo {

/// The exact solver as a method; with a tolerance (ExactLimits::merge_tolerance) the approximate one.
class WindowRuns final : public GeodesicMethod {
 public:
  WindowRuns(const std::shared_ptr<const Mesh>& mesh, double merge_tolerance)
      : solver_(mesh), merge_tolerance_(merge_tolerance) {}
  std::vector<double> field(std::span<const Index> sources, const Progress& progress) override;
  double pair(Index source, Index target) override;
  std::size_t bytes() const override { return solver_.memory_bytes(); }
  /// Made in the last field.
  std::size_t window_count() const { return solver_.window_count(); }

 private:
  ExactSolver solver_;
  double merge_tolerance_;
};

}  // namespace vorogeo
