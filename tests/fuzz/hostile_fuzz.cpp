// Hostile meshes through everything: build, fields, pairs, paths, Voronoi regions and files are compared with
// the exact field, and that with a reference that shares no code with it. See tests/README.md.
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <new>
#include <string>
#include <vector>

#include "fuzz/hostile_case.h"
#include "mesh/mesh_check.h"

namespace {

using namespace vorogeo;
using namespace vorogeo::test;

constexpr const char* usage =
    "usage: hostile_fuzz [--count N | --hours H] [--first SEED | --of-today] [--vertices N | --mixed] "
    "[--jobs N] "
    "[--error E] [--no-costs] [--exact-only] [--spoilt]\n"
    "       hostile_fuzz --seed SEED [--vertices N] [--spoilt]\n"
    "  --count     meshes, seeds from --first on (default 1000, first 1)\n"
    "  --hours     as many as fit this time instead\n"
    "  --of-today  the first seed is 1,000,000,000 and ten thousand times the day's number, so that no day\n"
    "              repeats another's meshes; these are also machined, cut, decimated, in single precision;\n"
    "              from --first 4000000000 on, meshes are of all kinds\n"
    "  --vertices  size: meshes have half to twice as many (default 60)\n"
    "  --mixed     sizes of 60, some of 200, 600, 2500, 6000 and 10000\n"
    "  --jobs      processes (default 1)\n"
    "  --seed      one mesh in this process: what a finding names\n"
    "  --error     relative error of an index and of quick fields above which it is a finding (default .01)\n"
    "  --no-costs  does not compare time and memory with those of a scan\n"
    "  --exact-only  exact fields alone, with 1, 2, 3 and 8 threads: no index, no costs\n"
    "  --spoilt    meshes have what the generator leaves out, and are refused with values that are none\n";

struct Options {
  unsigned first = 1;
  unsigned count = 1000;
  double seconds = 0.0;  ///< 0: only `count` ends the run
  int vertices = 60;
  bool mixed = false;
  int jobs = 1;
  bool single = false;
  bool costs = true;
  bool index = true;
  bool spoilt = false;
  double greatest_error = 0.01;
};

#ifdef VOROGEO_SMALL_TESTS
constexpr double slowness = 20.0;  // of the sanitizers
#else
constexpr double slowness = 1.0;
constexpr rlim_t max_memory = rlim_t{4} << 30;
#endif
/// Processor time after which a mesh is assumed to hang; the slowest scan of this size takes 1 % of it.
double max_mesh_seconds(int vertices) { return slowness * (5.0 + 0.05 * vertices); }

int size_of(unsigned seed, const Options& options) {
  if (!options.mixed) return options.vertices;
  constexpr std::array sizes{60, 60, 60, 60, 60,  60,  60,  60,  60,  60,
                             60, 60, 60, 60, 200, 200, 200, 200, 600, 2500};
  // One in 200 is larger, so that threads share a field.
  const std::size_t draw = HostileRandom(seed).below(400);
  return draw == 199 ? 6000 : draw == 399 ? 10000 : sizes[draw % sizes.size()];
}

/// Scales a mesh up to the limits of lengths, or moves corners to any vertex: non-manifold in every way.
void spoil(HostileMesh& mesh, HostileRandom random) {
  mesh.flat.clear();
  if (random.one_in(2)) {
    mesh.soup = scaled(mesh.soup, random.power(-140.0, 140.0));
    mesh.defects.emplace_back("a size of any order");
    return;
  }
  for (auto& face : mesh.soup.faces) {
    if (random.one_in(8))
      face[random.below(3)] = static_cast<Index>(random.below(mesh.soup.positions.size()));
  }
  mesh.defects.emplace_back("corners anywhere");
}

/// Checks that a mesh with a coordinate that is not finite, or a corner that is no vertex, is refused.
void require_refusals(HostileCase& hostile) {
  const Soup& soup = hostile.hostile.soup;
  HostileRandom random(hostile.seed);
  auto require_refusal = [&](const Soup& bad, const std::string& what) {
    hostile.ask("mesh with " + what);
    if (check_mesh(bad.positions, bad.faces).usable())
      hostile.fail("the report calls usable what is none", what);
    if (hostile.attempt([&] { make_mesh(bad); }, true)) hostile.fail("a mesh was made of what is none", what);
  };
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), unreachable, -unreachable}) {
    Soup bad = soup;
    bad.positions[random.below(bad.positions.size())][random.below(3)] = value;
    require_refusal(bad, "a coordinate " + exactly(value));
  }
  if (soup.faces.empty()) return;
  for (const Index vertex :
       {-1, static_cast<Index>(soup.positions.size()), std::numeric_limits<Index>::max()}) {
    Soup bad = soup;
    bad.faces[random.below(bad.faces.size())][random.below(3)] = vertex;
    require_refusal(bad, "a corner " + std::to_string(vertex));
  }
}

