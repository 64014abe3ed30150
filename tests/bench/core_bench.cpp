// Times of the C++ core on one mesh, as lines of JSON: {"name": ..., "detail": ..., "values": [wall clock],
// "cpu": [all cores together]}, in seconds. Tasks:
// - exact MESH SOURCE...: exact solver on the whole mesh, one thread, and on cut-out pieces
// - build MESH THREADS INDEX: one build; the index is saved to INDEX
// - build_in_file MESH THREADS INDEX: one build in the file INDEX, for meshes whose index is larger than the
// memory
//   Both print the phases in the order of time: "phase ACTIVITY", and in "memory ACTIVITY" the most bytes
//   that the process had in memory, with and without the pages of files
// - fields MESH INDEX THREADS ROUNDS SOURCE...: fields with 1 to THREADS threads
// - pairs MESH INDEX PAIRS ROUNDS: two points; PAIRS: a file of int32 (source, target)
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "exact/exact_solver.h"
#include "index/geodesic_index.h"
#include "mesh_file.h"
#include "query/geodesic_query.h"

namespace {

using vorogeo::Index;
using MeshPointer = std::shared_ptr<const vorogeo::Mesh>;

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

/// The times of many calls, each divided by `share`.
class Times {
 public:
  template <class Call>
  void add(Call&& call, double share = 1.0) {
    const bench::Seconds seconds = bench::seconds(call);
    wall_.push_back(seconds.wall / share);
    cpu_.push_back(seconds.cpu / share);
  }
  void print(const char* name, double detail) const { ::print(name, detail, wall_, cpu_); }

