// Points in the middle of others: means, medians and medoids of weighted points.
#include "tasks/means.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <tuple>
#include <utility>

#include "exact/straightest.h"
#include "support/parallel.h"
#include "tasks/directions.h"
#include "tasks/path_through.h"

namespace vorogeo {

namespace {

/// Steps shorter than the first end a descent; below the second, the change of the sum is lost in rounding.
/// Both are fractions of the distance of the farthest point.
constexpr double least_move = 1e-9, least_measured_move = 1e-6;
/// Sums whose relative difference is less are equal.
constexpr double tie = 1e-9;
constexpr std::size_t most_starts = 4;
constexpr int most_steps = 200;
/// Each step of a descent takes this part of the remaining progress, as their number is unknown.
constexpr double part_of_step = 0.2;

/// A shortest path to one of the points, as it begins.
struct Pull {
  double angle;   ///< around the place
  double force;   ///< the sum falls by this per length along the path
  double along;   ///< its second derivative along the path
  double across;  ///< and across
};

/// Where a descent stands, and what it sees from there.
struct Place {
  TangentFrame frame;
  std::vector<Pull> pulls{};
  std::vector<Turn> turns{};  ///< nearest first
  double energy = 0.0;
  double kink = 0.0;      ///< growth of the sum per length in every direction, by points at this place
  double farthest = 0.0;  ///< distance of the points

  double between(double angle, double other) const {
    const double turned = std::abs(angle - other);
    return std::min({turned, std::abs(frame.full_turn() - turned), std::numbers::pi});
  }
  /// First and second derivative of the sum in a direction. A path straight back grows by the whole step.
  double slope(double angle) const {
    double slope = kink;
    for (const Pull& pull : pulls) slope -= pull.force * std::cos(between(angle, pull.angle));
    return slope;
  }
  double bend(double angle) const {
    double bend = 0.0;
    for (const Pull& pull : pulls) {
      const double cosine = std::cos(between(angle, pull.angle));
      bend += pull.along * cosine * cosine + pull.across * (1.0 - cosine * cosine);
    }
    return bend;
  }
};

struct Move {
  double angle = 0.0;
  double length = 0.0;
};

class Descent {
 public:
  Descent(Surface& surface, const PointList& points, std::span<const double> weights, Power power,
          int threads, const Progress& progress)
      : surface_(surface),
        geometry_(agreeing_geometry(surface, points[0])),
        points_(points),
        weights_(weights),
        power_(power),
        threads_(threads),
        progress_(progress) {}

  Centre run(const SurfacePoint& start, double reach) {
    Place here = look(start, reach);
    if (here.energy == unreachable) here = look(start, unreachable);  // an index's reach is too short
    double left = unreachable;
    for (int step = 0; step < most_steps; ++step) {
      const Move move = best_move(here);
      left = move.length;
      if (!(left > least_move * here.farthest) || !go(here, move)) break;
    }
    Centre centre{here.frame.point(), here.energy, {}};
    if (left > least_measured_move * here.farthest) {
      centre.remark = "The descent to the centre did not settle: its last step would have been " +
                      std::to_string(left) + " long.";
    }
    return centre;
  }

 private:
  /// The descent may come to a point without directions, although its start has them.
  void require_frame(const SurfacePoint& point) const {
    try {
      TangentFrame(geometry_, point);
    } catch (const InvalidInput& error) {
      const std::string why = error.what();
      throw InvalidInput("The descent to the middle of the points cannot go on. " +
                         why.substr(0, why.rfind("; ")) + "; give other points, or take their medoid.");
    }
  }

  Place look(const SurfacePoint& point, double reach) {
    Place place{TangentFrame(geometry_, point)};
    const LogMap map = surface_.lend([&](Query& query) {
      const Progress step = progress_.part(0.0, part_of_step);
      LogMap found = query.log_map(place.frame, points_, reach, Answer::exact, threads_, step);
      progress_ = progress_.part(part_of_step, 1.0);
      place.turns = query.first_turns(points_);
      return found;
    });
    place.farthest = *std::ranges::max_element(map.distance);
    for (std::size_t i = 0; i < points_.size(); ++i) add(place, map, i);
    std::ranges::sort(place.turns, {}, &Turn::distance);
    return place;
  }

  void add(Place& place, const LogMap& map, std::size_t i) const {
    const double weight = weights_[i], distance = map.distance[i];
    const double straight = std::min(distance, place.turns[i].distance);
    place.energy += weight * powered(distance, power_);
    const bool is_here = distance <= std::numeric_limits<double>::epsilon() * place.farthest;
    if (power_ == Power::two) {
      const double angle = is_here ? 0.0 : place.frame.angle_of(map.vector[i]);
      const double across = is_here ? 1.0 : distance / straight;
      place.pulls.push_back({angle, 2.0 * weight * distance, 2.0 * weight, 2.0 * weight * across});
    } else if (is_here) {
      place.kink += weight;
    } else {
      place.pulls.push_back({place.frame.angle_of(map.vector[i]), weight, 0.0, weight / straight});
    }
  }

