// What the sources of the public interface share: the core beside the public header, and what translates
// points and options in both directions.
#pragma once

#include <mutex>
#include <new>
#include <optional>
#include <utility>

#include "index/build_cost.h"
#include "mesh/mesh_check.h"
#include "mesh/mesh_input.h"
#include "mesh/metric.h"
#include "mesh/one_way.h"
#include "mesh/outliers.h"
#include "mesh/surface_locator.h"
#include "query/surface.h"
#include "support/memory.h"
#include "support/parallel.h"
#include "tasks/bands.h"
#include "tasks/clusters.h"
#include "tasks/curve_sources.h"
#include "tasks/curves.h"
#include "tasks/cut.h"
#include "tasks/cut_locus.h"
#include "tasks/directions.h"
#include "tasks/distance_gradient.h"
#include "tasks/distance_matrix.h"
#include "tasks/extent.h"
#include "tasks/girth.h"
#include "tasks/loops.h"
#include "tasks/means.h"
#include "tasks/neighbors.h"
#include "tasks/path_through.h"
#include "tasks/polygon.h"
#include "tasks/profile.h"
#include "tasks/region_areas.h"
#include "tasks/set_distances.h"
#include "tasks/signed_distance.h"
#include "tasks/spread_points.h"
#include "tasks/surface_lines.h"
#include "tasks/texture.h"
#include "tasks/voronoi_regions.h"

// Names for what the core declares, before the header below declares public things of the same names. Core
// functions of a surface or a mesh need none: they are found by their arguments.
namespace inner {
using vorogeo::check_mesh;
using vorogeo::CutMesh;
using vorogeo::hiking_time;
using vorogeo::IndexOptions;
using vorogeo::name_of;
using vorogeo::path_through;
using vorogeo::PointList;
using vorogeo::Query;
using vorogeo::slope_cost;
using vorogeo::Surface;
using vorogeo::SurfacePoint;
using vorogeo::TaskOptions;
using vorogeo::tighten;
using vorogeo::travel_time;
}  // namespace inner

#include "vorogeo.h"

namespace vorogeo {
inline namespace v0 {

struct Surface::State {
  std::shared_ptr<const Mesh> mesh;
  inner::IndexOptions options;

  std::mutex mutex;  ///< guards `surface`; held for moments
  std::shared_ptr<inner::Surface> surface;
  std::once_flag locator_made;
  std::unique_ptr<const SurfaceLocator> locator;

  std::shared_ptr<inner::Surface> current() {
    const std::lock_guard lock(mutex);
    return surface;
  }
  const SurfaceLocator& located() {
    std::call_once(locator_made, [&] { locator = std::make_unique<SurfaceLocator>(mesh); });
    return *locator;
  }
  void adopt(std::shared_ptr<const GeodesicIndex> index) {
    const std::lock_guard lock(mutex);
    surface = std::make_shared<inner::Surface>(mesh, std::move(index), surface->spent(), options);
  }
};

/// Runs code of the core, whose errors are those of the public header, and makes running out of memory one.
template <class Body>
auto translated(Body&& body) {
  try {
    return body();
  } catch (const std::bad_alloc&) {
    throw NotEnoughMemory(out_of_memory_sentence);
  }
}

// ---- Points in and out

inline inner::SurfacePoint point_in(const Mesh& mesh, const SurfacePoint& point) {
  return InputMap(mesh).point_in({point.vertex, point.face, point.weights});
}

inline inner::PointList points_in(const Mesh& mesh, const PointList& points) {
  std::vector<inner::SurfacePoint> list;
  list.reserve(points.size());
  for (const SurfacePoint& point : points) list.push_back(point_in(mesh, point));
  return list;
}

/// A point on a bridge lies in no given face.
inline SurfacePoint point_out(const Mesh& mesh, const inner::SurfacePoint& point) {
  const InputPoint out = InputMap(mesh).point_out(point);
  return out.vertex >= 0 ? SurfacePoint(out.vertex) : SurfacePoint(out.face, out.weights);
}

inline std::vector<SurfacePoint> points_out(const Mesh& mesh,
                                            const std::vector<inner::SurfacePoint>& points) {
  std::vector<SurfacePoint> out;
  for (const auto& point : points) out.push_back(point_out(mesh, point));
  return out;
}

// ---- Questions and what answers them

/// The method and the progress of any of the public options.
template <class Options>
inner::TaskOptions core_options(const Options& options) {
  return {.by = options.by, .progress = Progress(options.progress)};
}

/// How and where a question is asked, and then what answered it.
struct Asked {
  inner::Surface& surface;
  const Mesh& mesh;
  inner::TaskOptions options;
  Answered answered = {};

  inner::SurfacePoint in(const SurfacePoint& point) const { return point_in(mesh, point); }
  inner::PointList in(const PointList& points) const { return points_in(mesh, points); }
  std::vector<std::vector<inner::SurfacePoint>> in(
      const std::vector<std::vector<SurfacePoint>>& lines) const {
    std::vector<std::vector<inner::SurfacePoint>> inside(lines.size());
    for (std::size_t k = 0; k < lines.size(); ++k) {
      for (const SurfacePoint& point : lines[k]) inside[k].push_back(in(point));
    }
    return inside;
  }
};

/// Both ends of k pairs; one point goes with each of k.
struct Pairs {
  /// \throw InvalidInput for lists of other sizes, or a vertex or face that does not exist.
  Pairs(const Asked& at, const PointList& from, const PointList& to)
      : sources(repeated(at, from, to.size(), "Source")), targets(repeated(at, to, from.size(), "Target")) {
    if (sources.size() == targets.size()) return;
    throw InvalidInput("There are " + std::to_string(from.size()) + " points to start from and " +
                       std::to_string(to.size()) + " to go to; give as many of both.");
  }
  PointPairs pairs() const { return {sources, targets}; }

  inner::PointList sources;
  inner::PointList targets;

 private:
  /// One that is alone is checked here: beside an empty list, no copy of it goes on to the question.
  static inner::PointList repeated(const Asked& at, const PointList& points, std::size_t count,
                                   const char* role) {
    inner::PointList given = at.in(points);
    if (given.size() != 1) return given;
    return std::vector(count, points_on(at.mesh, given, role)[0]);
  }
};

/// Calls body(asked) for the surface as it is now.
template <class Options, class Body>
auto ask(const Surface& surface, const Options& options, Body&& body) {
  return translated([&] {
    const auto current = surface.state().current();
    inner::Surface* answering = current.get();
    if constexpr (requires { options.to; }) {
      if (options.to) answering = &current->reversed();
    }
    Asked asked{*answering, *surface.state().mesh, core_options(options)};
    asked.options.answered = &asked.answered;
    return body(asked);
  });
}

inline Path path_out(const Mesh& mesh, const ExactPath& found, const Answered& answered) {
  Path path;
  path.points = positions_of(mesh, found.path.points);
  path.surface_points = points_out(mesh, found.path.points);
  path.length = found.path.length;
  path.certified = found.certified;
  path.answered_by = static_cast<Answer>(answered.by);
  path.remark = answered.remark;
  return path;
}

}  // namespace v0
}  // namespace vorogeo
