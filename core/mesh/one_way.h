// Metrics by which a way back costs something else: time in a wind, and over terrain uphill and downhill.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "mesh/metric.h"

namespace vorogeo {

/// A Randers metric for each face: a step v costs sqrt(v' G v) + w . v.
struct Randers {
  std::vector<Tensor> tensors;  ///< G
  std::vector<Point> drifts;    ///< w, of a norm below 1 in the lengths of G
};

/// The metric as Mesh takes it, with the points on edges that the tensors need. \throw InvalidInput as
/// sides_by_face_tensor, drifts_by_face and edge_points_for.
Metric metric_of(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                 const Randers& randers);

/// Zermelo's problem: the travel time with an own `speed` in a medium that moves with the velocity `wind`,
/// both given for each face; the part of a wind perpendicular to its face does not count. With W = wind /
/// speed and lam = 1 - W . W: G = (lam I + W W') / (lam speed)^2 and w = -W / (lam speed). Where wind or
/// speed is NaN, so is the drift. \throw InvalidInput for a speed that is not above 0, or not above that of
/// the wind; names the face.
Randers travel_time(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                    std::span<const Point> wind, std::span<const double> speed);

/// Maps grades (rise by length on the map, below 0 downhill) to the costs of a unit of length on the map
/// there. Costs are above 0, and infinite for grades at which none can go.
using CostOfGrade = std::function<std::vector<double>(std::span<const double>)>;
CostOfGrade for_each_grade(std::function<double(double)> cost);

/// Seconds per metre by Tobler's hiking function, 6 exp(-3.5 |grade + 0.05|) km/h, and by Naismith's rule, 5
/// km/h and an hour for each 600 m of ascent.
double tobler(double grade);
double naismith(double grade);
/// The length in space plus the given cost for each unit of height, uphill or downhill. \throw InvalidInput
/// for a number that is not finite or below 0.
CostOfGrade climbing_cost(double uphill, double downhill);

/// In each face, steps straight up, straight down and on the level cost what `pace` says, and the directions
/// between follow an ellipse through these. Where a gentler grade climbs or descends a unit of height for
/// less, the cost of a zigzag at that grade is taken. \throw InvalidInput for a cost that is not above 0, or
/// infinite on the level or at all grades up or down; an `up` of length 0.
Randers hiking_time(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                    const CostOfGrade& pace, const Point& up);

}  // namespace vorogeo
