// A worker thread that answers the newest request only, so that whoever asks never waits.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "support/progress.h"

namespace vorogeo::plugin {

/// Requests in, answers out, both in order. A request that still waits when the next one comes is dropped,
/// except one that was posted to be kept. What is being computed is finished, not cancelled: when requests
/// come faster than answers, there are answers all the same.
///
/// All public functions are called from one thread; `work` and `deliver` run on the worker's own.
template <class Request, class Answer>
class NewestRequest {
 public:
  /// May be cancelled where it reports to the progress or has a checkpoint. It handles all its errors but
  /// Cancelled, after which nothing is delivered.
  using Work = std::function<Answer(const Request&, const Progress&)>;
  using Deliver = std::function<void(Request, Answer)>;

  NewestRequest(Work work, Deliver deliver) : work_(std::move(work)), deliver_(std::move(deliver)) {}
  ~NewestRequest() { stop(); }
  NewestRequest(const NewestRequest&) = delete;
  NewestRequest& operator=(const NewestRequest&) = delete;

  /// Drops the request that waits, if any, and lets this one wait in its place.
  void post(Request request) {
    {
      const std::lock_guard lock(mutex_);
      if (newest_) ++dropped_;
      newest_ = std::move(request);
    }
    wake();
  }

  /// A request that will be answered, before later ones; it replaces the one that waits.
  void post_kept(Request request) {
    {
      const std::lock_guard lock(mutex_);
      if (newest_) ++dropped_;
      newest_.reset();
      kept_.push_back(std::move(request));
    }
    wake();
  }

  /// Drops all requests and cancels what is being computed; what it would have answered is not delivered.
  void clear() {
    const std::lock_guard lock(mutex_);
    newest_.reset();
    kept_.clear();
    cancel_ = true;
  }

  /// As clear(), and returns when the thread has ended. The next request starts a new one.
  void stop() {
    {
      const std::lock_guard lock(mutex_);
      newest_.reset();
      kept_.clear();
      cancel_ = true;
      ends_ = true;
    }
    changed_.notify_all();
    if (thread_.joinable()) thread_.join();
    ends_ = false;
  }

  /// Requests that were replaced before they were answered.
  int dropped() const {
    const std::lock_guard lock(mutex_);
    return dropped_;
  }

 private:
  void wake() {
    if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
    changed_.notify_all();
  }

  void run() {
    const Progress progress([this](double, const std::string&) {
      const std::lock_guard lock(mutex_);
      return !cancel_;
    });
    for (;;) {
      std::optional<Request> request;
      {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return ends_ || newest_ || !kept_.empty(); });
        if (ends_) return;
        if (kept_.empty()) {
          request = std::exchange(newest_, std::nullopt);
        } else {
          request = std::move(kept_.front());
          kept_.pop_front();
        }
        cancel_ = false;
      }
      try {
        const Watch watch([&progress] { progress.report(0.0, {}); });
        Answer answer = work_(*request, progress);
        progress.report(1.0, {});
        deliver_(std::move(*request), std::move(answer));
      } catch (const Cancelled&) {  // nobody wants the answer any more
      }
    }
  }

  const Work work_;
  const Deliver deliver_;
  std::thread thread_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Request> newest_;
  std::deque<Request> kept_;  ///< answered before the newest
  bool cancel_ = false;
  bool ends_ = false;
  int dropped_ = 0;
};

}  // namespace vorogeo::plugin
