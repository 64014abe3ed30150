// Faces divided into smaller ones, with distances from sites at the corners of these.
#pragma once

#include <memory>
#include <vector>

#include "support/progress.h"
#include "tasks/field_team.h"
#include "tasks/voronoi_borders.h"

namespace vorogeo {

/// A face and the sites that may own a part of it.
struct ContestedFace {
  Index face;
  std::vector<Index> sites;  ///< ascending
};

/// Where the metric jumps, paths into a dear face come from many of its sides, and distances inside do not
/// follow from those of its corners. So the contested faces are divided, and the distances of the corners of
/// their parts are asked for.
class DividedFaces {
 public:
  /// Parts of each side of a face.
  static constexpr Index per_side = 4;
  static constexpr Index parts_per_face = per_side * per_side;
  /// The part of a face in which its centre is.
  static constexpr Index central_part = 9;

  /// `radius`: no distance above it is asked for. \throw Cancelled.
  DividedFaces(FieldTeam& team, const PointList& sites, std::vector<ContestedFace> contested, double radius,
               const Progress& progress);

  /// The parts of all contested faces, in space; those of contested face i are faces i * parts_per_face on.
  const Mesh& parts() const { return *parts_; }
  const std::vector<ContestedFace>& contested() const { return contested_; }
  /// The sites known at all three corners of a part.
  std::vector<FaceSite> sites_of(Index part) const;

 private:
  std::vector<ContestedFace> contested_;
  std::shared_ptr<const Mesh> parts_;
  std::vector<std::vector<double>> distance_;  ///< by corner of parts, then by site of its `at_`
  std::vector<std::vector<Index>> at_;         ///< by corner of parts: its sites, ascending
};

}  // namespace vorogeo
