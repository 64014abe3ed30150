// Frames of the user's faces, and these faces by patch.
#include "index/unsplit_surface.h"

#include <algorithm>

#include "partition/halo.h"

namespace vorogeo {

UnsplitSurface::UnsplitSurface(std::shared_ptr<const Mesh> mesh, const WorkMesh& work,
                               const Partition& partition)
    : geometry(std::make_shared<const LocalGeometry>(std::move(mesh))),
      first_face(first_faces(partition.second_layer, partition.second_layer_count)) {
  // The pieces of a face stay together in the work mesh.
  std::ranges::unique_copy(work.user_face, std::back_inserter(faces));
}

}  // namespace vorogeo
