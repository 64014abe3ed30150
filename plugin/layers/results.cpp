// What filters leave behind: distances as vertex quality, and new layers.
#include "layers/results.h"

#include <vcg/complex/algorithms/update/normal.h>
#include <vcg/complex/allocate.h>

#include <QFile>
#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>

#include "layers/points.h"
#include "mesh/mesh_input.h"
#include "support/file.h"

namespace vorogeo::plugin {

// ---- Distances as quality and colours

vcg::Color4b color_of_distance(double distance, double largest, double least) {
  if (!std::isfinite(distance)) return grey();
  vcg::Color4b color;
  color.SetColorRamp(static_cast<float>(least), static_cast<float>(largest), static_cast<float>(distance));
  return color;
}

vcg::Color4b color_of_angle(double angle, bool is_dark) {
  vcg::Color4b color;
  color.SetHSVColor(static_cast<float>(angle / (2.0 * std::numbers::pi)), 0.75F, is_dark ? 0.82F : 1.0F);
  return color;
}

void write_distances(MeshModel& layer, std::span<const Index> host_vertices,
                     std::span<const double> distances, double largest) {
  layer.updateDataMask(MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR);
  for (std::size_t v = 0; v < distances.size(); ++v) {
    CVertexO& vertex = layer.cm.vert[static_cast<std::size_t>(host_vertices[v])];
    vertex.Q() = static_cast<Scalarm>(std::isfinite(distances[v]) ? distances[v] : quality_without_distance);
    vertex.C() = color_of_distance(distances[v], largest);
  }
}

// ---- Fills new layers of the document

namespace {

MeshModel& new_layer(MeshDocument& document, const MeshModel& on, const QString& name,
                     const std::vector<Point>& points, std::span<const double> quality, bool make_current) {
  const Placement placement = placement_of(on);
  MeshModel& layer = *document.addNewMesh("", name, make_current);
  layer.cm.Tr = on.cm.Tr;
  if (!points.empty()) vcg::tri::Allocator<CMeshO>::AddVertices(layer.cm, points.size());
  if (!quality.empty()) layer.updateDataMask(MeshModel::MM_VERTQUALITY);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point p = placement.to_layer(points[i]);
    layer.cm.vert[i].P() =
        Point3m(static_cast<Scalarm>(p[0]), static_cast<Scalarm>(p[1]), static_cast<Scalarm>(p[2]));
    if (!quality.empty()) layer.cm.vert[i].Q() = static_cast<Scalarm>(quality[i]);
    layer.cm.bbox.Add(layer.cm.vert[i].P());
  }
  return layer;
}

}  // namespace

void add_polyline_layer(MeshDocument& document, const MeshModel& on, const QString& name,
                        const SurfaceLines& lines, std::span<const double> quality, bool make_current) {
  if (lines.points.empty()) return;
  MeshModel& layer = new_layer(document, on, name, lines.points, quality, make_current);
  if (lines.segments.empty()) return;
  vcg::tri::Allocator<CMeshO>::AddEdges(layer.cm, lines.segments.size());
  for (std::size_t i = 0; i < lines.segments.size(); ++i) {
    layer.cm.edge[i].V(0) = &layer.cm.vert[lines.segments[i][0]];
    layer.cm.edge[i].V(1) = &layer.cm.vert[lines.segments[i][1]];
  }
}

QVariant add_surface_point_layer(FilterCall& call, const QString& name, const LayerSurface& layer,
                                 const Mesh& mesh, const PointList& points) {
  std::vector<Point> positions;
  std::vector<int> numbers;
  for (const SurfacePoint& point : points) {
    positions.push_back(position_of(mesh, point));
    numbers.push_back(point.is_vertex() ? layer.host_vertex(point.vertex) : -1);
  }
  new_layer(call.document, call.layer, name, positions, {}, true);
  return as_vector(numbers);
}

// ---- Parts of a cut mesh

