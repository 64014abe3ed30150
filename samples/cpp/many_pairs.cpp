// Many pairs from several threads: an index is built once, then a distance takes microseconds.
#include <vorogeo.h>

#include <algorithm>
#include <cstdio>
#include <thread>

#include "sheet.h"

int main() {
  const Sheet sheet(100);
  vorogeo::Surface surface(sheet.positions, sheet.faces);
  surface.build_index();  // with {.file = "sheet.vgi"} it is kept there, and read the next time

  constexpr int threads = 4, pairs = 2000;
  std::array<double, threads> error{};
  std::vector<std::thread> team;
  for (int t = 0; t < threads; ++t) {
    team.emplace_back([&, t] {
      vorogeo::Query query = surface.query();  // one for each thread: nothing is locked in the loop
      for (int i = t; i < pairs; i += threads) {
        const int from = i * 37 % surface.vertex_count(), to = (i * 7919 + 5000) % surface.vertex_count();
        const double flat = sheet.flat_distance(from, to);
        error[t] = std::max(error[t], std::abs(query.distance(from, to) - flat) / std::max(flat, 1e-2));
      }
    });
  }
  for (std::thread& thread : team) thread.join();
  const double worst = *std::max_element(error.begin(), error.end());
  std::printf("%d distances, none off by more than %.2e of its length\n", pairs, worst);
  return worst < 5e-3 ? 0 : 1;
}
