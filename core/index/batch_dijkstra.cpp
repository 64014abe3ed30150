// A full search from the leader, and the followers in lanes.
#include "index/batch_dijkstra.h"

#include <algorithm>
#include <vector>

#include "support/checkpoint.h"

namespace vorogeo {

void BatchDijkstra::search_from_each(std::span<const Index> sources,
                                     std::span<const std::uint8_t> patch_allowed,
                                     const std::function<void(std::size_t i)>& done) {
  // Twice the radius would be enough if unfolding kept the triangle inequality to the last bit.
  constexpr double slack_per_radius = 2.1;
  // Near the source, the order of nodes may differ from that by distance from the leader.
  constexpr double near_per_radius = 3.0;
  lane_ = no_index;
  const std::size_t leader = sources.size() / 2;
  search_all(sources[leader], patch_allowed);
  done(leader);
  std::vector<std::size_t> reached, others;
  double radius = 0.0;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    if (i == leader) continue;
    const double distance = search_.distance(sources[i]);
    (distance < unreachable ? reached : others).push_back(i);
    if (distance < unreachable) radius = std::max(radius, distance);
  }
  if (!reached.empty()) sweep_.prepare(search_, patch_allowed, slack_per_radius * radius);
  for (std::size_t begin = 0; begin < reached.size(); begin += FollowerSweep::lanes) {
    const std::size_t count = std::min<std::size_t>(FollowerSweep::lanes, reached.size() - begin);
    follow(sources, {reached.data() + begin, count}, patch_allowed, near_per_radius * radius, done);
  }
  for (std::size_t i : others) {
    checkpoint();
    search_all(sources[i], patch_allowed);
    done(i);
  }
}

void BatchDijkstra::follow(std::span<const Index> sources, std::span<const std::size_t> followers,
                           std::span<const std::uint8_t> patch_allowed, double near,
                           const std::function<void(std::size_t i)>& done) {
  sweep_.clear();
  for (std::size_t lane = 0; lane < followers.size(); ++lane) {
    search_.reset();
    search_.add(sources[followers[lane]], 0.0);
    search_.run(patch_allowed, near);
    sweep_.add(static_cast<Index>(lane), search_, near);
  }
  const std::uint32_t unsettled = sweep_.run();
  for (std::size_t lane = 0; lane < followers.size(); ++lane) {
    const std::size_t i = followers[lane];
    if ((unsettled >> lane & 1u) == 0) {
      lane_ = static_cast<Index>(lane);
      done(i);
      lane_ = no_index;
    } else {
      search_all(sources[i], patch_allowed);
      done(i);
    }
  }
}

void BatchDijkstra::search_all(Index source, std::span<const std::uint8_t> patch_allowed) {
  search_.reset();
  search_.add(source, 0.0);
  search_.run(patch_allowed);
}

}  // namespace vorogeo