Measured examine(HostileCase& hostile, const Options& options, ScanCosts* scans) {
  if (!hostile.make_mesh()) return {};
  check_exact(hostile);
  if (hostile.seed != scan_seed) {
    check_laws(hostile);
    if (options.index) {
      check_metrics(hostile);
      check_gaps(hostile);
      check_tasks(hostile);
    }
  }
  if (!options.index) return {};
  check_index(hostile);
  if (scans != nullptr && !hostile.exact[1].empty()) check_costs(hostile, *scans);
  return {hostile.costs, hostile.patches};
}

ScanCosts scan_costs(const Options& options, HostileTally& tally) {
  return ScanCosts([&](const HostileMesh& scan, const IndexOptions& index_options) {
    // A scan's time is not charged to the mesh that is compared with it, and has no limit.
    const double started = tally.mesh_seconds - processor_seconds();
    tally.mesh_seconds = std::numeric_limits<double>::infinity();
    HostileCase hostile(scan_seed, scan, tally);
    hostile.options = index_options;
    const Measured measured = examine(hostile, options, nullptr);
    tally.mesh_seconds = started + processor_seconds();
    return measured;
  });
}

void examine_seed(unsigned seed, const Options& options, HostileTally& tally, ScanCosts& scans) {
  // In this order, as the parent would otherwise charge this seed with the time of the mesh before.
  tally.mesh_seconds = processor_seconds();
  tally.seed = seed;
  std::strcpy(tally.question, "generator");
  const int vertices = size_of(seed, options);
  tally.vertices = vertices;
  std::snprintf(tally.size_argument, sizeof(tally.size_argument), " --vertices %d%s", vertices,
                options.spoilt ? " --spoilt" : "");
  HostileMesh mesh = hostile_mesh(seed, vertices);
  if (options.spoilt) spoil(mesh, HostileRandom(seed));
  tally.vertices = std::max(vertices, static_cast<int>(mesh.soup.positions.size()));
  HostileCase hostile(seed, std::move(mesh), tally);
  hostile.greatest_error = options.greatest_error;
  if (options.spoilt) require_refusals(hostile);
  // An exception of a check itself, as where its reference finds no memory, is a finding as well.
  hostile.attempt([&] { examine(hostile, options, options.costs ? &scans : nullptr); });
  ++tally.meshes;
  for (const std::size_t kind : hostile.hostile.kinds) {
    KindTally& of_kind = tally.kinds[kind];
    ++of_kind.meshes;
    of_kind.with_findings += hostile.findings > 0 ? 1 : 0;
    of_kind.dearest.add(hostile.dearest, seed);
  }
}

/// One of the processes of a run: takes every jobs-th seed.
struct Worker {
  HostileTally* tally = nullptr;
  std::uint64_t next = 0;
  std::uint64_t end = 0;  ///< one past the last seed, at most 2^32
  pid_t process = 0;      ///< 0: none is running

