// Unfolding face by face, and the funnel as a double-ended queue.
#include "query/path_funnel.h"

#include <algorithm>
#include <cmath>

#include "exact/solver_state.h"

namespace vorogeo {

namespace {

double cross(const PlanePoint& origin, const PlanePoint& a, const PlanePoint& b) {
  return (a[0] - origin[0]) * (b[1] - origin[1]) - (a[1] - origin[1]) * (b[0] - origin[0]);
}

}  // namespace

void Funnel::unfold(const ExactGeometry& geometry, const FaceStrip& strip) {
  const Mesh& mesh = *geometry.mesh;
  edges_.clear();
  std::array<double, 3> weights{};
  const FacePlane first(geometry, strip.faces.front());
  weights_in_face(mesh, strip.source, strip.faces.front(), weights);
  source_ = first.at(weights);
  if (strip.faces.size() == 1) {
    weights_in_face(mesh, strip.target, strip.faces.front(), weights);
    target_ = first.at(weights);
    return;
  }
  // The plane has the corners counterclockwise: who leaves across a half-edge sees its head on the left.
  const Index leaving = strip.exit.front();
  edges_.push_back({mesh.head(leaving), mesh.tail(leaving), first.corner[Mesh::next_in_face(leaving) % 3],
                    first.corner[leaving % 3]});
  for (std::size_t i = 1; i < strip.faces.size(); ++i) {
    const Index entry = strip.entry[i - 1];
    const FaceFrame& frame = geometry.frame[entry];
    const UnfoldedEdge edge = edges_.back();
    const double length = mesh.edge_length(mesh.edge_of(entry));
    const bool left_first = mesh.edge_vertices(mesh.edge_of(entry))[0] == edge.left;
    const double from_left = left_first ? frame.apex_x : length - frame.apex_x;
    double ux = edge.at_right[0] - edge.at_left[0];
    double uy = edge.at_right[1] - edge.at_left[1];
    const double scale = length > 0.0 ? 1.0 / length : 0.0;
    ux *= scale;
    uy *= scale;
    const PlanePoint apex{edge.at_left[0] + ux * from_left - uy * frame.apex_depth,
                          edge.at_left[1] + uy * from_left + ux * frame.apex_depth};
    if (i + 1 == strip.faces.size()) {
      weights_in_face(mesh, strip.target, strip.faces[i], weights);
      target_ = {};
      for (int k = 0; k < 3; ++k) {
        const Index v = mesh.face_vertices(strip.faces[i])[k];
        const PlanePoint& at = v == edge.left ? edge.at_left : v == edge.right ? edge.at_right : apex;
        target_[0] += weights[k] * at[0];
        target_[1] += weights[k] * at[1];
      }
      return;
    }
    const Index out = strip.exit[i];
    const bool keeps_left = mesh.tail(out) == edge.left || mesh.head(out) == edge.left;
    if (keeps_left) {
      edges_.push_back({edge.left, frame.apex, edge.at_left, apex});
    } else {
      edges_.push_back({frame.apex, edge.right, apex, edge.at_right});
    }
  }
}

std::size_t Funnel::add(const PlanePoint& point, bool left, Index vertex, std::size_t crossing) {
  const std::size_t id = nodes_.size();
  auto at = [&](std::size_t slot) -> const PlanePoint& { return nodes_[funnel_[slot]].at; };
  if (left) {
    while (head_ < tail_) {
      if (head_ < apex_) {
        if (cross(at(head_ + 1), at(head_), point) > 0.0) break;
        ++head_;
      } else {
        if (cross(at(head_), at(head_ + 1), point) >= 0.0) break;
        ++head_;
        apex_ = head_;
      }
    }
    nodes_.push_back({point, funnel_[head_], vertex, crossing, left});
    funnel_[--head_] = id;
  } else {
    while (head_ < tail_) {
      if (tail_ > apex_) {
        if (cross(at(tail_ - 1), at(tail_), point) < 0.0) break;
        --tail_;
      } else {
        if (cross(at(tail_), at(tail_ - 1), point) <= 0.0) break;
        --tail_;
        apex_ = tail_;
      }
    }
    nodes_.push_back({point, funnel_[tail_], vertex, crossing, left});
    funnel_[++tail_] = id;
  }
  return id;
}

void Funnel::pull(const ExactGeometry& geometry, const FaceStrip& strip) {
  unfold(geometry, strip);
  nodes_.clear();
  bends_.clear();
  const std::size_t middle = edges_.size() + 2;
  funnel_.resize(2 * middle + 1);
  head_ = tail_ = apex_ = middle;
  nodes_.push_back({source_, 0, no_index, 0, true});
  funnel_[middle] = 0;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const UnfoldedEdge& edge = edges_[i];
    if (i == 0 || edge.left != edges_[i - 1].left) add(edge.at_left, true, edge.left, i);
    if (i == 0 || edge.right != edges_[i - 1].right) add(edge.at_right, false, edge.right, i);
  }
  std::size_t node = add(target_, true, no_index, edges_.size());
  length_ = 0.0;
  while (node != 0) {
    const std::size_t parent = nodes_[node].parent;
    const PlanePoint& a = nodes_[node].at;
    const PlanePoint& b = nodes_[parent].at;
    length_ += std::hypot(a[0] - b[0], a[1] - b[1]);
    if (parent != 0) {
      bends_.push_back({nodes_[parent].vertex, nodes_[parent].left, b, nodes_[parent].crossing});
    }
    node = parent;
  }
  std::reverse(bends_.begin(), bends_.end());
}

}  // namespace vorogeo
