// VTP (Qin, Han, Yu, Yu, Zhang 2016) on one mesh, from its authors' sources: prints {"field": source, "cpu":
// seconds} for each source. A run spoils their mesh, so each source has a mesh of its own, whose set-up
// counts.
//
//   vtp_peer MESH FIELDS SOURCE...
// FIELDS: float64, one field after the other.
#include <cstring>
#include <memory>        // for their auto_ptr
#define sscanf_s sscanf  // their reader of files, which nothing here calls
#include <geodesic_algorithm_exact.h>
#include <geodesic_mesh.h>
#undef sscanf_s

#include "raw_mesh.h"

int main(int count, char** arguments) try {
  if (count < 4) {
    std::fprintf(stderr, "usage: vtp_peer MESH FIELDS SOURCE...\n");
    return 2;
  }
  const bench::RawMesh raw = bench::read_mesh(arguments[1]);
  std::vector<double> points;
  std::vector<unsigned> faces;
  for (const auto& point : raw.positions) points.insert(points.end(), point.begin(), point.end());
  for (const auto& face : raw.faces) faces.insert(faces.end(), face.begin(), face.end());
  std::ofstream fields(arguments[2], std::ios::binary);
  for (int i = 3; i < count; ++i) {
    std::vector<double> distances;
    std::cout.setstate(std::ios::failbit);  // they print
    const bench::Seconds time = bench::seconds([&] {
      geodesic::Mesh mesh;
      mesh.initialize_mesh_data(points, faces);
      geodesic::GeodesicAlgorithmExact algorithm(&mesh);
      algorithm.propagate(static_cast<unsigned>(std::atol(arguments[i])));
      for (geodesic::Vertex& vertex : mesh.vertices()) distances.push_back(vertex.geodesic_distance());
    });
    fields.write(reinterpret_cast<const char*>(distances.data()),
                 static_cast<std::streamsize>(distances.size() * sizeof(double)));
    std::printf("{\"field\": %s, \"cpu\": %.9g}\n", arguments[i], time.cpu);
    std::fflush(stdout);
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
