// Findings, and checks of distances that need no reference.
#include "fuzz/hostile_case.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <sstream>

#include "mesh/mesh_check.h"
#include "support/error.h"
#include "support/hostile_parts.h"

namespace vorogeo::test {

namespace {

template <std::size_t Size>
void copy_text(char (&to)[Size], const std::string& text) {
  std::strncpy(to, text.c_str(), Size - 1);
  to[Size - 1] = 0;
}

}  // namespace

std::string exactly(double value) {
  std::ostringstream text;
  text.precision(15);
  text << value;
  return text.str();
}

HostileCase::HostileCase(unsigned case_seed, HostileMesh mesh_of_seed, HostileTally& shared_tally)
    : seed(case_seed),
      hostile(std::move(mesh_of_seed)),
      random(case_seed + (1ULL << 40)),
      tally(shared_tally) {
  if (seed != scan_seed) copy_text(tally.sentence, hostile.sentence());
  typical = typical_edge(hostile.soup);
  for (const Point& p : hostile.soup.positions) {
    for (const double x : p) farthest = std::max(farthest, std::abs(x));
  }
  find_components();
  options.threads = 1;
  options.delta = random.one_in(4) ? 0.01 : 0.0;
  // Most meshes here are smaller than one automatic patch, which answers everything exactly. With patches as
  // small as these, all borders are split into many parts: twelve patches take 0.15 s whatever the mesh.
  constexpr std::array<std::array<Index, 2>, 3> counts{{{2, 2}, {3, 4}, {6, 2}}};
  if (random.below(10) < 6) return;
  const auto [first, second] = counts[random.one_in(12) ? random.between(1, 2) : 0];
  if (first * second > static_cast<Index>(hostile.soup.faces.size() / 4)) return;
  options.first_layer_patches = first;
  options.second_layer_patches = second;
}

void HostileCase::find_components() {
  component_.resize(hostile.soup.positions.size());
  std::iota(component_.begin(), component_.end(), 0);
  std::function<Index(Index)> root = [&](Index v) {
    while (component_[v] != v) v = component_[v] = component_[component_[v]];
    return v;
  };
  for (const auto& [a, b, c] : hostile.soup.faces) {
    // A face that names a vertex twice connects nothing.
    if (a == b || b == c || c == a) continue;
    component_[root(b)] = root(a);
    component_[root(c)] = root(a);
  }
  for (Index v = 0; v < static_cast<Index>(component_.size()); ++v) component_[v] = root(v);
}

std::string HostileCase::index_text() const {
  return "index of " + std::to_string(options.first_layer_patches) + " x " +
         std::to_string(options.second_layer_patches) + " patches (0: chosen), delta " +
         exactly(options.delta) + ": ";
}

void HostileCase::ask(const std::string& question) {
  question_ = question;
  copy_text(tally.question, question);
}

bool HostileCase::make_mesh() {
  ask("mesh");
  const bool made = attempt([&] {
    for (const std::string& sentence : check_mesh(hostile.soup.positions, hostile.soup.faces).sentences()) {
      if (sentence.size() < 20) fail("a finding of check_mesh without a sentence", sentence);
    }
    mesh = std::make_shared<const Mesh>(hostile.soup.positions, hostile.soup.faces);
  });
  // A soup may hold nothing but faces that name a vertex twice.
  if (!made || mesh->face_count() == 0) return false;
  longest_ = mesh->longest_edge_length();
  walk = std::make_unique<SurfaceWalk>(hostile.soup, mesh->faces());
  for (Index& source : sources) source = mesh->face_vertices(Index(random.below(mesh->face_count())))[0];
  return true;
}

void HostileCase::fail(const std::string& kind, const std::string& numbers) {
  constexpr int shown_of_each_kind = 2;
  ++tally.findings;
  if (findings++ == 0) ++tally.meshes_with_findings;
  const auto known = std::ranges::find(kinds_, kind, &std::pair<std::string, int>::first);
  if (known == kinds_.end()) {
    kinds_.emplace_back(kind, 1);
  } else if (++known->second > shown_of_each_kind) {
    return;
  }
  std::printf("FINDING %s\n  seed %u: %s\n  %s\n  %s\n  again: hostile_fuzz --seed %u%s\n", kind.c_str(),
              seed, hostile.sentence().c_str(), question_.c_str(), numbers.c_str(), seed,
              tally.size_argument);
  std::fflush(stdout);
}

bool HostileCase::attempt(const std::function<void()>& answer, bool may_refuse) {
  try {
    answer();
    return true;
  } catch (const Error& error) {
    if (std::strlen(error.what()) < 20) fail("an error without a sentence", error.what());
    if (!may_refuse) fail("refused without reason", error.what());
  } catch (const std::exception& error) {
    fail("an exception that is not ours", error.what());
  } catch (...) {
    fail("an exception that is not ours", "not even a std::exception");
  }
  return false;
}

void HostileCase::note_error(ErrorKind kind, double actual, double exact_distance) {
  if (seed == scan_seed) return;
  // Between points at one place, rounding alone makes any relative error infinite; it is not reported.
  const double least = 1e-9 * typical;
  if (exact_distance < least || exact_distance == unreachable || actual == unreachable) return;
  tally.errors[static_cast<int>(kind)].add((actual - exact_distance) / exact_distance, seed);
}

void HostileCase::require_same(const std::string& law, Index v, double expected, double actual, double more) {
  if (expected == actual || std::abs(expected - actual) <= slack(expected) + more) return;
  fail(law, "vertex " + std::to_string(v) + ": " + exactly(actual) + ", not " + exactly(expected));
}

void HostileCase::require_same(const std::string& law, const std::function<double(Index)>& expected,
                               const std::function<double(Index)>& actual, double more) {
  const auto count = static_cast<Index>(hostile.soup.positions.size());
  for (Index v = 0; v < count; ++v) require_same(law, v, expected(v), actual(v), more);
}

void HostileCase::require_sound(const std::vector<double>& field, Index source, double along_edges) {
  if (field[source] != 0.0) fail("the source is not at distance 0", exactly(field[source]));
  const Point& origin = hostile.soup.positions[source];
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    const std::string vertex = "vertex " + std::to_string(v) + ": " + exactly(field[v]);
    if (!(field[v] >= 0.0)) fail("a negative distance or none", vertex);
    const bool reached = field[v] < unreachable;
    if (reached != connected(source, v)) {
      fail("reached or not, against the components", vertex);
      continue;
    }
    const Point& p = hostile.soup.positions[v];
    const double straight = std::hypot(p[0] - origin[0], p[1] - origin[1], p[2] - origin[2]);
    if (field[v] < straight * (1.0 - along_edges) - slack(straight)) {
      fail("shorter than the straight line", vertex + ", straight " + exactly(straight));
    }
  }
  for (Index e = 0; e < mesh->edge_count(); ++e) {
    const auto [a, b] = mesh->edge_vertices(e);
    if (!(field[a] < unreachable && field[b] < unreachable)) continue;
    const double most = std::max(field[a], field[b]);
    if (std::abs(field[a] - field[b]) > mesh->edge_length(e) + along_edges * most + slack(most)) {
      fail("differs by more than an edge", "vertices " + std::to_string(a) + " and " + std::to_string(b) +
                                               ": " + exactly(field[a]) + ", " + exactly(field[b]) +
                                               ", edge " + exactly(mesh->edge_length(e)));
    }
  }
}

