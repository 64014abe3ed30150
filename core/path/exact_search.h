// Exact propagation from one end of a path to the other, within whatever bounds are known.
#pragma once

#include <memory>
#include <span>

#include "exact/exact_landmarks.h"
#include "exact/exact_solver.h"
#include "index/local_tables.h"
#include "path/corridor_search.h"
#include "path/exact_pair.h"
#include "path/path_ends.h"

namespace vorogeo {

/// Paths over the work mesh of an index, or over the user's mesh where exact runs take that
/// (IndexData::unsplit), each by one or two runs of the exact solver. Holds scratch memory: one
/// object belongs to one thread.
class ExactSearch {
 public:
  explicit ExactSearch(const IndexData& data);

  /// Paths shorter than `max_distance`, over the faces of the work mesh that are allowed (not 0; empty: all).
  FoundPath within(const PathEnd& from, const PathEnd& to, double max_distance,
                   std::span<const std::uint8_t> face_allowed = {});
  /// Over all faces, with the bounds of the landmarks, if there are any.
  FoundPath between_landmarks(const PathEnd& from, const PathEnd& to, double max_distance);
  /// The same with the bounds that the index gives, which are not proven.
  FoundPath by_index(const PathEnd& from, const PathEnd& to, double max_distance);
  /// Ends in one patch or in patches that touch: first in these patches and their halo; if a path could have
  /// left them, everywhere. `estimate`: an upper bound of the distance, if the tables are right.
  FoundPath nearby(const PathEnd& from, const PathEnd& to, double estimate);
  /// Without any bound: the last resort if a bound was wrong.
  FoundPath everywhere(const PathEnd& from, const PathEnd& to);

  void use_landmarks(std::shared_ptr<const ExactLandmarks> landmarks) { landmarks_ = std::move(landmarks); }

 private:
  FoundPath run(const PathEnd& from, const PathEnd& to, const ExactLimits& limits);
  /// `mask`: faces allowed of the mesh that runs take; empty: all.
  FoundPath within_mask(const PathEnd& from, const PathEnd& to, double max_distance,
                        std::span<const std::uint8_t> mask);

  const IndexData& data_;
  const UnsplitSurface* unsplit_;
  CorridorSearch corridor_;
  Halo halo_;
  RemainingBounds bounds_;
  std::vector<std::uint8_t> user_mask_;
  std::vector<double> user_bound_;
  std::shared_ptr<const ExactLandmarks> landmarks_;
};

}  // namespace vorogeo
