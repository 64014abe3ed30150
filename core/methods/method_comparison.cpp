// Runs methods one after the other and writes the table.
#include "methods/method_comparison.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "exact/exact_solver.h"
#include "support/error.h"
#include "tasks/extent.h"

namespace vorogeo {

namespace {

using Clock = std::chrono::steady_clock;

/// Pairs that are timed for each source.
constexpr int pairs_per_source = 5;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string printed(const char* format, double value) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\n");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\n") - first + 1);
}

[[noreturn]] void refuse_list(const std::string& at) {
  throw InvalidInput("The list of methods cannot be read at \"" + at +
                     "\". Give names with commas between, options in parentheses: vorogeo, svg(K=100).");
}

MethodRequest parse_one(const std::string& text) {
  const auto open = text.find('(');
  MethodRequest request{trimmed(text.substr(0, open)), {}, false};
  if (request.name.empty()) refuse_list(text);
  if (open != std::string::npos) {
    const auto close = text.find(')', open);
    if (close == std::string::npos || !trimmed(text.substr(close + 1)).empty()) refuse_list(text);
    std::string rest = text.substr(open + 1, close - open - 1);
    while (!trimmed(rest).empty()) {
      const auto comma = rest.find(',');
      const std::string option = rest.substr(0, comma);
      const auto equals = option.find('=');
      if (equals == std::string::npos) refuse_list(text);
      const std::string value = trimmed(option.substr(equals + 1));
      char* end = nullptr;
      const double number = std::strtod(value.c_str(), &end);
      if (value.empty() || *end != '\0') refuse_list(text);
      request.options[trimmed(option.substr(0, equals))] = number;
      rest = comma == std::string::npos ? "" : rest.substr(comma + 1);
    }
  }
  completed_options(method_named(request.name).info, request.options);
  return request;
}

struct Column {
  const char* name;
  std::string (*of)(const MethodMeasure&);
};

std::string seconds(double value) {
  if (std::isnan(value)) return "-";
  if (value < 1e-3) return printed("%.3g us", 1e6 * value);
  return value < 1.0 ? printed("%.3g ms", 1e3 * value) : printed("%.3g s", value);
}
std::string percent(double value) { return printed("%.2g %%", 100.0 * value); }
const MethodClaims& claims_of(const MethodMeasure& m) { return method_named(m.request.name).info.claims; }

constexpr std::array<Column, 13> columns{{
    {"method", [](const MethodMeasure& m) { return m.request.text(); }},
    {"many sources", [](const MethodMeasure& m) { return claims_of(m).sources; }},
    {"reuse", [](const MethodMeasure& m) { return claims_of(m).reuse; }},
    {"error bound", [](const MethodMeasure& m) { return claims_of(m).bound; }},
    {"metrics", [](const MethodMeasure& m) { return claims_of(m).metrics; }},
    {"growth", [](const MethodMeasure& m) { return claims_of(m).growth; }},
    {"set-up", [](const MethodMeasure& m) { return seconds(m.setup_seconds); }},
    {"field", [](const MethodMeasure& m) { return seconds(m.field_seconds); }},
    {"pair", [](const MethodMeasure& m) { return seconds(m.pair_seconds); }},
    {"memory",
     [](const MethodMeasure& m) { return printed("%.3g MB", 1e-6 * static_cast<double>(m.bytes)); }},
    {"mean", [](const MethodMeasure& m) { return percent(m.mean_error); }},
    {"99 %", [](const MethodMeasure& m) { return percent(m.p99_error); }},
    {"largest", [](const MethodMeasure& m) { return percent(m.max_error); }},
}};

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

MethodMeasure measure(const std::shared_ptr<const Mesh>& mesh, const MethodRequest& request,
                      const std::vector<Index>& sources, const std::vector<double>& exact,
                      const Progress& progress) {
  MethodMeasure result;
  result.request = request;
  auto start = Clock::now();
  const auto method = prepare_method(request.name, mesh, request.options, progress.part(0.0, 0.5));
  result.setup_seconds = seconds_since(start);
  std::vector<double> all;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const auto count = static_cast<double>(sources.size());
    const double done = static_cast<double>(i) / count;
    start = Clock::now();
    const auto field =
        method->field({&sources[i], 1}, progress.part(0.5 + 0.5 * done, 0.5 + 0.5 * (done + 1.0 / count)));
    result.field_seconds += seconds_since(start) / count;
    all.insert(all.end(), field.begin(), field.end());
  }
  result.bytes = method->bytes();
  result.pair_seconds = std::numeric_limits<double>::quiet_NaN();
  if (method_named(request.name).info.has_pairs && !sources.empty()) {
    const auto targets = spread_vertices(*mesh, pairs_per_source + 1);
    start = Clock::now();
    for (Index source : sources) {
      for (Index target : targets) method->pair(source, target);
    }
    result.pair_seconds = seconds_since(start) / static_cast<double>(sources.size() * targets.size());
  }
  const FieldDifference difference = difference_of(all, exact);
  result.mean_error = difference.mean;
  result.p99_error = difference.p99;
  result.max_error = difference.max;
  result.compared = difference.compared;
  return result;
}

}  // namespace

