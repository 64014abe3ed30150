// Points and edges of the faces that were given, on a mesh in which some of them are split.
#pragma once

#include <span>
#include <vector>

#include "mesh/surface_point.h"

namespace vorogeo {

/// The first face of the mesh that is the given face of this number or a part of it; no_index if that was
/// left out.
Index first_part(const Mesh& mesh, Index given_face);

/// The point with these weights in a given face. Weights that validated() refuses are passed on to it.
/// \pre `first` is first_part() of the face.
SurfacePoint point_in_given(const Mesh& mesh, Index first, const std::array<double, 3>& weights);

/// The weights of the corners of the given face in a point that has `weights` in its part `face`.
std::array<double, 3> weights_in_given(const Mesh& mesh, Index face, const std::array<double, 3>& weights);

/// The face given that holds a point, the first of those at a vertex that was added; no_index at a vertex
/// that was given. \pre The point is not in a bridge.
Index given_face_at(const Mesh& mesh, const SurfacePoint& point);

/// Of each given face that was not left out, itself or the part of it with its centre; without bridges.
std::vector<Index> central_parts(const Mesh& mesh);

/// The edges that make up the edge between two given vertices, in order; empty if there is none.
std::vector<Index> edges_between(const Mesh& mesh, Index a, Index b);

/// Values of the given vertices, and means of two for those that were added.
std::vector<double> with_middles(const Mesh& mesh, std::span<const double> values);

}  // namespace vorogeo
