// A mesh as a host gives it, and the translation of its numbers and points to the measured mesh and back.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "mesh/gaps.h"
#include "mesh/mesh.h"
#include "mesh/surface_point.h"

namespace vorogeo {

/// A mesh as a host gives it. A face that names one vertex three times takes the place of a masked one.
struct MeshInput {
  std::vector<Point> positions;
  std::vector<std::array<Index, 3>> faces;
  Metric metric;
  GapLimit gap;
};

/// The measured mesh: with its gaps bridged, or its metric, for which faces may be split, or both.
/// \throw InvalidInput, also for gaps of a mesh without positions; Cancelled.
std::shared_ptr<const Mesh> measured_mesh(MeshInput input);

/// A point in the numbers of the host. What comes out of InputMap has a face with the weights of its corners,
/// also at a vertex, which then has its first face; a point inside a bridge has no face.
struct InputPoint {
  Index vertex = no_index;
  Index face = no_index;
  std::array<double, 3> weights{};
};

/// Translates vertices, faces and points between the numbers of the host and those of the measured mesh,
/// which leaves out faces, splits some of them at added vertices, and has bridges. A view of a mesh, which
/// must outlive it.
class InputMap {
 public:
  explicit InputMap(const Mesh& mesh) : mesh_(mesh) {}

  /// \throw InvalidInput for a vertex or a face that is not given or was left out; names it. Weights that
  /// validated() refuses are returned as they are.
  SurfacePoint point_in(const InputPoint& point) const;
  /// The point with these weights in a given face; none if that does not exist or was left out.
  std::optional<SurfacePoint> in_face(Index given_face, const std::array<double, 3>& weights) const;
  InputPoint point_out(const SurfacePoint& point) const;
  /// The given face that holds a point: the first one at an added vertex, no_index at a given vertex.
  /// \pre The point is not in a bridge.
  Index face_at(const SurfacePoint& point) const;
  /// The weights in the given face of the point that has `weights` in `face`, that face or a part of it.
  std::array<double, 3> weights_out(Index face, const std::array<double, 3>& weights) const;

  /// Values of all vertices, without those of added vertices.
  template <class T>
  std::vector<T> of_vertices(std::vector<T> values) const {
    values.resize(static_cast<std::size_t>(mesh_.given_vertex_count()));
    return values;
  }
  /// Values of the given vertices, and for each added one the mean of the two ends of its line.
  std::vector<double> on_vertices(std::span<const double> values) const;
  /// For each given face that was not left out: itself, or the part that holds its centre. Without bridges.
  std::vector<Index> central_parts() const;
  /// Values of faces at the centres of the given ones; `none` where one was left out.
  template <class Values, class T>
  std::vector<T> of_faces(const Values& values, const T& none) const {
    std::vector<T> given(static_cast<std::size_t>(mesh_.given_face_count()), none);
    for (const Index f : central_parts()) given[mesh_.input_face(f)] = values[f];
    return given;
  }
  /// The edges that make up the edge between two given vertices, in order; empty if there is none.
  std::vector<Index> edges_between(Index a, Index b) const;

 private:
  SurfacePoint in_parts(Index first, const std::array<double, 3>& weights) const;
  bool is_given(const SurfacePoint& point) const {
    return point.is_vertex() && point.vertex < mesh_.given_vertex_count();
  }

  const Mesh& mesh_;
};

}  // namespace vorogeo
