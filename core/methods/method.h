// What a method to compare with is, and the table of them.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "mesh/mesh.h"
#include "support/progress.h"

namespace vorogeo {

// ---- What all geodesic methods have in common: options, what they claim, fields, pairs, memory

/// A number that a method takes.
struct MethodOption {
  std::string name;
  double standard;  ///< the default
  double least, greatest;
  bool whole;  ///< only whole numbers
  std::string meaning;
};

/// What the literature claims of a method, in the columns of the comparison: short phrases.
struct MethodClaims {
  std::string sources;  ///< "MSAD": many sources in one field; "SSSD": two points without a field
  std::string reuse;    ///< what is prepared once and serves all sources
  std::string bound;    ///< of the error
  std::string metrics;  ///< other than the lengths of the mesh
  std::string growth;   ///< time of preparation and field with the number n of vertices
};

/// What is known of a method before it runs.
struct MethodInfo {
  std::string name;   ///< by which it is chosen
  std::string title;  ///< for people
  std::string paper;
  std::vector<MethodOption> options;
  MethodClaims claims;
  bool exact = false;
  bool has_pairs = false;  ///< two points cost it less than a field
};

/// Values of all options of a method, by their names.
using MethodOptions = std::map<std::string, double>;

/// A method that has been prepared for a mesh. Belongs to one thread.
class GeodesicMethod {
 public:
  /// `activity`: what the computation of a field is called in reports; empty if solve() reports by itself.
  explicit GeodesicMethod(std::shared_ptr<const Mesh> mesh, std::string activity = {})
      : mesh_(std::move(mesh)), activity_(std::move(activity)) {}
  virtual ~GeodesicMethod() = default;
  /// Distances from the nearest of the sources to every vertex; `unreachable` where there is none. Vertices
  /// merged over gaps have the same distance. \pre The sources are vertices of the mesh. \throw Cancelled.
  std::vector<double> field(std::span<const Index> sources, const Progress& progress = {});
  /// Distance of two vertices. Without a faster method it is the value of a field.
  double pair(Index source, Index target) {
    return solve_pair(mesh_->representative(source), mesh_->representative(target));
  }
  /// Bytes held beside the mesh, scratch memory of the last field included.
  virtual std::size_t bytes() const = 0;

 protected:
  const Mesh& mesh() const { return *mesh_; }
  virtual std::vector<double> solve(std::span<const Index> sources, const Progress& progress) = 0;
  virtual double solve_pair(Index source, Index target) { return solve({&source, 1}, {})[target]; }

 private:
  std::shared_ptr<const Mesh> mesh_;
  std::string activity_;
};

/// A method made by a constructor that takes the mesh, and maybe options and a progress.
template <class Method>
std::unique_ptr<GeodesicMethod> prepared(const std::shared_ptr<const Mesh>& mesh,
                                         const MethodOptions& options, const Progress& progress) {
  if constexpr (std::is_constructible_v<Method, decltype(mesh), decltype(options), decltype(progress)>) {
    return std::make_unique<Method>(mesh, options, progress);
  } else if constexpr (std::is_constructible_v<Method, decltype(mesh), decltype(options)>) {
    return std::make_unique<Method>(mesh, options);
  } else {
    return std::make_unique<Method>(mesh);
  }
}

/// A row of the table of methods.
struct MethodEntry {
  MethodInfo info;
  std::function<std::unique_ptr<GeodesicMethod>(const std::shared_ptr<const Mesh>& mesh,
                                                const MethodOptions& options, const Progress& progress)>
      prepare;
  /// What a user ought to know before it runs on this mesh; empty if nothing. May be unset.
  std::function<std::string(const Mesh& mesh)> warning = {};
};

/// The field that the last run of a solver has found.
template <class Solver>
std::vector<double> vertex_distances(const Mesh& mesh, const Solver& solver) {
  std::vector<double> distances(mesh.vertex_count());
  for (Index v = 0; v < mesh.vertex_count(); ++v) distances[v] = solver.distance(v);
  return distances;
}

/// Bytes of a vector's memory.
template <class T>
std::size_t bytes_of(const std::vector<T>& values) {
  return values.capacity() * sizeof(T);
}

// ---- The table of all geodesic methods, by their names

MethodEntry vorogeo_entry();
MethodEntry mmp_entry();
MethodEntry ammp_entry();
MethodEntry ch_entry();
MethodEntry ich_entry();
MethodEntry fast_marching_entry();
MethodEntry heat_entry();
MethodEntry svg_entry();
MethodEntry dgg_entry();
MethodEntry gsp_entry();
MethodEntry gtu_entry();
MethodEntry campen_kobbelt_entry();
MethodEntry stvd_entry();
MethodEntry dijkstra_entry();

/// In the order in which they are offered.
const std::vector<MethodEntry>& all_methods();

/// \throw InvalidInput for a name that is not known; it lists those that are.
const MethodEntry& method_named(const std::string& name);

/// What a user ought to know before the method of this name runs on this mesh; empty if nothing.
std::string warning_of(const std::string& name, const Mesh& mesh);

/// Options of a method with standard values for those that are not given.
/// \throw InvalidInput for an unknown option, or a value out of range.
MethodOptions completed_options(const MethodInfo& info, const MethodOptions& given);

/// Prepares a method. Options that are not given have their standard value.
/// \throw InvalidInput for an unknown name or option, or a value out of range; Cancelled.
std::unique_ptr<GeodesicMethod> prepare_method(const std::string& name,
                                               const std::shared_ptr<const Mesh>& mesh,
                                               const MethodOptions& given, const Progress& progress);

}  // namespace vorogeo
