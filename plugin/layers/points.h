// What filters ask for: parameters that several have, and points: a start vertex, two ends, lists, the
// selection, another layer.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "host/filter_row.h"
#include "layers/layer_surface.h"
#include "mesh/surface_locator.h"
#include "mesh/surface_point.h"
#include "support/error.h"

namespace vorogeo::plugin {

// ---- The scene, in which points and lengths are given and measured

/// \throw InvalidInput as Placement; the message names the layer.
Placement placement_of(const MeshModel& layer);

/// The bounding box of the layer as it stands in the scene.
Box3m scene_box(const MeshModel& layer);

// ---- Parameters that several filters have, and how errors name a parameter

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

/// A length in the unit of the scene, or in percent of the diagonal of scene_box(). `advanced`: shown on
/// request only, after the others.
RichLength length_parameter(const MeshDocument& document, const char* name, double share_of_diagonal,
                            const char* label, const char* tooltip, bool advanced = false);

/// Which finite values a parameter may have.
enum class Values : std::uint8_t { all, from_0, above_0 };
/// \throw InvalidInput, which ends with `advice`, for a `value` that the parameter may not have.
double checked_value(const FilterCall& call, const char* parameter, double value, Values allowed,
                     const std::string& advice);
/// The value of a length. \throw InvalidInput if it is not allowed.
double length_of(const FilterCall& call, const char* parameter, bool may_be_zero);
/// The value of a number. \throw InvalidInput, which ends with `advice`, if it is not allowed.
double real_of(const FilterCall& call, const char* parameter, Values allowed, const char* advice);
/// The value of a whole number. \throw InvalidInput, which ends with `advice`, if it is out of range.
int number_of(const FilterCall& call, const char* parameter, int least, const char* advice,
              int greatest = std::numeric_limits<int>::max());

RichLength max_snap_distance_parameter(const MeshDocument& document);

/// The parameter exact of all filters that can also do without the index.
RichBool exact_parameter();

/// The parameter seed, and its value. \throw InvalidInput if it is negative.
RichInt seed_parameter(bool advanced = false);
std::uint64_t seed_of(const FilterCall& call);

/// The core vertex whose number in the host is the value of a parameter. \throw InvalidInput if there is
/// none.
Index vertex_of(const FilterCall& call, const LayerSurface& layer, const char* parameter);

/// A point of the scene. \throw InvalidInput if it is not finite.
Point point_of(const FilterCall& call, const char* parameter);

// ---- The vertices that the user has selected, as sources or points of a filter

/// Core vertices selected in the layer, ascending. \throw InvalidInput if there is none; `purpose` ends the
/// sentence "Select the vertices ...".
std::vector<Index> selected_vertices(const FilterCall& call, const LayerSurface& layer, const char* purpose);

// ---- The source of a filter that takes only one: a vertex by number, or what is nearest to a point

/// The parameters start_point (a point picker in the window) and vertex_index. `what`: begins the tooltip of
/// the point, such as "Where distances start: at the nearest point of the surface".
RichParameterList start_parameters(const MeshDocument& document, const QString& what);

/// The start vertex named by number, otherwise the point of the surface nearest to the start point: a vertex
/// if it is one up to single precision. Logs which. \throw InvalidInput for a number without a vertex and a
/// point that is not finite.
SnappedPoint start_point(const FilterCall& call, LayerSurface& layer);

/// The same, but always a vertex: the nearest one that has a face, as no path reaches others.
SnappedPoint start_vertex(const FilterCall& call, LayerSurface& layer);

/// Where a start point is, as returned values: start_vertex and start_face, one of which is -1, and
/// snap_distance.
Results about_start(const LayerSurface& layer, const Mesh& mesh, const SnappedPoint& start);

// ---- The two points of a filter for one pair

/// Two points of the surface; `distance` is how far each was moved there.
struct EndPoints {
  SnappedPoint source;
  SnappedPoint target;
};

/// The parameters source and target (vertices by number), source_point and target_point (in space),
/// max_snap_distance, and surface_points (both as text). `vertex`: what source and target are by default.
RichParameterList end_point_parameters(const MeshDocument& document, int vertex);

/// The points that these parameters give. \throw InvalidInput for a point that does not exist or is too far
/// from the surface.
EndPoints end_points(const FilterCall& call, LayerSurface& layer);

/// How far the points were moved to the surface, as returned values.
Results about_end_points(const EndPoints& ends);

/// Explains source and target, for the help.
QString help_on_end_points();

// ---- The points that a task is about: selected vertices, the points of a layer, or surface points in a text

/// The points, and what errors, logs and results call them.
struct TaskPoints {
  PointList points;
  /// The number of each point: that of its vertex in the current layer (selection) or in the layer that it
  /// comes from, or its position in the text.
  std::vector<int> numbers;
  std::string what;            ///< such as "selected vertices"
  double snap_distance = 0.0;  ///< the farthest move of a layer's point

  std::size_t size() const { return points.size(); }
};

/// The parameters point_layer, surface_points and max_snap_distance. `what`: ends the sentence "The layer
/// with the ...".
RichParameterList task_point_parameters(const MeshDocument& document, const char* what);

/// The points that these parameters give. `purpose`: as for selected_vertices. \throw InvalidInput if there
/// is no point, or one that is not on the surface or too far from it.
TaskPoints task_points(const FilterCall& call, LayerSurface& layer, const char* purpose);

// ---- A layer from which a filter takes points: its parameter, and its points moved to the surface

/// The parameter source_layer; max_snap_distance belongs to it. `what`: "points", or "points or lines".
RichMesh source_layer_parameter(const MeshDocument& document, const char* what);

/// The layer named by a parameter. \throw InvalidInput if there is none, or if it is the current one.
const MeshModel& other_layer(const FilterCall& call, const char* parameter, const char* what);

/// The positions of all vertices of a layer in the scene, by number. \throw InvalidInput as placement_of().
std::vector<Point> scene_positions(const MeshModel& layer);

/// Moves points of the scene to the surface of the layer, within max_snap_distance.
class PointSnapper {
 public:
  PointSnapper(const FilterCall& call, LayerSurface& layer);
  /// \throw InvalidInput if it is too far away; the message begins with name(), and ends with what to do:
  /// "Move `it` ...".
  SnappedPoint snap(const Point& at, const std::function<std::string()>& name, const char* it);
  /// The same for the vertex of this number in the layer that a parameter names.
  SurfacePoint snap_vertex(const Point& at, std::size_t number, const char* parameter);
  /// The farthest move so far.
  double farthest() const { return farthest_; }

 private:
  const FilterCall& call_;
  std::shared_ptr<const SurfaceLocator> locator_;
  double max_distance_;
  double farthest_ = 0.0;
};

/// All vertices of a layer, moved to the surface. \throw InvalidInput as other_layer and PointSnapper, and
/// for a layer without vertices.
TaskPoints snapped_layer(const FilterCall& call, LayerSurface& layer, const char* parameter,
                         const char* what);

}  // namespace vorogeo::plugin
