#pragma once

#include <atomic>
#include <chrono>

/// Cooperative cancellation: one token that every loop checks.
///   const Stop stop(60);              // s; or stop.request() from any thread
///   const Stoppable here(&stop);      // this thread's work, and that of in_parallel inside, now checks it
///   ... check_stop(); ...             // between pieces of work
namespace oddity {

/// Thrown by work that was stopped, which has no result. Not a std::exception, so that code that collects
/// failures does not catch it.
struct Stopped {};

/// A stop is requested by a call, by the end of its time, or by the stop around it.
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
  static constexpr double for_ever = 1e9;  // s; a clock can still add it

  std::atomic<bool> is_requested_ = false;
  bool has_end_ = false;
  Clock::time_point end_ = {};
  const Stop* around_ = nullptr;
};

/// The stop that this thread's work checks; null: nothing stops it.
inline thread_local const Stop* stop_here = nullptr;

/// Makes this thread check the stop during its lifetime.
class Stoppable {
 public:
  explicit Stoppable(const Stop* stop) : before_(stop_here) { stop_here = stop; }
  Stoppable(const Stoppable&) = delete;
  Stoppable& operator=(const Stoppable&) = delete;
  ~Stoppable() { stop_here = before_; }

 private:
  const Stop* before_;
};

/// Throws Stopped if this thread's work was stopped. Takes some 30 ns.
inline void check_stop() {
#ifndef __wasm__  // the WebAssembly module has neither a clock nor exceptions, and nothing stops it
  if (stop_here && stop_here->is_requested()) throw Stopped();
#endif
}

/// For loops with iterations below a microsecond: checks the stop at every 64th call.
inline void check_stop_at_times() {
  thread_local unsigned calls = 0;
  if (stop_here && ++calls % 64 == 0) check_stop();
}

}  // namespace oddity
