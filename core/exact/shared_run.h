// One run of the exact solver on several threads.
#pragma once

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <vector>

#include "exact/solver_state.h"
#include "support/progress.h"

namespace vorogeo {

/// Solvers that share a run: each computes what lies in its own territory, and hands what leaves it to the
/// others.
///
/// All advance in steps of distance. Within a step they work alone, on what they were handed when it began;
/// what they hand on is taken in at the next step, whether or not it belongs there: a window that comes late
/// replaces what was propagated in its place, as any shorter one does.
///
/// Why nothing is lost or overtaken, whatever the sizes and the timing: between two steps, all that is still
/// to be propagated lies in the queues and in the boxes that are handed on, and `front_` is no more than any
/// distance in either (BucketQueue::least_key, Outbox::least). Windows and vertices descend only from those,
/// so no later distance is below `front_`, and an edge behind it can be closed. A step takes all that lies
/// below its end, late items included; the end lies above the front, so the run goes on until queues and
/// boxes are empty. What a solver does in a step depends on its own state and the boxes, which are read in
/// the order of their senders: the result depends on the number of solvers, in its last digits, but not on
/// the threads that happened to run them, nor on what the solvers did in an earlier run.
class SharedRun {
 public:
  SharedRun(std::shared_ptr<const ExactGeometry> geometry, int solvers);

  int solvers() const { return static_cast<int>(others_.size()) + 1; }
  /// Propagates from the sources of `first`, which has been reset and is one of the solvers; it has all the
  /// distances afterwards. \throw Cancelled.
  void run(ExactSolver::State& first, const Progress* progress);

  /// Sums over the solvers besides the first.
  std::size_t window_count() const;
  std::size_t memory_bytes() const;

 private:
  void prepare(ExactSolver::State& first);
  /// A thread's part: takes steps of solvers, its own one first, until the run has ended.
  void work(int own, Watch* watch);
  void take_step(int solver);
  /// Called by the thread that finished the last solver's step.
  void begin_next_step();
  void announce_step();

  Territories territories_;
  std::vector<std::unique_ptr<ExactSolver::State>> others_;
  std::vector<ExactSolver::State*> all_;
  /// What was handed on in the step before: by sender, by receiver.
  std::vector<std::vector<Outbox>> handed_;
  std::vector<std::size_t> made_;  ///< windows in this step, by solver
  double front_ = 0.0;             ///< no distance below it is still to be propagated
  double end_of_step_ = 0.0;
  double step_length_ = 0.0;
  double least_step_length_ = 0.0;    ///< positive
  std::atomic<double> reached_{0.0};  ///< fraction of the vertices
  static constexpr int ended = -1;
  std::atomic<int> step_{0};
  std::vector<std::atomic<int>> next_step_;  ///< the number of each solver's next step
  std::atomic<int> unfinished_{0};
  // For threads that wait for a step.
  std::mutex mutex_;
  std::condition_variable next_step_begins_;
};

}  // namespace vorogeo
