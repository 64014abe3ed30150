// The class _core.Paths: points anywhere on the surface of an index's mesh, their paths and fields.
#include "paths_binding.h"

#include <algorithm>
#include <mutex>

#include "arrays.h"
#include "index_binding.h"
#include "mesh/surface_locator.h"
#include "progress_bridge.h"
#include "query/path_query.h"
#include "query/source_field.h"
#include "support/error.h"
#include "support/parallel.h"

namespace vorogeo::python {

namespace {

using ValueArray = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

/// Surface points as Python holds them: a vertex, or -1 and a face with three weights.
struct PointArrays {
  const IdArray& vertex;
  const IdArray& face;
  const VertexArray& weights;
};

/// Queries of one index, each lent to one caller at a time; made when first needed.
class Paths {
 public:
  explicit Paths(nb::handle index) : held_(held_index(index)) {}

  nb::tuple snap(const VertexArray& points) {
    std::vector<Index> faces(points.shape(0));
    std::vector<double> weights(3 * faces.size());
    std::vector<double> distances(faces.size());
    {
      nb::gil_scoped_release release;
      const SurfaceLocator& on_surface = locator();
      for (std::size_t i = 0; i < faces.size(); ++i) {
        const double* p = points.data() + 3 * i;
        const SnappedPoint found = on_surface.nearest({p[0], p[1], p[2]});
        distances[i] = found.distance;
        put(found.point, faces[i], weights.data() + 3 * i);
      }
    }
    return nb::make_tuple(to_numpy(std::move(faces)), to_numpy(std::move(weights)),
                          to_numpy(std::move(distances)));
  }

  /// Paths of pairs: lengths, certified, where the points of each begin, positions, vertices, faces, weights.
  nb::tuple paths(const IdArray& source_vertex, const IdArray& source_face, const VertexArray& source_weights,
                  const IdArray& target_vertex, const IdArray& target_face, const VertexArray& target_weights,
                  bool exact, bool certify, nb::object progress) {
    const auto sources = points_from({source_vertex, source_face, source_weights});
    const auto targets = points_from({target_vertex, target_face, target_weights});
    std::vector<ExactPath> found(sources.size());
    ProgressBridge bridge(progress);
    bridge.run([&](const Progress& report) {
      constexpr std::size_t at_once = 16;
      const std::size_t blocks = (found.size() + at_once - 1) / at_once;
      parallel_for(blocks, held_.threads, report, "Paths", [&](std::size_t block, int) {
        std::unique_ptr<PathQuery> query = take_query();
        for (std::size_t i = block * at_once; i < std::min(found.size(), (block + 1) * at_once); ++i) {
          found[i] = exact ? query->exact_path(sources[i], targets[i], certify)
                           : ExactPath{query->path(sources[i], targets[i]), false};
        }
        const std::lock_guard lock(mutex_);
        queries_.push_back(std::move(query));
      });
      return true;
    });
    return as_arrays(found);
  }

  nb::tuple field(const IdArray& vertex, const IdArray& face, const VertexArray& weights,
                  const ValueArray& offsets, double max_distance) {
    const auto points = points_from({vertex, face, weights});
    LabelledField result;
    {
      nb::gil_scoped_release release;
      std::vector<ExactSource> sources;
      for (std::size_t i = 0; i < points.size(); ++i) sources.push_back({points[i], offsets.data()[i]});
      const std::lock_guard lock(field_mutex_);
      if (!field_) field_ = std::make_unique<SourceField>(held_.index, held_.threads);
      result = field_->field(sources, max_distance);
    }
    return nb::make_tuple(to_numpy(std::move(result.distance)), to_numpy(std::move(result.source)));
  }

 private:
  const Mesh& mesh() const { return *held_.index->mesh(); }

  const SurfaceLocator& locator() {
    const std::lock_guard lock(mutex_);
    if (!locator_) locator_ = std::make_unique<SurfaceLocator>(held_.index->mesh());
    return *locator_;
  }

  std::unique_ptr<PathQuery> take_query() {
    {
      const std::lock_guard lock(mutex_);
      if (!queries_.empty()) {
        auto query = std::move(queries_.back());
        queries_.pop_back();
        return query;
      }
    }
    return std::make_unique<PathQuery>(held_.index);
  }

