// Exact distances inside second-layer patches.
#pragma once

#include <memory>

#include "exact/exact_geometry.h"
#include "index/patch_layer.h"
#include "support/progress.h"

namespace vorogeo {

/// The faces of some patches and a rim around them, as a mask for the exact solver.
///
/// A shortest path between points of the patches may leave them for a short way; the rim (halo) lets it.
class Halo {
 public:
  /// `label`: patch of each face, ascending, so that the faces of a patch are consecutive.
  Halo(const Mesh& mesh, std::span<const Index> label, Index patch_count);

  /// Faces of patches and rim together, relative to those of the patches alone: enough for paths between
  /// points of the patches.
  static constexpr double default_growth = 1.5;

  /// Marks the patches and a rim around them; earlier marks are taken back. Complexity: O(faces marked).
  void surround(std::span<const Index> patches, double growth = default_growth);
  /// Marks also what is within some rings of faces around the given faces, but no further ring once these are
  /// `most` faces. To be called once after surround(). Complexity: O(faces in the rings).
  void widen(std::span<const Index> around, int rings, std::size_t most);
  /// Not 0 for the marked faces. Shape (faces).
  std::span<const std::uint8_t> mask() const { return mask_; }
  /// The marked faces.
  std::span<const Index> faces() const { return faces_; }

 private:
  /// Calls visit(face) for all faces at the vertices of faces list[begin ...]; returns where those end that
  /// the list had at first.
  template <class Visit>
  std::size_t for_ring(const std::vector<Index>& list, std::size_t begin, Visit&& visit) const;

  const Mesh& mesh_;
  std::vector<Index> face_begin_;
  // Bits of the mask.
  static constexpr std::uint8_t surrounded = 1;
  static constexpr std::uint8_t in_rings = 2;
  std::vector<std::uint8_t> mask_;
  std::vector<Index> faces_;
  std::vector<Index> ringed_;
};

/// The same for tables: about one ring of faces. A distance that a wider halo would make shorter is mostly
/// found as well by a way through the next patch; wider ones changed no error of fields and pairs on real
/// meshes.
inline constexpr double table_growth = 1.2;

/// Fills the tables of a second layer by exact propagation from each border node inside its patches and their
/// halo.
void fill_local_tables(std::shared_ptr<const ExactGeometry> geometry, std::span<const Index> label,
                       PatchLayer& layer, int threads, const Progress& progress);

}  // namespace vorogeo
