// Steps of a shared run, and how threads wait for one another.
#include "exact/shared_run.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <thread>

#include "support/parallel.h"
#include "support/progress.h"

namespace vorogeo {

namespace {

/// Length of a step in widths of a bucket, if there is enough to do: longer ones make more windows come
/// late, shorter ones make threads wait for one another more often.
constexpr double least_step = 2.0;

/// Windows that a solver makes in one step below which steps become longer.
constexpr std::size_t few_windows = 64;

/// Most windows that a solver makes in one step, a little more than on a scan. Until it takes in nearer
/// windows that the others have for it, a solver may follow its own around a thin part, turn by turn, as long
/// as the step lasts, and more of them at each turn.
constexpr std::size_t most_windows = 1 << 14;

/// How often a thread looks whether the others have finished the step before it goes to sleep.
constexpr int looks = 200;

}  // namespace

SharedRun::SharedRun(std::shared_ptr<const ExactGeometry> geometry, int solvers)
    : territories_(*geometry->mesh, solvers), next_step_(solvers) {
  others_.resize(solvers - 1);
  handed_.assign(solvers, std::vector<Outbox>(solvers));
  made_.resize(solvers);
  parallel_for(others_.size(), solvers - 1, {}, "",
               [&](std::size_t i, int) { others_[i] = std::make_unique<ExactSolver::State>(geometry); });
}

void SharedRun::prepare(ExactSolver::State& first) {
  all_.assign(1, &first);
  for (const auto& other : others_) {
    other->reset();
    other->sources = first.sources;
    other->max_distance = first.max_distance;
    other->distances_only = first.distances_only;
    other->merge_tolerance = first.merge_tolerance;
    other->directions = first.directions;
    other->face_allowed = {};
    other->has_corridor = false;
    all_.push_back(other.get());
  }
  for (std::size_t i = 0; i < all_.size(); ++i) {
    all_[i]->territories = &territories_;
    all_[i]->number = static_cast<std::uint8_t>(i);
    all_[i]->outbox.assign(all_.size(), {});
    next_step_[i] = 1;
  }
  for (auto& from : handed_) {
    for (Outbox& outbox : from) outbox.clear();
  }
  std::fill(made_.begin(), made_.end(), 0);
  least_step_length_ = least_step * first.queue.width();
  step_length_ = least_step_length_;
  end_of_step_ = 0.0;
  step_ = 0;
}

void SharedRun::run(ExactSolver::State& first, const Progress* progress) {
  prepare(first);
  first.start();
  begin_next_step();
  std::optional<Watch> watch;
  if (progress != nullptr) watch.emplace(*progress, "Computing distances");
  parallel_for(all_.size(), solvers(), {}, "", [&](std::size_t own, int worker) {
    try {
      work(static_cast<int>(own), worker == 0 && watch ? &*watch : nullptr);
    } catch (...) {
      step_ = ended;
      announce_step();
      throw;
    }
  });
  // From here on, `first` looks as if it had run alone.
  first.touched_vertices.clear();
  for (Index v = 0; v < first.mesh.vertex_count(); ++v) {
    first.vertices[v] = all_[territories_.of_vertex[v]]->vertices[v];
    if (first.vertices[v].distance < unreachable) first.touched_vertices.push_back(v);
  }
}

void SharedRun::work(int own, Watch* watch) {
  auto last_report = std::chrono::steady_clock::now();
  int step = step_;
  while (step != ended) {
    for (int i = 0; i < solvers(); ++i) {
      const int solver = (own + i) % solvers();
      int expected = step;
      if (!next_step_[solver].compare_exchange_strong(expected, step + 1)) continue;
      take_step(solver);
      if (--unfinished_ == 0) begin_next_step();
    }
    if (watch != nullptr && std::chrono::steady_clock::now() - last_report >= report_interval) {
      last_report = std::chrono::steady_clock::now();
      watch->reach(reached_);
    } else {
      checkpoint();
    }
    for (int look = 0; look < looks && step_ == step; ++look) std::this_thread::yield();
    {
      std::unique_lock lock(mutex_);
      next_step_begins_.wait(lock, [&] { return step_ != step; });
    }
    step = step_;
  }
}

void SharedRun::take_step(int solver) {
  ExactSolver::State& state = *all_[solver];
  for (const auto& from : handed_) state.take_in(from[solver]);
  const std::size_t made_before = state.envelope.made();
  while (state.envelope.made() - made_before < most_windows) {
    const Index item = state.queue.pop(end_of_step_);
    if (item == no_index) break;
    state.take(item, front_);
  }
  made_[solver] = state.envelope.made() - made_before;
}

void SharedRun::begin_next_step() {
  double front = unreachable;
  for (std::size_t i = 0; i < all_.size(); ++i) {
    ExactSolver::State& state = *all_[i];
    front = std::min(front, state.queue.least_key());
    for (const Outbox& outbox : state.outbox) front = std::min(front, outbox.least);
    std::swap(state.outbox, handed_[i]);
    for (Outbox& outbox : state.outbox) outbox.clear();
  }
  int step = step_;
  if (front == unreachable) {
    step_ = ended;
    announce_step();
    return;
  }
  const std::size_t made = *std::max_element(made_.begin(), made_.end());
  step_length_ = made < few_windows ? 2.0 * step_length_ : std::max(least_step_length_, 0.5 * step_length_);
  front_ = front;
  // After a step that was cut off, the other solvers must not run ahead of what was left.
  end_of_step_ = (made < most_windows ? std::max(end_of_step_, front) : front) + step_length_;
  std::size_t reached = 0;
  for (const auto* state : all_) reached += state->touched_vertices.size();
  reached_ = std::min(1.0, static_cast<double>(reached) / all_.front()->mesh.vertex_count());
  unfinished_ = solvers();
  // A thread that failed has ended the run.
  if (step != ended && step_.compare_exchange_strong(step, step + 1)) announce_step();
}

void SharedRun::announce_step() {
  // Once the lock is free, every thread that read the old step is waiting, and will be notified.
  { const std::lock_guard lock(mutex_); }
  next_step_begins_.notify_all();
}

std::size_t SharedRun::window_count() const {
  std::size_t made = 0;
  for (const auto& other : others_) made += other->envelope.made();
  return made;
}

std::size_t SharedRun::memory_bytes() const {
  std::size_t bytes = territories_.memory_bytes();
  for (const auto& other : others_) bytes += other->memory_bytes();
  return bytes;
}

}  // namespace vorogeo
