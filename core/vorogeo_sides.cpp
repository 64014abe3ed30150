// The public interface over the core: distances with a sign, their derivatives, cut loci, texture
// coordinates.
#include <utility>

#include "public_interface.h"

namespace vorogeo {
inline namespace v0 {

std::vector<double> signed_distance(const Surface& surface,
                                    const std::vector<std::vector<SurfacePoint>>& curves,
                                    const SignedDistanceOptions& options) {
  return ask(surface, TaskOptions{Answer::exact, options.progress}, [&](const Asked& at) {
    return signed_distance(at.surface, at.in(curves), options.limit, at.options);
  });
}

std::vector<double> signed_distance(const Surface& surface, const std::vector<bool>& in_region,
                                    const SignedDistanceOptions& options) {
  return ask(surface, TaskOptions{Answer::exact, options.progress}, [&](const Asked& at) {
    if (in_region.size() != static_cast<std::size_t>(surface.face_count())) {
      throw InvalidInput("The region has " + std::to_string(in_region.size()) + " values, but the mesh has " +
                         std::to_string(surface.face_count()) + " faces; give one value for each.");
    }
    const std::vector<std::uint8_t> flags(in_region.begin(), in_region.end());
    return signed_distance(at.surface, flags, options.limit, at.options);
  });
}

DistanceGradient distance_gradient(const Surface& surface, const PointList& from, const PointList& to,
                                   const TaskOptions& options) {
  return ask(surface, options, [&](const Asked& at) {
    return distance_gradient(at.surface, Pairs(at, from, to).pairs(), at.options);
  });
}

CutLocus cut_locus(const Surface& surface, const PointList& sources, const CutLocusOptions& options) {
  return ask(surface, TaskOptions{Answer::exact, options.progress}, [&](const Asked& at) {
    auto found = cut_locus(at.surface, at.in(sources), options.min_angle, options.limit, at.options);
    return CutLocus{points_out(at.mesh, found.points), positions_of(at.mesh, found.points),
                    std::move(found.edges), std::move(found.distance), std::move(found.angle)};
  });
}

TextureCoordinates texture_coordinates(const Surface& surface, const SurfacePoint& point, double radius,
                                       const TextureOptions& options) {
  return ask(surface, TaskOptions{Answer::exact, options.progress}, [&](const Asked& at) {
    return texture_coordinates(at.surface, at.in(point), {radius, options.rotation, options.scale},
                               at.options);
  });
}

}  // namespace v0
}  // namespace vorogeo
