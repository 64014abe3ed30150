// Labels and checks of parameters.
#include "layers/parameters.h"

#include <cmath>

namespace vorogeo::plugin {

std::string named(const FilterCall& call, const char* parameter) {
  // A list that was read from a filter script has names only.
  const std::string label =
      call.parameters.getParameterByName(parameter).fieldDescription().section(" (0:", 0, 0).toStdString();
  return label.empty() ? parameter : "\"" + label + "\" (" + parameter + ")";
}

RichLength length_parameter(const MeshDocument& document, const char* name, double share_of_diagonal,
                            const char* label, const char* tooltip, bool advanced) {
  const Scalarm diagonal = document.mm()->cm.bbox.Diag();  // infinite if a coordinate is
  const Scalarm length = share_of_diagonal > 0.0 ? static_cast<Scalarm>(share_of_diagonal) * diagonal : 0;
  return RichLength(name, length, 0, diagonal, label, tooltip, advanced);
}

RichLength max_snap_distance_parameter(const MeshDocument& document) {
  return length_parameter(document, "max_snap_distance", 0.0, "Max snap distance (0: no limit)",
                          "How far a point may be from the surface; 0: any distance.");
}

double length_of(const FilterCall& call, const char* parameter, bool may_be_zero) {
  const double length = call.parameters.getAbsPerc(parameter);
  if (std::isfinite(length) && (length > 0.0 || (may_be_zero && length == 0.0))) return length;
  refuse(call, parameter, length,
         std::string(". Give a length ") + (may_be_zero ? "of 0 or more" : "above 0") +
             " in the unit of the mesh or in percent.");
}

RichBool exact_parameter() {
  return RichBool("exact", false, "Exact",
                  "Exact propagation for each point instead of the index: slower, without its errors.");
}

RichInt seed_parameter() { return RichInt("seed", 0, "Seed", "Seed of the random numbers."); }

std::uint64_t seed_of(const FilterCall& call) {
  const int seed = call.parameters.getInt("seed");
  if (seed < 0) refuse(call, "seed", seed, ". Give 0 or a positive number.");
  return static_cast<std::uint64_t>(seed);
}

Index vertex_of(const FilterCall& call, const LayerSurface& layer, const char* parameter) {
  return layer.core_vertex(call.parameters.getInt(parameter), named(call, parameter));
}

Point point_of(const FilterCall& call, const char* parameter) {
  const Point3m given = call.parameters.getPoint3m(parameter);
  const Point point{double(given[0]), double(given[1]), double(given[2])};
  for (double coordinate : point) {
    if (!std::isfinite(coordinate)) {
      throw InvalidInput(named(call, parameter) +
                         " has a coordinate that is NaN or infinite. Give three finite coordinates, or the "
                         "number of a vertex.");
    }
  }
  return point;
}

}  // namespace vorogeo::plugin
