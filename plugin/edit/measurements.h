// What was measured on a document: kinds and quantities, units, text for the table, the clipboard and files,
// and the paths as lines of a layer.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "layers/layer_surface.h"
#include "layers/path_lines.h"
#include "mesh/fingerprint.h"
#include "mesh/mesh.h"
#include "mesh/vcg_adapter.h"

namespace vorogeo::plugin {

// ---- Kinds of measurements, their quantities and units

enum class MeasureKind : std::uint8_t { distance, path, polygon, loop, tape, disk, angle };

/// By kind: its name, how it is measured, and how many points it has at least.
struct KindOfMeasure {
  const char* name;
  const char* hint;
  std::size_t least_points;
};
inline constexpr std::array<KindOfMeasure, 7> kinds{
    {{"distance", "Drag on the surface from one point to another: the shortest path.", 2},
     {"path", "Click on points: the path through them. Double click or Enter ends it.", 2},
     {"polygon", "Click on corners: area and perimeter. Double click or Enter ends it.", 3},
     {"loop", "Drag on the surface: the shortest loop there that cannot be contracted.", 1},
     {"tape", "Drag on a limb: the tape measure round it at the cursor.", 1},
     {"disk", "Drag on the surface from the centre of a disk to its border.", 2},
     {"angle", "Click on three points: the angle at the second one.", 3}}};
inline const char* name_of(MeasureKind kind) { return kinds[static_cast<std::size_t>(kind)].name; }
inline std::size_t least_points(MeasureKind kind) {
  return kinds[static_cast<std::size_t>(kind)].least_points;
}
/// Whether points are clicked one after the other until an end, not dragged.
inline bool takes_clicks(MeasureKind kind) {
  return kind == MeasureKind::path || kind == MeasureKind::polygon || kind == MeasureKind::angle;
}

enum class Quantity : std::uint8_t {
  length,
  straight,
  ratio,
  area,
  perimeter,
  tape,
  section,
  loop,
  radius,
  border,
  angle  ///< in degrees
};
inline constexpr std::array<const char*, 11> quantity_names{"length",    "straight", "ratio",   "area",
                                                            "perimeter", "tape",     "section", "loop",
                                                            "radius",    "border",   "angle"};

struct Value {
  Quantity what;
  double value;

  friend bool operator==(const Value&, const Value&) = default;
};

/// The unit of the document's coordinates. Values are not converted.
enum class LengthUnit : std::uint8_t { model, mm, cm, m, inch };
inline constexpr std::array<const char*, 5> unit_names{"model", "mm", "cm", "m", "inch"};
/// Such as "mm" or its square; empty for a ratio.
std::string unit_of(Quantity quantity, LengthUnit unit);

/// What paths cost and which gaps they cross, as in the parameters of the filters.
struct RulerMetric {
  LayerMetric metric = LayerMetric::length;
  double weight = 0.0;  ///< slope_penalty or curvature_weight; 0 in other metrics
  double gap = 0.0;

  bool has_weight() const { return metric == LayerMetric::slope || metric == LayerMetric::curvature; }
  bool is_of_quality() const {
    return metric == LayerMetric::vertex_quality || metric == LayerMetric::face_quality;
  }
  friend bool operator==(const RulerMetric&, const RulerMetric&) = default;
};
/// Such as "slope penalty 1, gap 0.5"; empty for lengths on the mesh as it is.
std::string name_of(const RulerMetric& metric);

// ---- Measurements

struct Measurement {
  int number = 0;  ///< from 1; never reused
  std::string name;
  MeasureKind kind = MeasureKind::distance;
  int layer = 0;  ///< the host's number of the layer; -1 if the document has none
  std::string layer_name;
  std::vector<Value> values;  ///< the first is what was asked for: `unreachable` without a path
  std::vector<Point> points;  ///< on the surface, by which it is measured again
  std::string method;         ///< "exact"; "refined" in files of earlier versions
  PathLines path;             ///< without points if there is none
  RulerMetric metric{};
  Fingerprint mesh{};  ///< of the mesh on which it was taken
  bool is_hidden = false;
  bool is_of_another_mesh = false;  ///< the layer was edited since

  /// Whether it was imported and not measured since.
  bool lacks_lines() const {
    return path.lines.points.empty() && !values.empty() && std::isfinite(values.front().value);
  }
};

/// The measurements of a document, which all its views show, and their text. What is shown has four digits;
/// files have all digits. Numbers are written with a point in every language. All functions are called from
/// one thread.
class Measurements {
 public:
  const std::vector<Measurement>& all() const { return all_; }
  /// Null if there is none.
  const Measurement* find(int number) const;
  LengthUnit unit() const { return unit_; }
  /// Grows with every change.
  int revision() const { return revision_; }

  /// Adds it under the next number, and names it by that if it has no name. `mesh`: on which it was taken.
  const Measurement& add(Measurement measurement, const VcgMeshArrays& mesh);
  /// The same measured again: number, name and whether it is hidden stay. If it was imported and only gets
  /// its lines, undo() skips that. \return null if it is gone.
  const Measurement* replace(int number, Measurement measurement, const VcgMeshArrays& mesh);
  void remove(const std::vector<int>& numbers);
  void rename(int number, const std::string& name);
  void hide(int number, bool is_hidden);
  void set_unit(LengthUnit unit);
  /// Takes back the last of these changes, except of the unit.
  void undo();
  /// The mesh of a layer as it is now, in a metric; null where it has none. compare() keeps measurements of
  /// another mesh, but marks them.
  using MeshIn = std::function<const VcgMeshArrays*(const RulerMetric&)>;
  void compare(int layer, const MeshIn& mesh_in);
  /// `changed` is called now and after every change, until unwatch(who).
  void watch(const void* who, std::function<void()> changed);
  void unwatch(const void* who) { watchers_.erase(who); }

  static std::vector<std::string> columns();
  std::vector<std::string> row(const Measurement& measurement) const;
  /// The first value, as it stands beside the path: four digits, or all of its whole part, and its unit.
  std::string label(const Measurement& measurement) const;
  static std::string four_digits(double value);
  /// Tab-separated rows, the first with the columns: what spreadsheets take from the clipboard.
  std::string table() const;
  /// The number of a layer, -1 if there is none of that name.
  using LayerOf = std::function<int(const std::string& name)>;
  /// Comma-separated, with all digits: a column for each quantity, and the points.
  std::string csv() const { return written(false); }
  /// Adds what csv() wrote, without lines. \throw InvalidInput for anything else, also for a unit other than
  /// that of the present measurements (names the line); nothing is changed then.
  void add_csv(const std::string& text, const LayerOf& layer_of) { take(text, false, layer_of); }

  /// Everything, to be read again: csv() with more columns.
  std::string text() const { return written(true); }
  /// Replaces everything by what text() wrote. \throw InvalidInput as add_csv().
  void read(const std::string& text, const LayerOf& layer_of) { take(text, true, layer_of); }

 private:
  std::string written(bool whole) const;
  void take(const std::string& text, bool whole, const LayerOf& layer_of);
  Measurement* own(int number);
  void remember();
  void tell();

  std::vector<Measurement> all_;
  std::vector<std::vector<Measurement>> undo_states_;  ///< for undo(): earlier states, the latest last
  LengthUnit unit_ = LengthUnit::model;
  int last_ = 0;
  int revision_ = 0;
  std::map<const void*, std::function<void()>> watchers_;
};

}  // namespace vorogeo::plugin
