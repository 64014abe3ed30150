// The surface that an index works on: the user's faces sorted by patch, and points on the borders of patches.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "exact/exact_solver.h"
#include "mesh/mesh.h"
#include "mesh/surface_point.h"
#include "patches/partition.h"

namespace vorogeo {

/// The same faces as those of the user, none of them split, and the same distances. Distances between patches
/// are kept at *places*: the vertices of this mesh, and points on border edges that are long for the patches
/// beside them. To split such edges instead would turn the faces at them into needles, which every run would
/// have to cross.
struct InnerSurface {
  InnerSurface() = default;
  /// Sorts faces by patch, those of a patch in their old order, and vertices in the order in which these
  /// faces first name them: solvers and sweeps run patch by patch. Vertices without a face are left out.
  /// Complexity: O(faces + n log n) for n border points. \throw Cancelled.
  InnerSurface(const Mesh& user, const Partition& partition);

  std::shared_ptr<const Mesh> mesh;
  std::vector<Index> vertex;        ///< by user vertex; no_index for one without a face
  std::vector<Index> user_vertex;   ///< by vertex
  std::vector<Index> face;          ///< by user face
  std::vector<Index> user_face;     ///< by face; their corners are in the same order
  std::vector<Index> second_layer;  ///< second-layer patch by face, ascending
  std::vector<EdgePoint> point;     ///< points on border edges, by edge and position: place vertex_count + i

  Index vertex_count() const { return static_cast<Index>(user_vertex.size()); }
  Index place_count() const { return vertex_count() + static_cast<Index>(point.size()); }
  bool is_vertex(Index place) const { return place < vertex_count(); }
  /// \pre The place is not a vertex.
  const EdgePoint& point_at(Index place) const { return point[place - vertex_count()]; }
  /// Calls visit(vertex) or visit(point of an edge) for what is at a place, as solvers take either.
  template <class Visit>
  decltype(auto) at_place(Index place, Visit&& visit) const {
    return is_vertex(place) ? visit(place) : visit(point_at(place));
  }
  /// Whether faces with different labels meet at an edge.
  bool is_border(Index edge, std::span<const Index> label) const;
  /// The places inside an edge, in order from its first vertex, by the first and one past the last.
  /// Complexity: O(log points) at an edge between patches of the second layer, O(1) at others.
  std::array<Index, 2> places_inside(Index edge) const;
  SurfacePoint surface_point(Index place) const;
  /// In space; NaN on a surface without positions.
  Point position(Index place) const { return position_of(*mesh, surface_point(place)); }

  /// A validated point of the user's mesh on this one. \pre If it is a vertex, it has a face.
  SurfacePoint inner_point(const SurfacePoint& user) const {
    return user.is_vertex() ? SurfacePoint::at_vertex(vertex[user.vertex])
                            : SurfacePoint::in_face(face[user.face], user.barycentric);
  }
  SurfacePoint user_point(const SurfacePoint& inner) const {
    return inner.is_vertex() ? SurfacePoint::at_vertex(user_vertex[inner.vertex])
                             : SurfacePoint::in_face(user_face[inner.face], inner.barycentric);
  }
  SurfacePath user_path(SurfacePath path) const;

  /// Calls visit(edge, place, next place, length) for every edge, or every piece of it between two places.
  template <class Visit>
  void for_each_piece(Visit&& visit) const {
    auto next = point.begin();
    for (Index edge = 0; edge < mesh->edge_count(); ++edge) {
      const auto [first, last] = mesh->edge_vertices(edge);
      Index place = first;
      double at = 0.0;
      for (; next != point.end() && next->edge == edge; ++next) {
        const Index here = vertex_count() + static_cast<Index>(next - point.begin());
        visit(edge, place, here, next->position - at);
        place = here;
        at = next->position;
      }
      visit(edge, place, last, mesh->edge_length(edge) - at);
    }
  }

  std::size_t memory_bytes() const;
};

/// Places as the targets of a run.
struct PlaceTargets {
  std::vector<Index> vertices;
  std::vector<EdgePoint> points;

  void clear() {
    vertices.clear();
    points.clear();
  }
  void add(const InnerSurface& surface, std::span<const Index> places);
  std::size_t size() const { return vertices.size() + points.size(); }
};

/// The triangle of places around a point of a face: the face itself, or where there are places on its sides,
/// one of the pieces into which they divide it. The distances of its corners tell that of the point: far
/// corners of a large face would tell it less well.
struct FacePiece {
  /// \pre `weights` are those of a point in the face.
  FacePiece(const InnerSurface& surface, Index face, const std::array<double, 3>& weights);

  std::array<Index, 3> place;
  std::array<double, 3> weights;  ///< of the point among these places
  std::array<double, 3> length;   ///< of the side from each place to the next

  /// The point's distance from a source, by those of the three places. See distance_in_triangle().
  double distance(const std::array<double, 3>& at_places) const {
    return distance_in_triangle(length, weights, at_places);
  }
};

}  // namespace vorogeo
