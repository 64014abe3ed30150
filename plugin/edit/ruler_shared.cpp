// One list for each document that still exists.
#include "edit/ruler_shared.h"

namespace vorogeo::plugin {

std::shared_ptr<DocumentMeasurements> RulerShared::measurements_of(MeshDocument& document) {
  std::erase_if(measurements_,
                [](const auto& entry) { return entry.first.isNull() || entry.second.expired(); });
  for (const auto& [known, list] : measurements_) {
    if (known == &document) return list.lock();
  }
  auto made = std::make_shared<DocumentMeasurements>();
  measurements_.emplace_back(&document, made);
  return made;
}

}  // namespace vorogeo::plugin
