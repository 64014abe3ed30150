// Directions, neighbours and distances of border edges.
#include "mesh/border_sides.h"

#include <cmath>

#include "mesh/vectors.h"

namespace vorogeo {

namespace {

/// Sides face each other if their directions out of the surface differ by at least 60 degrees.
constexpr double max_cosine = 0.5;
/// Faces may overlap by this part of their height, as rounding and noise make borders that meet overlap.
constexpr double max_overlap = 0.1;

std::uint64_t key_of(Index a, Index b) {
  const auto [low, high] = std::minmax(a, b);
  return static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high);
}

BorderSide side_of(const Mesh& mesh, Index h) {
  BorderSide side{h, mesh.tail(h), mesh.head(h), {}, 0.0};
  const Point& a = mesh.position(side.tail);
  const Point along = minus(mesh.position(side.head), a);
  const Point to_apex = minus(mesh.position(mesh.apex(h)), a);
  const double square = dot(along, along);
  const Point inwards = square > 0.0 ? moved(to_apex, -dot(to_apex, along) / square, along) : to_apex;
  side.depth = length_of(inwards);
  if (side.depth > 0.0) side.out = moved({}, -1.0 / side.depth, inwards);
  return side;
}

std::vector<BorderSide> sides_of(const Mesh& mesh) {
  std::vector<BorderSide> sides;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    if (mesh.is_border_edge(e)) sides.push_back(side_of(mesh, mesh.edge_halfedge(e)));
  }
  return sides;
}

Box box_of(const Mesh& mesh, const BorderSide& side) {
  Box box{mesh.position(side.tail), mesh.position(side.tail)};
  box.add({mesh.position(side.head), mesh.position(side.head)});
  return box;
}

std::vector<Box> boxes_of(const Mesh& mesh, const std::vector<BorderSide>& sides) {
  std::vector<Box> boxes;
  boxes.reserve(sides.size());
  for (const BorderSide& side : sides) boxes.push_back(box_of(mesh, side));
  return boxes;
}

}  // namespace

BorderSides::BorderSides(const Mesh& mesh)
    : mesh_(mesh), sides_(sides_of(mesh)), tree_(boxes_of(mesh, sides_)) {
  side_between_.reserve(sides_.size());
  for (Index s = 0; s < count(); ++s) side_between_[key_of(sides_[s].tail, sides_[s].head)] = s;
}

Box BorderSides::box(Index side) const { return box_of(mesh_, sides_[side]); }

Index BorderSides::between(Index a, Index b) const {
  const auto found = side_between_.find(key_of(a, b));
  return found == side_between_.end() ? no_index : found->second;
}

Index BorderSides::next(Index side, Index vertex) const {
  Index h = sides_[side].halfedge;
  for (;;) {
    const Index other = mesh_.head(h) == vertex ? Mesh::next_in_face(h) : Mesh::previous_in_face(h);
    const Index twin = mesh_.next_around_edge(other);
    if (twin == other) return between(mesh_.tail(other), mesh_.head(other));
    if (mesh_.next_around_edge(twin) != other) return no_index;
    h = twin;
  }
}

Point BorderSides::nearest_on(Index side, const Point& position) const {
  const Point& a = mesh_.position(sides_[side].tail);
  const Point along = minus(mesh_.position(sides_[side].head), a);
  const double square = dot(along, along);
  const double t = square > 0.0 ? std::clamp(dot(minus(position, a), along) / square, 0.0, 1.0) : 0.0;
  return moved(a, t, along);
}

SidePair BorderSides::beside(Index first, Index second) const {
  const Point& a = mesh_.position(sides_[first].tail);
  const Point along = minus(mesh_.position(sides_[first].head), a);
  const double square = dot(along, along);
  const auto place = [&](Index vertex) {
    const double t = square > 0.0 ? dot(minus(mesh_.position(vertex), a), along) / square : 0.0;
    return std::clamp(t, 0.0, 1.0);
  };
  const auto [from, to] = std::minmax({place(sides_[second].tail), place(sides_[second].head)});
  SidePair pair{};
  pair.overlap = (to - from) * std::sqrt(square);
  const Point middle = moved(a, 0.5 * (from + to), along);
  pair.across = minus(nearest_on(second, middle), middle);
  pair.apart = length_of(pair.across);
  pair.nearest = pair.apart;
  for (const double t : {from, to}) {
    const Point at = moved(a, t, along);
    pair.nearest = std::min(pair.nearest, distance_between(at, nearest_on(second, at)));
  }
  return pair;
}

bool BorderSides::continues(Index first, Index second, const Point& across, bool folds) const {
  const BorderSide& a = sides_[first];
  const BorderSide& b = sides_[second];
  return (folds || dot(a.out, b.out) <= max_cosine) && dot(a.out, across) >= -max_overlap * a.depth &&
         -dot(b.out, across) >= -max_overlap * b.depth;
}

}  // namespace vorogeo
