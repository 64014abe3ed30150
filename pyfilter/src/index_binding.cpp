// The class _core.Index: a built index with its queries, without argument checks.
#include "index_binding.h"

#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "arrays.h"
#include "index/geodesic_index.h"
#include "mesh/given_points.h"
#include "progress_bridge.h"
#include "query_pool.h"
#include "support/progress.h"
#include "support/parallel.h"

namespace vorogeo::python {

namespace {

/// What a Python index object holds.
class IndexHandle {
 public:
  IndexHandle(std::shared_ptr<const GeodesicIndex> index, std::size_t input_faces, int threads)
      : pool_(std::make_shared<QueryPool>(std::move(index), threads)), input_faces_(input_faces) {}

  const GeodesicIndex& index() const { return pool_->index(); }
  HeldIndex held() const { return {pool_->shared_index(), pool_, pool_->threads(), input_faces_}; }

  double distance(Index source, Index target) {
    nb::gil_scoped_release release;
    return pool_->lend([&](GeodesicQuery& query) { return query.distance(source, target); });
  }

  DoubleArray distances(const IdArray& sources, const IdArray& targets) {
    const auto from = ids_of(sources);
    const auto to = ids_of(targets);
    std::vector<double> values(from.size());
    auto fill = [&](std::size_t begin, std::size_t end) {
      pool_->lend([&](GeodesicQuery& query) {
        for (std::size_t i = begin; i < end; ++i) values[i] = query.distance(from[i], to[i]);
        return true;
      });
    };
    constexpr std::size_t pairs_at_once = 256;
    if (values.size() <= pairs_at_once) {
      nb::gil_scoped_release release;
      fill(0, values.size());
    } else {
      ProgressBridge bridge{nb::handle(Py_None)};
      bridge.run([&](const Progress& progress) {
        const std::size_t count = (values.size() + pairs_at_once - 1) / pairs_at_once;
        parallel_for(count, pool_->threads(), progress, "Distances", [&](std::size_t item, int) {
          fill(item * pairs_at_once, std::min(values.size(), (item + 1) * pairs_at_once));
        });
      });
    }
    return to_numpy(std::move(values));
  }

  DoubleArray distance_field(const IdArray& sources, double max_distance) {
    std::vector<double> values;
    {
      nb::gil_scoped_release release;
      values = pool_->lend(
          [&](GeodesicQuery& query) { return query.distance_field(ids_of(sources), max_distance); });
    }
    return of_given_vertices(*index().mesh(), std::move(values));
  }

  /// Patches by input face, of one in parts that at its centre; no_index for a face that the mesh leaves out.
  IndexArray face_patches(int layer) const {
    const std::span<const Index> patches = index().face_patches(layer);
    std::vector<Index> values(input_faces_, no_index);
    for (Index f : central_parts(*index().mesh())) values[index().mesh()->input_face(f)] = patches[f];
    return to_numpy(std::move(values));
  }

  void save(const std::filesystem::path& file) const {
    nb::gil_scoped_release release;
    index().save(file);
  }

  /// How many bridges join borders.
  Index bridge_count() const { return index().mesh()->face_count() - index().mesh()->first_bridge(); }

  nb::dict statistics() const {
    const IndexStatistics& s = index().statistics();
    nb::dict d;
    const Mesh& mesh = *index().mesh();
    Index faces = 0;
    for (Index f = 0; f < mesh.first_bridge(); ++f) {
      faces += f == 0 || mesh.input_face(f) != mesh.input_face(f - 1);
    }
    d["vertices"] = s.vertices;
    d["faces"] = faces;
    d["bridges"] = bridge_count();
    d["components"] = s.components;
    d["first_layer_patches"] = s.first_layer_patches;
    d["second_layer_patches"] = s.second_layer_patches;
    d["first_layer_border_vertices"] = s.first_layer_border_vertices;
    d["second_layer_border_vertices"] = s.second_layer_border_vertices;
    d["form"] = to_string(s.form);
    d["arcs_before_pruning"] = s.arcs_before_pruning;
    d["arcs"] = s.arcs;
    d["bytes"] = s.bytes;
    d["mapped_bytes"] = s.mapped_bytes;
    d["seconds"] = s.seconds;
    d["expected_fields"] = s.expected_fields;
    d["delta"] = s.delta;
    d["seed"] = s.seed;
    return d;
  }

