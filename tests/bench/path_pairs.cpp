// Refined and exact paths of random pairs against the exact field of each source, on one mesh.
//
// One line of JSON for each pair: exact length, refined length, length of exact_path, whether it is
// certified, processor seconds of both, length and seconds of exact_path without certificate, and of
// exact_path with landmarks.
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <mutex>

#include "core_bench.h"
#include "exact/exact_solver.h"
#include "query/landmarks.h"
#include "query/path_query.h"
#include "support/parallel.h"

namespace bench {

namespace {

using vorogeo::SurfacePoint;

/// Processor time of this thread.
template <class Call>
double thread_seconds(Call&& call) {
  const double start = vorogeo::thread_seconds();
  call();
  return vorogeo::thread_seconds() - start;
}

/// Read from the file if it is there and of this mesh, else built and written.
std::shared_ptr<const vorogeo::GeodesicIndex> index_of(const MeshPointer& mesh, const char* file) {
  if (std::filesystem::exists(file)) {
    try {
      return vorogeo::GeodesicIndex::load(file, mesh);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "core_bench: %s: building it again\n", error.what());
    }
  }
  auto index = vorogeo::GeodesicIndex::build(mesh, {});
  index->save(file);
  return index;
}

/// Random points of one component.
class Draw {
 public:
  Draw(const vorogeo::Mesh& mesh, bool in_faces, std::uint64_t seed)
      : mesh_(mesh), in_faces_(in_faces), random_(seed) {}
  SurfacePoint any() {
    if (!in_faces_) return SurfacePoint::at_vertex(below(mesh_.vertex_count()));
    double u = unit(), v = unit();
    if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
    return SurfacePoint::in_face(below(mesh_.face_count()), {1.0 - u - v, u, v});
  }
  SurfacePoint connected_to(const SurfacePoint& other) {
    for (;;) {
      const SurfacePoint point = any();
      if (component(point) == component(other)) return point;
    }
  }

 private:
  double unit() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  Index below(Index count) { return static_cast<Index>(random_() % static_cast<std::uint64_t>(count)); }
  Index component(const SurfacePoint& point) const {
    return mesh_.component(point.is_vertex() ? point.vertex : mesh_.face_vertices(point.face).front());
  }
  const vorogeo::Mesh& mesh_;
  bool in_faces_;
  std::mt19937_64 random_;
};

}  // namespace

void measure_paths(Arguments arguments) {
  const MeshPointer mesh = load(arguments[0]);
  const auto index = index_of(mesh, arguments[1]);
  const auto sources = static_cast<std::size_t>(std::atol(arguments[2]));
  const long targets = std::atol(arguments[3]);
  const int threads = vorogeo::resolve_thread_count(std::atoi(arguments[4]));
  const bool in_faces = std::atoi(arguments[5]) != 0;
  const auto landmarks = vorogeo::landmarks_of(index, std::atoi(arguments[6]), threads);
  std::vector<std::unique_ptr<vorogeo::PathQuery>> queries(threads);
  std::mutex output;
  vorogeo::parallel_for(sources, threads, {}, "", [&](std::size_t item, int worker) {
    if (!queries[worker]) queries[worker] = std::make_unique<vorogeo::PathQuery>(index);
    vorogeo::PathQuery& query = *queries[worker];
    Draw draw(*mesh, in_faces, item + 1);
    const vorogeo::ExactSource source{draw.any()};
    vorogeo::ExactSolver solver(mesh);
    vorogeo::ExactLimits limits;
    limits.distances_only = !in_faces;
    solver.run(std::span(&source, 1), limits);
    for (long i = 0; i < targets; ++i) {
      const SurfacePoint target = draw.connected_to(source.point);
      vorogeo::SurfacePath refined;
      vorogeo::ExactPath exact;
      const double refined_seconds = thread_seconds([&] { refined = query.path(source.point, target); });
      const double exact_seconds = thread_seconds([&] { exact = query.exact_path(source.point, target); });
      vorogeo::ExactPath quick;
      const double quick_seconds =
          thread_seconds([&] { quick = query.exact_path(source.point, target, false); });
      vorogeo::ExactPath prepared;
      const double prepared_seconds =
          thread_seconds([&] { prepared = query.exact_path(source.point, target, true, landmarks.get()); });
      const double field = target.is_vertex() ? solver.distance(target.vertex) : solver.distance(target);
      const std::lock_guard lock(output);
      std::printf("[%.17g, %.17g, %.17g, %d, %.9g, %.9g, %.17g, %.9g, %.17g, %.9g]\n", field, refined.length,
                  exact.path.length, exact.certified && prepared.certified ? 1 : 0, refined_seconds,
                  exact_seconds, quick.path.length, quick_seconds, prepared.path.length, prepared_seconds);
    }
  });
}

}  // namespace bench
