// The comparison of methods on one mesh: what each costs, how far it errs, and what it claims.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "mesh/gaps.h"
#include "methods/method.h"

namespace vorogeo {

/// A method and the options that were given for it.
struct MethodRequest {
  std::string name;
  MethodOptions options;
  /// Left out of a comparison if it cannot work on the mesh; otherwise that stops the comparison.
  bool is_optional = false;
  /// As it is written: svg(K=100).
  std::string text() const;
};

/// The request. If the method crosses gaps by itself (option `gap`) and the request does not set that option,
/// it gets the width up to which the mesh was bridged.
MethodRequest with_gap(MethodRequest request, const GapLimit& limit);

/// Reads a list such as "vorogeo, svg(K=100), heat(time_step=2, delaunay=1)"; "all" stands for all methods
/// but those that warn, as far as they work on the mesh. \throw InvalidInput for what cannot be read, an
/// unknown name or option, a value out of range.
std::vector<MethodRequest> parse_methods(const std::string& text);

/// What was measured of a method. Errors are relative and without sign: 0.01 is 1 %.
struct MethodMeasure {
  MethodRequest request;
  double setup_seconds = 0.0;
  double field_seconds = 0.0;  ///< of one field, in the mean
  double pair_seconds = 0.0;   ///< of two vertices, in the mean; NaN if the method has only fields
  std::size_t bytes = 0;
  double mean_error = 0.0;
  double p99_error = 0.0;
  double max_error = 0.0;
  int compared = 0;  ///< distances that were compared
};

/// `count` vertices with a face, evenly spaced by number; all of them if there are fewer.
std::vector<Index> spread_vertices(const Mesh& mesh, int count);

/// Runs each method from each source on its own (wall time), and compares with exact distances. An optional
/// method that cannot work on this mesh is left out with a warning. \throw InvalidInput for any other that
/// cannot; Cancelled.
std::vector<MethodMeasure> compare_methods(const std::shared_ptr<const Mesh>& mesh,
                                           const std::vector<MethodRequest>& requests,
                                           const std::vector<Index>& sources, const Progress& progress);

/// A line for each method under a line of names, in columns of even width: claims first, then figures.
std::string comparison_text(const std::vector<MethodMeasure>& measures);
/// The same as CSV (RFC 4180), seconds, bytes and errors as plain numbers.
std::string comparison_csv(const std::vector<MethodMeasure>& measures);

}  // namespace vorogeo