 private:
  std::vector<double> wall_, cpu_;
};

MeshPointer load(const char* file) {
  bench::RawMesh raw = bench::read_mesh(file);
  return std::make_shared<const vorogeo::Mesh>(std::move(raw.positions), raw.faces);
}

std::vector<Index> vertices_from(int count, char** texts) {
  std::vector<Index> vertices;
  for (int i = 0; i < count; ++i) vertices.push_back(static_cast<Index>(std::atol(texts[i])));
  return vertices;
}

/// The faces nearest to a face, counted in steps over edges, as a mesh of about `size` vertices.
MeshPointer cut_out(const vorogeo::Mesh& mesh, Index seed, std::size_t size) {
  std::vector<Index> new_vertex(mesh.vertex_count(), vorogeo::no_index);
  std::vector<std::uint8_t> taken(mesh.face_count(), 0);
  std::vector<Index> order{seed};
  taken[seed] = 1;
  std::vector<vorogeo::Point> positions;
  std::vector<std::array<Index, 3>> faces;
  for (std::size_t i = 0; i < order.size() && positions.size() < size; ++i) {
    std::array<Index, 3> corners{};
    for (int c = 0; c < 3; ++c) {
      const Index halfedge = 3 * order[i] + c;
      const Index vertex = mesh.face_vertices(order[i])[c];
      if (new_vertex[vertex] == vorogeo::no_index) {
        new_vertex[vertex] = static_cast<Index>(positions.size());
        positions.push_back(mesh.position(vertex));
      }
      corners[c] = new_vertex[vertex];
      for (Index h = mesh.next_around_edge(halfedge); h != halfedge; h = mesh.next_around_edge(h)) {
        if (!taken[h / 3]) order.push_back(h / 3);
        taken[h / 3] = 1;
      }
    }
    faces.push_back(corners);
  }
  return std::make_shared<const vorogeo::Mesh>(std::move(positions), faces);
}

/// Nothing but the distances of vertices is read after the runs.
vorogeo::ExactLimits only_distances() {
  vorogeo::ExactLimits limits;
  limits.distances_only = true;
  return limits;
}

void time_exact(const MeshPointer& mesh, const std::vector<Index>& sources) {
  {
    Times times;
    vorogeo::ExactSolver solver(mesh);
    for (const Index& source : sources) {
      times.add([&] { solver.run_from_vertices({&source, 1}, only_distances()); });
    }
    times.print("exact", mesh->vertex_count());
  }
  for (const std::size_t size : {700, 1200, 2500}) {
    if (size * 2 > static_cast<std::size_t>(mesh->vertex_count())) continue;
    Times times;
    for (int patch = 0; patch < 5; ++patch) {
      const auto seed =
          static_cast<Index>((2 * patch + 1) * static_cast<std::int64_t>(mesh->face_count()) / 10);
      const MeshPointer part = cut_out(*mesh, seed, size);
      vorogeo::ExactSolver solver(part);
      for (int run = 0; run < 20; ++run) {
        const auto source =
            static_cast<Index>((2 * run + 1) * static_cast<std::int64_t>(part->vertex_count()) / 40);
        const auto solve = [&] { solver.run_from_vertices({&source, 1}, only_distances()); };
        if (run == 0) solve();  // takes the memory that later runs find
        times.add(solve, part->vertex_count());
      }
    }
    times.print("exact_patch", static_cast<double>(size));
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
        wall_ = bench::now();
        cpu_ = std::clock();
      }
      for (std::size_t i = 0; i < names.size(); ++i) memory_[i] = std::max(memory_[i], bytes(names[i]));
      return true;
    });
  }
  void finish() {
    if (!activity_.empty()) {
      const double cpu = static_cast<double>(std::clock() - cpu_) / CLOCKS_PER_SEC;
      print(("phase " + activity_).c_str(), count_, {bench::now() - wall_}, {cpu});
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

void time_build(const MeshPointer& mesh, int threads, const char* file, bool in_file) {
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

void time_fields(const MeshPointer& mesh, const char* index_file, int threads, int rounds,
                 const std::vector<Index>& sources) {
  const auto index = load_index(mesh, index_file);
  for (int workers = 1; workers <= threads; ++workers) {
    vorogeo::GeodesicQuery query(index, workers);
    query.distance_field({sources.data(), 1});
    Times times;
    for (int round = 0; round < rounds; ++round) {
      for (const Index& source : sources) times.add([&] { query.distance_field({&source, 1}); });
    }
    times.print("field", workers);
  }
}

void time_pairs(const MeshPointer& mesh, const char* index_file, const char* pairs_file, int rounds) {
  const auto index = load_index(mesh, index_file);
  std::ifstream stream(pairs_file, std::ios::binary);
  const std::size_t count = std::filesystem::file_size(pairs_file) / sizeof(std::array<Index, 2>);
  const auto pairs = bench::read_array<std::array<Index, 2>>(stream, count);
  vorogeo::GeodesicQuery query(index, 1);
  Times times;
  for (int round = 0; round < rounds; ++round) {
    for (const auto& pair : pairs) times.add([&] { query.distance(pair[0], pair[1]); });
  }
  times.print("pair", 1);
}

}  // namespace

int main(int count, char** arguments) try {
  const std::string task = count > 2 ? arguments[1] : "";
  if (task == "exact" && count > 3) {
    time_exact(load(arguments[2]), vertices_from(count - 3, arguments + 3));
  } else if ((task == "build" || task == "build_in_file") && count == 5) {
    time_build(load(arguments[2]), std::atoi(arguments[3]), arguments[4], task == "build_in_file");
  } else if (task == "fields" && count > 6) {
    time_fields(load(arguments[2]), arguments[3], std::atoi(arguments[4]), std::atoi(arguments[5]),
                vertices_from(count - 6, arguments + 6));
  } else if (task == "pairs" && count == 6) {
    time_pairs(load(arguments[2]), arguments[3], arguments[4], std::atoi(arguments[5]));
  } else {
    std::fprintf(stderr,
                 "usage: core_bench exact|build|build_in_file|fields|pairs MESH ...; see the head of "
                 "core_bench.cpp\n");
    return 2;
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "core_bench: %s\n", error.what());
  return 1;
}
