// Paths as arrays for Python.
#pragma once

#include <vector>

#include "arrays.h"
#include "exact/surface_path.h"
#include "point_arrays.h"

namespace vorogeo::python {

/// Collects paths: lengths, certified, where the points of each path begin, positions, vertices, faces,
/// weights, and which points begin a step over a gap.
class PathArrays {
 public:
  explicit PathArrays(const Mesh& mesh) : mesh_(mesh) {}

  void add(const SurfacePath& path, bool certified) {
    lengths_.push_back(path.length);
    certified_.push_back(certified ? 1 : 0);
    for (const SurfacePoint& point : path.points) {
      for (double coordinate : position_of(mesh_, point)) positions_.push_back(coordinate);
      rows_.add(mesh_, point);
    }
    for (const bool over : steps_over_gaps(mesh_, path.points)) over_gap_.push_back(over ? 1 : 0);
    begin_.push_back(static_cast<std::int64_t>(rows_.vertex.size()));
  }

  nb::tuple take() {
    return nb::make_tuple(to_numpy(std::move(lengths_)), to_numpy(std::move(certified_)),
                          to_numpy(std::move(begin_)), to_numpy(std::move(positions_)),
                          to_numpy(std::move(rows_.vertex)), to_numpy(std::move(rows_.face)),
                          to_numpy(std::move(rows_.weights)), to_numpy(std::move(over_gap_)));
  }

 private:
  const Mesh& mesh_;
  std::vector<double> lengths_;
  std::vector<Index> certified_;
  std::vector<std::int64_t> begin_{0};
  std::vector<double> positions_;
  PointRows rows_;
  std::vector<Index> over_gap_;
};

}  // namespace vorogeo::python
