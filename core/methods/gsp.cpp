// Virtual sources handed from face to face, one for each face.
#include "exact/virtual_sources.h"
#include "methods/method_table.h"
#include "support/checkpoint.h"

namespace vorogeo {

namespace {

class VirtualSourceFields final : public GeodesicMethod {
 public:
  explicit VirtualSourceFields(const std::shared_ptr<const Mesh>& mesh) : runs_(mesh) {}

  std::vector<double> field(std::span<const Index> sources, const Progress& progress) override {
    const Watch watch(progress, "Virtual sources");
    std::vector<ExactSource> points;
    for (Index source : sources) points.push_back({SurfacePoint::at_vertex(source)});
    runs_.run(points);
    std::vector<double> distances(runs_.mesh().vertex_count());
    for (Index v = 0; v < runs_.mesh().vertex_count(); ++v) distances[v] = runs_.distance(v);
    return distances;
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
