#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "reference/truth.hpp"

/// Motions sampled at many times, integrated only once.
namespace oddity::truth {

/// States along motions, kept between calls. Safe for many threads.
class Checkpoints {
 public:
  /// State number k of a motion, the start being number 0; each is computed from the one before. `motion`
  /// identifies the motion: everything that `start` and `next` depend on.
  Numbers state(std::size_t k, const std::vector<double>& motion, const std::function<Numbers()>& start,
                const std::function<Numbers(const Numbers& x, std::size_t k)>& next);

  /// The state at t >= 0: by the path of the request if it keeps one, otherwise via the states at whole
  /// seconds.
  Numbers at(double t, Precision, const std::vector<double>& motion, const std::function<Numbers()>& start,
             const std::function<Numbers(const Numbers& x, const Number& t0, const Number& t1)>& advance);

 private:
  struct Motion {
    std::mutex mutex;
    std::vector<Numbers> states;
  };
  std::shared_ptr<Motion> find(const std::vector<double>& motion);

  std::mutex mutex_;
  std::map<std::vector<double>, std::shared_ptr<Motion>> motions_;
};

/// Identifies a motion: its inputs, with the digits in place of the time, which is the last of them.
inline std::vector<double> motion_of(std::vector<double> inputs, int digits) {
  inputs.back() = digits;
  return inputs;
}

}  // namespace oddity::truth
