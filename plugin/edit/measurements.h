// The paths that were measured on a document, as a table and as lines of a layer.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "layers/path_lines.h"
#include "mesh/mesh.h"
#include "mesh/vcg_adapter.h"

namespace vorogeo::plugin {

/// A path that was drawn and kept.
struct Measurement {
  int number = 0;       ///< from 1; never used again
  int layer = 0;        ///< the host's number of the layer
  double length = 0.0;  ///< `unreachable` without a path
  Point from{};
  Point to{};
  std::string method;               ///< "exact" or "refined"
  PathLines path;                   ///< without points if there is none
  bool is_of_another_mesh = false;  ///< the layer was edited since

  double straight() const { return distance_between(from, to); }
};

/// The measurements of a document, which all its views show, and their text. Rows have seven digits, as the
/// log has; files have all digits. Numbers are written with a point in every language. All functions are
/// called from one thread.
class Measurements {
 public:
  const std::vector<Measurement>& all() const { return all_; }

  /// Gives it the next number, which is returned. `mesh`: on which it was taken.
  int add(Measurement measurement, const VcgMeshArrays& mesh);
  void remove(const std::vector<int>& numbers);
  /// The mesh of a layer as it is now: measurements of another one are kept, but say so.
  void compare(int layer, const VcgMeshArrays& mesh);
  /// `changed` is called now and after every change, until unwatch(who).
  void watch(const void* who, std::function<void()> changed);
  void unwatch(const void* who) { watchers_.erase(who); }

  static std::vector<std::string> columns();
  static std::vector<std::string> row(const Measurement& measurement);
  /// A length as it stands beside a path: four digits, and those of its whole part.
  static std::string label(double length);
  /// With tabs, a line for each row, the first with the columns: what spreadsheets take from the clipboard.
  std::string table() const;
  /// With commas, all digits and the positions of both ends.
  std::string csv() const;
  /// All paths of a layer.
  PathLines lines_on(int layer) const;

 private:
  void tell() const;

  std::vector<Measurement> all_;
  int last_ = 0;
  std::map<int, VcgMeshArrays> measured_;  ///< by layer, the mesh of its measurements
  std::map<const void*, std::function<void()>> watchers_;
};

}  // namespace vorogeo::plugin
