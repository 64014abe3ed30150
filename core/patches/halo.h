// The faces of some patches and a rim around them, as a mask for the exact solver.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace vorogeo {

/// First face of each patch, then the number of faces. `label`: patch of each face, ascending, so that the
/// faces of a patch are consecutive.
std::vector<Index> first_faces(std::span<const Index> label, Index patch_count);

/// The faces of some patches and a rim around them, as a mask for the exact solver.
///
/// A shortest path between points of the patches may leave them for a short stretch; the rim (halo) lets it.
class Halo {
 public:
  /// `face_begin`: see first_faces(). Both must outlive the halo.
  Halo(const Mesh& mesh, std::span<const Index> face_begin);

  /// Faces of patches and rim together, relative to those of the patches alone: enough for paths between
  /// points of the patches.
  static constexpr double default_growth = 1.5;
  /// A vertex with more faces than this is a hub of needles.
  static constexpr std::size_t greatest_fan = 1000;

  /// Marks the patches and a rim around them; earlier marks are cleared. A ring of faces is taken whole,
  /// unless that would make the rim much larger than asked for. At a hub of needles, a ring takes only the
  /// next face on either side: all faces at the hub may be most of the mesh, and would leave no room for
  /// faces beside the patches. Of the many faces at an edge of a hub, some may come a ring later. Complexity:
  /// O(faces marked), plus the faces at the vertex where a ring is cut short.
  void surround(std::span<const Index> patches, double growth = default_growth);
  /// Also marks the faces within some rings around given faces, up to about `max_faces` faces: the last ring
  /// is taken whole unless it is much larger. To be called once after surround(). Complexity: as surround().
  void widen(std::span<const Index> around, int rings, std::size_t max_faces);
  /// Not 0 for the marked faces. Shape (faces).
  std::span<const std::uint8_t> mask() const { return mask_; }
  /// The marked faces.
  std::span<const Index> faces() const { return faces_; }

 private:
  /// Calls visit(face) for the faces at the vertices of the faces list[begin ...] until the list has
  /// `max_faces` faces. visit() adds a face to the list and returns true, or false if it is there already.
  /// Returns the size that the list had at first.
  template <class Visit>
  std::size_t for_ring(const std::vector<Index>& list, std::size_t begin, std::size_t max_faces,
                       Visit&& visit);
  /// Marks all vertices as not passed.
  void forget_vertices();

  const Mesh& mesh_;
  std::span<const Index> face_begin_;  ///< by patch
  // Bits of the mask.
  static constexpr std::uint8_t surrounded = 1;
  static constexpr std::uint8_t in_rings = 2;
  std::vector<std::uint8_t> mask_;
  std::vector<Index> faces_;
  std::vector<Index> ringed_;
  /// By vertex: the value of stamp_ when its faces were visited, so that each fan but those of hubs is
  /// visited once.
  std::vector<std::uint32_t> passed_;
  std::uint32_t stamp_ = 0;
};

}  // namespace vorogeo