  void start(const Options& options, double deadline) {
    std::fflush(stdout);
    process = fork();
    if (process != 0) return;
#ifndef VOROGEO_SMALL_TESTS
    const rlimit limit{max_memory, max_memory};
    setrlimit(RLIMIT_AS, &limit);
#endif
    ScanCosts scans = scan_costs(options, *tally);
    for (std::uint64_t seed = next; seed < end; seed += options.jobs) {
      if (deadline > 0.0 && static_cast<double>(time(nullptr)) > deadline) break;
      examine_seed(static_cast<unsigned>(seed), options, *tally, scans);
    }
    tally->finished = true;
    std::fflush(stdout);
    // Without the destructors of main()'s variables, which belong to the parent; leaks are still looked for.
    std::exit(0);
  }

  double processor_seconds_used() const {
    clockid_t clock{};
    timespec used{};
    if (clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &used) != 0) return 0.0;
    return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
  }

  /// Notes the mesh at work as a finding: its process crashed, leaked, or was killed because it hung.
  void note_lost(const Options& options, const std::string& how) {
    const unsigned seed = tally->seed;
    ++tally->findings;
    ++tally->meshes_with_findings;
    ++tally->meshes;
    std::printf("FINDING %s\n  seed %u: %s\n  %s\n  again: hostile_fuzz --seed %u%s\n", how.c_str(), seed,
                tally->sentence, tally->question, seed, tally->size_argument);
    next = std::uint64_t{seed} + options.jobs;
    process = 0;
  }

  /// Checks on the process. \return whether there is more to do.
  bool attend(const Options& options, double deadline) {
    if (process == 0) {
      if (next >= end || (deadline > 0.0 && static_cast<double>(time(nullptr)) > deadline)) return false;
      start(options, deadline);
    }
    // Read in the opposite order to that in which they are written: see examine_seed().
    const unsigned seed = tally->seed;
    const double seconds = processor_seconds_used() - tally->mesh_seconds;
    if (seconds > max_mesh_seconds(tally->vertices) && tally->seed == seed && !tally->finished) {
      kill(process, SIGKILL);
      waitpid(process, nullptr, 0);
      note_lost(options, "a hang");
      return true;
    }
    int status = 0;
    if (waitpid(process, &status, WNOHANG) != process) return true;
    if (tally->finished && WIFEXITED(status) && WEXITSTATUS(status) == 0) {
      process = 0;
      next = end;
      return false;
    }
    note_lost(options, tally->finished ? "a leak or a late error of the process" : "a crash");
    if (tally->finished) next = end;
    return true;
  }
};

