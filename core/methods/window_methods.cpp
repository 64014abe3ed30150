// Exact and nearly exact methods that run our own solver: MMP, AMMP, GSP.
#include "methods/window_methods.h"

#include <array>

#include "exact/virtual_sources.h"
#include "methods/method.h"
#include "support/progress.h"

namespace vorogeo {

// ---- Runs of the exact solver for all vertices, or until one is final

std::vector<double> WindowRuns::field(std::span<const Index> sources, const Progress& progress) {
  ExactLimits limits;
  limits.merge_tolerance = merge_tolerance_;
  limits.distances_only = true;
  limits.progress = &progress;
  solver_.run_from_vertices(sources, limits);
  return vertex_distances(solver_.mesh(), solver_);
}

double WindowRuns::pair(Index source, Index target) {
  const std::array targets{target};
  ExactLimits limits;
  limits.merge_tolerance = merge_tolerance_;
  limits.distances_only = true;
  limits.targets = targets;
  solver_.run_from_vertices({&source, 1}, limits);
  return solver_.distance(target);
}

// ---- Exact distances by continuous Dijkstra (core/exact)

MethodEntry mmp_entry() {
  return {
      {"mmp",
       "Exact (MMP)",
       "J. S. B. Mitchell, D. M. Mount, C. H. Papadimitriou: The discrete geodesic problem. SIAM Journal on "
       "Computing 16(4), 1987; V. Surazhsky et al.: Fast exact and approximate geodesics on meshes. "
       "SIGGRAPH 2005",
       {},
       {"MSAD, SSSD", "none", "exact", "none", "field n^2 log n at most"},
       true,
       true},
      [](const std::shared_ptr<const Mesh>& mesh, const MethodOptions&, const Progress&) {
        return std::make_unique<WindowRuns>(mesh, 0.0);
      },
      {}};
}

// ---- Continuous Dijkstra with neighbouring windows merged under a tolerance

// After section 4 of the paper: two neighbouring windows are replaced by one whose distances at the outer
// ends are theirs and whose rays reach no less far, where it deviates from them by no more than the
// tolerance. The tolerance is a length for each edge that is crossed (core/exact/solver_state.cpp), so that
// a path across k edges is off by no more than k times eps times the typical edge.
MethodEntry ammp_entry() {
  return {{"ammp",
           "Windows merged under a tolerance (AMMP)",
           "V. Surazhsky, T. Surazhsky, D. Kirsanov, S. J. Gortler, H. Hoppe: Fast exact and approximate "
           "geodesics "
           "on meshes. SIGGRAPH 2005, section 4",
           {{"eps", 3e-4, 0.0, 0.1, false,
             "deviation allowed for each edge that a path crosses, in typical edge lengths; 0: exact"}},
           {"MSAD, SSSD", "none", "eps edges for each edge crossed", "none", "field about n log n"},
           false,
           true},
          [](const std::shared_ptr<const Mesh>& mesh, const MethodOptions& options, const Progress&) {
            return std::make_unique<WindowRuns>(mesh, options.at("eps"));
          },
          {}};
}

// ---- Virtual sources handed from face to face, one for each face

namespace {

class VirtualSourceFields final : public GeodesicMethod {
 public:
  explicit VirtualSourceFields(const std::shared_ptr<const Mesh>& mesh) : runs_(mesh) {}

  std::vector<double> field(std::span<const Index> sources, const Progress& progress) override {
    const Watch watch(progress, "Virtual sources");
    std::vector<ExactSource> points;
    for (Index source : sources) points.push_back({SurfacePoint::at_vertex(source)});
    runs_.run(points);
    return vertex_distances(runs_.mesh(), runs_);
  }
  std::size_t bytes() const override { return runs_.memory_bytes(); }

 private:
  VirtualSources runs_;
};

}  // namespace

MethodEntry gsp_entry() {
  return {{"gsp",
           "Virtual sources (GSP)",
           "P. Trettner, D. Bommes, L. Kobbelt: Geodesic distance computation via virtual source "
           "propagation. Computer "
           "Graphics Forum 40(5), 2021",
           {},
           {"MSAD", "none", "none", "none", "field about n"},
           false,
           false},
          [](const std::shared_ptr<const Mesh>& mesh, const MethodOptions&, const Progress&) {
            return std::make_unique<VirtualSourceFields>(mesh);
          },
          {}};
}

}  // namespace vorogeo
