#pragma once

#include <atomic>
#include <chrono>

/// Cooperative cancellation: one token that every loop looks at.
///   const Stop stop(60);              // s; or stop.request() from any thread
///   const Stoppable here(&stop);      // this thread's work, and that of in_parallel inside, now looks at it
///   ... check_stop(); ...             // between pieces of work
namespace oddity {

/// Thrown by work that was asked to stop. No std::exception, so that nothing that collects failures takes it
/// for one: what was stopped has no result.
struct Stopped {};

/// Requested by a call, by the end of its time, or because the one around it is.
class Stop {
 public:
  Stop() = default;
  explicit Stop(double seconds) : has_end_(seconds < for_ever) {
    if (has_end_)
      end_ =
          Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  }
  explicit Stop(const Stop* around) : around_(around) {}
  Stop(const Stop&) = delete;
  Stop& operator=(const Stop&) = delete;

  void request() { is_requested_.store(true, std::memory_order_relaxed); }
  bool is_requested() const {
    return is_requested_.load(std::memory_order_relaxed) || (has_end_ && Clock::now() >= end_) ||
           (around_ && around_->is_requested());
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr double for_ever = 1e9;  // s, which a clock can still add

  std::atomic<bool> is_requested_ = false;
  bool has_end_ = false;
  Clock::time_point end_ = {};
  const Stop* around_ = nullptr;
};

/// What this thread's work looks at; null: nothing stops it.
inline thread_local const Stop* stop_here = nullptr;

/// This thread looks at that stop while this lives.
class Stoppable {
 public:
  explicit Stoppable(const Stop* stop) : before_(stop_here) { stop_here = stop; }
  Stoppable(const Stoppable&) = delete;
  Stoppable& operator=(const Stoppable&) = delete;
  ~Stoppable() { stop_here = before_; }

 private:
  const Stop* before_;
};

/// Throws Stopped when this thread's work was asked to stop. Takes some 30 ns.
inline void check_stop() {
#ifndef __wasm__  // the page's module has neither a clock nor exceptions, and nothing stops it
  if (stop_here && stop_here->is_requested()) throw Stopped();
#endif
}

/// For loops whose turns take less than a microsecond: looks at the stop at every 64th call.
inline void check_stop_at_times() {
  thread_local unsigned calls = 0;
  if (stop_here && ++calls % 64 == 0) check_stop();
}

}  // namespace oddity
