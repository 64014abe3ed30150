// Asks the surface and measures the time.
#include "edit/ruler_requests.h"

#include <chrono>
#include <exception>
#include <new>

#include "support/error.h"

namespace vorogeo::plugin {

RulerAnswer answer(const RulerRequest& request, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  RulerAnswer result;
  result.is_field = request.is_field;
  try {
    if (request.is_field) {
      result.field = request.surface->field(request.from, progress);
    } else {
      result.path = request.surface->path(request.from, request.to, progress);
      result.lines = lines_of(*request.surface->layer()->mesh(), result.path.path);
    }
  } catch (const Cancelled&) {
    throw;
  } catch (const std::bad_alloc&) {
    result.error = "There is not enough memory to measure on this mesh. Close other layers.";
  } catch (const std::exception& error) {
    result.error = error.what();
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace vorogeo::plugin
