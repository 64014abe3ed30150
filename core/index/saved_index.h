// What an index file holds, in the order of its blocks.
#pragma once

#include "index/index_data.h"
#include "index/index_file.h"

namespace vorogeo {

/// Writes all blocks of an index.
void write_index(IndexFileWriter& out, const IndexData& data);

/// Where the index in a file ends, by the sizes of its blocks alone. \throw IndexFileError if there is none.
std::uint64_t end_of_index(const std::filesystem::path& file);

/// Fills in the statistics of an index whose large tables lie in a file.
void note_mapped_bytes(IndexData& data);

}  // namespace vorogeo