namespace {

/// What a part has if the layer that was cut has it. Normals are always there.
constexpr int attributes_of_parts = MeshModel::MM_VERTCOLOR | MeshModel::MM_VERTQUALITY |
                                    MeshModel::MM_VERTTEXCOORD | MeshModel::MM_FACECOLOR |
                                    MeshModel::MM_FACEQUALITY | MeshModel::MM_WEDGTEXCOORD;

using CornerWeights = std::array<double, 3>;

/// Texture coordinates between those of the corners, corner(i); the texture is that of the nearest corner.
template <class Corner>
vcg::TexCoord2<float> tex_coord_between(const CornerWeights& weights, Corner&& corner) {
  double u = 0.0, v = 0.0;
  for (int i = 0; i < 3; ++i) {
    u += weights[i] * corner(i).U();
    v += weights[i] * corner(i).V();
  }
  vcg::TexCoord2<float> between(static_cast<float>(u), static_cast<float>(v));
  between.N() = corner(static_cast<int>(std::ranges::max_element(weights) - weights.begin())).N();
  return between;
}

/// Gives a vertex what varies over a face, as it is at a place in the face.
void interpolate(CVertexO& vertex, const CFaceO& face, const CornerWeights& weights, bool has_tex_coord) {
  double quality = 0.0;
  Point3m normal(0, 0, 0);
  std::array<double, 4> color{};
  for (int i = 0; i < 3; ++i) {
    if (weights[i] == 0.0) continue;  // a quality that is not finite stays at its corner
    quality += weights[i] * face.cV(i)->cQ();
    Point3m direction = face.cV(i)->cN();  // of any length, as hosts sum them up
    normal += direction.Normalize() * static_cast<Scalarm>(weights[i]);
    for (int k = 0; k < 4; ++k) color[k] += weights[i] * face.cV(i)->cC()[k];
  }
  vertex.Q() = static_cast<Scalarm>(quality);
  vertex.N() = normal.Normalize();
  // Rounded, unlike VCG's mixture, so that a face of one colour keeps it.
  for (int k = 0; k < 4; ++k) vertex.C()[k] = static_cast<unsigned char>(std::lround(color[k]));
  if (has_tex_coord) vertex.T() = tex_coord_between(weights, [&](int i) { return face.cV(i)->cT(); });
}

}  // namespace

void add_part_layer(FilterCall& call, const QString& name, const LayerSurface& layer, const Mesh& mesh,
                    const CutMesh& cut, std::span<const Index> faces) {
  std::vector<Index> vertices;
  for (const Index f : faces) vertices.insert(vertices.end(), cut.faces[f].begin(), cut.faces[f].end());
  std::ranges::sort(vertices);
  vertices.erase(std::ranges::unique(vertices).begin(), vertices.end());
  std::vector<Point> positions;
  for (const Index v : vertices) positions.push_back(position_of(mesh, cut.points[v]));

  const InputMap input(mesh);
  const MeshModel& whole = call.layer;
  MeshModel& part = new_layer(call.document, whole, name, positions, {}, true);
  part.updateDataMask(whole.dataMask() & attributes_of_parts);
  part.cm.textures = whole.cm.textures;
  for (const auto& [file, image] : whole.getTextures()) part.addTexture(file, image);
  vcg::tri::Allocator<CMeshO>::AddFaces(part.cm, faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Index cut_from = cut.face_of[faces[f]];
    const CFaceO& given = whole.cm.face[layer.host_face(mesh, cut_from)];
    CFaceO& face = part.cm.face[f];
    for (int i = 0; i < 3; ++i) {
      const Index corner = cut.faces[faces[f]][i];
      CVertexO& vertex = part.cm.vert[std::ranges::lower_bound(vertices, corner) - vertices.begin()];
      face.V(i) = &vertex;
      CornerWeights weights{};
      weights_in_face(mesh, cut.points[corner], cut_from, weights);
      weights = input.weights_out(cut_from, weights);
      interpolate(vertex, given, weights, part.hasDataMask(MeshModel::MM_VERTTEXCOORD));
      if (part.hasDataMask(MeshModel::MM_WEDGTEXCOORD)) {
        face.WT(i) = tex_coord_between(weights, [&](int k) { return given.cWT(k); });
      }
    }
    if (part.hasDataMask(MeshModel::MM_FACECOLOR)) face.C() = given.cC();
    if (part.hasDataMask(MeshModel::MM_FACEQUALITY)) face.Q() = given.cQ();
  }
  vcg::tri::UpdateNormal<CMeshO>::PerFaceNormalized(part.cm);
}

// ---- Files

std::filesystem::path output_file(const FilterCall& call, const char* parameter, const char* what) {
  const std::filesystem::path file =
      QFile::encodeName(call.parameters.getSaveFileName(parameter)).toStdString();
  if (!file.empty()) output_target(file, what);
  return file;
}

RichFileToWrite csv_file_parameter() {
  return RichFileToWrite("csv_file", "", "*.csv", "CSV file",
                         "File to write the table to. Empty: nothing is written.");
}

std::filesystem::path csv_file(const FilterCall& call) {
  return output_file(call, "csv_file", "The CSV file");
}

void write_csv(FilterCall& call, const std::filesystem::path& file, const std::string& text) {
  if (file.empty()) return;
  OutputFile output(file, "The CSV file");
  output.write(std::as_bytes(std::span(text)));
  output.finish();
  call.log("Table written to " + file.string());
}

// ---- Lengths

std::string logged_length(double length) {
  std::ostringstream text;
  text << std::setprecision(7) << length << " mesh units";
  return text.str();
}

}  // namespace vorogeo::plugin
