// What is kept between calls goes into a Surface, and back after the answer.
#include "layers/surface_of_layer.h"

#include "host/ticking.h"
#include "layers/index_cache.h"
#include "layers/index_of_layer.h"
#include "layers/parameters.h"

namespace vorogeo::plugin {

namespace {

/// By AnswerMethod.
constexpr const char* answered_by[] = {"", "the index", "exact propagation", "virtual sources (quick)"};

}  // namespace

RichEnum method_parameter() {
  QStringList names;
  for (const AnswerMethod method :
       {AnswerMethod::automatic, AnswerMethod::index, AnswerMethod::exact, AnswerMethod::quick}) {
    names.append(to_string(method));
  }
  return RichEnum(
      "method", static_cast<int>(AnswerMethod::automatic), names, "Method",
      "automatic: the index if this mesh has one, else exact answers, until these have taken as long as "
      "building an index would; then it is built. index: builds it at once. exact: no errors, no "
      "index. quick: a field with errors of some tenths of a percent in a tenth of the time.");
}

AnswerMethod method_of(const FilterCall& call) {
  const int number = call.parameters.getEnum("method");
  if (number < 0 || number > static_cast<int>(AnswerMethod::quick)) {
    refuse(call, "method", number, ". Give automatic, index, exact or quick, or its number from 0 to 3.");
  }
  return static_cast<AnswerMethod>(number);
}

SurfaceOfLayer::SurfaceOfLayer(FilterCall& call, const LayerMesh& layer_mesh,
                               std::shared_ptr<const Mesh> mesh)
    : call_(call), layer_mesh_(layer_mesh) {
  auto index = call.indexes.find(layer_mesh.arrays(), layer_mesh.gap(), &call.document);
  had_index_ = index != nullptr;
  if (had_index_) {
    mesh = index->mesh();
  } else {
    log_warnings(call, layer_mesh);
    if (!mesh) mesh = read_mesh(call, layer_mesh);
  }
  const RentOrBuy spent = call.indexes.spent(fingerprint_of(*mesh), mesh->vertex_count());
  surface_ = std::make_unique<Surface>(mesh, std::move(index), spent);
}

Results SurfaceOfLayer::finish(const Answered& answered) {
  call_.indexes.keep_spent(fingerprint_of(*mesh()), surface_->spent());
  if (!answered.remark.empty()) call_.log(answered.remark);
  if (const auto index = surface_->index(); index && !had_index_) {
    log_statistics(call_, index->statistics());
    call_.indexes.put(layer_mesh_.arrays(), layer_mesh_.gap(), index, &call_.document);
  }
  Results results = {{"answered_by", static_cast<int>(answered.by)}};
  std::string line = std::string("Answered by ") + answered_by[static_cast<int>(answered.by)];
  if (answered.by == AnswerMethod::index) {
    if (had_index_) line += ": reused, the mesh has not changed since it was built";
    results["index_reused"] = had_index_;
    results["index_seconds"] = answered.index_seconds;
  }
  call_.log(line);
  return results;
}

}  // namespace vorogeo::plugin