  /// The face of the mesh that was given as this row of faces. \throw InvalidInput if it was left out.
  Index mesh_face(Index input_face) const {
    Index low = 0;
    Index high = mesh().face_count();
    while (low < high) {
      const Index middle = low + (high - low) / 2;
      (mesh().input_face(middle) < input_face ? low : high) =
          mesh().input_face(middle) < input_face ? middle + 1 : middle;
    }
    if (low < mesh().face_count() && mesh().input_face(low) == input_face) return low;
    throw InvalidInput(
        "Face " + std::to_string(input_face) +
        " is left out of the index (it names a vertex twice or repeats a face), so no point lies in it.");
  }

  std::vector<SurfacePoint> points_from(const PointArrays& arrays) const {
    std::vector<SurfacePoint> points(arrays.vertex.shape(0));
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double* w = arrays.weights.data() + 3 * i;
      const Index vertex = arrays.vertex.data()[i];
      points[i] = vertex >= 0 ? SurfacePoint::at_vertex(vertex)
                              : validated(mesh(), SurfacePoint::in_face(mesh_face(arrays.face.data()[i]),
                                                                        {w[0], w[1], w[2]}));
    }
    return points;
  }

  /// A point as a row of the given faces and weights; a vertex as a corner of its first face.
  void put(const SurfacePoint& point, Index& face, double* weights) const {
    for_first_face(point, [&](Index at, const std::array<double, 3>& there) {
      face = mesh().input_face(at);
      std::ranges::copy(there, weights);
    });
  }
  template <class Visit>
  void for_first_face(const SurfacePoint& point, Visit&& visit) const {
    bool done = false;
    for_each_face_at(mesh(), point, [&](Index face, const std::array<double, 3>& weights) {
      if (!done) visit(face, weights);
      done = true;
    });
  }

  nb::tuple as_arrays(const std::vector<ExactPath>& found) const {
    std::vector<double> lengths;
    std::vector<Index> certified;
    std::vector<std::int64_t> begin{0};
    std::vector<double> positions;
    std::vector<Index> vertices;
    std::vector<Index> faces;
    std::vector<double> weights;
    for (const ExactPath& one : found) {
      lengths.push_back(one.path.length);
      certified.push_back(one.certified ? 1 : 0);
      for (const SurfacePoint& point : one.path.points) {
        for (double coordinate : position_of(mesh(), point)) positions.push_back(coordinate);
        vertices.push_back(point.is_vertex() ? point.vertex : no_index);
        faces.push_back(no_index);
        weights.resize(weights.size() + 3, 0.0);
        put(point, faces.back(), weights.data() + weights.size() - 3);
      }
      begin.push_back(static_cast<std::int64_t>(vertices.size()));
    }
    return nb::make_tuple(to_numpy(std::move(lengths)), to_numpy(std::move(certified)),
                          to_numpy(std::move(begin)), to_numpy(std::move(positions)),
                          to_numpy(std::move(vertices)), to_numpy(std::move(faces)),
                          to_numpy(std::move(weights)));
  }

  HeldIndex held_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<PathQuery>> queries_;
  std::unique_ptr<SurfaceLocator> locator_;
  std::mutex field_mutex_;
  std::unique_ptr<SourceField> field_;
};

}  // namespace

void bind_paths(nb::module_& module) {
  nb::class_<Paths>(module, "Paths")
      .def(nb::init<nb::handle>(), nb::arg("index"))
      .def("snap", &Paths::snap, nb::arg("points"))
      .def("paths", &Paths::paths, nb::arg("source_vertex"), nb::arg("source_face"),
           nb::arg("source_weights"), nb::arg("target_vertex"), nb::arg("target_face"),
           nb::arg("target_weights"), nb::arg("exact"), nb::arg("certify"), nb::arg("progress").none())
      .def("field", &Paths::field, nb::arg("vertex"), nb::arg("face"), nb::arg("weights"), nb::arg("offsets"),
           nb::arg("max_distance"));
}

}  // namespace vorogeo::python
