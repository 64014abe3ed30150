// A walk for each step of the chain.
#include "path/path_steps.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "path/step_walk.h"

namespace vorogeo {

namespace {

bool append(const Mesh& mesh, FaceStrip& strip, Index face, Index exit, Index entry, Index pivot) {
  if (exit == no_index) return turn_around(mesh, strip, pivot, face);
  strip.push(face, exit, entry);
  return true;
}

}  // namespace

bool strip_along_chain(const IndexData& data, const PathChain& chain, FaceStrip& strip) {
  const Mesh& mesh = *data.work.mesh;
  strip.clear();
  auto any_face = [&](const SurfacePoint& point) {
    return point.is_vertex() ? Mesh::face_of(mesh.corners(point.vertex).front()) : point.face;
  };
  std::vector<StepWalk> walks;
  std::vector<std::uint8_t> forwards;
  walks.reserve(chain.steps.size());
  Index vertex = chain.source;
  for (const ChainStep& step : chain.steps) {
    forwards.push_back(step.patch == no_index || data.row_in_patch(step.patch, step.vertex) != no_index);
    walks.emplace_back(data, step.patch, forwards.back() ? vertex : step.vertex,
                       forwards.back() ? step.vertex : vertex);
    vertex = step.vertex;
  }
  std::vector<StepWalk*> going;
  for (StepWalk& walk : walks) going.push_back(&walk);
  // Each walk terminates (step_walk.h).
  while (!going.empty()) std::erase_if(going, [](StepWalk* walk) { return !walk->go_on(); });
  vertex = chain.source;
  if (!strip.source.is_vertex()) strip.faces.push_back(strip.source.face);
  for (std::size_t k = 0; k < walks.size(); ++k) {
    if (!walks[k].arrived()) return false;
    const auto& passed = walks[k].passed();
    for (std::size_t i = 0; i < passed.size(); ++i) {
      const std::size_t at = forwards[k] ? i : passed.size() - 1 - i;
      Index exit = passed[at].exit;
      Index entry = passed[at].entry;
      Index pivot = passed[at].pivot;
      if (!forwards[k]) {
        // The crossing to the face walked after this one, in the opposite direction.
        const bool first = at + 1 == passed.size();
        exit = first ? no_index : passed[at + 1].entry;
        entry = first ? no_index : passed[at + 1].exit;
        pivot = first ? vertex : passed[at + 1].pivot;
      }
      if (strip.faces.empty()) {
        strip.faces.push_back(passed[at].face);
      } else if (!append(mesh, strip, passed[at].face, exit, entry, pivot)) {
        return false;
      }
    }
    vertex = chain.steps[k].vertex;
  }
  if (strip.faces.empty()) strip.faces.push_back(any_face(strip.source));
  if (strip.target.is_vertex()) {
    const auto& last = mesh.face_vertices(strip.faces.back());
    if (std::find(last.begin(), last.end(), strip.target.vertex) == last.end()) return false;
  } else if (!turn_around(mesh, strip, vertex, strip.target.face)) {
    return false;
  }
  tidy(mesh, strip);
  return true;
}

}  // namespace vorogeo
