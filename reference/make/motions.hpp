#pragma once

#include <map>
#include <memory>
#include <tuple>
#include <type_traits>
#include <typeindex>

#include "reference/truth.hpp"

/// Integrates a motion once for many requested times.
namespace oddity::truth {

/// A motion, integrated up to some time.
struct Path {
  virtual ~Path() = default;
};

/// The paths of one request. Their key is the type of the right-hand side (whose parameters are those of the
/// request), start, digits and direction.
class Motions {
 public:
  explicit Motions(Tick tick = {}) : tick_(std::move(tick)) {}

  /// The path from (t0, x0) towards t1; make() begins a new one.
  template <class Make>
  auto& path(std::type_index rhs, const Numbers& x0, const Number& t0, const Number& t1, int digits,
             const Make& make) {
    auto& path = paths_[{rhs, digits, t1 > t0, t0, x0}];
    if (!path) path = make();
    return static_cast<typename decltype(make())::element_type&>(*path);
  }
  /// Factor by which a motion may exceed the budget of an unwatched solution: a watcher can end it, and the
  /// processor's own numbers take seconds for it.
  long allowance() const {
    constexpr bool is_quick = std::is_floating_point_v<Number>;
    return tick_ || is_quick ? 50 : 1;
  }
  /// Call it between pieces of work.
  void tick() const {
    if (tick_) tick_(done_);
  }
  /// Records the finished part of the request.
  void come_to(double part) {
    done_ = part;
    tick();
  }

 private:
  using Key = std::tuple<std::type_index, int, bool, Number, Numbers>;
  Tick tick_;
  double done_ = 0;
  std::map<Key, std::unique_ptr<Path>> paths_;
};

}  // namespace oddity::truth
