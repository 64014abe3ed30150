// Pairs within a radius from bounded fields; nearest points by ranking the distances of all fields.
#include "tasks/neighbors.h"

#include <algorithm>
#include <atomic>
#include <string>
#include <utility>

#include "support/memory.h"
#include "support/parallel.h"

namespace vorogeo {

namespace {

struct Entry {
  Index column;
  double distance;
};

/// Only what can be reached, even with an infinite radius.
bool is_within(double distance, double radius) { return distance <= radius && distance < unreachable; }

/// Throws as soon as the entries found by all workers no longer fit.
class EntryCounter {
 public:
  explicit EntryCounter(std::int64_t max_bytes)
      : max_bytes_(max_bytes > 0 ? max_bytes : available_memory_bytes()) {}
  void add(std::size_t entries) {
    const auto all = static_cast<double>(entries_ += entries);
    require_memory(sparse_bytes(all), max_bytes_, "The matrix of the pairs within the radius",
                   "Give a smaller radius or fewer points.");
  }

 private:
  std::int64_t max_bytes_;
  std::atomic<std::size_t> entries_{0};
};

SparseDistances compressed(std::vector<std::vector<Entry>>& rows) {
  SparseDistances result;
  result.row_begin.reserve(rows.size() + 1);
  result.row_begin.push_back(0);
  for (const auto& row : rows) {
    result.row_begin.push_back(result.row_begin.back() + static_cast<std::int64_t>(row.size()));
  }
  result.column.reserve(static_cast<std::size_t>(result.row_begin.back()));
  result.distance.reserve(static_cast<std::size_t>(result.row_begin.back()));
  for (auto& row : rows) {
    for (const Entry& entry : row) {
      result.column.push_back(entry.column);
      result.distance.push_back(entry.distance);
    }
    row = {};
  }
  return result;
}

using Ranked = std::pair<double, Index>;  // distance, position in the set

/// Puts an entry into its place among the nearest `count` found so far.
void keep_nearest(std::vector<Ranked>& best, std::size_t count, Ranked entry) {
  if (entry.first == unreachable) return;
  if (best.size() == count && !(entry < best.back())) return;
  best.insert(std::upper_bound(best.begin(), best.end(), entry), entry);
  if (best.size() > count) best.pop_back();
}

}  // namespace

double sparse_bytes(double entries) { return entries * (sizeof(Entry) + sizeof(Index) + sizeof(double)); }

namespace {

/// For each row, the entries within the radius for which wanted(row, column). `entries_per_pair`: how many
/// entries of the result each of them makes.
template <class Wanted>
std::vector<std::vector<Entry>> entries_within(Surface& surface, const PointList& rows,
                                               const PointList& columns, double radius,
                                               std::size_t entries_per_pair, std::int64_t max_bytes,
                                               const TaskOptions& options, Wanted&& wanted) {
  require_radius(radius);
  Workers workers(surface, options, static_cast<double>(rows.size()), surface.reach_of(radius));
  std::vector<std::vector<Entry>> entries(rows.size());
  EntryCounter counter(max_bytes);
  parallel_for(rows.size(), workers.threads(), workers.progress(), "Pairs within the radius",
               [&](std::size_t i, int worker) {
                 const auto found = workers.distances(rows[i], columns, radius, worker);
                 for (std::size_t j = 0; j < columns.size(); ++j) {
                   if (!is_within(found[j], radius) || !wanted(i, j)) continue;
                   entries[i].push_back({static_cast<Index>(j), found[j]});
                 }
                 entries[i].shrink_to_fit();
                 counter.add(entries_per_pair * entries[i].size());
               });
  return entries;
}

}  // namespace

SparseDistances pairs_within(Surface& surface, const PointList& given, double radius, std::int64_t max_bytes,
                             const TaskOptions& options) {
  const PointList points = points_on(*surface.mesh(), given, "Point");
  if (surface.mesh()->is_one_way()) {
    auto rows = entries_within(surface, points, points, radius, 1, max_bytes, options,
                               [](std::size_t i, std::size_t j) { return i != j; });
    return compressed(rows);
  }
  // The pairs that are read from the field of the row.
  auto upper = entries_within(
      surface, points, points, radius, 2, max_bytes, options,
      [&](std::size_t i, std::size_t j) { return points[j] == points[i] ? i < j : points[i] < points[j]; });
  std::vector<std::vector<Entry>> rows(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const Entry& entry : upper[i]) {
      rows[i].push_back(entry);
      rows[entry.column].push_back({static_cast<Index>(i), entry.distance});
    }
    upper[i] = {};
  }
  for (auto& row : rows) std::ranges::sort(row, {}, &Entry::column);
  return compressed(rows);
}

SparseDistances pairs_within(Surface& surface, const PointList& row_points, const PointList& column_points,
                             double radius, std::int64_t max_bytes, const TaskOptions& options) {
  const PointList points = points_on(*surface.mesh(), row_points, "Point");
  const PointList others = points_on(*surface.mesh(), column_points, "Other");
  auto rows = entries_within(surface, points, others, radius, 1, max_bytes, options,
                             [](std::size_t, std::size_t) { return true; });
  return compressed(rows);
}

NearestOfSet nearest_of_set(Surface& surface, const PointList& set_points, const PointList& query_points,
                            std::size_t count, const TaskOptions& options) {
  const PointList set = points_on(*surface.mesh(), set_points, "Point");
  const PointList queries = points_on(*surface.mesh(), query_points, "Query");
  // A field for each point of the shorter list; from queries on the reversed surface, as paths lead to them.
  const bool by_query = queries.size() <= set.size();
  Workers workers(by_query ? surface.reversed() : surface, options,
                  static_cast<double>(std::min(set.size(), queries.size())));
  std::vector<std::vector<Ranked>> best(queries.size());
  const std::string activity = "Nearest points";
  if (count == 0 || set.empty()) {
    // Nothing to find: all entries stay empty.
  } else if (by_query) {
    parallel_for(queries.size(), workers.threads(), workers.progress(), activity,
                 [&](std::size_t q, int worker) {
                   const auto found = workers.distances(queries[q], set, unreachable, worker);
                   for (std::size_t i = 0; i < set.size(); ++i) {
                     keep_nearest(best[q], count, {found[i], static_cast<Index>(i)});
                   }
                 });
  } else {
    // Each worker ranks its share of the set; the merged ranking is the same for all shares.
    std::vector<std::vector<std::vector<Ranked>>> of_worker(workers.threads());
    parallel_for(set.size(), workers.threads(), workers.progress(), activity, [&](std::size_t i, int worker) {
      auto& mine = of_worker[worker];
      mine.resize(queries.size());
      const auto found = workers.distances(set[i], queries, unreachable, worker);
      for (std::size_t q = 0; q < queries.size(); ++q) {
        keep_nearest(mine[q], count, {found[q], static_cast<Index>(i)});
      }
    });
    for (auto& ranks : of_worker) {
      for (std::size_t q = 0; q < ranks.size(); ++q) {
        for (const Ranked& entry : ranks[q]) keep_nearest(best[q], count, entry);
      }
    }
  }
  NearestOfSet result;
  result.position.assign(queries.size() * count, no_index);
  result.distance.assign(queries.size() * count, unreachable);
  for (std::size_t q = 0; q < queries.size(); ++q) {
    for (std::size_t i = 0; i < best[q].size(); ++i) {
      result.distance[q * count + i] = best[q][i].first;
      result.position[q * count + i] = best[q][i].second;
    }
  }
  return result;
}

}  // namespace vorogeo
