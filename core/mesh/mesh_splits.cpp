// A mesh whose faces were split for a metric, with what was given of it.
#include <algorithm>

#include "mesh/mesh.h"

namespace vorogeo {

namespace {

std::vector<Point> with_middles(std::vector<Point> positions,
                                const std::vector<std::array<Index, 2>>& middle_of) {
  for (const auto& [a, b] : middle_of) {
    Point middle{};
    for (int k = 0; k < 3; ++k) middle[k] = 0.5 * positions[a][k] + 0.5 * positions[b][k];
    positions.push_back(middle);
  }
  return positions;
}

}  // namespace

Mesh::Mesh(std::vector<Point> positions, const std::vector<std::array<Index, 3>>& given,
           const FaceSplits& splits)
    : Mesh(with_middles(std::move(positions), splits.middle_of), splits.faces, &splits.sides) {
  middle_of_ = splits.middle_of;
  std::vector<Index> given_face(face_count());
  for (Index f = 0; f < face_count(); ++f) given_face[f] = splits.given_face[input_face(f)];
  for (Index f = 1; f < face_count(); ++f) {
    const Index number = given_face[f];
    const bool is_second_part =
        number == given_face[f - 1] && (split_faces_.empty() || split_faces_.back().given != number);
    if (is_second_part) split_faces_.push_back({number, given[number]});
  }
  input_face_ = std::move(given_face);
}

const std::array<Index, 3>& Mesh::given_corners(Index face) const {
  const auto found = std::ranges::lower_bound(split_faces_, input_face(face), {}, &SplitFace::given);
  const bool is_part = found != split_faces_.end() && found->given == input_face(face);
  return is_part ? found->corners : face_vertices_[face];
}

}  // namespace vorogeo
