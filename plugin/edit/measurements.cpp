// Text for the dock, the clipboard and files.
#include "edit/measurements.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <utility>

namespace vorogeo::plugin {

namespace {

std::string number_with(int digits, double value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(digits) << value;
  return text.str();
}

constexpr const char* no_path = "no path";
constexpr int digits_of_label = 4;
constexpr int digits_shown = 7;
constexpr int digits_of_ratio = 5;
constexpr int all_digits = std::numeric_limits<double>::max_digits10;

/// Infinite where both ends are at one place in space, on two sheets of the surface.
double ratio_of(const Measurement& measurement) {
  const double straight = measurement.straight();
  return measurement.length == straight ? 1.0 : measurement.length / straight;
}

}  // namespace

int Measurements::add(Measurement measurement, const VcgMeshArrays& mesh) {
  measured_[measurement.layer] = mesh;
  measurement.number = ++last_;
  all_.push_back(std::move(measurement));
  tell();
  return last_;
}

void Measurements::remove(const std::vector<int>& numbers) {
  std::erase_if(all_, [&](const Measurement& m) { return std::ranges::count(numbers, m.number) > 0; });
  tell();
}

void Measurements::compare(int layer, const VcgMeshArrays& mesh) {
  const auto measured = measured_.find(layer);
  if (measured == measured_.end()) return;
  const VcgMeshArrays& before = measured->second;
  if (before.positions == mesh.positions && before.faces == mesh.faces) return;
  for (Measurement& measurement : all_) {
    if (measurement.layer == layer) measurement.is_of_another_mesh = true;
  }
  measured_.erase(measured);
  tell();
}

void Measurements::watch(const void* who, std::function<void()> changed) {
  watchers_[who] = changed;
  changed();
}

void Measurements::tell() const {
  for (const auto& [who, changed] : watchers_) changed();
}

std::vector<std::string> Measurements::columns() { return {"No.", "Length", "Straight", "Ratio", "Method"}; }

std::string Measurements::label(double length) {
  if (!std::isfinite(length)) return no_path;
  int digits = digits_of_label;
  for (double limit = 1e4; length >= limit - 0.5 && digits < digits_shown; limit *= 10.0) ++digits;
  return number_with(digits, length);
}

std::vector<std::string> Measurements::row(const Measurement& m) {
  const bool has_path = std::isfinite(m.length);
  return {std::to_string(m.number), has_path ? number_with(digits_shown, m.length) : no_path,
          number_with(digits_shown, m.straight()), has_path ? number_with(digits_of_ratio, ratio_of(m)) : "",
          m.method + (m.is_of_another_mesh ? ", before an edit" : "")};
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
  std::string text = "number,layer,length,straight,ratio,method,edited_since,x0,y0,z0,x1,y1,z1\n";
  for (const Measurement& m : all_) {
    text += std::to_string(m.number) + ',' + std::to_string(m.layer);
    for (double value : {m.length, m.straight(), ratio_of(m)}) text += ',' + number_with(all_digits, value);
    text += ',' + m.method + ',' + (m.is_of_another_mesh ? '1' : '0');
    for (const Point& end : {m.from, m.to}) {
      for (double coordinate : end) text += ',' + number_with(all_digits, coordinate);
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

}  // namespace vorogeo::plugin
