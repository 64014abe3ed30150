// Binary little-endian PLY: the header line by line, then the elements at the sizes it gives.
#include "support/ply.h"

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace vorogeo::test {

namespace {

const std::map<std::string, int> size_of_type{{"char", 1},  {"uchar", 1},  {"int8", 1},    {"uint8", 1},
                                              {"short", 2}, {"ushort", 2}, {"int16", 2},   {"uint16", 2},
                                              {"int", 4},   {"uint", 4},   {"int32", 4},   {"uint32", 4},
                                              {"float", 4}, {"double", 8}, {"float32", 4}, {"float64", 8}};

template <class T>
T read_value(std::istream& in) {
  std::array<char, sizeof(T)> bytes{};
  in.read(bytes.data(), bytes.size());
  T value{};
  std::memcpy(&value, bytes.data(), sizeof(T));
  return value;
}

struct Header {
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::vector<std::pair<std::string, int>> vertex_properties;  // name and size
  bool usable = false;
};

Header read_header(std::istream& in) {
  Header header;
  std::string line;
  std::string element;
  bool little_endian = false;
  bool list_of_indices = false;
  while (std::getline(in, line) && line != "end_header") {
    std::istringstream words(line);
    std::string word;
    std::string type;
    std::string name;
    words >> word;
    if (word == "format") {
      words >> type;
      little_endian = type == "binary_little_endian";
    } else if (word == "element") {
      words >> element;
      words >> (element == "vertex" ? header.vertices : header.faces);
    } else if (word == "property" && element == "vertex") {
      words >> type >> name;
      header.vertex_properties.emplace_back(name, size_of_type.at(type));
    } else if (word == "property") {
      std::string rest;
      std::getline(words >> std::ws, rest);
      list_of_indices = rest.starts_with("list uchar int ") && !list_of_indices;
    }
  }
  header.usable = in && little_endian && list_of_indices;
  return header;
}

}  // namespace

Soup read_ply(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string magic;
  std::getline(in, magic);
  const Header header = read_header(in);
  if (magic != "ply" || !header.usable) {
    throw std::runtime_error(file.string() + " is no binary little-endian PLY file of triangles.");
  }
  Soup soup;
  soup.positions.resize(header.vertices);
  for (Point& p : soup.positions) {
    for (const auto& [name, size] : header.vertex_properties) {
      const bool coordinate = name == "x" || name == "y" || name == "z";
      if (coordinate && size >= 4) {
        p[name[0] - 'x'] = size == 4 ? static_cast<double>(read_value<float>(in)) : read_value<double>(in);
      } else {
        in.ignore(size);
      }
    }
  }
  soup.faces.resize(header.faces);
  for (auto& face : soup.faces) {
    if (read_value<std::uint8_t>(in) != 3)
      throw std::runtime_error(file.string() + " has a face that is no triangle.");
    for (Index& v : face) v = read_value<std::int32_t>(in);
  }
  if (!in) throw std::runtime_error(file.string() + " ends too early.");
  return soup;
}

std::optional<std::filesystem::path> test_mesh_file(const std::string& name) {
  const char* folder = std::getenv("VOROGEO_MESHES");
  const std::filesystem::path file =
      (folder ? std::filesystem::path(folder)
              : std::filesystem::path(VOROGEO_SOURCE_DIR) / "../shared/meshes") /
      (name + ".ply");
  if (!std::filesystem::exists(file)) return std::nullopt;
  return file;
}

}  // namespace vorogeo::test
