// What the report on a mesh says: one sentence for each finding, and a summary.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "mesh/mesh_check.h"

namespace vorogeo {

namespace {

/// "1 face has" or "3 faces have", from "face has|faces have".
std::string counted(Index count, const std::string& forms) {
  const auto bar = forms.find('|');
  return std::to_string(count) + " " + (count == 1 ? forms.substr(0, bar) : forms.substr(bar + 1));
}

/// "10,000".
std::string grouped(double power_of_ten) {
  std::ostringstream text;
  text.precision(0);
  text << std::fixed << power_of_ten;
  std::string digits = text.str();
  for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3) digits.insert(at, 1, ',');
  return digits;
}

std::string number(double value) {
  std::ostringstream text;
  text.precision(4);
  text << value;
  return text.str();
}

/// Four digits of a value, not below it.
std::string number_above(double value) {
  const double unit = value > 0.0 ? std::pow(10.0, std::floor(std::log10(value)) - 3.0) : 1.0;
  return number(std::ceil(value / unit * (1.0 - 1e-12)) * unit);
}

/// "2000, 40 and 3 vertices (the first: 0, 2000 and 2040)".
std::string sizes_of(const std::vector<MeshComponent>& components) {
  constexpr std::size_t max_named = 5;
  const std::size_t named = std::min(components.size(), max_named);
  std::string sizes;
  std::string vertices;
  for (std::size_t i = 0; i < named; ++i) {
    const std::string comma = i == 0 ? "" : i + 1 == components.size() ? " and " : ", ";
    sizes += comma + std::to_string(components[i].vertices);
    vertices += comma + std::to_string(components[i].first_vertex);
  }
  const std::size_t rest = components.size() - named;
  const std::string more = rest == 0 ? "" : " and " + std::to_string(rest) + " more";
  return sizes + more + " vertices (the first of each: " + vertices + more + ")";
}

}  // namespace

