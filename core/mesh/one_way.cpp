// Metrics by which a way back costs something else: time in a wind, and over terrain uphill and downhill.
#include "mesh/one_way.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>

#include "mesh/vectors.h"
#include "support/error.h"
#include "support/progress.h"

namespace vorogeo {

namespace {

/// identity * I + along * d d'.
Tensor tensor_of(double identity, double along, const Point& d) {
  Tensor tensor{};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) tensor[3 * i + k] = (i == k ? identity : 0.0) + along * d[i] * d[k];
  }
  return tensor;
}

}  // namespace

Metric metric_of(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                 const Randers& randers) {
  Metric metric = sides_by_face_tensor(positions, faces, randers.tensors);
  metric.points_per_edge = edge_points_for(positions, faces, metric.sides);
  metric.drifts = drifts_by_face(positions, faces, metric.sides, randers.drifts);
  return metric;
}

Randers travel_time(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                    std::span<const Point> wind, std::span<const double> speed) {
  Randers randers;
  for (const std::size_t f : checked(faces.size())) {
    const Point along = along_face(positions, faces[f], wind[f]);
    const Point relative{along[0] / speed[f], along[1] / speed[f], along[2] / speed[f]};
    const double lam = 1.0 - dot(relative, relative);
    if (speed[f] <= 0.0 || lam <= 0.0) {
      std::ostringstream text;
      text << "The wind of face " << f << " has the speed " << length_of(along)
           << ", and the own speed there is " << speed[f]
           << ", so there is no way against it; give own speeds above 0 that are greater than the wind's.";
      throw InvalidInput(text.str());
    }
    const double scale = lam * speed[f];
    const bool is_known = !std::isnan(scale);
    randers.drifts.push_back({-relative[0] / scale, -relative[1] / scale, -relative[2] / scale});
    randers.tensors.push_back(is_known ? tensor_of(lam / (scale * scale), 1.0 / (scale * scale), relative)
                                       : tensor_of(1.0, 0.0, {}));
  }
  return randers;
}

// ---- Costs by grade

CostOfGrade for_each_grade(std::function<double(double)> cost) {
  return [cost = std::move(cost)](std::span<const double> grades) {
    std::vector<double> costs(grades.size());
    std::ranges::transform(grades, costs.begin(), cost);
    return costs;
  };
}

double tobler(double grade) { return 0.6 * std::exp(3.5 * std::abs(grade + 0.05)); }

double naismith(double grade) { return 0.72 + 6.0 * std::max(grade, 0.0); }

CostOfGrade climbing_cost(double uphill, double downhill) {
  for (const auto& [name, cost] : {std::pair("uphill", uphill), std::pair("downhill", downhill)}) {
    if (cost >= 0.0 && std::isfinite(cost)) continue;
    throw InvalidInput(
        std::string("The ") + name + " cost is " + std::to_string(cost) +
        "; give a finite number of at least 0: what a unit of height costs besides the length.");
  }
  return for_each_grade([=](double grade) {
    return std::hypot(1.0, grade) + (grade > 0.0 ? uphill * grade : -downhill * grade);
  });
}

namespace {

std::vector<double> checked_costs(const CostOfGrade& pace, std::span<const double> grades) {
  std::vector<double> costs = pace(grades);
  for (std::size_t i = 0; i < costs.size(); ++i) {
    if (costs[i] > 0.0) continue;
    std::ostringstream text;
    text << "The pace is " << costs[i] << " at a grade of " << grades[i]
         << "; give a cost above 0 for each grade, infinite where none can go.";
    throw InvalidInput(text.str());
  }
  return costs;
}

/// A face's steepest line: rise by length in space and on the map.
struct Slope {
  double sine;
  double grade;
};

/// The cost of a unit of length straight up (way 1) or down (-1) each slope, or by cheaper zigzags.
std::vector<double> costs_of_climbs(const CostOfGrade& pace, std::span<const Slope> slopes, double way) {
  constexpr std::size_t count = 60001;
  constexpr double least_grade = 1e-3, greatest_grade = 1e3;
  std::vector<double> gentler(count), grades;
  for (std::size_t i = 0; i < count; ++i) {
    gentler[i] =
        way * least_grade * std::pow(greatest_grade / least_grade, static_cast<double>(i) / (count - 1));
  }
  // The least cost of a unit of height at each grade of the list or a gentler one.
  std::vector<double> least = checked_costs(pace, gentler);
  for (std::size_t i = 0; i < count; ++i) {
    gentler[i] *= way;
    least[i] = std::min(least[i] / gentler[i], i > 0 ? least[i - 1] : unreachable);
  }
  for (const Slope& slope : slopes) grades.push_back(way * slope.grade);
  std::vector<double> costs = checked_costs(pace, grades);
  for (std::size_t f = 0; f < slopes.size(); ++f) {
    const auto& [sine, grade] = slopes[f];
    costs[f] /= std::hypot(1.0, grade);
    const auto found = std::ranges::upper_bound(gentler, grade) - gentler.begin();
    if (found > 0) costs[f] = std::min(costs[f], least[found - 1] * sine);
  }
  return costs;
}

}  // namespace

Randers hiking_time(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                    const CostOfGrade& pace, const Point& up) {
  constexpr double least_cosine = 1e-6;  // of a wall
  const Point upwards = upwards_of(up);
  std::vector<Point> uphill;
  std::vector<Slope> slopes;
  for (const auto& face : faces) {
    const Point rise = along_face(positions, face, upwards);
    const double sine = length_of(rise);
    const double cosine = length_of(minus(upwards, rise));
    slopes.push_back({sine, sine / std::max(cosine, least_cosine)});
    uphill.push_back(sine > 0.0 ? Point{rise[0] / sine, rise[1] / sine, rise[2] / sine} : Point{});
  }
  const double level = checked_costs(pace, std::array{0.0})[0];
  const std::vector<double> ascent = costs_of_climbs(pace, slopes, 1.0);
  const std::vector<double> descent = costs_of_climbs(pace, slopes, -1.0);
  Randers randers;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const double mean = 0.5 * (ascent[f] + descent[f]), half = 0.5 * (ascent[f] - descent[f]);
    if (!std::isfinite(mean + level)) {
      throw InvalidInput(
          "The pace is infinite on the level, or at all grades up or down; give finite costs for grades near "
          "0.");
    }
    randers.tensors.push_back(tensor_of(level * level, mean * mean - level * level, uphill[f]));
    randers.drifts.push_back({half * uphill[f][0], half * uphill[f][1], half * uphill[f][2]});
  }
  return randers;
}

}  // namespace vorogeo
