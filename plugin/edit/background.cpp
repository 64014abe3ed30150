// The loop of the thread, and how it is told to stop.
#include "edit/background.h"

#include <utility>

namespace vorogeo::plugin {

void Background::post(Work work, bool is_kept) {
  {
    const std::lock_guard lock(mutex_);
    std::erase_if(waiting_, [](const Waiting& other) { return !other.is_kept; });
    waiting_.push_back({std::move(work), is_kept});
  }
  if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
  changed_.notify_all();
}

void Background::clear() {
  const std::lock_guard lock(mutex_);
  waiting_.clear();
  cancel_ = true;
}

void Background::stop() {
  {
    const std::lock_guard lock(mutex_);
    waiting_.clear();
    cancel_ = true;
    ends_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
  ends_ = false;
}

bool Background::is_running() const {
  const std::lock_guard lock(mutex_);
  return runs_ || !waiting_.empty();
}

double Background::fraction() const {
  const std::lock_guard lock(mutex_);
  return fraction_;
}

void Background::require_wanted() const {
  const std::lock_guard lock(mutex_);
  if (cancel_) throw Cancelled();
}

void Background::run() {
  const Progress progress([this](double fraction, const std::string&) {
    const std::lock_guard lock(mutex_);
    fraction_ = fraction;
    return !cancel_;
  });
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return ends_ || !waiting_.empty(); });
    if (ends_) return;
    Work work = std::move(waiting_.front().work);
    waiting_.pop_front();
    runs_ = true;
    cancel_ = false;
    fraction_ = 0.0;
    lock.unlock();
    try {
      const Watch watch([this] { require_wanted(); });
      work(progress);
    } catch (const Cancelled&) {  // nobody wants it any more
    }
    work = {};
    lock.lock();
    runs_ = false;
  }
}

}  // namespace vorogeo::plugin