std::vector<std::string> MeshReport::sentences() const {
  std::vector<std::string> result;
  auto say = [&](const MeshFinding& finding, const std::string& forms, const std::string& where,
                 const std::string& meaning) {
    if (finding.count == 0) return;
    const std::string first = finding.count == 1 ? " (" : " (the first: ";
    result.push_back(counted(finding.count, forms) + first + where + "); " + meaning);
  };
  auto vertex = [](const MeshFinding& finding) { return "vertex " + std::to_string(finding.first); };
  auto face = [](const MeshFinding& finding) { return "face " + std::to_string(finding.first); };

  if (faces == 0) result.emplace_back("The mesh has no face; distances over a surface need at least one.");
  say(non_finite_vertices,
      "vertex has a coordinate that is not a finite number|vertices have a coordinate that is not a finite "
      "number",
      vertex(non_finite_vertices), "such a mesh is refused: repair it or remove its bad vertices.");
  say(faces_out_of_range, "face names a vertex that does not exist|faces name a vertex that does not exist",
      face(faces_out_of_range),
      "such a mesh is refused: it has " +
          (vertices == 0 ? std::string("no vertices") : "vertices 0 to " + std::to_string(vertices - 1)) +
          "; repair it or remove its bad faces.");
  say(faces_with_repeated_vertex, "face names a vertex twice|faces name a vertex twice",
      face(faces_with_repeated_vertex), "left out.");
  say(duplicate_faces,
      "face has the three vertices of an earlier face|faces have the three vertices of an earlier face",
      face(duplicate_faces), "left out.");
  say(zero_area_faces, "face has no area|faces have no area", face(zero_area_faces),
      "kept as a connection without width, which paths cross at no cost.");
  say(duplicate_vertices,
      "vertex lies at the position of an earlier vertex|vertices lie at the position of an earlier vertex",
      vertex(duplicate_vertices),
      "not joined to it, so paths pass only where faces connect; merge close vertices first if they should "
      "be one.");
  say(isolated_vertices, "vertex belongs to no face|vertices belong to no face", vertex(isolated_vertices),
      "not reached by any path.");
  say(non_manifold_edges, "edge has three or more faces|edges have three or more faces",
      "between vertices " + std::to_string(first_non_manifold_edge[0]) + " and " +
          std::to_string(first_non_manifold_edge[1]) + ", at face " +
          std::to_string(non_manifold_edges.first),
      "paths may turn from each of the faces into any other.");
  say(non_manifold_vertices,
      "vertex joins faces that share no edge there|vertices join faces that share no edge there",
      vertex(non_manifold_vertices), "paths may pass through the vertex from any of the faces to any other.");
  say(inconsistent_edges,
      "edge lies between faces of opposite orientation|edges lie between faces of opposite orientation",
      "at face " + std::to_string(inconsistent_edges.first), "this does not change distances.");
  say(t_junctions,
      "vertex lies inside a border edge of another face|vertices lie inside a border edge of another face",
      vertex(t_junctions) + ", on the edge between vertices " + std::to_string(first_t_junction_edge[0]) +
          " and " + std::to_string(first_t_junction_edge[1]),
      "no path crosses such a T-junction: split the edge at the vertex if the surface should be joined.");
  // 17234 typical edges are given as 10,000: the order of magnitude is enough.
  const std::string ratio =
      outliers.count == 0 ? "" : grouped(std::pow(10.0, std::floor(std::log10(outlier_ratio) + 1e-9)));
  say(outliers,
      "vertex lies " + ratio + " times farther out than the rest|vertices lie " + ratio +
          " times farther out than the rest",
      vertex(outliers),
      "distances between the others are not affected (up to 1e13 times); remove them if they are errors of "
      "measurement or no-data values.");
  if (components > 1) {
    result.push_back(std::to_string(components) + " components, of " + sizes_of(component_sizes) +
                     "; no path leads from one to another.");
    if (gap_to_join_all < unreachable) {
      result.push_back("Bridging gaps of " +
                       (gap_to_join_all > 0.0 ? "up to " + number_above(gap_to_join_all)
                                              : std::string("any width, as borders touch,")) +
                       " would make the components one.");
    }
  }
  if (gap.length > 0.0) {
    result.push_back("Bridging gaps of up to " + number(gap.length) + " joins " +
                     counted(joined_borders, "border|borders") + " of " + std::to_string(border_loops.count) +
                     " and leaves " + counted(components_after_bridging, "component|components") + ".");
  }
  if (near_borders.count > 0) {
    result.push_back(counted(near_borders.count, "border vertex lies|border vertices lie") + " close to " +
                     (near_borders.count == 1 ? "another" : "others") +
                     " that no short path leads to (the closest: " + "vertices " +
                     std::to_string(near_borders.closest[0]) + " and " +
                     std::to_string(near_borders.closest[1]) + ", " + number(near_borders.least) +
                     " apart; the farthest: " + number(near_borders.greatest) +
                     "); paths cross such gaps only if they are bridged, or the vertices merged.");
  }
  const double factor = factor_to_unit(mean_edge_length, longest_edge_length);
  auto say_scale = [&](const std::string& who, const LengthLimits& limits) {
    result.push_back("Edges are " + number(mean_edge_length) + " long on average and up to " +
                     number(longest_edge_length) + ", but " + who + " mean lengths of at least " +
                     number(limits.least_mean) + " and edges of at most " + number(limits.greatest) +
                     ": multiply the coordinates, for example by " + number(factor) +
                     ", and divide the distances by it.");
  };
  if (!fits(exact_lengths)) {
    say_scale("distances take", exact_lengths);
  } else if (!fits(index_lengths)) {
    say_scale("an index takes", index_lengths);
  }
  return result;
}

std::string MeshReport::summary() const {
  std::string result = counted(vertices, "vertex|vertices") + ", " + counted(faces, "face|faces") + ", " +
                       counted(components, "component|components") + ", " +
                       counted(border_loops.count, "border loop|border loops");
  if (border_loops.count > 0) {
    result += std::string(border_loops.count == 1 ? " (" : " (the longest: ") +
              counted(border_loops.longest_edges, "edge|edges") + ", " + number(border_loops.longest_length) +
              " long, at vertex " + std::to_string(border_loops.longest_vertex) + ")";
  }
  return result + ".";
}

}  // namespace vorogeo
