// Text for the dock, the clipboard and files, and back from files.
#include "edit/measurements.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>
#include <utility>

#include "support/error.h"

namespace vorogeo::plugin {

namespace {

constexpr const char* no_path = "no path";
constexpr int digits_shown = 4;
constexpr int digits_of_whole_part = 15;
constexpr int all_digits = std::numeric_limits<double>::max_digits10;
constexpr std::size_t most_undone = 50;

std::string number_with(int digits, double value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(digits) << value;
  return text.str();
}

/// As a cell of a CSV file, in quotes where it needs them.
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (char letter : text) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + '"';
}

/// Line ends would end a line of the file.
std::string on_one_line(std::string text) {
  std::ranges::replace_if(
      text, [](char letter) { return letter == '\n' || letter == '\r'; }, ' ');
  return text;
}

template <std::size_t Count>
std::size_t position_in(const std::array<const char*, Count>& names, const std::string& name) {
  return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
}

/// The fingerprint of a mesh and, where quality is the cost, of the side lengths that it gives.
Fingerprint fingerprint_in(const RulerMetric& metric, const VcgMeshArrays& mesh) {
  Fingerprint found = fingerprint_of(mesh.positions, mesh.faces);
  if (metric.is_of_quality()) {
    const Fingerprint sides = fingerprint_of(mesh.metric.sides, {});
    for (std::size_t i = 0; i < found.words.size(); ++i) found.words[i] ^= sides.words[i];
  }
  return found;
}

}  // namespace

std::string unit_of(Quantity quantity, LengthUnit unit) {
  if (quantity == Quantity::ratio) return {};
  if (quantity == Quantity::angle) return "°";
  return std::string(unit_names[static_cast<std::size_t>(unit)]) + (quantity == Quantity::area ? "²" : "");
}

std::string name_of(const RulerMetric& metric) {
  std::string text;
  if (metric.metric != LayerMetric::length) {
    text = ruler_metrics[static_cast<std::size_t>(metric.metric)];
    text[0] = static_cast<char>(std::tolower(text[0]));
  }
  if (metric.has_weight()) text += ' ' + number_with(digits_shown, metric.weight);
  if (metric.gap > 0.0) text += (text.empty() ? "gap " : ", gap ") + number_with(digits_shown, metric.gap);
  return text;
}

// ---- Changes

const Measurement* Measurements::find(int number) const {
  const auto found = std::ranges::find(all_, number, &Measurement::number);
  return found == all_.end() ? nullptr : &*found;
}

Measurement* Measurements::own(int number) {
  const auto found = std::ranges::find(all_, number, &Measurement::number);
  return found == all_.end() ? nullptr : &*found;
}

const Measurement& Measurements::add(Measurement measurement, const VcgMeshArrays& mesh) {
  remember();
  measurement.number = ++last_;
  measurement.mesh = fingerprint_in(measurement.metric, mesh);
  if (measurement.name.empty()) {
    measurement.name = std::string(name_of(measurement.kind)) + ' ' + std::to_string(last_);
  }
  all_.push_back(std::move(measurement));
  tell();
  return all_.back();
}

const Measurement* Measurements::replace(int number, Measurement measurement, const VcgMeshArrays& mesh) {
  Measurement* const old = own(number);
  if (old == nullptr) return nullptr;
  if (!old->lacks_lines()) remember();
  measurement.number = number;
  measurement.name = old->name;
  measurement.is_hidden = old->is_hidden;
  measurement.mesh = fingerprint_in(measurement.metric, mesh);
  *old = std::move(measurement);
  tell();
  return old;
}

void Measurements::remove(const std::vector<int>& numbers) {
  const auto is_named = [&](const Measurement& m) { return std::ranges::count(numbers, m.number) > 0; };
  if (std::ranges::none_of(all_, is_named)) return;
  remember();
  std::erase_if(all_, is_named);
  tell();
}

void Measurements::rename(int number, const std::string& name) {
  Measurement* const measurement = own(number);
  if (measurement == nullptr) return;
  if (!name.empty() && name != measurement->name) {
    remember();
    measurement->name = on_one_line(name);
  }
  tell();  // also where the name is refused, as the table shows it
}

void Measurements::hide(int number, bool is_hidden) {
  Measurement* const measurement = own(number);
  if (measurement == nullptr || measurement->is_hidden == is_hidden) return;
  remember();
  measurement->is_hidden = is_hidden;
  tell();
}

void Measurements::set_unit(LengthUnit unit) {
  if (unit == unit_) return;
  unit_ = unit;
  tell();
}

