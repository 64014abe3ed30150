// How lengths are written into the host's log.
#pragma once

#include <string>

namespace vorogeo::plugin {

/// A length with its unit, in seven digits: what MeshLab's window holds. Returned values have all digits.
std::string logged_length(double length);

}  // namespace vorogeo::plugin
