// The file of an index while it is built: its tables where they will be in the end, and behind them what
// tells which are filled.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "index/index_data.h"
#include "index/table_room.h"
#include "index/transit_table.h"
#include "support/resumable_file.h"

namespace vorogeo {

/// Where the tables of an index are filled.
struct TableRooms {
  TableRoom second;
  TableRoom first;
  TransitRoom transit;
};

/// Rooms in memory for an index that is laid out.
TableRooms rooms_in_memory(const IndexData& data, IndexForm form);

/// Until it is finished the file is called NAME.unfinished and is no index file: it begins with a head of its
/// own, which names the mesh and the options. A build that is stopped, be it by kill -9, leaves it for the
/// next one with the same mesh and options, which keeps the parts whose checksums hold. All functions throw
/// IndexFileError if the file cannot be written.
class BuildFile {
 public:
  /// Opens what an earlier build has left, or makes a new file. \throw IndexFileError if that was of another
  /// mesh or other options, or another process is building it. `data`: with fingerprint, statistics and
  /// requested patches.
  BuildFile(const std::filesystem::path& file, const IndexData& data);

  /// Whether it is an index that is complete but for its name.
  bool is_complete() const { return is_complete_; }
  const std::filesystem::path& unfinished() const { return out_->unfinished(); }
  /// Cuts off what a complete file still has behind its end if the build was stopped in its last step.
  void cut_leftovers();
  /// Gives a complete file its name.
  void put_in_place();
  /// Forgets what was there.
  void start_anew();

  /// Takes the space for an index that is laid out, and returns where its tables are filled. \throw
  /// IndexFileError also if the disk is too full, which leaves no file.
  TableRooms rooms(const IndexData& data, IndexForm form);
  /// Writes what is not in the file yet, and puts it in its place.
  void finish(const IndexData& data);

 private:
  struct Head;
  struct Layout;

  Head head_of(const IndexData& data) const;
  [[noreturn]] void refuse(const char* what) const;

  std::filesystem::path file_;
  std::unique_ptr<ResumableFile> out_;
  bool is_complete_ = false;
  bool is_begun_ = false;  ///< space is taken, and parts may be filled
};

}  // namespace vorogeo
