// Finds methods by name and completes their options.
#include "methods/method.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "support/error.h"

namespace vorogeo {

namespace {

std::string number(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

template <class Rows, class Name>
std::string names_of(const Rows& rows, Name&& name) {
  std::string list;
  for (const auto& row : rows) list += (list.empty() ? "" : ", ") + name(row);
  return list;
}

}  // namespace

std::string warning_of(const std::string& name, const Mesh& mesh) {
  const MethodEntry& entry = method_named(name);
  return entry.warning ? entry.warning(mesh) : std::string();
}

MethodOptions completed_options(const MethodInfo& info, const MethodOptions& given) {
  MethodOptions options;
  for (const MethodOption& option : info.options) options[option.name] = option.standard;
  for (const auto& [name, value] : given) {
    const auto found = std::find_if(info.options.begin(), info.options.end(),
                                    [&](const MethodOption& option) { return option.name == name; });
    if (found == info.options.end()) {
      throw InvalidInput(
          "The method " + info.name + " has no option " + name +
          (info.options.empty()
               ? "; it has none."
               : "; it has " + names_of(info.options, [](const MethodOption& o) { return o.name; }) + "."));
    }
    const bool in_range = value >= found->least && value <= found->greatest;
    if (!in_range || (found->whole && std::floor(value) != value)) {
      throw InvalidInput("The option " + name + " of the method " + info.name + " is " + number(value) +
                         "; give a " + (found->whole ? "whole " : "") + "number from " +
                         number(found->least) + " to " + number(found->greatest) + ".");
    }
    options[name] = value;
  }
  return options;
}

const std::vector<MethodEntry>& all_methods() {
  static const std::vector<MethodEntry> methods{
      vorogeo_entry(), mmp_entry(),     ch_entry(),  ich_entry(), ammp_entry(), fast_marching_entry(),
      heat_entry(),    svg_entry(),     dgg_entry(), gsp_entry(), gtu_entry(),  campen_kobbelt_entry(),
      stvd_entry(),    dijkstra_entry()};
  return methods;
}

const MethodEntry& method_named(const std::string& name) {
  for (const MethodEntry& entry : all_methods()) {
    if (entry.info.name == name) return entry;
  }
  throw InvalidInput("The method " + name + " is not known; give one of " +
                     names_of(all_methods(), [](const MethodEntry& entry) { return entry.info.name; }) + ".");
}

std::vector<double> GeodesicMethod::field(std::span<const Index> sources, const Progress& progress) {
  const Watch watch(activity_.empty() ? Progress() : progress, activity_);
  std::vector<Index> named(sources.begin(), sources.end());
  for (Index& v : named) v = mesh_->representative(v);
  std::vector<double> distances = solve(named, progress);
  for (Index v = 0; v < mesh_->vertex_count(); ++v) distances[v] = distances[mesh_->representative(v)];
  return distances;
}

std::unique_ptr<GeodesicMethod> prepare_method(const std::string& name,
                                               const std::shared_ptr<const Mesh>& mesh,
                                               const MethodOptions& given, const Progress& progress) {
  const MethodEntry& entry = method_named(name);
  if (entry.info.name != vorogeo_entry().info.name) {
    require_agreeing_faces(*mesh, "The method " + entry.info.name + " and others of the literature");
  }
  return entry.prepare(mesh, completed_options(entry.info, given), progress);
}

}  // namespace vorogeo