void Measurements::remember() {
  undo_states_.push_back(all_);
  if (undo_states_.size() > most_undone) undo_states_.erase(undo_states_.begin());
}

void Measurements::undo() {
  if (undo_states_.empty()) return;
  all_ = std::move(undo_states_.back());
  undo_states_.pop_back();
  tell();
}

void Measurements::compare(int layer, const MeshIn& mesh_in) {
  std::vector<std::pair<RulerMetric, std::optional<Fingerprint>>> known;
  const auto now_in = [&](const RulerMetric& wanted) {
    // Only a metric of quality changes the fingerprint.
    const RulerMetric metric = wanted.is_of_quality() ? wanted : RulerMetric{};
    for (const auto& [other, fingerprint] : known) {
      if (other == metric) return fingerprint;
    }
    const VcgMeshArrays* const mesh = mesh_in(metric);
    known.emplace_back(metric, std::nullopt);
    if (mesh != nullptr) known.back().second = fingerprint_in(metric, *mesh);
    return known.back().second;
  };
  bool has_changed = false;
  for (Measurement& measurement : all_) {
    if (measurement.layer != layer) continue;
    const bool is_of_another_mesh = now_in(measurement.metric) != measurement.mesh;
    has_changed = has_changed || is_of_another_mesh != measurement.is_of_another_mesh;
    measurement.is_of_another_mesh = is_of_another_mesh;
  }
  if (has_changed) tell();
}

void Measurements::watch(const void* who, std::function<void()> changed) {
  watchers_[who] = changed;
  changed();
}

void Measurements::tell() {
  ++revision_;
  for (const auto& [who, changed] : watchers_) changed();
}

// ---- The table, its text, and lines

std::vector<std::string> Measurements::columns() {
  return {"No.", "Name", "Kind", "Value", "Unit", "Details"};
}

std::string Measurements::four_digits(double value) {
  if (!std::isfinite(value)) return no_path;
  int digits = digits_shown;
  for (double limit = 1e4; value >= limit - 0.5 && digits < digits_of_whole_part; limit *= 10.0) ++digits;
  return number_with(digits, value);
}

std::string Measurements::label(const Measurement& m) const {
  if (m.values.empty()) return {};
  const auto& [what, value] = m.values.front();
  const std::string unit = unit_of(what, unit_);
  const bool has_unit = std::isfinite(value) && (what == Quantity::angle || unit_ != LengthUnit::model);
  const std::string metric = name_of(m.metric);
  return four_digits(value) +
         (!has_unit                 ? ""
          : what == Quantity::angle ? unit
                                    : ' ' + unit) +
         (metric.empty() ? "" : ", " + metric);
}

std::vector<std::string> Measurements::row(const Measurement& m) const {
  std::string details;
  for (std::size_t i = 1; i < m.values.size(); ++i) {
    if (!std::isfinite(m.values[i].value)) continue;
    details += std::string(i > 1 ? ", " : "") + quantity_names[static_cast<std::size_t>(m.values[i].what)] +
               ' ' + four_digits(m.values[i].value);
  }
  for (const std::string& more : {name_of(m.metric), m.method}) {
    if (!more.empty()) details += (details.empty() ? "" : "; ") + more;
  }
  if (m.is_of_another_mesh) details += ", before an edit";
  const bool has_value = !m.values.empty();
  return {std::to_string(m.number),
          m.name,
          name_of(m.kind),
          has_value ? four_digits(m.values.front().value) : "",
          has_value ? unit_of(m.values.front().what, unit_) : "",
          details};
}

std::string Measurements::table() const {
  std::string text;
  auto add_line = [&text](const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) text += (i == 0 ? "" : "\t") + cells[i];
    text += '\n';
  };
  add_line(columns());
  for (const Measurement& measurement : all_) add_line(row(measurement));
  return text;
}