  /// Where the sum should be least, by its derivatives; of length 0 if it is least here.
  static Move best_move(const Place& here) {
    Move move = here.frame.point().is_vertex() ? steepest(here) : newton(here);
    move.length = std::min(move.length, here.farthest);
    return move;
  }

  /// Along a line on which the sum falls, to where its derivatives say it is least.
  static Move along(const Place& here, double angle) {
    const double slope = here.slope(angle), bend = here.bend(angle);
    if (!(slope < 0.0)) return {angle, 0.0};
    return {angle, bend > 0.0 ? -slope / bend : here.farthest};
  }

  /// In a face or on an edge, whose other face is unfolded: there, the surface is a plane.
  static Move newton(const Place& here) {
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
    for (const Pull& pull : here.pulls) {
      const double cosine = std::cos(pull.angle), sine = std::sin(pull.angle);
      x += pull.force * cosine;
      y += pull.force * sine;
      xx += pull.along * cosine * cosine + pull.across * sine * sine;
      xy += (pull.along - pull.across) * cosine * sine;
      yy += pull.along * sine * sine + pull.across * cosine * cosine;
    }
    Move move = along(here, std::atan2(y, x));
    const double determinant = xx * yy - xy * xy;
    // Where all points lie on one line, a median has no second derivative along it.
    if (here.kink == 0.0 && determinant > 1e-12 * (xx + yy) * (xx + yy)) {
      const double to_x = (yy * x - xy * y) / determinant, to_y = (xx * y - xy * x) / determinant;
      move = {std::atan2(to_y, to_x), std::hypot(to_x, to_y)};
    }
    if (!here.frame.is_on_border()) return move;
    const SurfacePoint& point = here.frame.point();
    Index h = 3 * point.face;
    while (point.barycentric[(h + 2) % 3] > 0.0) ++h;
    // The face lies to the left of its half-edges.
    const double edge = here.frame.angle_to(point.face, here.frame.geometry().mesh->head(h));
    if (std::sin(move.angle - edge) >= 0.0) return move;
    const double back = edge + std::copysign(std::numbers::pi, std::numbers::pi - edge);
    return along(here, here.slope(edge) < here.slope(back) ? edge : back);
  }

  /// At a vertex, in the direction in which the sum falls fastest: between the angles at which paths begin or
  /// cease to lead straight back, the slope is a sine.
  static Move steepest(const Place& here) {
    struct Part {
      double begin, cosine, sine, constant;
    };
    const double full = here.frame.full_turn(), half = std::min(std::numbers::pi, 0.5 * full);
    const double end = here.frame.is_on_border() ? 0.5 * full : full;
    std::vector<Part> parts{{0.0, 0.0, 0.0, here.kink}, {end, 0.0, 0.0, 0.0}};
    for (const Pull& pull : here.pulls) {
      parts[0].constant += pull.force;
      for (const double angle : {pull.angle - full, pull.angle, pull.angle + full}) {
        const double from = std::max(0.0, angle - half), to = std::min(end, angle + half);
        if (!(from < to)) continue;
        const double cosine = pull.force * std::cos(angle), sine = pull.force * std::sin(angle);
        parts.push_back({from, -cosine, -sine, -pull.force});
        parts.push_back({to, cosine, sine, pull.force});
      }
    }
    std::ranges::sort(parts, {}, &Part::begin);
    Part sum{0.0, 0.0, 0.0, 0.0};
    double best = 0.0, least = unreachable;
    const auto take = [&](double angle) {
      const double slope = sum.constant + sum.cosine * std::cos(angle) + sum.sine * std::sin(angle);
      if (slope < least) std::tie(least, best) = std::pair(slope, angle);
    };
    for (const Part& part : parts) {
      if (part.begin > sum.begin) {
        take(sum.begin);
        take(part.begin);
        const double bottom = std::atan2(-sum.sine, -sum.cosine);
        const double lifted =
            bottom + 2.0 * std::numbers::pi * std::ceil((sum.begin - bottom) / (2.0 * std::numbers::pi));
        if (lifted < part.begin) take(lifted);
      }
      sum = {part.begin, sum.cosine + part.cosine, sum.sine + part.sine, sum.constant + part.constant};
    }
    return along(here, best);
  }