std::string MethodRequest::text() const {
  std::string list;
  for (const auto& [option, value] : options) {
    list += (list.empty() ? "" : ", ") + option + printed("=%g", value);
  }
  return list.empty() ? name : name + "(" + list + ")";
}

MethodRequest with_gap(MethodRequest request, const GapLimit& limit) {
  const auto& options = method_named(request.name).info.options;
  if (std::ranges::find(options, "gap", &MethodOption::name) != options.end() && limit.length > 0.0) {
    request.options.try_emplace("gap", limit.length);
  }
  return request;
}

std::vector<MethodRequest> parse_methods(const std::string& text) {
  std::vector<MethodRequest> requests;
  if (trimmed(text) == "all") {
    for (const MethodEntry& entry : all_methods()) {
      if (!entry.warning) requests.push_back({entry.info.name, {}, true});
    }
    return requests;
  }
  std::size_t begin = 0;
  int depth = 0;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    const char c = i < text.size() ? text[i] : ',';
    depth += c == '(' ? 1 : (c == ')' ? -1 : 0);
    if (c != ',' || (depth > 0 && i < text.size())) continue;
    requests.push_back(parse_one(text.substr(begin, i - begin)));
    begin = i + 1;
  }
  return requests;
}

std::vector<Index> spread_vertices(const Mesh& mesh, int count) {
  std::vector<Index> with_face;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (!mesh.corners(v).empty()) with_face.push_back(v);
  }
  const auto wanted = std::min(with_face.size(), static_cast<std::size_t>(std::max(0, count)));
  std::vector<Index> chosen;
  for (std::size_t i = 0; i < wanted; ++i) chosen.push_back(with_face[i * with_face.size() / wanted]);
  return chosen;
}

std::vector<MethodMeasure> compare_methods(const std::shared_ptr<const Mesh>& mesh,
                                           const std::vector<MethodRequest>& requests,
                                           const std::vector<Index>& sources, const Progress& progress) {
  std::vector<double> exact;
  for (Index source : sources) {
    progress.report(0.0, "Exact distances");
    const auto field = exact_distance_field(mesh, {&source, 1});
    exact.insert(exact.end(), field.begin(), field.end());
  }
  std::vector<MethodMeasure> measures;
  const auto part = [&](std::size_t i) {
    return 0.1 + 0.9 * static_cast<double>(i) / static_cast<double>(requests.size());
  };
  for (std::size_t i = 0; i < requests.size(); ++i) {
    try {
      measures.push_back(measure(mesh, requests[i], sources, exact, progress.part(part(i), part(i + 1))));
    } catch (const InvalidInput& error) {
      if (!requests[i].is_optional) throw;
      progress.warn(std::string("Left out: ") + error.what());
    }
  }
  return measures;
}

std::string comparison_text(const std::vector<MethodMeasure>& measures) {
  std::array<std::size_t, columns.size()> width{};
  for (std::size_t c = 0; c < columns.size(); ++c) {
    width[c] = std::string(columns[c].name).size();
    for (const auto& m : measures) width[c] = std::max(width[c], columns[c].of(m).size());
  }
  const auto line = [&](auto&& cell) {
    std::string text;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      std::string value = cell(c);
      value.resize(width[c], ' ');
      text += (c == 0 ? "" : "  ") + value;
    }
    return text.substr(0, text.find_last_not_of(' ') + 1) + "\n";
  };
  std::string table = line([&](std::size_t c) { return std::string(columns[c].name); });
  for (const auto& m : measures) table += line([&](std::size_t c) { return columns[c].of(m); });
  return table;
}

std::string comparison_csv(const std::vector<MethodMeasure>& measures) {
  std::string text =
      "method,many_sources,reuse,error_bound,metrics,growth,setup_seconds,field_seconds,pair_seconds,bytes,"
      "mean_error,p99_error,max_error\r\n";
  for (const auto& m : measures) {
    for (std::size_t c = 0; c < 6; ++c) text += quoted(columns[c].of(m)) + ",";
    for (double value : {m.setup_seconds, m.field_seconds, m.pair_seconds, static_cast<double>(m.bytes),
                         m.mean_error, m.p99_error}) {
      text += (std::isnan(value) ? "" : printed("%.9g", value)) + ",";
    }
    text += printed("%.9g", m.max_error) + "\r\n";
  }
  return text;
}

}  // namespace vorogeo