 private:
  std::shared_ptr<QueryPool> pool_;
  std::size_t input_faces_;
};

/// The Python object owns what build and load return.
IndexHandle* build(const VertexArray& vertices, const FaceArray& faces, const SideArray& sides,
                   Index first_layer_patches, Index second_layer_patches, double delta, int threads,
                   std::uint64_t seed, std::int64_t memory_budget, double gap, bool folds,
                   const std::optional<std::filesystem::path>& file, nb::object progress) {
  IndexOptions options;
  options.first_layer_patches = first_layer_patches;
  options.second_layer_patches = second_layer_patches;
  options.delta = delta;
  options.threads = threads;
  options.seed = seed;
  options.memory_budget = memory_budget;
  ProgressBridge bridge(progress);
  auto index = bridge.run([&](const Progress& report) {
    std::shared_ptr<const Mesh> mesh;
    {
      const Watch watch(report.part(0.0, 0.01), "Reading the mesh");
      mesh = mesh_of(vertices, faces, sides, {gap, folds});
    }
    const Progress rest = report.part(0.01, 1.0);
    return file ? GeodesicIndex::build_in_file(*file, std::move(mesh), options, rest)
                : GeodesicIndex::build(std::move(mesh), options, rest);
  });
  return new IndexHandle(std::move(index), faces.shape(0), threads);
}

IndexHandle* load(const std::filesystem::path& file, const VertexArray& vertices, const FaceArray& faces,
                  const SideArray& sides, int threads, double gap, bool folds, bool mapped) {
  nb::gil_scoped_release release;
  auto index = GeodesicIndex::load(file, mesh_of(vertices, faces, sides, {gap, folds}),
                                   mapped ? TableStorage::mapped : TableStorage::copied);
  return new IndexHandle(std::move(index), faces.shape(0), threads);
}

}  // namespace

HeldIndex held_index(nb::handle object) { return nb::cast<const IndexHandle&>(object).held(); }

nb::object index_object(std::shared_ptr<const GeodesicIndex> index, std::size_t input_faces, int threads) {
  return nb::cast(new IndexHandle(std::move(index), input_faces, threads), nb::rv_policy::take_ownership);
}

void bind_index(nb::module_& module) {
  nb::class_<IndexHandle>(module, "Index")
      .def_static("build", &build, nb::arg("vertices"), nb::arg("faces"), nb::arg("sides").none(),
                  nb::arg("first_layer_patches"), nb::arg("second_layer_patches"), nb::arg("delta"),
                  nb::arg("threads"), nb::arg("seed"), nb::arg("memory_budget"), nb::arg("gap"),
                  nb::arg("folds"), nb::arg("file").none(), nb::arg("progress").none())
      .def_static("load", &load, nb::arg("file"), nb::arg("vertices"), nb::arg("faces"),
                  nb::arg("sides").none(), nb::arg("threads"), nb::arg("gap"), nb::arg("folds"),
                  nb::arg("mapped"))
      .def("distance", &IndexHandle::distance, nb::arg("source"), nb::arg("target"))
      .def("distances", &IndexHandle::distances, nb::arg("sources"), nb::arg("targets"))
      .def("distance_field", &IndexHandle::distance_field, nb::arg("sources"), nb::arg("max_distance"))
      .def("face_patches", &IndexHandle::face_patches, nb::arg("layer"))
      .def("save", &IndexHandle::save, nb::arg("file"))
      .def("statistics", &IndexHandle::statistics);
}

}  // namespace vorogeo::python
