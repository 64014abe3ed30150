// Applies the filter named by its parameter `filter` under the wanted conditions.
#include "filter_probe.h"

#include <common/plugins/plugin_manager.h>
#include <vcg/complex/allocate.h>

#include <QStringList>
#include <algorithm>
#include <chrono>
#include <exception>

namespace {

// The host's callback is a plain function, so what it counts has to be global.
int calls = 0;
int calls_allowed = -1;
int last_percentage = 0;
bool percentage_fell = false;
std::chrono::steady_clock::time_point last_call;
double longest_silence = 0.0;

/// Since the last call, or the beginning.
void note_silence() {
  const auto now = std::chrono::steady_clock::now();
  longest_silence = std::max(longest_silence, std::chrono::duration<double>(now - last_call).count());
  last_call = now;
}

bool count_and_maybe_cancel(const int percentage, const char*) {
  ++calls;
  note_silence();
  percentage_fell = percentage_fell || percentage < last_percentage;
  last_percentage = percentage;
  return calls_allowed < 0 || calls <= calls_allowed;
}

std::pair<FilterPlugin*, QAction*> find_filter(const QString& python_name) {
  for (FilterPlugin* plugin : meshlab::pluginManagerInstance().filterPluginIterator()) {
    for (QAction* action : plugin->actions()) {
      if (plugin->pythonFilterName(action) == python_name) return {plugin, action};
    }
  }
  throw MLException("There is no filter " + python_name);
}

/// "name=1;other=true": whole numbers and yes-or-no values for parameters of the filter.
void set_numbers(RichParameterList& list, const QString& text) {
  for (const QString& item : text.split(';', Qt::SkipEmptyParts)) {
    const QStringList parts = item.split('=');
    if (parts.at(1) == "true") {
      list.setValue(parts.at(0), BoolValue(true));
    } else {
      list.setValue(parts.at(0), IntValue(parts.at(1).toInt()));
    }
  }
}

/// Marks faces and vertices as deleted; the faces of a deleted vertex go with it.
void delete_elements(CMeshO& mesh, const QString& faces, const QString& vertices) {
  using Allocator = vcg::tri::Allocator<CMeshO>;
  for (const QString& number : faces.split(';', Qt::SkipEmptyParts)) {
    Allocator::DeleteFace(mesh, mesh.face[number.toInt()]);
  }
  for (const QString& number : vertices.split(';', Qt::SkipEmptyParts)) {
    CVertexO& vertex = mesh.vert[number.toInt()];
    for (CFaceO& face : mesh.face) {
      if (!face.IsD() && (face.V(0) == &vertex || face.V(1) == &vertex || face.V(2) == &vertex)) {
        Allocator::DeleteFace(mesh, face);
      }
    }
    Allocator::DeleteVertex(mesh, vertex);
  }
}

}  // namespace

FilterProbe::FilterProbe() {
  typeList = {0, 1};
  for (ActionIDType type : types()) actionList.push_back(new QAction(filterName(type), this));
}

QString FilterProbe::pluginName() const { return "FilterProbe"; }

QString FilterProbe::filterName(ActionIDType filter) const {
  return filter == 0 ? "Probe: apply a filter" : "Probe: length of a filter's help";
}

QString FilterProbe::pythonFilterName(ActionIDType filter) const {
  return filter == 0 ? "probe_apply" : "probe_help";
}

QString FilterProbe::filterInfo(ActionIDType) const { return "For tests."; }

FilterPlugin::FilterClass FilterProbe::getClass(const QAction*) const { return FilterPlugin::Other; }

int FilterProbe::postCondition(const QAction*) const { return MeshModel::MM_NONE; }

FilterPlugin::FilterArity FilterProbe::filterArity(const QAction*) const { return SINGLE_MESH; }

RichParameterList FilterProbe::initParameterList(const QAction* action, const MeshModel&) {
  RichParameterList list;
  list.addParam(RichString("filter", "", "Python name of the filter"));
  if (ID(action) == 1) return list;
  list.addParam(RichString("numbers", "", "Parameters, name=1;other=true"));
  list.addParam(RichInt("calls_allowed", -1, "Progress calls answered with true; -1: all"));
  list.addParam(RichBool("without_callback", false, "Pass no progress function"));
  list.addParam(RichString("deleted_faces", "", "Faces to delete first, 1;2"));
  list.addParam(RichString("deleted_vertices", "", "Vertices to delete first, 1;2"));
  return list;
}

std::map<std::string, QVariant> FilterProbe::applyFilter(const QAction* action,
                                                         const RichParameterList& parameters,
                                                         MeshDocument& document, unsigned int&,
                                                         vcg::CallBackPos*) {
  const auto [plugin, filter] = find_filter(parameters.getString("filter"));
  if (ID(action) == 1) {
    const QString help = plugin->filterInfo(filter);
    bool advanced_last = true;
    bool sends_to_docs = help.contains("docs/") || help.contains(".md");
    int advanced = 0;
    for (const RichParameter& parameter : plugin->initParameterList(filter, document)) {
      advanced_last = advanced_last && (parameter.isAdvanced() || advanced == 0);
      advanced += parameter.isAdvanced() ? 1 : 0;
      const QString words = parameter.fieldDescription() + parameter.toolTip();
      sends_to_docs = sends_to_docs || words.contains("docs/") || words.contains(".md");
    }
    return {{"advanced_parameters", advanced},
            {"advanced_last", advanced_last},
            {"sends_to_docs", sends_to_docs},
            {"help_length", plugin->filterInfo(filter).size()},
            {"names_itself", plugin->filterName(filter).contains("(VoroGeo)")},
            {"cites", plugin->filterInfo(filter).contains("See:")},
            {"filter_class", int(plugin->getClass(filter))},
            {"changes", plugin->postCondition(filter)}};
  }
  delete_elements(document.mm()->cm, parameters.getString("deleted_faces"),
                  parameters.getString("deleted_vertices"));
  RichParameterList list = plugin->initParameterList(filter, document);
  set_numbers(list, parameters.getString("numbers"));
  calls = 0;
  calls_allowed = parameters.getInt("calls_allowed");
  last_percentage = 0;
  percentage_fell = false;
  longest_silence = 0.0;
  last_call = std::chrono::steady_clock::now();
  unsigned int changes = MeshModel::MM_UNKNOWN;
  auto* const callback = parameters.getBool("without_callback") ? nullptr : count_and_maybe_cancel;
  std::map<std::string, QVariant> results;
  try {
    results = plugin->applyFilter(filter, list, document, changes, callback);
  } catch (const MLException&) {
    throw;
  } catch (const std::exception& error) {
    throw MLException(QString("NOT AN MLException: ") + error.what());
  }
  note_silence();
  results["probe_longest_silence"] = longest_silence;
  results["probe_calls"] = calls;
  results["probe_last_percentage"] = last_percentage;
  results["probe_percentage_fell"] = percentage_fell;
  return results;
}

MESHLAB_PLUGIN_NAME_EXPORTER(FilterProbe)
