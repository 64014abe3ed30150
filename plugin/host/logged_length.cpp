// How lengths are written into the host's log.
#include "host/logged_length.h"

#include <iomanip>
#include <sstream>

namespace vorogeo::plugin {

std::string logged_length(double length) {
  std::ostringstream text;
  text << std::setprecision(7) << length << " mesh units";
  return text.str();
}

}  // namespace vorogeo::plugin
