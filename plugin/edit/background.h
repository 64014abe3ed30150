// A thread for work that nobody waits for, of which only the newest is of use.
#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <new>
#include <string>
#include <thread>

#include "support/error.h"
#include "support/progress.h"

namespace vorogeo::plugin {

/// Runs posted work, in order. Work that still waits when more is posted is dropped, unless it is to be kept.
/// Running work is finished, not cancelled: so some is done even where work comes faster than it is done. All
/// public functions are called from one thread.
class Background {
 public:
  /// May be cancelled where it reports to the progress or has a checkpoint. It handles all its errors but
  /// Cancelled.
  using Work = std::function<void(const Progress&)>;

  Background() = default;
  ~Background() { stop(); }
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  /// Drops waiting work that is not kept, and queues this. `is_kept`: it will be done, before later work.
  void post(Work work, bool is_kept = false);
  /// Drops all waiting work and cancels the running one.
  void clear();
  /// As clear(), and returns when the thread has ended. The next work starts a new one.
  void stop();
  /// Whether there is work that has not ended.
  bool is_running() const;
  /// The progress of the running work, as it last reported.
  double fraction() const;

 private:
  struct Waiting {
    Work work;
    bool is_kept;
  };
  void run();
  void require_wanted() const;

  std::thread thread_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Waiting> waiting_;
  bool runs_ = false;
  bool cancel_ = false;
  bool ends_ = false;
  double fraction_ = 0.0;
};

/// Runs something. \return the sentence of its error, empty if there was none. \throw Cancelled.
template <class Run>
std::string error_of(Run&& run, const char* without_memory) {
  try {
    run();
  } catch (const Cancelled&) {
    throw;
  } catch (const std::bad_alloc&) {
    return without_memory;
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

}  // namespace vorogeo::plugin
