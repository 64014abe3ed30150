// Fast marching on triangles.
#pragma once

#include "methods/method.h"
#include "methods/obtuse_corners.h"

namespace vorogeo {

/// Plane waves through the triangles of a mesh, in order of arrival.
class FastMarching final : public GeodesicMethod {
 public:
  explicit FastMarching(const std::shared_ptr<const Mesh>& mesh);
  std::vector<double> field(std::span<const Index> sources, const Progress& progress) override;
  std::size_t bytes() const override;

 private:
  Index vertices_;
  std::vector<MarchingTriangle> triangles_;
  std::vector<std::size_t> begin_;
  std::vector<std::size_t> seen_from_;
};

}  // namespace vorogeo
