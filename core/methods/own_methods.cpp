// The project's own solvers as methods: the index, the exact solver (MMP, AMMP), virtual sources (GSP).

#include "exact/exact_solver.h"
#include "index/geodesic_index.h"
#include "methods/method.h"
#include "methods/virtual_sources.h"
#include "query/surface.h"

namespace vorogeo {

// ---- The index

namespace {

class IndexFields final : public GeodesicMethod {
 public:
  IndexFields(const std::shared_ptr<const Mesh>& mesh, const MethodOptions&, const Progress& progress)
      : GeodesicMethod(mesh), surface_(GeodesicIndex::build(mesh, {}, progress)), query_(surface_) {}
  std::size_t bytes() const override {
    return static_cast<std::size_t>(surface_.index()->statistics().bytes);
  }

 private:
  std::vector<double> solve(std::span<const Index> sources, const Progress&) override {
    return query_.field(sources_at(sources), unreachable, Answer::index, surface_.threads());
  }
  double solve_pair(Index source, Index target) override {
    return query_.distance(SurfacePoint::at_vertex(source), SurfacePoint::at_vertex(target), Answer::index);
  }

  Surface surface_;
  Query query_;
};

}  // namespace

MethodEntry vorogeo_entry() {
  return {
      {"vorogeo",
       "VoroGeo",
       "R. Aiello, F. Banterle, N. Pietroni, L. Malomo, P. Cignoni, R. Scopigno: Compression and querying of "
       "arbitrary geodesic distances. ICIAP 2015",
       {},
       {"MSAD, SSSD", "index", "none; pairs in one patch exact", "arbitrary",
        "field about n, pair nearly constant"},
       false,
       true},
      prepared<IndexFields>};
}

// ---- Continuous Dijkstra: all windows exact, or neighbouring ones merged under a tolerance

namespace {

/// Runs of the exact solver for all vertices, or until one is final.
class WindowRuns final : public GeodesicMethod {
 public:
  WindowRuns(const std::shared_ptr<const Mesh>& mesh, const MethodOptions& options)
      : GeodesicMethod(mesh), solver_(mesh) {
    limits_.distances_only = true;
    if (const auto eps = options.find("eps"); eps != options.end()) limits_.merge_tolerance = eps->second;
  }
  std::size_t bytes() const override { return solver_.memory_bytes(); }

 private:
  std::vector<double> solve(std::span<const Index> sources, const Progress& progress) override {
    ExactLimits limits = limits_;
    limits.progress = &progress;
    solver_.run_from_vertices(sources, limits);
    return vertex_distances(mesh(), solver_);
  }
  double solve_pair(Index source, Index target) override {
    ExactLimits limits = limits_;
    limits.targets = {&target, 1};
    solver_.run_from_vertices({&source, 1}, limits);
    return solver_.distance(target);
  }

  ExactSolver solver_;
  ExactLimits limits_;
};

}  // namespace

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
      prepared<WindowRuns>};
}

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
          prepared<WindowRuns>};
}

// ---- Virtual sources handed from face to face, one for each face

namespace {

class VirtualSourceFields final : public GeodesicMethod {
 public:
  explicit VirtualSourceFields(const std::shared_ptr<const Mesh>& mesh)
      : GeodesicMethod(mesh, "Virtual sources"), runs_(mesh) {}
  std::size_t bytes() const override { return runs_.memory_bytes(); }

 private:
  std::vector<double> solve(std::span<const Index> sources, const Progress&) override {
    runs_.run(sources);
    return vertex_distances(mesh(), runs_);
  }

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
          prepared<VirtualSourceFields>};
}

}  // namespace vorogeo
