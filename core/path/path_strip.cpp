// Walks around vertices, and removal of detours from strips.
#include "path/path_strip.h"

#include <algorithm>
#include <unordered_set>

#include "support/checkpoint.h"

namespace vorogeo {

namespace {

/// The half-edge of the face of `halfedge` that also ends in `vertex`, but is not `halfedge`.
Index other_halfedge_at(const Mesh& mesh, Index halfedge, Index vertex) {
  const Index next = Mesh::next_in_face(halfedge);
  const Index previous = Mesh::previous_in_face(halfedge);
  return mesh.tail(halfedge) == vertex ? previous : next;
}

/// Walks around a vertex from the face of `exit` across that half-edge, until `face` is entered, and adds the
/// crossings to the strip, but not the faces. \return the angle between the two faces; infinity if a border
/// of the mesh or a non-manifold edge is met.
double walk(const Mesh& mesh, Index vertex, Index exit, Index face, FaceStrip& strip) {
  double angle = 0.0;
  const Index begin = Mesh::face_of(exit);
  // Each step enters the next face around the vertex: the walk ends at `face`, at a border of the mesh, or
  // where it began.
  for (;;) {
    const Index entry = mesh.next_around_edge(exit);
    if (entry == exit || mesh.next_around_edge(entry) != exit) return unreachable;
    strip.exit.push_back(exit);
    strip.entry.push_back(entry);
    const Index at = Mesh::face_of(entry);
    if (at == face) return angle;
    if (at == begin) return unreachable;
    exit = other_halfedge_at(mesh, entry, vertex);
    angle += mesh.corner_angle(mesh.tail(entry) == vertex ? entry : exit);
  }
}

/// The path around a non-manifold vertex with the fewest faces, by breadth-first search over its corners.
/// `passed` is empty.
bool search(const Mesh& mesh, Index vertex, Index from, Index to, std::vector<HalfedgePair>& passed) {
  struct Visit {
    Index face;
    HalfedgePair by;
    std::size_t predecessor;
  };
  // Each face of the fan is visited once, and the faces around each edge are passed once.
  std::vector<Visit> visited{{from, {no_index, no_index}, 0}};
  std::unordered_set<Index> faces{from}, edges;
  for (std::size_t i = 0; i < visited.size(); ++i) {
    if (i % elements_per_checkpoint == 0) checkpoint();
    if (visited[i].face == to) {
      for (std::size_t at = i; at != 0; at = visited[at].predecessor) passed.push_back(visited[at].by);
      std::ranges::reverse(passed);
      return true;
    }
    for (int k = 0; k < 3; ++k) {
      const Index exit = 3 * visited[i].face + k;
      if (mesh.tail(exit) != vertex && mesh.head(exit) != vertex) continue;
      if (!edges.insert(mesh.edge_of(exit)).second) continue;
      for (Index entry = mesh.next_around_edge(exit); entry != exit; entry = mesh.next_around_edge(entry)) {
        const Index face = Mesh::face_of(entry);
        if (faces.insert(face).second) visited.push_back({face, {exit, entry}, i});
      }
    }
  }
  return false;
}

}  // namespace

void FaceStrip::clear() {
  faces.clear();
  entry.clear();
  exit.clear();
}

void FaceStrip::push(Index face, Index exit_halfedge, Index entry_halfedge) {
  faces.push_back(face);
  exit.push_back(exit_halfedge);
  entry.push_back(entry_halfedge);
}

bool turn_around(const Mesh& mesh, FaceStrip& strip, Index vertex, Index face) {
  const Index from = strip.faces.back();
  if (from == face) return true;
  // Both ways round are added to the end of the strip; the longer one is removed again.
  const std::size_t old_size = strip.entry.size();
  double least = unreachable;
  auto cut = [&](std::size_t begin, std::size_t end) {
    for (std::vector<Index>* list : {&strip.exit, &strip.entry}) {
      list->erase(list->begin() + static_cast<std::ptrdiff_t>(begin),
                  list->begin() + static_cast<std::ptrdiff_t>(end));
    }
  };
  for (int k = 0; k < 3 && mesh.fan(vertex) != Mesh::Fan::non_manifold; ++k) {
    const Index exit = 3 * from + k;
    if (mesh.tail(exit) != vertex && mesh.head(exit) != vertex) continue;
    const std::size_t middle = strip.entry.size();
    const double angle = walk(mesh, vertex, exit, face, strip);
    if (angle < least) {
      least = angle;
      cut(old_size, middle);
    } else {
      cut(middle, strip.entry.size());
    }
  }
  if (least == unreachable) {
    std::vector<HalfedgePair> found;
    if (!search(mesh, vertex, from, face, found)) return false;
    for (const HalfedgePair& crossing : found) {
      strip.exit.push_back(crossing.exit);
      strip.entry.push_back(crossing.entry);
    }
  }
  for (std::size_t i = old_size; i < strip.entry.size(); ++i) {
    strip.faces.push_back(Mesh::face_of(strip.entry[i]));
  }
  return true;
}

bool other_side(const Mesh& mesh, Index vertex, Index exit, Index face, std::vector<HalfedgePair>& passed) {
  if (mesh.fan(vertex) != Mesh::Fan::closed) return false;
  exit = other_halfedge_at(mesh, exit, vertex);
  // The fan is one cycle, so the walk comes to `face`.
  for (Index at = Mesh::face_of(exit); at != face;) {
    const Index entry = mesh.next_around_edge(exit);
    passed.push_back({exit, entry});
    at = Mesh::face_of(entry);
    exit = other_halfedge_at(mesh, entry, vertex);
  }
  return true;
}

void tidy(const Mesh& mesh, FaceStrip& strip) {
  // Removes faces left and entered again at once, by a stack.
  std::size_t kept = 0;
  for (std::size_t i = 1; i < strip.faces.size(); ++i) {
    if (kept > 0 && strip.faces[kept - 1] == strip.faces[i]) {
      --kept;
      continue;
    }
    if (kept > 0 && strip.exit[i - 1] == strip.entry[kept - 1]) {
      // The face was left by the edge by which it was entered, to a third face of that edge: go straight
      // there.
      strip.faces[kept] = strip.faces[i];
      strip.entry[kept - 1] = strip.entry[i - 1];
      continue;
    }
    ++kept;
    strip.faces[kept] = strip.faces[i];
    strip.entry[kept - 1] = strip.entry[i - 1];
    strip.exit[kept - 1] = strip.exit[i - 1];
  }
  if (!strip.faces.empty()) {
    strip.faces.resize(kept + 1);
    strip.entry.resize(kept);
    strip.exit.resize(kept);
  }
  std::array<double, 3> weights{};
  std::size_t begin = 0;
  while (begin + 1 < strip.faces.size() &&
         weights_in_face(mesh, strip.source, strip.faces[begin + 1], weights)) {
    ++begin;
  }
  if (begin > 0) {
    strip.faces.erase(strip.faces.begin(), strip.faces.begin() + static_cast<std::ptrdiff_t>(begin));
    strip.entry.erase(strip.entry.begin(), strip.entry.begin() + static_cast<std::ptrdiff_t>(begin));
    strip.exit.erase(strip.exit.begin(), strip.exit.begin() + static_cast<std::ptrdiff_t>(begin));
  }
  while (strip.faces.size() > 1 &&
         weights_in_face(mesh, strip.target, strip.faces[strip.faces.size() - 2], weights)) {
    strip.faces.pop_back();
    strip.entry.pop_back();
    strip.exit.pop_back();
  }
}

}  // namespace vorogeo