  /// Moves along a line, or half or a quarter of it, or to a vertex where paths turn: there, the sum has a
  /// kink, which lines approach only step by step. \return false if no move lowers the sum.
  bool go(Place& here, const Move& move) {
    for (double length = move.length; length > least_move * here.farthest; length *= 0.5) {
      const TracedEnd end = trace(here.frame, here.frame.vector(move.angle, length), AtBorder::end);
      if (improve(here, end.point, length)) return true;
      const auto turn = std::ranges::find_if(here.turns, [&](const Turn& one) {
        return one.distance <= length && std::ranges::find(tried_, one.vertex) == tried_.end();
      });
      if (turn == here.turns.end()) continue;
      const Turn tried = *turn;
      tried_.push_back(tried.vertex);
      if (!TangentFrame::exists_at(*geometry_.mesh, tried.vertex)) continue;
      if (improve(here, SurfacePoint::at_vertex(tried.vertex), tried.distance)) return true;
    }
    return false;
  }

  bool improve(Place& here, const SurfacePoint& point, double length) {
    const SurfacePoint end = canonical(*geometry_.mesh, point);
    require_frame(end);
    Place there = look(end, 1.001 * (here.farthest + length));
    const bool is_rounding = length <= least_measured_move * here.farthest;
    if (!(there.energy < here.energy * (is_rounding ? 1.0 + 1e-13 : 1.0))) return false;
    here = std::move(there);
    return true;
  }

  Surface& surface_;
  const ExactGeometry& geometry_;
  const PointList& points_;
  const std::span<const double> weights_;
  const Power power_;
  const int threads_;
  Progress progress_;
  std::vector<Index> tried_;  ///< vertices not to be tried again: the sum there is no lower than here
};

/// The given points on the mesh. \throw InvalidInput as centre_of().
PointList joined_points(const Mesh& mesh, const PointList& given, std::span<const double> weights) {
  if (given.empty()) throw InvalidInput("There is no point; give at least one.");
  const PointList points = points_on(mesh, given, "Point");
  const auto component = [&](std::size_t i) { return component_of(mesh, points[i]); };
  std::size_t first = 0;
  while (!(weights[first] > 0.0)) ++first;
  for (std::size_t i = first + 1; i < points.size(); ++i) {
    if (weights[i] > 0.0 && component(i) != component(first))
      refuse_leg(mesh, first, points[first], i, points[i]);
  }
  return points;
}

}  // namespace

std::vector<double> checked_weights(std::span<const double> weights, std::size_t count) {
  if (weights.empty()) return std::vector<double>(count, 1.0);
  if (weights.size() != count) {
    throw InvalidInput("There are " + std::to_string(count) + " points and " +
                       std::to_string(weights.size()) + " weights; give one for each.");
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    sum += weights[i];
    if (weights[i] >= 0.0 && std::isfinite(sum)) continue;
    throw InvalidInput("Weight " + std::to_string(i) + " is " + std::to_string(weights[i]) +
                       "; give finite numbers of at least 0.");
  }
  if (!(sum > 0.0)) throw InvalidInput("All weights are 0; give at least one above 0.");
  return {weights.begin(), weights.end()};
}

std::vector<double> least_energies(Workers& workers, const PointList& points, std::span<const double> weights,
                                   Power power, std::span<const double> row, const Progress& progress) {
  const std::size_t count = points.size();
  // By the triangle inequality, no point is farther from another than by way of a third one.
  std::vector<double> limit(count, unreachable);
  const auto narrow = [&](std::span<const double> distance) {
    double farthest = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      if (weights[i] > 0.0) farthest = std::max(farthest, distance[i]);
    }
    for (std::size_t i = 0; i < count; ++i) {
      limit[i] = std::min(limit[i], bounded_field_slack * (distance[i] + farthest));
    }
  };
  if (!row.empty()) narrow(row);
  // By the triangle inequality, this root differs between two points by at most the scale times their
  // distance.
  const auto root = [&](double sum) { return power == Power::two ? std::sqrt(sum) : sum; };
  const double scale = root(std::accumulate(weights.begin(), weights.end(), 0.0));
  const double unsure = workers.is_exact() ? tie : bounded_field_slack - 1.0;
  std::vector<double> energy(count, unreachable), bound(count, 0.0);
  std::vector<std::size_t> open(count);
  std::iota(open.begin(), open.end(), std::size_t{0});
  std::vector<std::vector<double>> rows(static_cast<std::size_t>(workers.threads()));
  for (double least = unreachable; !open.empty();) {
    const std::size_t batch = std::min(rows.size(), open.size());
    std::ranges::partial_sort(open, open.begin() + static_cast<std::ptrdiff_t>(batch), {},
                              [&](std::size_t i) { return std::pair(bound[i], i); });
    parallel_for(batch, workers.threads(), {}, "", [&](std::size_t k, int worker) {
      const SurfacePoint& from = points[open[k]];
      rows[k] = workers.few_distances(from, points, limit[open[k]], worker);
      for (std::size_t j = 0; j < count; ++j) {
        if (!(weights[j] > 0.0) || rows[k][j] < unreachable || limit[open[k]] == unreachable) continue;
        rows[k] = workers.few_distances(from, points, unreachable, worker);  // an index's limit is too short
        break;
      }
    });
    for (std::size_t k = 0; k < batch; ++k) {
      narrow(rows[k]);
      double sum = 0.0;
      for (std::size_t j = 0; j < count; ++j) {
        if (weights[j] > 0.0) sum += weights[j] * powered(rows[k][j], power);
      }
      energy[open[k]] = sum;
      least = std::min(least, sum);
      for (std::size_t j = 0; j < count; ++j) {
        const double apart = scale * rows[k][j];
        bound[j] = std::max(bound[j], std::abs(root(sum) - apart) - unsure * apart);
      }
    }
    open.erase(open.begin(), open.begin() + static_cast<std::ptrdiff_t>(batch));
    std::erase_if(open, [&](std::size_t i) { return bound[i] > root(least) * (1.0 + tie); });
    progress.report(1.0 - static_cast<double>(open.size()) / static_cast<double>(count),
                    "The best of some points");
  }
  return energy;
}

