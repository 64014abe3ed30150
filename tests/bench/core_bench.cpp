// The program of the benchmarks: measures the C++ core on meshes and prints lines of JSON. `tasks`, at the
// end, has their arguments. MESH: see raw_mesh.h; in any_mesh a PLY file, or the name of a part that the
// tests make.
//
// exact, build, fields and pairs print {"name": ..., "detail": ..., "values": [wall clock], "cpu": [all cores
// together]}, in seconds. exact: the whole mesh, one thread. build: one build, saved to
// INDEX; build_in_file: in that file, for meshes whose index is larger than the memory. Both print the phases
// in the order of time: "phase ACTIVITY", and in "memory ACTIVITY" the most bytes that the process had in
// memory, with and without the pages of files. fields: with 1 to THREADS threads. PAIRS: a file of int32
// (source, target).
#include "core_bench.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>

#include "exact/exact_solver.h"
#include "index/geodesic_index.h"
#include "support/indexes.h"

namespace {

using namespace bench;

void print_array(const char* name, const std::vector<double>& values) {
  std::printf(", \"%s\": [", name);
  for (std::size_t i = 0; i < values.size(); ++i) std::printf("%s%.9g", i ? ", " : "", values[i]);
  std::printf("]");
}

/// One line of the output. `detail` tells measurements of one name apart.
void print(const char* name, double detail, const std::vector<double>& values,
           const std::vector<double>& cpu = {}) {
  std::printf("{\"name\": \"%s\", \"detail\": %.17g", name, detail);
  print_array("values", values);
  print_array("cpu", cpu);
  std::printf("}\n");
  std::fflush(stdout);
}

/// The times of many calls.
class Times {
 public:
  template <class Call>
  void add(Call&& call) {
    const Seconds spent = seconds(call);
    wall_.push_back(spent.wall);
    cpu_.push_back(spent.cpu);
  }
  void print(const char* name, double detail) const { ::print(name, detail, wall_, cpu_); }

 private:
  std::vector<double> wall_, cpu_;
};

std::vector<Index> vertices_of(Arguments texts) {
  std::vector<Index> vertices;
  for (const char* text : texts) vertices.push_back(static_cast<Index>(std::atol(text)));
  return vertices;
}

void time_exact(Arguments arguments) {
  const MeshPointer mesh = load(arguments[0]);
  vorogeo::ExactSolver solver(mesh);
  vorogeo::ExactLimits limits;
  limits.distances_only = true;
  Times times;
  for (const Index source : vertices_of(arguments.subspan(1))) {
    times.add([&] { solver.run_from_vertices({&source, 1}, limits); });
  }
  times.print("exact", mesh->vertex_count());
}

/// As a script pays that asks once, from arrays to a field, and as one that asks again; one thread.
void time_fresh(Arguments arguments) {
  const RawMesh raw = read_mesh(arguments[0]);
  vorogeo::ExactLimits limits;
  limits.distances_only = true;
  for (const Index source : vertices_of(arguments.subspan(1))) {
    std::optional<vorogeo::ExactSolver> solver;
    auto run = [&] { solver->run_from_vertices({&source, 1}, limits); };
    const double fresh = cpu_seconds([&] {
      solver.emplace(std::make_shared<const vorogeo::Mesh>(raw.positions, raw.faces));
      run();
    });
    const double warm = cpu_seconds(run);
    const auto windows = static_cast<double>(solver->window_count());
    print_figures("source", std::to_string(source),
                  {{"fresh", fresh},
                   {"warm", warm},
                   {"windows", windows / solver->mesh().edge_count()},
                   {"bytes", static_cast<double>(solver->memory_bytes())}});
  }
}

/// Notes from the reports of a build when each of its phases begins, and the most memory in it.
class Phases {
 public:
  vorogeo::Progress progress() {
    return vorogeo::Progress([this](double, const std::string& activity) {
      if (activity_ != activity) {
        finish();
        activity_ = activity;
        wall_ = now();
        cpu_ = std::clock();
      }
      for (std::size_t i = 0; i < names.size(); ++i) memory_[i] = std::max(memory_[i], bytes(names[i]));
      return true;
    });
  }
  void finish() {
    if (!activity_.empty()) {
      const double cpu = static_cast<double>(std::clock() - cpu_) / CLOCKS_PER_SEC;
      print(("phase " + activity_).c_str(), count_, {now() - wall_}, {cpu});
      print(("memory " + activity_).c_str(), count_++, {memory_[0], memory_[1]});
    }
    memory_ = {};
  }

 private:
  static constexpr std::array<const char*, 2> names{"VmRSS:", "RssAnon:"};

