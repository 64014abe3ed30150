// The saddle vertex graph: arcs to the nearest vertices that a geodesic reaches without passing a vertex.
#include "methods/graph_method.h"
#include "methods/method_table.h"

namespace vorogeo {

// Section 3 of the paper: a shortest path is a chain of direct geodesics between saddle vertices. Section 5:
// each vertex keeps the K nearest of its direct geodesics, which bounds the graph and makes long ones
// polylines over vertices.
MethodEntry svg_entry() {
  return {
      {"svg",
       "Saddle vertex graph (SVG)",
       "X. Ying, X. Wang, Y. He: Saddle vertex graph (SVG): a novel solution to the discrete geodesic "
       "problem. ACM "
       "Transactions on Graphics 32(6), 2013",
       {{"K", 50.0, 3.0, 10000.0, true, "direct geodesics that each vertex keeps"}},
       {"MSAD, SSSD", "graph of K n arcs", "never too short; falls with K", "any on arcs",
        "set-up K^2 log K n, field K n log n"},
       false,
       true},
      [](const std::shared_ptr<const Mesh>& mesh, const MethodOptions& options, const Progress& progress) {
        TreeRules rules;
        rules.bends = false;
        rules.max_vertices = static_cast<Index>(options.at("K"));
        return direct_geodesics(mesh, rules, progress);
      },
      {}};
}

}  // namespace vorogeo
