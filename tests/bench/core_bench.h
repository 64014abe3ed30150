// What the tasks of the program core_bench share: meshes, lines of JSON, times, random vertices.
#pragma once

#include <cstdio>
#include <ctime>
#include <initializer_list>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <utility>

#include "mesh/mesh.h"
#include "raw_mesh.h"

namespace bench {

using vorogeo::Index;
using MeshPointer = std::shared_ptr<const vorogeo::Mesh>;
/// Those of the command line behind the name of the task.
using Arguments = std::span<char* const>;

inline MeshPointer load(const char* file) {
  RawMesh raw = read_mesh(file);
  return std::make_shared<const vorogeo::Mesh>(std::move(raw.positions), raw.faces);
}

inline Index any_vertex(const vorogeo::Mesh& mesh, std::mt19937& random) {
  return static_cast<Index>(random() % static_cast<unsigned>(mesh.vertex_count()));
}

/// Processor time that a call takes.
template <class Call>
double cpu_seconds(Call&& call) {
  return seconds(std::forward<Call>(call)).cpu;
}

/// A line of JSON with a text and numbers.
inline void print_figures(const char* name, const std::string& text,
                          std::initializer_list<std::pair<const char*, double>> figures) {
  std::printf("{\"%s\": \"%s\"", name, text.c_str());
  for (const auto& [figure, value] : figures) std::printf(", \"%s\": %.6g", figure, value);
  std::printf("}\n");
  std::fflush(stdout);
}

// The tasks that core_bench.cpp does not have itself.
void measure_any_mesh(Arguments arguments);
void measure_trade_off(Arguments arguments);
void measure_paths(Arguments arguments);

}  // namespace bench
