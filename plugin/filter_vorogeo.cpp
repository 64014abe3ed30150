// The plugin's answers to the host, and the only place where errors and progress are passed to it.
#include "filter_vorogeo.h"

#include <QCoreApplication>
#include <chrono>
#include <exception>
#include <new>

#include "edit/ruler_tool.h"
#include "filters/rows.h"
#include "layers/layer_metric.h"
#include "support/error.h"

using vorogeo::plugin::FilterCall;
using vorogeo::plugin::FilterRow;

namespace {

using Clock = std::chrono::steady_clock;

/// The host's progress bar redraws at every call, so at least this time passes between calls.
constexpr std::chrono::milliseconds callback_interval{20};

/// MeshLab's window handles its events only at calls whose percentage differs from that of the previous call:
/// while a percentage stays the same, it would not respond. Its progress bar ignores values outside 0 to 100.
constexpr int still_the_same = -1;

/// Whether the host has windows; PyMeshLab has none.
bool host_has_windows() {
  const QCoreApplication* application = QCoreApplication::instance();
  return application != nullptr && application->inherits("QApplication");
}

vorogeo::Progress progress_to(vcg::CallBackPos* callback, const vorogeo::WarningFunction& warning) {
  if (callback == nullptr) return vorogeo::Progress({}, warning);
  return vorogeo::Progress(
      [callback, has_windows = host_has_windows(), told = still_the_same, last = Clock::time_point{}](
          double fraction, const std::string& activity) mutable {
        const auto now = Clock::now();
        if (now - last < callback_interval) return true;
        last = now;
        const int percentage = static_cast<int>(100.0 * fraction);
        told = has_windows && percentage == told ? still_the_same : percentage;
        return callback(told, activity.c_str());
      },
      warning);
}

}  // namespace

FilterVorogeo::FilterVorogeo() : rows_(vorogeo::plugin::all_rows()) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    typeList.push_back(static_cast<ActionIDType>(i));
    actionList.push_back(new QAction(rows_[i].menu_name, this));
  }
}

QString FilterVorogeo::pluginName() const { return "FilterVorogeo"; }

QString FilterVorogeo::vendor() const { return "VoroGeo"; }

const FilterRow& FilterVorogeo::row(ActionIDType filter) const {
  if (filter < 0 || static_cast<std::size_t>(filter) >= rows_.size()) {
    throw MLException(QString("VoroGeo has no filter with number %1.").arg(filter));
  }
  return rows_[static_cast<std::size_t>(filter)];
}

const FilterRow& FilterVorogeo::row(const QAction* action) const { return row(ID(action)); }

QString FilterVorogeo::filterName(ActionIDType filter) const { return row(filter).menu_name; }

QString FilterVorogeo::pythonFilterName(ActionIDType filter) const { return row(filter).python_name; }

QString FilterVorogeo::filterInfo(ActionIDType filter) const {
  const FilterRow& described = row(filter);
  return described.has_metric ? described.help + vorogeo::plugin::help_on_metric() : described.help;
}

FilterPlugin::FilterClass FilterVorogeo::getClass(const QAction* action) const {
  return row(action).filter_class;
}

int FilterVorogeo::postCondition(const QAction* action) const { return row(action).changes; }

FilterPlugin::FilterArity FilterVorogeo::filterArity(const QAction*) const { return SINGLE_MESH; }

RichParameterList FilterVorogeo::initParameterList(const QAction* action, const MeshDocument& document) {
  if (document.mm() == nullptr) return {};
  const FilterRow& described = row(action);
  return vorogeo::plugin::list_of(
      described.parameters(document),
      described.has_metric ? vorogeo::plugin::metric_parameters() : RichParameterList(),
      vorogeo::plugin::gap_parameters(document));
}

std::map<std::string, QVariant> FilterVorogeo::applyFilter(const QAction* action,
                                                           const RichParameterList& parameters,
                                                           MeshDocument& document, unsigned int&,
                                                           vcg::CallBackPos* callback) {
  try {
    if (document.mm() == nullptr) {
      throw vorogeo::InvalidInput("There is no layer. Load or create a triangle mesh first.");
    }
    const auto to_log = [this](const std::string& sentence) { log(GLLogStream::FILTER, sentence); };
    const auto warning = [this](const std::string& sentence) {
      log(GLLogStream::WARNING, sentence);
      return true;
    };
    FilterCall call{document, *document.mm(), parameters, *layers_, progress_to(callback, warning), to_log};
    free_layers_with(document);
    const FilterRow& applied = row(action);
    const vorogeo::plugin::KeptCost kept(call, applied);
    auto results = applied.apply(call);
    kept.write(call);
    return results;
  } catch (const MLException&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw MLException(
        "There is not enough memory for this filter on this mesh. Close other layers or use a smaller mesh.");
  } catch (const std::exception& error) {
    throw MLException(QString::fromUtf8(error.what()));
  } catch (...) {
    throw MLException("An unknown error happened inside VoroGeo; the layer was not changed.");
  }
}

void FilterVorogeo::free_layers_with(MeshDocument& document) {
  const void* gone = &document;
  if (!documents_.insert(gone).second) return;
  connect(
      &document, &QObject::destroyed, this,
      [this, gone] {
        layers_->forget(gone);
        documents_.erase(gone);
      },
      Qt::DirectConnection);
}

EditTool* FilterVorogeo::make_ruler() {
  if (!rulers_) {
    rulers_ = std::make_shared<vorogeo::plugin::RulerShared>(
        layers_, [plugin = QPointer<FilterVorogeo>(this)](MeshDocument& document) {
          if (plugin) plugin->free_layers_with(document);
        });
  }
  return new vorogeo::plugin::RulerTool(rulers_);
}

MESHLAB_PLUGIN_NAME_EXPORTER(FilterVorogeo)