void check_costs(HostileCase& hostile, ScanCosts& scans) {
  if (!counts_memory()) return;
  // Soups have more faces than a surface over their vertices.
  const std::size_t size =
      std::max(hostile.hostile.soup.positions.size(), hostile.hostile.soup.faces.size() / 2);
  const Costs& scan = scans.of(size, hostile.patches, hostile.options);
  // The errors of the clock, and a handful of pages.
  constexpr double clock = 0.01;
  constexpr double some_bytes = 1 << 20;
  // Any answer may take an exact run, even if on the scan it comes from tables and takes next to no memory.
  const double exact_bytes = scan[static_cast<int>(Step::exact_field)].bytes;
  for (int i = 0; i < step_count; ++i) {
    const Cost& cost = hostile.costs[i];
    const double seconds = scan[i].seconds;
    const double bytes = std::max(scan[i].bytes, exact_bytes);
    // Without the errors of the clock and a handful of pages.
    const double times = std::max(0.0, cost.seconds - clock) / seconds;
    const double memories = std::max(0.0, cost.bytes - some_bytes) / bytes;
    hostile.tally.times[i].add(times, hostile.seed);
    hostile.tally.memories[i].add(memories, hostile.seed);
    // Relative to the cost that is allowed.
    hostile.dearest = std::max({hostile.dearest, times / most_of_a_scan, memories / most_of_a_scan});
    hostile.ask(hostile.index_text() + step_names[i]);
    if (cost.seconds > most_of_a_scan * seconds + clock) {
      hostile.fail(std::string("time of ") + step_names[i],
                   exactly(cost.seconds) + " s, a scan no smaller takes " + exactly(seconds) + " s");
    }
    if (cost.bytes > most_of_a_scan * bytes + some_bytes) {
      hostile.fail(std::string("memory of ") + step_names[i],
                   exactly(cost.bytes) + " bytes, a scan no smaller takes " + exactly(bytes) + " bytes");
    }
  }
}

}  // namespace vorogeo::test
