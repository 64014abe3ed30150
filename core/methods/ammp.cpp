// Continuous Dijkstra with neighbouring windows merged under a tolerance.
#include "methods/method_table.h"
#include "methods/window_runs.h"

namespace vorogeo {

// After section 4 of the paper: two neighbouring windows are replaced by one whose distances at the outer
// ends are theirs and whose rays reach no less far, where it deviates from them by no more than the
// tolerance. The tolerance is a length for each edge that is crossed (core/exact/window_merging.cpp), so that
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

}  // namespace vorogeo
