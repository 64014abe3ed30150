// Triangle meshes for tests: shapes whose geodesic distances have a closed form, closed surfaces, and
// defects.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "mesh/mesh.h"
#include "mesh/surface_point.h"

namespace vorogeo::test {

/// Raw arrays, as in a mesh file.
struct Soup {
  std::vector<Point> positions;
  std::vector<std::array<Index, 3>> faces;
};

std::shared_ptr<const Mesh> make_mesh(const Soup& soup);
/// All coordinates times `factor`.
Soup scaled(Soup soup, double factor);
/// Each face in four, over the middles of its edges, which follow the other vertices; without faces that name
/// a vertex twice.
Soup in_four(const Soup& soup);

/// A mesh and the exact geodesic distance of any two of its points, from a formula.
///
/// The formula takes points by vertices and faces of the soup; those of its Mesh are the same, as nothing is
/// left out.
struct Shape {
  Soup soup;
  std::function<double(const SurfacePoint&, const SurfacePoint&)> distance;

  double vertex_distance(Index a, Index b) const {
    return distance(SurfacePoint::at_vertex(a), SurfacePoint::at_vertex(b));
  }
};

// ---- shapes with closed-form distances (shapes.cpp, box.cpp)

/// Rectangle [0, width] x [0, height] in z = 0 with columns x rows cells of two triangles; inner vertices
/// move by up to `jitter` of a cell (at most 0.25). Vertex (i, j) has index j (columns + 1) + i. Distance:
/// the straight line.
Shape plane_grid(int columns, int rows, double width, double height, double jitter = 0.0, unsigned seed = 1);

/// Open prism over a regular polygon: a strip rolled up, each flat side `columns_per_side` cells wide; inner
/// heights move by up to `jitter` of a row (below 0.5). Distance: the straight line in the strip, by the
/// shorter way round.
Shape prism(int sides, int columns_per_side, int rows, double side_width, double height, double jitter = 0.0,
            unsigned seed = 1);

/// Cone of flat sectors around an apex (vertex 0), `rings` rings of faces. The unrolled angle of a sector is
/// total_angle / sectors. Below 2 pi: a convex pyramid; above: a zig-zag saddle (sectors even). Distance: the
/// straight line unrolled, through the apex if the unrolled angle between the points reaches pi.
Shape cone(int sectors, int rings, double total_angle, double radius);

/// Closed box [0, size[0]] x [0, size[1]] x [0, size[2]], `cells` grid cells along each edge. Distance: the
/// shortest straight line over all unfoldings of its six sides.
Shape box(const std::array<double, 3>& size, int cells);

/// Three rectangles of spine_length x page_width glued along one spine of non-manifold edges. Distance: the
/// straight line with the two pages laid flat.
Shape book_of_three_pages(int cells, double spine_length, double page_width);

/// Two unit squares in one plane that share only the corner (0, 0, 0). Distance: straight, or through that
/// corner.
Shape bow_tie(int cells);

/// plane_grid over [-2, 2] x [-1, 1] (2 cells a unit x `refinement`) cut open along y = 0, -1 <= x <= 1.
/// Distance: the straight line, or round an end of the slit.
Shape plane_with_slit(int refinement);

// ---- closed surfaces (surfaces.cpp)

/// Unit icosahedron, each face split into 4 `subdivisions` times, vertices on the unit sphere.
Soup icosphere(int subdivisions);
/// Convex hull of random points of the unit sphere.
Soup random_sphere(int vertices, unsigned seed);
/// Torus with the given radii, around z.
Soup torus(int around, int across, double major_radius, double minor_radius);

// ---- parts as CAD programs triangulate them (machined.cpp)

/// Plate [0, columns] x [0, rows] x [0, thickness] with a hole of random radius through each unit cell;
/// circles of 16 to 64 points, in fans from the corners of the cells, and walls one face high. Closed, genus
/// columns x rows.
Soup drilled_plate(int columns, int rows, double thickness, unsigned seed);
/// Toothed wheel with a bore, one face high; the end faces are needles from the teeth to an eighth as many
/// points of the bore. `points_per_tooth` x `teeth` is a multiple of 8. Closed, genus 1.
Soup gear(int teeth, int points_per_tooth, double height);
/// Ground [0, columns] x [0, rows] with a block of random height on each unit cell, in as few faces as that
/// takes. One sheet with a border; positions are heights above the ground but for the walls.
Soup block_city(int columns, int rows, unsigned seed);

// ---- defects (defects.cpp); indices of the vertices and faces that were there stay, unless said otherwise

/// Both in one soup without joining them; the second's vertices and faces follow the first's.
Soup two_components(const Soup& first, const Soup& second);
/// One more vertex, in no face.
Soup with_isolated_vertex(const Soup& soup, const Point& position);
/// The face once more at the end, starting at another corner and turned over.
Soup with_duplicate_face(const Soup& soup, Index face);
/// A face that names the same vertex twice, at the end.
Soup with_repeated_vertex_face(const Soup& soup, Index face);
/// The orientation of about half of the faces turned over.
Soup with_flipped_faces(const Soup& soup, unsigned seed);
/// Adds a vertex in the middle of an edge of a face on this face's side only: the face is split (its second
/// half is the last but one face) and a cap of zero area over the edge and the new, last vertex closes the
/// gap (the last face).
Soup with_zero_area_cap(const Soup& soup, Index face, int corner);

/// A part of the edges, none of which share a vertex, scaled about their first end: to length 0 by factor 0
/// (two vertices at the same place), to twice their length by 2.
Soup with_scaled_edges(const Soup& soup, double part, double factor, unsigned seed);

/// A part of the inner edges, none of which share a face, cut open: each is given two midpoints at the same
/// place, one for the face on either side, so that the surface has a slit there. The new vertices come last,
/// in pairs; the faces are renumbered.
Soup with_slit_edges(const Soup& soup, double part, unsigned seed);

/// The soup and a copy of it, `ratio` times as large and 0.5 higher, that share one vertex in 110: needles
/// join the two.
Soup with_small_copy(const Soup& soup, double ratio);

}  // namespace vorogeo::test