namespace {

/// The typical number of fields that least_energies() takes.
double expected_rows(std::size_t points) {
  const auto count = static_cast<double>(points);
  return std::min(count, 4.0 * std::sqrt(count));
}

}  // namespace

Index medoid(Surface& surface, const PointList& given, std::span<const double> given_weights,
             const TaskOptions& options) {
  const auto weights = checked_weights(given_weights, given.size());
  const PointList points = joined_points(*surface.mesh(), given, weights);
  require_both_ways_alike(*surface.mesh(), "Medoids");
  Workers workers(surface, options, expected_rows(points.size()));
  const auto energy = least_energies(workers, points, weights, Power::one, {}, workers.progress());
  return static_cast<Index>(std::ranges::min_element(energy) - energy.begin());
}

Centre descend(Surface& surface, const SurfacePoint& start, const PointList& points,
               std::span<const double> weights, Power power, double reach, int threads,
               const Progress& progress) {
  return Descent(surface, points, weights, power, threads, progress).run(start, reach);
}

Centre centre_of(Surface& surface, const PointList& given, std::span<const double> given_weights, Power power,
                 const TaskOptions& options) {
  require_exact(options, "Directions are");
  require_both_ways_alike(*surface.mesh(), "Means and medians");
  const auto weights = checked_weights(given_weights, given.size());
  const PointList points = joined_points(*surface.mesh(), given, weights);
  std::vector<SurfacePoint> starts, pulling;
  std::vector<double> pulls;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(weights[i] > 0.0)) continue;
    pulling.push_back(points[i]);
    pulls.push_back(weights[i]);
  }
  agreeing_geometry(surface, pulling[0]);
  const Stopwatch watch;
  {
    Workers workers(surface, {Answer::automatic, options.progress.part(0.0, 0.3)},
                    expected_rows(points.size()));
    const auto energy = least_energies(workers, points, weights, power, {}, workers.progress());
    const double least = *std::ranges::min_element(energy);
    for (std::size_t i = 0; i < points.size() && starts.size() < most_starts; ++i) {
      const bool is_new = std::ranges::find(starts, points[i]) == starts.end();
      if (is_new && energy[i] <= least * (1.0 + tie)) starts.push_back(points[i]);
    }
  }
  const double total = std::accumulate(pulls.begin(), pulls.end(), 0.0);
  Centre best;
  bool is_tied = false;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const auto share = [&](std::size_t k) {
      return 0.3 + 0.7 * static_cast<double>(k) / static_cast<double>(starts.size());
    };
    Centre found = descend(surface, starts[i], pulling, pulls, power, unreachable, surface.threads(),
                           options.progress.part(share(i), share(i + 1)));
    if (i > 0) {
      Answered ignored;
      const double apart = surface.distance(found.point, best.point, Answer::exact, ignored);
      const bool is_equal = std::abs(found.energy - best.energy) <= tie * best.energy;
      const double mean = best.energy / total;
      const double near = least_measured_move * (power == Power::two ? std::sqrt(mean) : mean);
      is_tied = is_tied || (is_equal && apart > near);
      if (is_equal || found.energy >= best.energy) continue;
      is_tied = false;
    }
    best = std::move(found);
  }
  options.progress.report(1.0, "The middle of some points");
  if (is_tied) {
    best.remark += (best.remark.empty() ? "" : " ");
    best.remark += "Other points of the surface are as good: the centre is one of several.";
  }
  report_exact(options, watch);
  if (options.answered != nullptr) options.answered->remark = best.remark;
  return best;
}

}  // namespace vorogeo
