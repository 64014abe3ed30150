// Exact distances by continuous Dijkstra (core/exact).
#include "methods/method_table.h"
#include "methods/window_runs.h"

namespace vorogeo {

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

}  // namespace vorogeo