HostileTally* shared_tally() {
  void* memory =
      mmap(nullptr, sizeof(HostileTally), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  return new (memory) HostileTally;
}

int summary(const std::vector<Worker>& workers, double started) {
  HostileTally total;
  for (const Worker& worker : workers) {
    const HostileTally& tally = *worker.tally;
    total.meshes += tally.meshes;
    total.refused += tally.refused;
    total.findings += tally.findings;
    total.meshes_with_findings += tally.meshes_with_findings;
    for (int i = 0; i < error_kind_count; ++i) total.errors[i].add(tally.errors[i]);
    for (int i = 0; i < step_count; ++i) {
      total.times[i].add(tally.times[i]);
      total.memories[i].add(tally.memories[i]);
    }
    for (std::size_t i = 0; i < total.kinds.size(); ++i) total.kinds[i].add(tally.kinds[i]);
  }
  // Tables in Markdown, which run.sh --report copies into docs/hostile.md.
  std::printf(
      "| times a scan's | meshes | time, at most | seed | memory, at most | seed "
      "|\n|---|--:|--:|---|--:|---|\n");
  for (int i = 0; i < step_count; ++i) {
    const CostRatios& time = total.times[i];
    const CostRatios& memory = total.memories[i];
    std::printf("| %s | %u | %.2g | %u | %.2g | %u |\n", step_names[i], time.meshes, time.largest,
                time.largest_seed, memory.largest, memory.largest_seed);
  }
  std::printf("\n| relative errors | answers | mean | p99 | largest | seed |\n|---|--:|--:|--:|--:|---|\n");
  for (int i = 0; i < error_kind_count; ++i) {
    const ErrorHistogram& errors = total.errors[i];
    std::printf("| %s | %llu | %.2g | %.2g | %.2g | %u |\n", error_kind_names[i],
                static_cast<unsigned long long>(errors.count), errors.mean(), errors.quantile(0.99),
                errors.largest, errors.largest_seed);
  }
  std::printf(
      "\n| kind | meshes | with findings | dearest step, of what it may cost | seed "
      "|\n|---|--:|--:|--:|---|\n");
  for (std::size_t i = 0; i < total.kinds.size(); ++i) {
    const KindTally& kind = total.kinds[i];
    std::printf("| %s | %u | %u | %.2g | %u |\n", hostile_kinds[i], kind.meshes, kind.with_findings,
                kind.dearest.largest, kind.dearest.largest_seed);
  }
  std::printf("\n");
  std::printf("%u meshes in %.0f s (%u refused in a sentence): %u findings on %u of them\n", total.meshes,
              static_cast<double>(time(nullptr)) - started, total.refused, total.findings,
              total.meshes_with_findings);
  return total.findings == 0 ? 0 : 1;
}

bool read_options(int argc, char** argv, Options& options) {
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    if (name == "--mixed") {
      options.mixed = true;
      continue;
    }
    if (name == "--no-costs") {
      options.costs = false;
      continue;
    }
    if (name == "--exact-only") {
      options.index = options.costs = false;
      continue;
    }
    if (name == "--spoilt") {
      options.spoilt = true;
      continue;
    }
    if (name == "--of-today") {
      options.first = first_remeshed_seed + 10000 * static_cast<unsigned>(time(nullptr) / 86400);
      continue;
    }
    if (++i >= argc) return false;
    char* rest = nullptr;
    const double value = std::strtod(argv[i], &rest);
    if (rest == argv[i] || *rest != 0 || !(value >= 0.0) || value >= 0x1p32) return false;
    if (name == "--seed") {
      options.first = static_cast<unsigned>(value);
      options.count = 1;
      options.single = true;
    } else if (name == "--error") {
      options.greatest_error = value;
    } else if (name == "--first") {
      options.first = static_cast<unsigned>(value);
    } else if (name == "--count") {
      options.count = static_cast<unsigned>(value);
    } else if (name == "--hours") {
      options.seconds = 3600.0 * value;
      options.count = std::numeric_limits<unsigned>::max();
    } else if (name == "--vertices") {
      options.vertices = static_cast<int>(value);
      options.mixed = false;
    } else if (name == "--jobs") {
      options.jobs = std::max(1, static_cast<int>(value));
    } else {
      return false;
    }
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  if (!read_options(argc, argv, options)) {
    std::fputs(usage, stderr);
    return 2;
  }
  const auto started = static_cast<double>(time(nullptr));
  std::vector<Worker> workers(options.single ? 1 : options.jobs);
  for (std::size_t i = 0; i < workers.size(); ++i) {
    workers[i].tally = shared_tally();
    workers[i].next = std::uint64_t{options.first} + i;
    workers[i].end = std::min(std::uint64_t{options.first} + options.count, std::uint64_t{1} << 32);
  }
  if (options.single) {
    // In this process, so that a debugger sees it.
    HostileTally& tally = *workers[0].tally;
    ScanCosts scans = scan_costs(options, tally);
    examine_seed(options.first, options, tally, scans);
    std::printf("seed %u: %s\n", options.first, tally.sentence);
    return summary(workers, started);
  }
  const double deadline = options.seconds > 0.0 ? started + options.seconds : 0.0;
  for (bool more = true; more;) {
    more = false;
    for (Worker& worker : workers) more = worker.attend(options, deadline) || more;
    if (more) usleep(20000);
  }
  return summary(workers, started);
}
