// The host's plugin interface, with the differences between the supported MeshLab versions evened out.
#pragma once

#include <common/plugins/interfaces/filter_plugin.h>

#if VOROGEO_HOST_VERSION >= 202301
#include <common/parameters/rich_parameters.h>
#endif

namespace vorogeo::plugin {

// The parameter type for a file to write was renamed after 2022.02.
#if VOROGEO_HOST_VERSION >= 202301
using RichFileToWrite = RichFileSave;
#else
using RichFileToWrite = RichSaveFile;
#endif

}  // namespace vorogeo::plugin
