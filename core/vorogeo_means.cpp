// The public interface over the core: curves, means and clusters.
#include <optional>
#include <utility>

#include "public_interface.h"

namespace vorogeo {
inline namespace v0 {

// ---- Curves

std::vector<SurfacePoint> points_along(const Surface& surface, const PointList& path,
                                       const std::vector<double>& fractions) {
  return translated([&] {
    const Mesh& mesh = *surface.state().mesh;
    return points_out(mesh, points_along(mesh, points_in(mesh, path), fractions));
  });
}

Path bezier(const Surface& surface, const PointList& points, int samples, const TaskOptions& options) {
  return ask(surface, options, [&](const Asked& at) {
    return path_out(at.mesh, bezier(at.surface, at.in(points), samples, at.options), at.answered);
  });
}

Path b_spline(const Surface& surface, const PointList& points, bool closed, int levels,
              const TaskOptions& options) {
  return ask(surface, options, [&](const Asked& at) {
    return path_out(at.mesh, b_spline(at.surface, at.in(points), closed, levels, at.options), at.answered);
  });
}

Path spline(const Surface& surface, const PointList& points, bool closed, int samples,
            const TaskOptions& options) {
  return ask(surface, options, [&](const Asked& at) {
    return path_out(at.mesh, spline(at.surface, at.in(points), closed, samples, at.options), at.answered);
  });
}

// ---- Means and clusters of points

namespace {

Centre centre(const Surface& surface, const PointList& points, const std::vector<double>& weights,
              Power power, const TaskOptions& options) {
  return ask(surface, options, [&](const Asked& at) {
    auto found = centre_of(at.surface, at.in(points), weights, power, at.options);
    return Centre{point_out(at.mesh, found.point), found.energy, std::move(found.remark)};
  });
}

Clusters clusters(const Surface& surface, int count, Power power, const ClusterOptions& options) {
  return ask(surface, options, [&](const Asked& at) {
    std::optional<inner::PointList> points;
    if (!options.points.empty()) points = at.in(options.points);
    auto found = clusters_of(at.surface, count, points, options.weights, power, options.rounds, options.seed,
                             at.options);
    return Clusters{points_out(at.mesh, found.centres), std::move(found.label), std::move(found.energy)};
  });
}

}  // namespace

Centre frechet_mean(const Surface& surface, const PointList& points, const std::vector<double>& weights,
                    const TaskOptions& options) {
  return centre(surface, points, weights, Power::two, options);
}

Centre geometric_median(const Surface& surface, const PointList& points, const std::vector<double>& weights,
                        const TaskOptions& options) {
  return centre(surface, points, weights, Power::one, options);
}

int medoid(const Surface& surface, const PointList& points, const std::vector<double>& weights,
           const TaskOptions& options) {
  return ask(surface, options,
             [&](const Asked& at) { return medoid(at.surface, at.in(points), weights, at.options); });
}

Clusters k_means(const Surface& surface, int count, const ClusterOptions& options) {
  return clusters(surface, count, Power::two, options);
}

Clusters k_medoids(const Surface& surface, int count, const ClusterOptions& options) {
  return clusters(surface, count, Power::one, options);
}

}  // namespace v0
}  // namespace vorogeo
