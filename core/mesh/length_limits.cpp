// The scale that is advised for meshes that are too large or too small to compute with.
#include "mesh/length_limits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "support/error.h"

namespace vorogeo {

void require_lengths(double mean, double longest, const std::string& what, const LengthLimits& limits) {
  if (limits.allow(mean, longest)) return;
  std::ostringstream message;
  message << "The mesh has a mean edge length of " << mean << " and a longest edge of " << longest << "; "
          << what << " lengths between " << limits.least_mean << " and " << limits.greatest
          << ": scale the mesh, for example by " << factor_to_unit(mean, longest) << ".";
  throw InvalidInput(message.str());
}

double factor_to_unit(double mean, double longest) {
  constexpr double least = std::numeric_limits<double>::denorm_min();
  constexpr double greatest = std::numeric_limits<double>::max();
  const double exponent = 0.5 * std::log10(std::clamp(mean, least, greatest)) +
                          0.5 * std::log10(std::clamp(longest, least, greatest));
  return std::pow(10.0, -std::clamp(std::round(exponent), -300.0, 300.0));
}

}  // namespace vorogeo
