// This project's index as one of the methods.
#include "index/geodesic_index.h"
#include "methods/method.h"
#include "query/geodesic_query.h"

namespace vorogeo {

namespace {

class IndexFields final : public GeodesicMethod {
 public:
  explicit IndexFields(std::shared_ptr<const GeodesicIndex> index) : query_(std::move(index)) {}
  std::vector<double> field(std::span<const Index> sources, const Progress&) override {
    return query_.distance_field(sources);
  }
  double pair(Index source, Index target) override { return query_.distance(source, target); }
  std::size_t bytes() const override { return static_cast<std::size_t>(query_.index().statistics().bytes); }

 private:
  GeodesicQuery query_;
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
      [](const std::shared_ptr<const Mesh>& mesh, const MethodOptions&, const Progress& progress) {
        return std::make_unique<IndexFields>(GeodesicIndex::build(mesh, {}, progress));
      },
      {}};
}

}  // namespace vorogeo
