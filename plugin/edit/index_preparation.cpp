// The thread of a build: its progress, its end, and cancelling it.
#include "edit/index_preparation.h"

#include <exception>
#include <new>
#include <utility>

#include "support/error.h"
#include "support/progress.h"

namespace vorogeo::plugin {

namespace {

/// Processor time of a build for each vertex, as measured on scans.
constexpr double core_seconds_per_vertex = 5e-4;

}  // namespace

double expected_build_seconds(Index vertices, int threads) {
  return core_seconds_per_vertex * vertices / (threads > 1 ? threads : 1);
}

void IndexPreparation::start(Build build, Done done) {
  cancel();
  cancel_ = false;
  fraction_ = 0.0;
  is_running_ = true;
  thread_ = std::thread([this, build = std::move(build), done = std::move(done)] {
    const Progress progress([this](double fraction, const std::string&) {
      fraction_ = fraction;
      return !cancel_;
    });
    Result result;
    try {
      const Watch watch([this] {
        if (cancel_) throw Cancelled();
      });
      result.index = build(progress);
    } catch (const Cancelled&) {  // neither an index nor an error
    } catch (const std::bad_alloc&) {
      result.error = "There is not enough memory for the index of this mesh.";
    } catch (const std::exception& error) {
      result.error = error.what();
    }
    is_running_ = false;
    done(std::move(result));
  });
}

void IndexPreparation::cancel() {
  cancel_ = true;
  if (thread_.joinable()) thread_.join();
}

}  // namespace vorogeo::plugin
