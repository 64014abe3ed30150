// The discrete geodesic graph: arcs along direct geodesics, as few as an expected error allows.
#include "methods/graph_method.h"
#include "methods/method_table.h"

namespace vorogeo {

// Windows end, and vertices get no arc, where a detour over a vertex beside them is good enough: detours.cpp.
MethodEntry dgg_entry() {
  return {
      {"dgg",
       "Discrete geodesic graph (fast DGG)",
       "Y. Y. Adikusuma, Z. Fang, Y. He: Fast construction of discrete geodesic graphs. ACM Transactions on "
       "Graphics "
       "39(2), 2020",
       {{"epsilon", 0.001, 1e-6, 0.1, false, "expected relative error"}},
       {"MSAD, SSSD", "graph of n / sqrt(epsilon) arcs", "expected error epsilon", "any on arcs",
        "set-up n / epsilon^0.75, field n / sqrt(epsilon)"},
       false,
       true},
      [](const std::shared_ptr<const Mesh>& mesh, const MethodOptions& options, const Progress& progress) {
        TreeRules rules;
        rules.bends = false;
        rules.epsilon = options.at("epsilon");
        return direct_geodesics(mesh, rules, progress);
      },
      {}};
}

}  // namespace vorogeo