std::string Measurements::written(bool whole) const {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(all_digits) << "number,name,kind,layer,unit,metric,weight,gap,method";
  if (!whole) text << ",edited_since";  // which compare() finds again
  for (const char* name : quantity_names) text << ',' << name;
  text << ",points,mesh" << (whole ? ",hidden,last,vertices,segments" : "") << '\n';
  for (const Measurement& m : all_) {
    text << m.number << ',' << cell(m.name) << ',' << name_of(m.kind) << ',' << cell(m.layer_name) << ','
         << unit_names[static_cast<std::size_t>(unit_)] << ','
         << ruler_metrics[static_cast<std::size_t>(m.metric.metric)] << ',' << m.metric.weight << ','
         << m.metric.gap << ',' << m.method;
    if (!whole) text << ',' << m.is_of_another_mesh;
    for (std::size_t quantity = 0; quantity < quantity_names.size(); ++quantity) {
      text << ',';
      for (const Value& v : m.values) {
        if (static_cast<std::size_t>(v.what) == quantity) text << v.value;
      }
    }
    text << ',';
    for (const auto& point : m.points) {
      text << (&point == m.points.data() ? "" : ";") << point[0] << ' ' << point[1] << ' ' << point[2];
    }
    text << ',' << m.mesh.words[0] << ' ' << m.mesh.words[1];
    if (whole) {
      text << ',' << m.is_hidden << ',' << last_ << ',';
      for (std::size_t i = 0; i < m.path.lines.points.size(); ++i) {
        const auto& [x, y, z] = m.path.lines.points[i];
        text << (i == 0 ? "" : ";") << x << ' ' << y << ' ' << z << ' ' << m.path.along[i];
      }
      text << ',';
      for (const auto& ends : m.path.lines.segments) {
        text << (&ends == m.path.lines.segments.data() ? "" : ";") << ends[0] << ' ' << ends[1];
      }
    }
    text << '\n';
  }
  return text.str();
}

// ---- Reads what was written, in columns of any order

namespace {

/// Reads the words of a line one by one; a missing word or one that is no number makes the line a bad one.
class Words {
 public:
  explicit Words(const std::string& line) : stream_(line) {}

  std::string word() {
    std::string next;
    is_good_ = static_cast<bool>(stream_ >> next) && is_good_;
    return next;
  }
  template <class Number>
  Number number() {
    const std::string next = word();
    Number value{};
    const auto [end, error] = std::from_chars(next.data(), next.data() + next.size(), value);
    is_good_ = is_good_ && error == std::errc() && end == next.data() + next.size();
    return value;
  }
  /// By a stream, which knows no infinity: in libstdc++ 10, `std::from_chars` reads no doubles.
  double real() {
    const std::string next = word();
    if (next == "inf") return unreachable;
    std::istringstream text(next);
    text.imbue(std::locale::classic());
    double value = 0.0;
    text >> value;
    is_good_ = is_good_ && !text.fail() && text.eof();
    return value;
  }
  Point point() {
    Point found{};
    for (double& coordinate : found) coordinate = real();
    return found;
  }
  /// Whether all words have been read and are good.
  bool is_at_end() { return is_good_ && (stream_ >> std::ws).eof(); }

 private:
  std::istringstream stream_;
  bool is_good_ = true;
};

/// \return whether there is such a kind.
bool set_kind(Measurement& m, const std::string& name) {
  const auto kind = std::ranges::find_if(kinds, [&](const KindOfMeasure& one) { return one.name == name; });
  m.kind = static_cast<MeasureKind>(kind - kinds.begin());
  return kind != kinds.end();
}

/// \return whether there is such a metric.
bool set_metric(Measurement& m, const std::string& name) {
  const std::size_t metric = position_in(ruler_metrics, name);
  m.metric.metric = static_cast<LayerMetric>(metric);
  return metric < ruler_metrics.size();
}

/// Items with semicolons between them, each by read(its words). \return whether all are good.
template <class Read>
bool read_items(const std::string& text, Read&& read) {
  std::istringstream items(text);
  for (std::string item; std::getline(items, item, ';');) {
    Words words(item);
    read(words);
    if (!words.is_at_end()) return false;
  }
  return true;
}

/// The cells of a CSV file, line by line. Two quotes within quotes stand for one.
std::vector<std::vector<std::string>> cells_of(const std::string& text) {
  std::vector<std::vector<std::string>> lines;
  lines.emplace_back(1);
  bool is_quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char letter = text[i];
    const bool is_twice = is_quoted && text.compare(i, 2, "\"\"") == 0;
    if (is_twice) ++i;
    if (letter == '"' && !is_twice) {
      is_quoted = !is_quoted;
    } else if (!is_quoted && letter == ',') {
      lines.back().emplace_back();
    } else if (!is_quoted && letter == '\n') {
      lines.emplace_back(1);
    } else if (is_quoted || letter != '\r') {
      lines.back().back() += letter;
    }
  }
  if (lines.back() == std::vector<std::string>(1)) lines.pop_back();
  return lines;
}

