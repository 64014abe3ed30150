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
  std::vector<Point> drifts;    ///< w, shorter than 1 in the lengths of G
};

/// As a mesh takes it, with the points on edges that the tensors need. \throw InvalidInput as
/// sides_by_face_tensor, drifts_by_face and edge_points_for.
Metric metric_of(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                 const Randers& randers);

/// Zermelo's problem: the time of what moves with `speed` in a medium that moves with the velocity `wind`,
/// one of both for each face; the part of a wind across its face does not count. With W = wind / speed and
/// lam = 1 - W . W: G = (lam I + W W') / (lam speed)^2 and w = -W / (lam speed). Where one of them is NaN, so
/// is the drift. \throw InvalidInput for a speed that is not above 0, or not above that of the wind, by face.
Randers travel_time(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                    std::span<const Point> wind, std::span<const double> speed);

/// What a unit of length on the map costs at each of some grades: rise by length on the map, below 0
/// downhill. Above 0; infinite for grades at which none can go.
using CostOfGrade = std::function<std::vector<double>(std::span<const double>)>;
CostOfGrade for_each_grade(std::function<double(double)> cost);

/// Seconds per metre by Tobler's hiking function, 6 exp(-3.5 |grade + 0.05|) km/h, and by Naismith's rule, 5
/// km/h and an hour for each 600 m of ascent.
double tobler(double grade);
double naismith(double grade);
/// Length in space, and so much more for each unit of height up and down. \throw InvalidInput for a number
/// that is not finite or below 0.
CostOfGrade climbing_cost(double uphill, double downhill);

/// In each face, straight up, straight down and on the level cost what `pace` says, and directions between
/// follow an ellipse around these. Where a gentler grade climbs or descends for less, a zigzag at that
/// counts. \throw InvalidInput for a cost that is not above 0, or infinite on the level or at all grades up
/// or down; an `up` of length 0.
Randers hiking_time(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                    const CostOfGrade& pace, const Point& up);

}  // namespace vorogeo
