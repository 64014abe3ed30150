// Reads and checks names of index files.
#include "filters/index_file_name.h"

#include <QFile>
#include <system_error>

#include "support/error.h"

namespace vorogeo::plugin {

namespace fs = std::filesystem;

fs::path index_file_name(const QString& name) { return QFile::encodeName(name).toStdString(); }

void check_index_file_can_be_written(const fs::path& file) {
  if (file.empty()) throw IndexFileError("No index file is named. Name one that ends in .vgi.");
  std::error_code error;
  if (fs::is_directory(file, error)) {
    throw IndexFileError("The index file " + file.string() + " is a folder. Name a file in it.");
  }
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) {
    throw IndexFileError("The index file " + file.string() + " cannot be written: there is no folder " +
                         folder.string() + ". Create it or name another file.");
  }
}

}  // namespace vorogeo::plugin
