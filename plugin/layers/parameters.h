// Parameters that several filters have, and how errors name a parameter.
#pragma once

#include <sstream>
#include <string>

#include "host/filter_row.h"
#include "layers/layer_surface.h"
#include "support/error.h"

namespace vorogeo::plugin {

/// A parameter as errors name it: by its label in the window, without what that says about 0, and its
/// name in scripts, such as "Start vertex" (vertex_index).
std::string named(const FilterCall& call, const char* parameter);

/// \throw InvalidInput saying which parameter has which value, followed by `rest`.
template <class Value>
[[noreturn]] void refuse(const FilterCall& call, const char* parameter, const Value& value,
                         const std::string& rest) {
  std::ostringstream text;
  text << named(call, parameter) << " is " << value << rest;
  throw InvalidInput(text.str());
}

/// A length in the unit of the mesh, or in percent of the diagonal of its bounding box. `advanced`: shown on
/// request only, after the others.
RichLength length_parameter(const MeshDocument& document, const char* name, double share_of_diagonal,
                            const char* label, const char* tooltip, bool advanced = false);
/// The value of a length. \throw InvalidInput if it is negative, not a number, or zero where that is not
/// allowed.
double length_of(const FilterCall& call, const char* parameter, bool may_be_zero);

/// The parameter max_snap_distance.
RichLength max_snap_distance_parameter(const MeshDocument& document);

/// The parameter exact of all filters that can also do without the index.
RichBool exact_parameter();

/// The parameter seed, and its value. \throw InvalidInput if it is negative.
RichInt seed_parameter();
std::uint64_t seed_of(const FilterCall& call);

/// The core vertex whose number in the host is the value of a parameter. \throw InvalidInput if there is
/// none.
Index vertex_of(const FilterCall& call, const LayerSurface& layer, const char* parameter);

/// A point. \throw InvalidInput if it is not finite.
Point point_of(const FilterCall& call, const char* parameter);

}  // namespace vorogeo::plugin
