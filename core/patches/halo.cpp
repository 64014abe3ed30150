// Rings of faces grown around patches.
#include "patches/halo.h"

#include <algorithm>

namespace vorogeo {

namespace {

/// Number of faces at which a ring is cut short: far more than the rings of meshes without hubs have.
std::size_t broken_off(std::size_t wanted) { return 2 * wanted + Halo::greatest_fan; }

}  // namespace

std::vector<Index> first_faces(std::span<const Index> label, Index patch_count) {
  std::vector<Index> begin(patch_count + 1, 0);
  for (Index patch : label) ++begin[patch + 1];
  for (Index p = 0; p < patch_count; ++p) begin[p + 1] += begin[p];
  return begin;
}

Halo::Halo(const Mesh& mesh, std::span<const Index> face_begin)
    : mesh_(mesh), face_begin_(face_begin), mask_(mesh.face_count(), 0), passed_(mesh.vertex_count(), 0) {}

template <class Visit>
std::size_t Halo::for_ring(const std::vector<Index>& list, std::size_t begin, std::size_t max_faces,
                           Visit&& visit) {
  const std::size_t end = list.size();
  for (std::size_t i = begin; i < end; ++i) {
    const Index first_corner = 3 * list[i];
    for (Index corner = first_corner; corner < first_corner + 3; ++corner) {
      const Index v = mesh_.tail(corner);
      if (passed_[v] == stamp_) continue;
      const auto corners = mesh_.corners(v);
      if (corners.size() > greatest_fan) {
        for (Index side : {corner, Mesh::previous_in_face(corner)}) {
          // A next face that was taken before is in the list itself, and the ring goes on from there.
          for (Index h = mesh_.next_around_edge(side); h != side; h = mesh_.next_around_edge(h)) {
            if (list.size() >= max_faces) return end;
            if (!visit(Mesh::face_of(h))) break;
          }
        }
        continue;
      }
      passed_[v] = stamp_;
      for (Index around : corners) {
        if (list.size() >= max_faces) return end;
        visit(Mesh::face_of(around));
      }
    }
  }
  return end;
}

void Halo::forget_vertices() {
  if (++stamp_ != 0) return;
  std::fill(passed_.begin(), passed_.end(), 0);
  stamp_ = 1;
}

void Halo::surround(std::span<const Index> patches, double growth) {
  for (Index f : faces_) mask_[f] = 0;
  faces_.clear();
  for (Index p : patches) {
    for (Index f = face_begin_[p]; f < face_begin_[p + 1]; ++f) {
      mask_[f] = surrounded;
      faces_.push_back(f);
    }
  }
  const auto wanted = static_cast<std::size_t>(growth * static_cast<double>(faces_.size()));
  forget_vertices();
  std::size_t ring = 0;
  while (ring < faces_.size() && faces_.size() < wanted) {
    ring = for_ring(faces_, ring, broken_off(wanted), [&](Index f) {
      if (mask_[f] != 0) return false;
      mask_[f] = surrounded;
      faces_.push_back(f);
      return true;
    });
  }
}

void Halo::widen(std::span<const Index> around, int rings, std::size_t max_faces) {
  ringed_.clear();
  forget_vertices();
  auto mark = [&](Index f) {
    if ((mask_[f] & in_rings) != 0) return false;
    if (mask_[f] == 0) faces_.push_back(f);
    mask_[f] |= in_rings;
    ringed_.push_back(f);
    return true;
  };
  for (Index f : around) mark(f);
  std::size_t ring = 0;
  for (int k = 0; k < rings && ring < ringed_.size() && ringed_.size() < max_faces; ++k) {
    ring = for_ring(ringed_, ring, broken_off(max_faces), mark);
  }
}

}  // namespace vorogeo
