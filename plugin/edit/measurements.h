// The paths that were measured, as a table and as lines of a layer.
#pragma once

#include <string>
#include <vector>

#include "layers/path_lines.h"
#include "mesh/mesh.h"

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

/// The measurements of a ruler, and their text. Lengths have seven digits, as in the log; files have
/// all digits. Numbers are written with a point in every language.
class Measurements {
 public:
  const std::vector<Measurement>& all() const { return all_; }

  /// Gives it the next number, which is returned.
  int add(Measurement measurement);
  /// \return false if there is no measurement of that number.
  bool remove(int number);
  /// The layer was edited: its measurements are kept, but say so.
  void mesh_has_changed(int layer);

  static std::vector<std::string> columns();
  static std::vector<std::string> row(const Measurement& measurement);
  /// With tabs, a line for each row, the first with the columns: what spreadsheets take from the clipboard.
  std::string table() const;
  /// With commas, all digits and the positions of both ends.
  std::string csv() const;
  /// Whether there is a path to save for this layer.
  bool has_path_on(int layer) const;
  /// All paths of a layer.
  PathLines lines_on(int layer) const;

 private:
  std::vector<Measurement> all_;
  int last_ = 0;
};

}  // namespace vorogeo::plugin