/// Reads a cell of a measurement in the column of this name; columns that say nothing about it are skipped.
/// \return whether the cell is a good one.
bool read_cell(const std::string& column, const std::string& text, Measurement& m) {
  Words words(text);
  if (column == "name") {
    m.name = on_one_line(text);
  } else if (column == "layer") {
    m.layer_name = text;
  } else if (column == "kind") {
    return set_kind(m, text);
  } else if (column == "method") {
    m.method = words.word();
    return words.is_at_end();
  } else if (column == "edited_since" || column == "hidden") {
    (column == "hidden" ? m.is_hidden : m.is_of_another_mesh) = words.number<int>() != 0;
    return words.is_at_end();
  } else if (column == "metric") {
    return set_metric(m, text);
  } else if (column == "weight" || column == "gap") {
    (column == "gap" ? m.metric.gap : m.metric.weight) = words.real();
    return words.is_at_end();
  } else if (column == "mesh") {
    for (std::uint64_t& word : m.mesh.words) word = words.number<std::uint64_t>();
    return words.is_at_end();
  } else if (column == "points") {
    return read_items(text, [&](Words& point) { m.points.push_back(point.point()); });
  } else if (column == "vertices") {
    return read_items(text, [&](Words& vertex) {
      m.path.lines.points.push_back(vertex.point());
      m.path.along.push_back(vertex.real());
    });
  } else if (column == "segments") {
    const auto count = static_cast<Index>(m.path.lines.points.size());
    const bool is_good = read_items(text, [&](Words& ends) {
      const auto a = ends.number<Index>(), b = ends.number<Index>();
      m.path.lines.segments.push_back({a, b});
    });
    return is_good && std::ranges::all_of(m.path.lines.segments, [&](const auto& ends) {
             return 0 <= std::min(ends[0], ends[1]) && std::max(ends[0], ends[1]) < count;
           });
  } else if (const std::size_t quantity = position_in(quantity_names, column);
             quantity < quantity_names.size() && !text.empty()) {
    m.values.push_back({static_cast<Quantity>(quantity), words.real()});
    return words.is_at_end();
  }
  return true;
}

}  // namespace

void Measurements::take(const std::string& text, bool whole, const LayerOf& layer_of) {
  const auto lines = cells_of(text);
  if (lines.empty() || std::ranges::count(lines[0], "kind") != 1 ||
      std::ranges::count(lines[0], "points") != 1) {
    throw InvalidInput(
        "The first line has no columns kind and points, as a table of this version of the ruler has: "
        "open a CSV file that Save... wrote, or measure again.");
  }
  std::vector<Measurement> found;
  std::size_t unit = whole ? 0 : static_cast<std::size_t>(unit_);
  int last = whole ? 0 : last_;
  const bool has_unit = !whole && !all_.empty();
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::string place = "Line " + std::to_string(i + 1) + " of the measurements ";
    if (lines[i].size() != lines[0].size()) {
      throw InvalidInput(place + "has " + std::to_string(lines[i].size()) + " cells, but the first one " +
                         std::to_string(lines[0].size()) +
                         ": save the file again with commas between cells.");
    }
    Measurement& m = found.emplace_back();
    for (std::size_t j = 0; j < lines[i].size(); ++j) {
      const std::string &column = lines[0][j], &content = lines[i][j];
      std::size_t named = unit;
      bool is_good = true;
      if (column == "unit") {
        named = position_in(unit_names, content);
        is_good = named < unit_names.size();
      } else if (column == "number" || column == "last") {
        Words words(content);
        const int number = whole ? words.number<int>() : 0;
        is_good = !whole || words.is_at_end();
        if (column == "number") m.number = number;
        last = std::max(last, number);
      } else {
        is_good = read_cell(column, content, m);
      }
      if (!is_good) {
        throw InvalidInput(place + "cannot be read: '" + content + "' in the column " + column + ".");
      }
      if (named != unit && (i > 1 || has_unit)) {
        throw InvalidInput(place + "counts in " + content + ", but those before it in " + unit_names[unit] +
                           ". Values are not converted: choose one unit for all of them.");
      }
      unit = named;
    }
    if (m.points.size() < least_points(m.kind) || m.values.empty()) {
      throw InvalidInput(place + "has too few points, or no value.");
    }
    m.layer = layer_of(m.layer_name);
  }
  if (whole) {
    all_.clear();
    undo_states_.clear();
  } else {
    if (found.empty()) return;
    remember();
  }
  unit_ = static_cast<LengthUnit>(unit);
  last_ = last;
  for (Measurement& m : found) {
    if (m.number == 0) m.number = ++last_;
    if (m.name.empty()) m.name = std::string(name_of(m.kind)) + ' ' + std::to_string(m.number);
    all_.push_back(std::move(m));
  }
  tell();
}

}  // namespace vorogeo::plugin
