// CGAL's geodesic distances on one mesh, with the protocol of worker.py: lines of JSON, and the fields in a
// file.
//
//   cgal_peer exact|heat MESH FIELDS BUDGET REPEATS SOURCE...
// FIELDS: float64, one field after the other. BUDGET: seconds of all cores after which no further source is
// begun.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/version.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "raw_mesh.h"

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Surface::Vertex_index;

Surface load(const char* file) {
  const bench::RawMesh raw = bench::read_mesh(file);
  Surface surface;
  for (const auto& p : raw.positions) surface.add_vertex({p[0], p[1], p[2]});
  for (const auto& f : raw.faces) {
    if (surface.add_face(Vertex(f[0]), Vertex(f[1]), Vertex(f[2])) == Surface::null_face()) {
      throw std::runtime_error("CGAL::Surface_mesh refuses a face: the mesh is not an oriented manifold");
    }
  }
  return surface;
}

/// Exact distances: Xin and Wang (2009).
class Exact {
 public:
  explicit Exact(const Surface& surface) : surface_(surface), solver_(surface) {}
  std::vector<double> field(Vertex source) {
    solver_.remove_all_source_points();
    solver_.add_source_point(source);
    std::vector<double> distances;
    distances.reserve(surface_.number_of_vertices());
    for (const Vertex vertex : surface_.vertices()) {
      distances.push_back(solver_.shortest_distance_to_source_points(vertex).first);
    }
    return distances;
  }

 private:
  const Surface& surface_;
  CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Surface>> solver_;
};

/// Heat method on the intrinsic Delaunay triangulation, CGAL's default.
class Heat {
 public:
  explicit Heat(const Surface& surface) : surface_(surface), solver_(surface_) {
    distance_ = surface_.add_property_map<Vertex, double>("v:distance", 0.0).first;
    field(*surface_.vertices().begin());  // the first one factors the matrices
  }
  std::vector<double> field(Vertex source) {
    solver_.clear_sources();
    solver_.add_source(source);
    solver_.estimate_geodesic_distances(distance_);
    std::vector<double> distances;
    distances.reserve(surface_.number_of_vertices());
    for (const Vertex vertex : surface_.vertices()) distances.push_back(distance_[vertex]);
    return distances;
  }

 private:
  Surface surface_;
  Surface::Property_map<Vertex, double> distance_;
  CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Surface> solver_;
};

template <class Method>
void run(const char* mesh_file, const char* fields_file, double budget, int repeats, int count,
         char** sources) {
  const Surface surface = load(mesh_file);
  const std::clock_t start = std::clock();
  Method method(surface);
  std::printf("{\"prepared\": %.9g, \"version\": \"%s\"}\n",
              static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, CGAL_VERSION_STR);
  std::fflush(stdout);
  std::ofstream fields(fields_file, std::ios::binary);
  const std::clock_t begin = std::clock();
  const auto has_time = [&] { return static_cast<double>(std::clock() - begin) < budget * CLOCKS_PER_SEC; };
  for (int i = 0; i < count && (i == 0 || has_time()); ++i) {
    const Vertex source(static_cast<Vertex::size_type>(std::atol(sources[i])));
    for (int repeat = 0; repeat < repeats && (repeat == 0 || has_time()); ++repeat) {
      std::vector<double> distances;
      const bench::Seconds time = bench::seconds([&] { distances = method.field(source); });
      if (repeat == 0) {
        fields.write(reinterpret_cast<const char*>(distances.data()),
                     static_cast<std::streamsize>(distances.size() * sizeof(double)));
        fields.flush();
      }
      std::printf("{\"field\": %s, \"seconds\": %.9g, \"cpu\": %.9g}\n", sources[i], time.wall, time.cpu);
      std::fflush(stdout);
    }
  }
}

}  // namespace

int main(int count, char** arguments) try {
  const std::string method = count > 6 ? arguments[1] : "";
  if (method != "exact" && method != "heat") {
    std::fprintf(stderr, "usage: cgal_peer exact|heat MESH FIELDS BUDGET REPEATS SOURCE...\n");
    return 2;
  }
  (method == "exact" ? run<Exact> : run<Heat>)(arguments[2], arguments[3], std::atof(arguments[4]),
                                               std::atoi(arguments[5]), count - 6, arguments + 6);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
