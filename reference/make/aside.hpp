#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <utility>

#include "reference/truth.hpp"
#include "solvers/stop.hpp"

namespace oddity::truth {

/// Frees this thread's caches of constants such as pi when it ends.
struct Caches {
  ~Caches() {
#if !defined(ODDITY_NUMBER) && !defined(ODDITY_BALLS)
    mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE);
#endif
  }
};

/// A value computed by another thread in the meantime, which ends with this object. If no thread can be
/// started, get() computes it.
template <class Made>
class Aside {
 public:
  /// `make` takes a tick to call between pieces of its work; it is empty if `tick`, called in this thread,
  /// is.
  Aside(const Tick& tick, std::function<Made(const Tick&)> make)
      : tick_(tick), make_(std::move(make)), made_(std::async([this] { return make_in_its_thread(); })) {}
  Aside(const Aside&) = delete;
  Aside& operator=(const Aside&) = delete;
  ~Aside() { over_.request(); }

  bool is_ready() const { return made_.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }
  /// The value; may be called once. Throws the exceptions of `make`.
  Made get() {
    constexpr std::chrono::milliseconds a_while(20);
    while (made_.wait_for(a_while) == std::future_status::timeout) {
      check_stop();
      if (tick_) tick_(1);
    }
    return made_.get();
  }

 private:
  Made make_in_its_thread() const {
    const Stoppable here(&over_);
    const Tick until_over = [](double) { check_stop(); };
    const Caches caches;
    return make_(tick_ ? until_over : Tick());
  }

  const Tick& tick_;
  const std::function<Made(const Tick&)> make_;
  Stop over_{stop_here};
  std::future<Made> made_;  // destroyed first, it waits
};

}  // namespace oddity::truth
