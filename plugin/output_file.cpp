// Reads matrix_file.
#include "output_file.h"

#include <QFile>

#include "support/error.h"

namespace vorogeo::plugin {

RichFileToWrite output_file_parameter() {
  return RichFileToWrite("matrix_file", "", "*.npy", "File",
                         "File to write to, in the format of numpy. Empty: nothing is written.");
}

std::filesystem::path output_file(const FilterCall& call) {
  const std::filesystem::path file =
      QFile::encodeName(call.parameters.getSaveFileName("matrix_file")).toStdString();
  const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  std::error_code error;
  if (!file.empty() && !std::filesystem::is_directory(folder, error)) {
    throw InvalidInput("The file " + file.string() + " cannot be written: there is no folder " +
                       folder.string() + ". Create it or name another file.");
  }
  return file;
}

}  // namespace vorogeo::plugin
