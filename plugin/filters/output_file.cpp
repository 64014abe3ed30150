// Reads matrix_file.
#include "filters/output_file.h"

#include <QFile>

#include "support/file.h"

namespace vorogeo::plugin {

RichFileToWrite output_file_parameter() {
  return RichFileToWrite("matrix_file", "", "*.npy", "File",
                         "File to write to, in the format of numpy. Empty: nothing is written.");
}

std::filesystem::path output_file(const FilterCall& call) {
  const std::filesystem::path file =
      QFile::encodeName(call.parameters.getSaveFileName("matrix_file")).toStdString();
  if (!file.empty()) output_target(file, "The file");
  return file;
}

}  // namespace vorogeo::plugin
