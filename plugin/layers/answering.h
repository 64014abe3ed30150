// From a filter call to what answers it: the surface of its layer, by the method that was chosen.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "host/filter_row.h"
#include "host/ticking.h"
#include "index/geodesic_index.h"
#include "layers/layer_metric.h"
#include "layers/layer_surface.h"
#include "query/surface.h"
#include "tasks/workers.h"

namespace vorogeo::plugin {

// ---- The layer of a call

/// The current layer in the metric and with the gaps that the parameters choose: that of an earlier call if
/// nothing of it has changed since, otherwise read anew, while the window stays responsive. Its mesh has been
/// made. \throw InvalidInput as read_surface() and measure_of().
std::shared_ptr<LayerSurface> layer_of(FilterCall& call);

/// Logs what a user should know about the mesh before trusting distances on it.
void log_warnings(FilterCall& call, LayerSurface& layer);

// ---- The index of a layer

/// What an index holds, as one line of the log and as values to return.
void log_statistics(const FilterCall& call, const IndexStatistics& statistics);
Results statistics_results(const IndexStatistics& statistics);

/// Builds an index, which answers questions about the layer from then on; logs what it holds and anything odd
/// about the mesh. `file`: where it is built, or where a build that was stopped goes on
/// (GeodesicIndex::build_in_file); empty: in memory.
std::shared_ptr<const GeodesicIndex> build_index(FilterCall& call, LayerSurface& layer,
                                                 const IndexOptions& options, const Progress& progress,
                                                 const std::filesystem::path& file = {});

// ---- The parameter method of the distance filters, and answers by it

/// The parameter method, the same in all filters that have it, and its value.
RichEnum method_parameter();
Answer method_of(const FilterCall& call);

/// What a surface found, and what a filter returns about that: answered_by, the number of its choice in the
/// parameter; from the index also index_reused and index_seconds.
template <class Found>
struct AnswerOfLayer {
  Found found;
  Answered answered;
  Results about;
};

/// Frees the solvers of an exact or quick answer where they take gigabytes; to make them anew takes little
/// time beside such an answer. `vertices`: how many a field has reached, or the mesh of a path has.
void rest_if_large(LayerSurface& layer, const Answered& answered, Index vertices);

/// Logs what answered.
Results about_answer(FilterCall& call, LayerSurface& layer, bool had_index, const Answered& answered);

/// The answer of ask(surface, answered, progress), which runs while the window stays responsive; on the
/// reversed surface if the parameter `to` asks for paths to the points. Logs what a user should know about
/// the mesh first, unless it has an index, and at the end what answered.
template <class Ask>
auto ask_surface(FilterCall& call, LayerSurface& layer, const std::string& activity, Ask&& ask) {
  const bool had_index = layer.index() != nullptr;
  if (!had_index) log_warnings(call, layer);
  Answered answered;
  const bool to = asks_for_paths_to(call);
  auto found = run_ticking(call.progress, activity, [&](const Progress& progress) {
    try {
      return ask(to ? layer.surface()->reversed() : *layer.surface(), answered, progress);
    } catch (const InvalidInput& error) {
      throw InvalidInput(layer.in_host_numbers(error.what()));
    }
  });
  Results about = about_answer(call, layer, had_index, answered);
  return AnswerOfLayer<decltype(found)>{std::move(found), std::move(answered), std::move(about)};
}

/// The same for a task of the core: the answer of task(surface, arguments..., options). The parameter exact
/// decides: by what is fastest, or by exact propagation.
template <class Task, class... Arguments>
auto ask_task(FilterCall& call, LayerSurface& layer, const char* activity, Task&& task,
              const Arguments&... arguments) {
  const Answer by = call.parameters.getBool("exact") ? Answer::exact : Answer::automatic;
  return ask_surface(call, layer, activity,
                     [&](Surface& surface, Answered& answered, const Progress& progress) {
                       return task(surface, arguments..., TaskOptions{by, progress, &answered});
                     });
}

/// The same by the method that the caller names. Large solvers are freed, and seconds are returned, too.
template <class Task, class... Arguments>
auto ask_task_by(Answer by, FilterCall& call, LayerSurface& layer, const char* activity, Task&& task,
                 const Arguments&... arguments) {
  auto answer =
      ask_surface(call, layer, activity, [&](Surface& surface, Answered& answered, const Progress& progress) {
        return task(surface, arguments..., TaskOptions{by, progress, &answered});
      });
  rest_if_large(layer, answer.answered, layer.mesh()->vertex_count());
  call.progress.report(1.0, activity);
  answer.about["seconds"] = answer.answered.seconds;
  return answer;
}

}  // namespace vorogeo::plugin
