// How long an exact field of a mesh takes, without waiting for all of it.
#pragma once

#include <memory>

#include "support/progress.h"

namespace vorogeo {

struct LocalGeometry;

/// A run from one vertex that was stopped after some time.
struct FieldTiming {
  double seconds = 0.0;     ///< of the processor that it took
  double reached = 0.0;     ///< part of the component's vertices that it reached
  bool is_complete = true;  ///< nothing was left to do

  /// Seconds of the whole field: windows grow in number with the distance, so the part that was reached takes
  /// less than its share.
  double expected_seconds() const;
};

/// Runs in the largest component for at most about `max_seconds` of the processor. \throw Cancelled if the
/// progress asks for it.
FieldTiming time_exact_field(const std::shared_ptr<const LocalGeometry>& geometry, double max_seconds,
                             const Progress& progress, const char* activity);

}  // namespace vorogeo
