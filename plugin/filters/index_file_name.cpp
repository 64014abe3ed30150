// Reads and checks names of index files.
#include "filters/index_file_name.h"

#include <QFile>

#include "support/file.h"

namespace vorogeo::plugin {

namespace fs = std::filesystem;

fs::path index_file_name(const QString& name) { return QFile::encodeName(name).toStdString(); }

void check_index_file_can_be_written(const fs::path& file) {
  if (file.empty()) throw IndexFileError("No index file is named. Name one that ends in .vgi.");
  output_target(file, "The index file");
}

}  // namespace vorogeo::plugin
