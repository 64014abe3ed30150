// The host's plugin interface, with the differences between the supported MeshLab versions evened out.
#pragma once

#include <common/plugins/interfaces/filter_plugin.h>

#if VOROGEO_HOST_VERSION >= 202301
#include <common/parameters/rich_parameters.h>
#endif

namespace vorogeo::plugin {

// These parameter types were renamed after 2022.02.
#if VOROGEO_HOST_VERSION >= 202301
using RichFileToWrite = RichFileSave;
using RichFileToRead = RichFileOpen;
using RichLength = RichPercentage;
#else
using RichFileToWrite = RichSaveFile;
using RichFileToRead = RichOpenFile;
using RichLength = RichAbsPerc;
#endif

}  // namespace vorogeo::plugin
