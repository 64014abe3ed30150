// The raw mesh files that the benchmark programs read: int64 counts of vertices and faces, float64 positions
// of shape (n, 3), int32 triangles of shape (m, 3); written by meshes.py. And their clocks.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace bench {

struct RawMesh {
  std::vector<std::array<double, 3>> positions;
  std::vector<std::array<std::int32_t, 3>> faces;
};

template <class Element>
std::vector<Element> read_array(std::istream& stream, std::size_t count) {
  std::vector<Element> array(count);
  stream.read(reinterpret_cast<char*>(array.data()), static_cast<std::streamsize>(count * sizeof(Element)));
  return array;
}

/// \throw std::runtime_error if the file is missing or too short.
inline RawMesh read_mesh(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  const auto counts = read_array<std::int64_t>(stream, 2);
  if (!stream) throw std::runtime_error("cannot read the raw mesh " + file);
  RawMesh mesh;
  mesh.positions = read_array<std::array<double, 3>>(stream, static_cast<std::size_t>(counts[0]));
  mesh.faces = read_array<std::array<std::int32_t, 3>>(stream, static_cast<std::size_t>(counts[1]));
  if (!stream) throw std::runtime_error("the raw mesh " + file + " is too short");
  return mesh;
}

/// Seconds on a clock that only goes forward.
inline double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Seconds that a call takes: on the wall's clock, and of all cores together.
struct Seconds {
  double wall, cpu;
};

template <class Call>
Seconds seconds(Call&& call) {
  const std::clock_t cpu = std::clock();
  const double start = now();
  call();
  return {now() - start, static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC};
}

}  // namespace bench
