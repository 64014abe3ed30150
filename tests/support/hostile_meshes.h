// Meshes as bad as users have them: a random shape with random defects, the same for the same seed.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "support/shapes.h"

namespace vorogeo::test {

/// Random numbers that are the same everywhere (the distributions of the standard library are not).
class HostileRandom {
 public:
  explicit HostileRandom(std::uint64_t seed) : engine_(seed) {}
  /// In [0, count); 0 if count is 0.
  std::size_t below(std::size_t count) { return count == 0 ? 0 : engine_() % count; }
  /// In [low, high], both whole numbers.
  int between(int low, int high) { return low + static_cast<int>(below(high - low + 1)); }
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  /// A power of ten whose exponent is uniform in [low, high].
  double power(double low, double high);
  bool one_in(int count) { return below(count) == 0; }
  Point direction();

 private:
  std::mt19937_64 engine_;
};

enum class HostileBase : std::uint8_t {
  grid,       ///< rectangle: flat, hilly or rough
  folded,     ///< corrugated sheet: distances are straight lines once it is laid flat
  scan,       ///< rough closed surface
  extrusion,  ///< prism over a polygon of arcs and long sides, caps of needles: like CAD
  plate,      ///< thick plate with many holes: high genus
  pipe,       ///< long closed tube of changing width
  fan,        ///< needles round one or two vertices
  soup,       ///< random triangles over few vertices, or without any in common
  crumbs      ///< many small components: two-sided quads, tetrahedra, triangles
};
inline constexpr int hostile_base_count = 9;

enum class HostileDefect : std::uint8_t {
  // Positions move, connectivity stays.
  outliers,         ///< vertices at 1e1 to 1e12 edges, like no-data cells
  spikes,           ///< thick spikes of 1e1 to 1e4 edges
  collapsed_edges,  ///< both ends have equal coordinates
  tiny_edges,       ///< 1e-3, 1e-9 or 1e-15 of what they were
  squashed,         ///< one axis shrunk: needles
  noise,            ///< each vertex moved by about an edge: folded faces
  snapped,          ///< coordinates rounded to a coarse grid: equal vertices, faces without area
  graded,           ///< edges grow by up to 1e6 from one side to the other
  rescaled,         ///< all coordinates times 1e-20 to 1e20
  far_from_origin,  ///< moved by 1e3 to 1e8 edges: coordinates have lost digits
  // Connectivity changes.
  doubled_sheet,     ///< a region repeated on top of itself
  slit,              ///< cut open along edges, both sides at equal coordinates
  needle_fan,        ///< an edge with very many points on it, all joined to the opposite corners
  collinear_points,  ///< vertices added on edges
  flat_caps,         ///< faces without area along edges
  t_junctions,       ///< a vertex on an edge in only one of its faces: a crack
  flipped_faces,
  repeated_faces,  ///< and faces that name a vertex twice
  components,      ///< small ones, of many sizes
  small_copy,      ///< the mesh once more, 1e-2 to 1e-9 of its size
  fins,            ///< edges with three faces and more
  welds,           ///< vertices joined with others anywhere
  isolated_vertices,
  holes,
  shuffled  ///< vertices and faces in random order
};
inline constexpr int hostile_defect_count = 25;

/// All bases and defects, by their names in tables.
inline constexpr std::array hostile_kinds{"grid",
                                          "folded sheet",
                                          "scan",
                                          "extrusion",
                                          "plate with many holes",
                                          "pipe",
                                          "fan of needles",
                                          "soup of triangles",
                                          "many components",
                                          "gear",
                                          "city of blocks",
                                          "block with fillets",
                                          "drilled plate",
                                          "cylinder or cone",
                                          "plate of strips",
                                          "outliers",
                                          "spikes",
                                          "edges of no length",
                                          "tiny edges",
                                          "squashed",
                                          "noise",
                                          "rounded coordinates",
                                          "graded",
                                          "times 1e-20 to 1e20",
                                          "far from the origin",
                                          "second sheet",
                                          "slit",
                                          "fan of needles on an edge",
                                          "points on edges",
                                          "caps without area",
                                          "T-junctions",
                                          "flipped faces",
                                          "repeated faces",
                                          "more components",
                                          "small copy",
                                          "edges of three faces",
                                          "joined vertices",
                                          "isolated vertices",
                                          "holes",
                                          "random order",
                                          "cut by planes",
                                          "contracted edges",
                                          "single precision",
                                          "half taken away, capped",
                                          "cut apart",
                                          "decimated",
                                          "merged vertices",
                                          "another mesh in the same place",
                                          "loops of one edge",
                                          "georeferenced",
                                          "subdivided in places"};
/// Where the defects begin, in the order of HostileDefect; the bases come first, in that of HostileBase.
inline constexpr std::size_t first_defect_kind = 15;
static_assert(std::string_view(hostile_kinds[first_defect_kind]) == "outliers");

/// A mesh and what it is, for messages.
struct HostileMesh {
  Soup soup;
  std::string base;                  ///< "a grid of 12 x 9 cells"
  std::vector<std::string> defects;  ///< "3 vertices 1e+07 edges away"
  /// Position of each vertex in the unrolled surface, NaN where unknown: the straight line is then the
  /// geodesic distance. Empty if the surface does not unroll (any more).
  std::vector<std::array<double, 2>> flat;
  std::vector<std::size_t> kinds{};  ///< in hostile_kinds, each once

  /// \pre The name is one of hostile_kinds.
  void note_kind(std::string_view name);
  /// "a grid of 12 x 9 cells with 3 vertices 1e+07 edges away and 2 fins: 130 vertices, 238 faces"
  std::string sentence() const;
};

/// A base shape of about `vertices` vertices without defects.
HostileMesh hostile_base(HostileBase base, int vertices, HostileRandom& random);
/// Adds one defect, in about 1 to 5 % of the elements unless its name says otherwise. A mesh that offers no
/// place for it is left unchanged.
void add_defect(HostileMesh& mesh, HostileDefect defect, HostileRandom& random);
/// A toothed wheel or a city of blocks, of about `vertices` vertices.
HostileMesh machined_part(int vertices, HostileRandom& random);
/// The mesh as programs leave it: cut by planes that nearly meet a vertex or each other, decimated, or in
/// single precision.
HostileMesh remeshed(HostileMesh mesh, HostileRandom& random);
/// A part of CAD with fillets or holes, a cylinder of one or two faces for each side, or a plate of strips.
HostileMesh cad_part(int vertices, HostileRandom& random);
/// The mesh as users leave it: halved and capped, cut apart, decimated, subdivided or merged in places, with
/// another one beside it, georeferenced in single precision, or with loops of one edge.
HostileMesh edited(HostileMesh mesh, HostileRandom& random);

/// Meshes of these seeds and above are also machined parts, and most are remeshed.
inline constexpr unsigned first_remeshed_seed = 1'000'000'000;
/// Those of these are also parts of CAD, and most are edited.
inline constexpr unsigned first_edited_seed = 4'000'000'000;
/// A base with none to four defects, all chosen by the seed. The size is between half and twice `vertices`.
HostileMesh hostile_mesh(unsigned seed, int vertices);

}  // namespace vorogeo::test
