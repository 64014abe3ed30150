// When an index pays, without knowing how many questions are still to come.
#pragma once

#include <algorithm>
#include <chrono>
#include <optional>

#include "support/parallel.h"
#include "support/types.h"

namespace vorogeo {

/// A field that two threads share takes up to so many times the processor time of the calling one, as they
/// wait for one another at each step; in a build they do not. Anything beyond that is other programs' work.
inline constexpr double waiting_in_shared_field = 1.25;

/// How long answers take.
class Stopwatch {
 public:
  /// Wall-clock time.
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  /// What RentOrBuy counts: processor time of the calling thread, which leaves out other programs, and its
  /// waiting for others. `threads`: how many shared the work.
  double rent(int threads) const {
    const double waiting = threads > 1 ? waiting_in_shared_field : 1.0;
    return std::min(seconds(), waiting * (thread_seconds() - worked_));
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double worked_ = thread_seconds();
};

/// Exact answers are rent, an index is bought: renting until the rent would exceed the price, and buying
/// then, costs at most twice as much as the better of both for any number of questions, and without knowledge
/// of the future no rule does better (Karlin, Manasse, Rudolph, Sleator: Competitive snoopy caching,
/// Algorithmica 3, 1988). The price is an estimate, so "twice" holds up to its error. Of a field, the rent is
/// only what an index would save.
class RentOrBuy {
 public:
  /// For a mesh of so many vertices.
  explicit RentOrBuy(Index vertices) : least_price_(least_seconds_per_vertex * vertices) {}

  /// An exact answer took so many seconds, of the same clock as the price. With several threads, the seconds
  /// of the calling thread, which does its share, and what it waited for the others.
  void pay(double seconds) {
    rent_ += std::max(0.0, seconds);
    ++answers_;
  }
  /// Whether the price may have been reached, so that it is time to estimate it.
  bool wants_price() const {
    const double enough = answers_ >= least_answers ? least_price_ : likely_price * least_price_;
    return !has_price_ && answers_ >= 2 && rent_with_next() >= enough;
  }
  /// What one whole field takes.
  struct Fields {
    double exact_seconds = 0.0;  ///< an exact one, on one thread
    double index_share = 0.0;    ///< one from the index on one thread, as a part of that
  };
  void set_price(double seconds, std::optional<Fields> fields = {}) {
    price_ = seconds;
    has_price_ = true;
    fields_ = fields;
  }
  /// Set with the price.
  const std::optional<Fields>& fields() const { return fields_; }
  /// The index cannot be had: rent for ever.
  void give_up() { set_price(unreachable, fields_); }
  bool has_given_up() const { return has_price_ && price_ == unreachable; }
  /// Whether an index should be built instead of the next exact answers, which take so many seconds; 0: of
  /// one more.
  bool should_buy(double next_seconds = 0.0) const {
    return has_price_ && std::max(rent_with_next(), rent_ + next_seconds) > price_;
  }
  /// Seconds of exact answers so far.
  double rent() const { return rent_; }

 private:
  /// No build on any mesh and machine is as fast as this.
  static constexpr double least_seconds_per_vertex = 2e-5;
  /// A build mostly takes as long as tens of exact fields, so that a few slow answers say little.
  static constexpr int least_answers = 8;
  /// On large meshes a build may take only as long as a few fields: a rent of so many times the least price
  /// counts after fewer answers.
  static constexpr double likely_price = 4.0;

  double rent_with_next() const { return answers_ == 0 ? 0.0 : rent_ + rent_ / answers_; }

  double least_price_;
  double price_ = 0.0;
  bool has_price_ = false;
  std::optional<Fields> fields_;
  double rent_ = 0.0;
  int answers_ = 0;
};

}  // namespace vorogeo
