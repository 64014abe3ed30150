// Text for the dock, the clipboard and files, and back from files.
#include "edit/measurements.h"

#include <algorithm>
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
constexpr const char* first_line = "VoroGeo measurements 1";

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

}  // namespace

std::string unit_of(Quantity quantity, LengthUnit unit) {
  if (quantity == Quantity::ratio) return {};
  if (quantity == Quantity::angle) return "°";
  return std::string(unit_names[static_cast<std::size_t>(unit)]) + (quantity == Quantity::area ? "²" : "");
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
  measurement.mesh = fingerprint_of(mesh.positions, mesh.faces);
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
  remember();
  measurement.number = number;
  measurement.name = old->name;
  measurement.is_hidden = old->is_hidden;
  measurement.mesh = fingerprint_of(mesh.positions, mesh.faces);
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
  tell();  // also where the table shows a name that is not taken
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
  before_.push_back(all_);
  if (before_.size() > most_undone) before_.erase(before_.begin());
}

void Measurements::undo() {
  if (before_.empty()) return;
  all_ = std::move(before_.back());
  before_.pop_back();
  tell();
}

void Measurements::compare(int layer, const VcgMeshArrays& mesh) {
  if (std::ranges::count(all_, layer, &Measurement::layer) == 0) return;
  const Fingerprint now = fingerprint_of(mesh.positions, mesh.faces);
  bool has_changed = false;
  for (Measurement& measurement : all_) {
    if (measurement.layer != layer) continue;
    const bool is_of_another_mesh = measurement.mesh != now;
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
  return four_digits(value) + (!has_unit ? "" : what == Quantity::angle ? unit : ' ' + unit);
}

std::vector<std::string> Measurements::row(const Measurement& m) const {
  std::string details;
  for (std::size_t i = 1; i < m.values.size(); ++i) {
    if (!std::isfinite(m.values[i].value)) continue;
    details += std::string(i > 1 ? ", " : "") + quantity_names[static_cast<std::size_t>(m.values[i].what)] +
               ' ' + four_digits(m.values[i].value);
  }
  details += (details.empty() ? "" : "; ") + m.method + (m.is_of_another_mesh ? ", before an edit" : "");
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

std::string Measurements::csv() const {
  std::string text = "number,name,kind,layer,unit,method,edited_since";
  for (const char* name : quantity_names) text += std::string(",") + name;
  text += ",points\n";
  for (const Measurement& m : all_) {
    text += std::to_string(m.number) + ',' + cell(m.name) + ',' + name_of(m.kind) + ',' + cell(m.layer_name) +
            ',' + unit_names[static_cast<std::size_t>(unit_)] + ',' + m.method + ',' +
            (m.is_of_another_mesh ? '1' : '0');
    for (std::size_t quantity = 0; quantity < quantity_names.size(); ++quantity) {
      text += ',';
      for (const Value& v : m.values) {
        if (static_cast<std::size_t>(v.what) == quantity) text += number_with(all_digits, v.value);
      }
    }
    text += ',';
    for (std::size_t i = 0; i < m.points.size(); ++i) {
      const auto& [x, y, z] = m.points[i];
      text += (i == 0 ? "" : ";") + number_with(all_digits, x) + ' ' + number_with(all_digits, y) + ' ' +
              number_with(all_digits, z);
    }
    text += '\n';
  }
  return text;
}

PathLines Measurements::lines_on(int layer) const {
  PathLines result;
  for (const Measurement& m : all_) {
    if (m.layer == layer) append(result, m.path);
  }
  return result;
}

// ---- Files: a line for each thing, its word first; the lines of a measurement follow its own

std::string Measurements::text() const {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(all_digits) << first_line << "\nunit "
       << unit_names[static_cast<std::size_t>(unit_)] << "\nlast " << last_ << '\n';
  for (const Measurement& m : all_) {
    text << "measurement " << m.number << ' ' << name_of(m.kind) << ' ' << m.method << ' ' << m.mesh.words[0]
         << ' ' << m.mesh.words[1] << ' ' << m.is_hidden << "\nname " << m.name << "\nlayer "
         << on_one_line(m.layer_name) << '\n';
    for (const auto& [what, value] : m.values) {
      text << "value " << quantity_names[static_cast<std::size_t>(what)] << ' ' << value << '\n';
    }
    for (const auto& [x, y, z] : m.points) text << "point " << x << ' ' << y << ' ' << z << '\n';
    for (std::size_t i = 0; i < m.path.lines.points.size(); ++i) {
      const auto& [x, y, z] = m.path.lines.points[i];
      text << "vertex " << x << ' ' << y << ' ' << z << ' ' << m.path.along[i] << '\n';
    }
    for (const auto& [a, b] : m.path.lines.segments) text << "segment " << a << ' ' << b << '\n';
  }
  return text.str();
}

namespace {

/// Takes the words of a line one after the other; what is missing or no number makes the line a bad one.
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
  Point point() {
    Point found{};
    for (double& coordinate : found) coordinate = number<double>();
    return found;
  }
  std::string rest() {
    std::string left;
    stream_.get();
    std::getline(stream_, left);
    return left;
  }
  bool is_good() const { return is_good_; }

 private:
  std::istringstream stream_;
  bool is_good_ = true;
};

/// \return whether the line is one of a measurement.
bool read_line(const std::string& line, Measurement& m) {
  Words words(line);
  const std::string what = words.word();
  if (what == "name") {
    m.name = words.rest();
  } else if (what == "layer") {
    m.layer_name = words.rest();
  } else if (what == "value") {
    const std::size_t quantity = position_in(quantity_names, words.word());
    m.values.push_back({static_cast<Quantity>(quantity), words.number<double>()});
    return words.is_good() && quantity < quantity_names.size();
  } else if (what == "point") {
    m.points.push_back(words.point());
  } else if (what == "vertex") {
    m.path.lines.points.push_back(words.point());
    m.path.along.push_back(words.number<double>());
  } else if (what == "segment") {
    const auto a = words.number<Index>();
    const auto b = words.number<Index>();
    m.path.lines.segments.push_back({a, b});
    const auto count = static_cast<Index>(m.path.lines.points.size());
    return words.is_good() && 0 <= std::min(a, b) && std::max(a, b) < count;
  } else {
    return false;
  }
  return words.is_good();
}

/// \return whether the line begins a measurement.
bool begin_measurement(const std::string& line, Measurement& m) {
  Words words(line);
  if (words.word() != "measurement") return false;
  m.number = words.number<int>();
  const std::string kind = words.word();
  const auto text = std::ranges::find_if(kinds, [&](const KindOfMeasure& one) { return one.name == kind; });
  m.kind = static_cast<MeasureKind>(text - kinds.begin());
  m.method = words.word();
  for (std::uint64_t& word : m.mesh.words) word = words.number<std::uint64_t>();
  m.is_hidden = words.number<int>() != 0;
  return words.is_good() && text != kinds.end();
}

}  // namespace

void Measurements::read(const std::string& text, const std::function<int(const std::string&)>& layer_of) {
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  if (line != first_line) {
    throw InvalidInput("The file does not begin with '" + std::string(first_line) +
                       "': it holds no measurements, or those of another version.");
  }
  std::vector<Measurement> found;
  std::size_t unit = 0;
  int last = 0;
  for (int number = 2; std::getline(lines, line); ++number) {
    Words words(line);
    const std::string what = words.word();
    bool is_good = false;
    if (what == "unit") {
      unit = position_in(unit_names, words.word());
      is_good = unit < unit_names.size();
    } else if (what == "last") {
      last = words.number<int>();
      is_good = words.is_good();
    } else if (what == "measurement") {
      is_good = begin_measurement(line, found.emplace_back());
      last = std::max(last, found.back().number);
    } else if (!found.empty()) {
      is_good = read_line(line, found.back());
    }
    if (!is_good) {
      throw InvalidInput("Line " + std::to_string(number) + " of the measurements cannot be read: '" + line +
                         "'; it was damaged, or is of another version.");
    }
  }
  for (Measurement& m : found) {
    if (m.points.size() < least_points(m.kind)) {
      throw InvalidInput("Measurement " + std::to_string(m.number) +
                         " has too few points: the file is damaged.");
    }
    m.layer = layer_of(m.layer_name);
  }
  all_ = std::move(found);
  before_.clear();
  unit_ = static_cast<LengthUnit>(unit);
  last_ = last;
  tell();
}

}  // namespace vorogeo::plugin
