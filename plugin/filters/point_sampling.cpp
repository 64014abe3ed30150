// Filters: samplings by geodesic distance, Lloyd relaxation and means, each as a new layer of points.
#include <algorithm>
#include <iomanip>
#include <span>
#include <sstream>
#include <string>

#include "filters/rows.h"
#include "layers/answering.h"
#include "layers/points.h"
#include "layers/results.h"
#include "tasks/means.h"
#include "tasks/spread_points.h"

namespace vorogeo::plugin {

namespace {

RichParameterList farthest_parameters(const MeshDocument& document) {
  return list_of(
      RichInt("sample_number", 100, "Samples (0: no limit)",
              "Number of samples; 0: as many as the radius needs."),
      length_parameter(document, "radius", 0.0, "Covering radius (0: no limit)",
                       "Stop as soon as every vertex is at most this far from a sample."),
      RichBool("from_selection", false, "Begin with the selection",
               "Begin with the selected vertices, or the points given below; otherwise with a random one."),
      task_point_parameters(document, "points to begin with"), seed_parameter(), exact_parameter(),
      direction_parameter());
}

Results farthest_sampling(FilterCall& call) {
  const auto layer = layer_of(call);
  const FarthestStop stop{call.parameters.getInt("sample_number"), length_of(call, "radius", true)};
  if (stop.count < 0 || (stop.count == 0 && stop.radius == 0.0)) {
    refuse(call, "sample_number", stop.count,
           ". Give a number of samples above 0, or 0 and a covering radius above 0.");
  }
  const std::uint64_t seed = seed_of(call);
  TaskPoints start;
  if (call.parameters.getBool("from_selection")) {
    start = task_points(call, *layer, "that the sampling shall begin with");
  }
  auto [samples, answered, results] =
      ask_task(call, *layer, "Farthest point sampling", sample_farthest, stop, start.points, seed);
  results["samples"] = static_cast<int>(samples.points.size());
  results["covering_radius"] = samples.covering_radius;
  results["vertices"] =
      add_surface_point_layer(call, "Farthest point samples", *layer, *layer->mesh(), samples.points);
  results["snap_distance"] = start.snap_distance;
  call.log(std::to_string(samples.points.size()) + " samples; every vertex is within " +
           logged_length(samples.covering_radius) + " of one");
  return results;
}

RichParameterList poisson_parameters(const MeshDocument& document) {
  return list_of(
      length_parameter(document, "radius", 0.05, "Radius", "Least geodesic distance of two samples."),
      seed_parameter(), exact_parameter());
}

Results poisson_disk_sampling(FilterCall& call) {
  const auto layer = layer_of(call);
  const double radius = length_of(call, "radius", false);
  const std::uint64_t seed = seed_of(call);
  auto [samples, answered, results] =
      ask_task(call, *layer, "Poisson-disk sampling", sample_poisson_disk, radius, seed);
  results["samples"] = static_cast<int>(samples.size());
  results["vertices"] =
      add_surface_point_layer(call, "Poisson-disk samples", *layer, *layer->mesh(), PointList(samples));
  call.log(std::to_string(samples.size()) + " samples, at least " + logged_length(radius) + " apart");
  return results;
}

RichParameterList lloyd_parameters(const MeshDocument& document) {
  return list_of(task_point_parameters(document, "points that shall be relaxed"),
                 RichInt("rounds", 10, "Rounds", "At most this many; fewer if nothing improves."),
                 exact_parameter());
}

Results lloyd_relaxation(FilterCall& call) {
  const int rounds = number_of(call, "rounds", 0, ". Give 0 or more.");
  const auto layer = layer_of(call);
  const TaskPoints points = task_points(call, *layer, "that shall be relaxed");
  const auto relax = [&](Surface& surface, const TaskOptions& options) {
    return relax_points(surface, points.points, rounds, options);
  };
  auto [relaxed, answered, results] = ask_task(call, *layer, "Lloyd relaxation", relax);
  results["rounds"] = static_cast<int>(relaxed.energy.size()) - 1;
  results["energy_before"] = relaxed.energy.front();
  results["energy_after"] = relaxed.energy.back();
  results["vertices"] =
      add_surface_point_layer(call, "Relaxed points", *layer, *layer->mesh(), relaxed.points);
  results["snap_distance"] = points.snap_distance;
  call.log("Lloyd relaxation: the energy went from " + std::to_string(relaxed.energy.front()) + " to " +
           std::to_string(relaxed.energy.back()) + " in " + std::to_string(relaxed.energy.size() - 1) +
           " rounds");
  return results;
}

RichParameterList mean_parameters(const MeshDocument& document) {
  return list_of(task_point_parameters(document, "points whose mean is wanted"),
                 RichBool("median", false, "Median",
                          "The geometric median instead: the least sum of distances, not of their squares."));
}

Results mean_of_points(FilterCall& call) {
  const auto layer = layer_of(call);
  const auto mesh = layer->mesh();
  const TaskPoints points = task_points(call, *layer, "whose mean is wanted");
  const bool median = call.parameters.getBool("median");
  auto [centre, answered, results] =
      ask_task_by(Answer::exact, call, *layer, "Mean of points", centre_of, points.points,
                  std::span<const double>(), median ? Power::one : Power::two);
  const HostPlace place = layer->host_place(*mesh, centre.point);
  const char* name = median ? "Geometric median" : "Frechet mean";
  add_surface_point_layer(call, name, *layer, *mesh, std::span(&centre.point, 1));
  std::ostringstream text;
  text << name << " of " << points.size() << " " << points.what << ": "
       << (place.face < 0 ? "vertex " : "a point in face ") << std::max(place.vertex, place.face)
       << ", from which the " << (median ? "distances" : "squared distances") << " sum up to "
       << std::setprecision(7) << centre.energy;
  call.log(text.str());
  results["vertex"] = place.vertex;
  results["face"] = place.face;
  results["energy"] = centre.energy;
  results["snap_distance"] = points.snap_distance;
  return results;
}

}  // namespace

std::vector<FilterRow> sampling_rows() {
  return {
      {"Geodesic farthest point sampling (VoroGeo)", "generate_sampling_vorogeo_farthest_point",
       "<p>Samples of the vertices, each the one that is geodesically farthest from those before it, as a "
       "new layer of points, which becomes the current one. They are spread evenly: at least the covering "
       "radius apart, and every vertex is at most this radius from one. Every component gets a sample before "
       "any gets two.</p><p>It stops at <b>Samples</b> samples or at the <b>Covering radius</b>, whichever "
       "comes first. With <b>Begin with the selection</b>, the selected vertices or other points given come "
       "first; otherwise the first sample is a random vertex, chosen by <b>Seed</b>. Returns the number of "
       "<i>samples</i>, the <i>covering_radius</i>, and the numbers of the <i>vertices</i> in the sampled "
       "layer (-1: a point to begin with that is not a vertex).</p>" +
           help_on_task_points() + help_on_exact_parameter() +
           "<p>See:<br/><i>Carsten Moenning, Neil A. Dodgson</i><br/><b>\"Fast marching farthest point "
           "sampling\"</b><br/>Eurographics 2003.</p>",
       FilterPlugin::Sampling, MeshModel::MM_NONE, farthest_parameters, farthest_sampling},
      {"Geodesic Poisson-disk sampling (VoroGeo)", "generate_sampling_vorogeo_poisson_disk",
       "<p>Random vertices with a geodesic distance of at least <b>Radius</b> from each other, as a new "
       "layer of points, which becomes the current one. No vertex could be added: each is less than the "
       "radius from a sample. Distances run over the surface, so that samples on two sides of a thin wall do "
       "not repel each other.</p><p>Returns the number of <i>samples</i> and the numbers of the "
       "<i>vertices</i> in the sampled layer. The same <b>Seed</b> gives the same samples.</p>" +
           help_on_exact_parameter() +
           "<p>See:<br/><i>Robert L. Cook</i><br/><b>\"Stochastic sampling in computer "
           "graphics\"</b><br/>ACM Transactions on Graphics 5(1), 1986.</p>",
       FilterPlugin::Sampling, MeshModel::MM_NONE, poisson_parameters, poisson_disk_sampling},
      {"Geodesic Lloyd relaxation of the selection (VoroGeo)", "generate_sampling_vorogeo_lloyd_relaxation",
       "<p>Moves points repeatedly to the middle of their geodesic Voronoi regions, until they are spread "
       "evenly: towards a centroidal Voronoi tessellation. Points may begin anywhere and move to vertices. A "
       "point moves only if that lowers the integral of the squared geodesic distance over its region, so "
       "every round lowers the energy. The result is a new layer of points, which becomes the current "
       "one.</p>"
       "<p>Returns the <i>rounds</i> done, <i>energy_before</i>, <i>energy_after</i> and the numbers of the "
       "<i>vertices</i> in the sampled layer, in the order of the points.</p>" +
           help_on_task_points() + help_on_exact_parameter() +
           "<p>See:<br/><i>Gabriel Peyr&eacute;, Laurent D. Cohen</i><br/><b>\"Geodesic remeshing using "
           "front propagation\"</b><br/>International Journal of Computer Vision 69(1), 2006.</p>",
       FilterPlugin::Sampling, MeshModel::MM_NONE, lloyd_parameters, lloyd_relaxation},
      {"Geodesic mean of points (VoroGeo)", "generate_sampling_vorogeo_mean",
       "<p>The mean of points on the surface: the point from which the sum of the squared geodesic distances "
       "is least (Frechet mean), or with <b>Median</b> the sum of the distances (geometric median). It is a "
       "new layer with this point, which becomes the current one. It need not be a vertex.</p>" +
           help_on_task_points() +
           "<p>How to choose: a mean follows points that lie far off, a median hardly does. A sum may have "
           "several minima: the result is one near the given point that is best, and the log says if others "
           "are as good. Exact, without an index.</p><p>Returns the <i>energy</i>, which is the sum, and "
           "<i>vertex</i> or <i>face</i>, of which one is -1: where the point lies. The mesh is not "
           "changed.</p><p>See:<br/><i>Hermann Karcher</i><br/><b>\"Riemannian center of mass and mollifier "
           "smoothing\"</b><br/>Communications on Pure and Applied Mathematics 30(5), 1977.</p>",
       FilterPlugin::Sampling, MeshModel::MM_NONE, mean_parameters, mean_of_points}};
}

}  // namespace vorogeo::plugin
