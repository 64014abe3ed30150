// What filters leave behind: distances as vertex quality, and new layers.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>

#include "host/filter_row.h"
#include "layers/layer_surface.h"
#include "mesh/surface_point.h"
#include "tasks/cut.h"
#include "tasks/surface_lines.h"

namespace vorogeo::plugin {

// ---- Distances as quality and colours

/// Quality of a vertex that got no distance: no path leads to it, or it lies beyond max_distance. A number
/// below every distance and finite, so that it can be told from a source and does not spoil ramps and
/// histograms.
inline constexpr double quality_without_distance = -1.0;

/// Light grey, which is on no ramp and in no palette: without a distance, in no region.
inline vcg::Color4b grey() { return {160, 160, 160, 255}; }

/// Along the host's ramp from red at the least to blue at the largest distance; grey without one.
vcg::Color4b color_of_distance(double distance, double largest, double least = 0.0);

/// On the host's colour wheel, where `angle` is in [0, 2 pi].
vcg::Color4b color_of_angle(double angle, bool is_dark);

/// Distances, one for each core vertex, as quality and colours. `host_vertices`: their numbers in the layer.
void write_distances(MeshModel& layer, std::span<const Index> host_vertices,
                     std::span<const double> distances, double largest);

// ---- Layers that filters add to the document: points, polylines and parts of the surface of the current
// layer, given in the scene. They have the matrix of the layer on which they lie.

/// Adds a layer with vertices and edges on another one, and with `quality` (a value for each vertex, or
/// none). Without vertices, adds no layer. `make_current`: as the host does for filters that generate. \throw
/// InvalidInput as placement_of().
void add_polyline_layer(MeshDocument& document, const MeshModel& on, const QString& name,
                        const SurfaceLines& lines, std::span<const double> quality, bool make_current);

/// Points of the surface as a layer, which becomes current. \return the numbers of their vertices in the
/// host, -1 for a point that is not a vertex, as Eigen::VectorXd.
QVariant add_surface_point_layer(FilterCall& call, const QString& name, const LayerSurface& layer,
                                 const Mesh& mesh, const PointList& points);

/// Faces of a cut mesh of the current layer as a layer, which becomes current. Its vertices and faces have
/// the colours, quality, normals and texture coordinates that the cut layer has there: between the corners of
/// a face these are interpolated. Vertices keep their order.
void add_part_layer(FilterCall& call, const QString& name, const LayerSurface& layer, const Mesh& mesh,
                    const CutMesh& cut, std::span<const Index> faces);

// ---- Files

/// The file that a parameter names; empty: none. Refused before a long computation if it is not a plain file
/// in an existing folder, or may not be written. `what` begins the message: "The CSV file". \throw
/// InvalidInput, FileError.
std::filesystem::path output_file(const FilterCall& call, const char* parameter, const char* what);

/// The parameter csv_file, and its file. The whole text is written, or nothing; nothing without a name.
/// \throw FileError.
RichFileToWrite csv_file_parameter();
std::filesystem::path csv_file(const FilterCall& call);
void write_csv(FilterCall& call, const std::filesystem::path& file, const std::string& text);

// ---- Lengths and numbers

/// A length with its unit, in seven digits: what MeshLab's window holds. Returned values have all digits.
std::string logged_length(double length);

/// Numbers in the form in which the host passes them to Python: the values, or a member of each.
template <class Values, class Member = std::identity>
QVariant as_vector(const Values& values, Member member = {}) {
  Eigen::VectorXd vector(static_cast<Eigen::Index>(values.size()));
  Eigen::Index at = 0;
  for (const auto& value : values) vector[at++] = static_cast<double>(std::invoke(member, value));
  return QVariant::fromValue(vector);
}

}  // namespace vorogeo::plugin
