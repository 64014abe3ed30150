// Lets the index of a mesh be built on a thread of its own, while the window goes on.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "index/geodesic_index.h"

namespace vorogeo::plugin {

/// Seconds that building the index of a mesh of this size takes on so many threads: a guess from the size
/// alone, good to a factor of two on scans.
double expected_build_seconds(Index vertices, int threads);

/// One build at a time. All functions are called from one thread.
class IndexPreparation {
 public:
  /// How a build ended: with an index, with the sentence of an error, or, cancelled, with neither.
  struct Result {
    std::shared_ptr<const GeodesicIndex> index;
    std::string error;
  };
  /// Called on the thread of the build, which then ends.
  using Done = std::function<void(Result)>;

  IndexPreparation() = default;
  ~IndexPreparation() { cancel(); }
  IndexPreparation(const IndexPreparation&) = delete;
  IndexPreparation& operator=(const IndexPreparation&) = delete;

  /// Builds, on its own thread; may be cancelled where it reports to the progress or has a checkpoint.
  using Build = std::function<std::shared_ptr<const GeodesicIndex>(const Progress&)>;

  /// A build that runs is cancelled before.
  void start(Build build, Done done);
  /// Returns when the build has ended, which takes a fraction of a second.
  void cancel();
  bool is_running() const { return is_running_; }
  double fraction() const { return fraction_; }

 private:
  std::thread thread_;
  std::atomic<bool> is_running_ = false;
  std::atomic<bool> cancel_ = false;
  std::atomic<double> fraction_ = 0.0;
};

}  // namespace vorogeo::plugin