  static double bytes(const std::string& name) {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
      double kilobytes = 0.0;
      if (word == name && status >> kilobytes) return 1024.0 * kilobytes;
    }
    return 0.0;
  }

  std::string activity_;
  double wall_ = 0.0;
  std::clock_t cpu_ = 0;
  std::array<double, 2> memory_{};
  int count_ = 0;
};

void build(Arguments arguments, bool in_file) {
  const MeshPointer mesh = load(arguments[0]);
  const int threads = std::atoi(arguments[1]);
  const char* file = arguments[2];
  vorogeo::IndexOptions options;
  options.threads = threads;
  std::shared_ptr<const vorogeo::GeodesicIndex> index;
  Times times;
  Phases phases;
  if (in_file) {
    std::filesystem::remove(file);
    times.add([&] { index = vorogeo::GeodesicIndex::build_in_file(file, mesh, options, phases.progress()); });
  } else {
    times.add([&] { index = vorogeo::GeodesicIndex::build(mesh, options, phases.progress()); });
  }
  phases.finish();
  times.print("build", threads);
  if (!in_file) index->save(file);
  print("index_bytes", mesh->vertex_count(), {static_cast<double>(index->statistics().bytes)});
  print("file_bytes", mesh->vertex_count(), {static_cast<double>(std::filesystem::file_size(file))});
}

std::shared_ptr<const vorogeo::GeodesicIndex> load_index(const MeshPointer& mesh, const char* file) {
  std::shared_ptr<const vorogeo::GeodesicIndex> index;
  Times times;
  times.add([&] { index = vorogeo::GeodesicIndex::load(file, mesh); });
  times.print("load", 1);
  return index;
}

void time_fields(Arguments arguments) {
  const auto index = load_index(load(arguments[0]), arguments[1]);
  const int threads = std::atoi(arguments[2]);
  const int rounds = std::atoi(arguments[3]);
  const auto sources = vertices_of(arguments.subspan(4));
  for (int workers = 1; workers <= threads; ++workers) {
    vorogeo::test::IndexQuery query(index, workers);
    query.distance_field({sources.data(), 1});
    Times times;
    for (int round = 0; round < rounds; ++round) {
      for (const Index& source : sources) times.add([&] { query.distance_field({&source, 1}); });
    }
    times.print("field", workers);
  }
}

void time_pairs(Arguments arguments) {
  const auto index = load_index(load(arguments[0]), arguments[1]);
  std::ifstream stream(arguments[2], std::ios::binary);
  const std::size_t count = std::filesystem::file_size(arguments[2]) / sizeof(std::array<Index, 2>);
  const auto pairs = read_array<std::array<Index, 2>>(stream, count);
  const int rounds = std::atoi(arguments[3]);
  vorogeo::test::IndexQuery query(index, 1);
  Times times;
  for (int round = 0; round < rounds; ++round) {
    for (const auto& pair : pairs) times.add([&] { query.distance(pair[0], pair[1]); });
  }
  times.print("pair", 1);
}

struct Task {
  std::string_view name, arguments;
  std::size_t least;  ///< number of arguments; more only where they end in "..."
  void (*run)(Arguments);
};
constexpr Task tasks[] = {
    {"exact", "MESH SOURCE...", 2, time_exact},
    {"fresh", "MESH SOURCE...", 2, time_fresh},
    {"build", "MESH THREADS INDEX", 3, [](Arguments arguments) { build(arguments, false); }},
    {"build_in_file", "MESH THREADS INDEX", 3, [](Arguments arguments) { build(arguments, true); }},
    {"fields", "MESH INDEX THREADS ROUNDS SOURCE...", 5, time_fields},
    {"pairs", "MESH INDEX PAIRS ROUNDS", 4, time_pairs},
    {"any_mesh", "SOURCES MESH...", 2, measure_any_mesh},
    {"trade_off", "MESH SOURCES", 2, measure_trade_off},
    {"paths", "MESH INDEX SOURCES TARGETS THREADS 0|1:POINTS_IN_FACES LANDMARKS", 7, measure_paths},
};

}  // namespace

int main(int count, char** values) try {
  const Arguments arguments(values + std::min(count, 2), values + count);
  for (const Task& task : tasks) {
    if (count < 2 || task.name != values[1] || arguments.size() < task.least) continue;
    if (arguments.size() > task.least && !task.arguments.ends_with("...")) continue;
    task.run(arguments);
    return 0;
  }
  for (const Task& task : tasks) {
    std::fprintf(stderr, "usage: core_bench %s %s\n", task.name.data(), task.arguments.data());
  }
  return 2;
} catch (const std::exception& error) {
  std::fprintf(stderr, "core_bench: %s\n", error.what());
  return 1;
}
