// The algorithms of Chen and Han, and of Xin and Wang, as methods.
#include <cmath>
#include <sstream>

#include "methods/method_table.h"
#include "methods/window_tree.h"
#include "support/checkpoint.h"

namespace vorogeo {

namespace {

/// Windows that take about a minute without order and filter.
constexpr double windows_to_warn = 3e8;

class ChenHan final : public GeodesicMethod {
 public:
  ChenHan(const std::shared_ptr<const Mesh>& mesh, bool ordered, bool filtered)
      : mesh_(mesh), tree_(std::make_shared<const ExactGeometry>(mesh)) {
    rules_.ordered = ordered;
    rules_.filtered = filtered;
  }
  std::vector<double> field(std::span<const Index> sources, const Progress& progress) override {
    const Watch watch(progress, "Windows as a tree");
    tree_.run(sources, rules_);
    std::vector<double> distances(mesh_->vertex_count());
    for (Index v = 0; v < mesh_->vertex_count(); ++v) distances[v] = tree_.distance(v);
    return distances;
  }
  std::size_t bytes() const override { return tree_.bytes(); }

 private:
  std::shared_ptr<const Mesh> mesh_;
  WindowTree tree_;
  TreeRules rules_;
};

}  // namespace

MethodEntry ch_entry() {
  return {{"ch",
           "Window tree (CH)",
           "J. Chen, Y. Han: Shortest paths on a polyhedron. Symposium on Computational Geometry 1990",
           {},
           {"MSAD", "none", "exact", "none", "field n^2"},
           true,
           false},
          [](const std::shared_ptr<const Mesh>& mesh, const MethodOptions&, const Progress&) {
            return std::make_unique<ChenHan>(mesh, false, false);
          },
          [](const Mesh& mesh) -> std::string {
            const double windows = static_cast<double>(mesh.face_count()) * mesh.face_count();
            if (windows < windows_to_warn) return "";
            std::ostringstream text;
            text.precision(2);
            text << "The method ch makes up to " << windows << " windows on this mesh of "
                 << mesh.face_count()
                 << " faces, for minutes to days. The methods ich and mmp give the same distances sooner.";
            return text.str();
          }};
}

MethodEntry ich_entry() {
  return {
      {"ich",
       "Window tree, ordered and filtered (ICH)",
       "S.-Q. Xin, G.-J. Wang: Improving Chen and Han's algorithm on the discrete geodesic problem. ACM "
       "Transactions on Graphics 28(4), 2009",
       {{"order", 1.0, 0.0, 1.0, true, "1: the nearest window is handed on first; 0: in order of arrival"},
        {"filter", 1.0, 0.0, 1.0, true, "1: windows that a vertex overtakes are dropped"}},
       {"MSAD", "none", "exact", "none", "field n^2 log n at most"},
       true,
       false},
      [](const std::shared_ptr<const Mesh>& mesh, const MethodOptions& options, const Progress&) {
        return std::make_unique<ChenHan>(mesh, options.at("order") != 0.0, options.at("filter") != 0.0);
      },
      {}};
}

}  // namespace vorogeo
