// The index: built once per mesh, immutable, shared by threads and queries.
#pragma once

#include <filesystem>
#include <memory>
#include <span>

#include "index/index_options.h"
#include "mesh/fingerprint.h"
#include "mesh/mesh.h"
#include "support/progress.h"

namespace vorogeo {

struct IndexData;

/// Where a loaded index has its large tables: in the file, whose pages all processes that load it share, or
/// in memory of its own.
enum class TableStorage { mapped, copied };

/// Two layers of geodesic Voronoi patches with their tables, and the transit table or a graph between them.
class GeodesicIndex {
 public:
  /// Builds the index of a mesh. \throw InvalidInput (no face, delta, patch counts or budget out of range,
  /// edges longer than 1e28 or shorter than 1e-28 in the mean; a budget that is too small for either form,
  /// naming the least that would do), Cancelled.
  static std::shared_ptr<const GeodesicIndex> build(std::shared_ptr<const Mesh> mesh,
                                                    const IndexOptions& options = {},
                                                    const Progress& progress = {});

  /// The index of a mesh in a file, to which its tables are written as they are filled, and from which they
  /// are read: their memory is that of the system's file cache, and the memory budget does not count them. If
  /// the file has the index of this mesh, it is loaded. If an earlier build was stopped, by whatever, this
  /// one goes on from the parts that it filled; until a build ends they are in NAME.unfinished. The file
  /// equals one that save() writes, to the last bit.
  ///
  /// \throw as build(), and IndexFileError if the file cannot be written, or if it or the unfinished one is
  /// of another mesh or has other options.
  static std::shared_ptr<const GeodesicIndex> build_in_file(const std::filesystem::path& file,
                                                            std::shared_ptr<const Mesh> mesh,
                                                            const IndexOptions& options = {},
                                                            const Progress& progress = {});

  /// Writes the index (not the mesh) to a file, which appears complete or not at all.
  /// \throw IndexFileError if it cannot be written.
  void save(const std::filesystem::path& file) const;
  /// Reads an index and ties it to its mesh. \throw IndexFileError if the file is missing, damaged, of
  /// another version, or was built for a mesh with another fingerprint.
  ///
  /// A mapped file may be removed or replaced by another, but not written to or cut in place (MappedFile).
  static std::shared_ptr<const GeodesicIndex> load(const std::filesystem::path& file,
                                                   std::shared_ptr<const Mesh> mesh,
                                                   TableStorage storage = TableStorage::mapped);

  const std::shared_ptr<const Mesh>& mesh() const;
  const Fingerprint& fingerprint() const;
  const IndexStatistics& statistics() const;
  /// Patch of each face of mesh(), numbered from 0, in layer 1 or 2. \throw InvalidInput for another layer.
  std::span<const Index> face_patches(int layer) const;

  const IndexData& data() const { return *data_; }

  explicit GeodesicIndex(std::unique_ptr<IndexData> data);
  ~GeodesicIndex();

 private:
  std::unique_ptr<IndexData> data_;
};

}  // namespace vorogeo
