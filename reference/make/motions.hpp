#pragma once

#include <map>
#include <memory>
#include <tuple>
#include <typeindex>

#include "reference/truth.hpp"

/// A motion that is asked for at many times is integrated once.
namespace oddity::truth {

/// A motion as far as it has been integrated.
struct Path {
  virtual ~Path() = default;
};

/// The paths of one request, by what tells them apart: the type of the right-hand side (whose parameters are
/// the request's), start, digits and direction.
class Motions {
 public:
  explicit Motions(Tick tick = {}) : tick_(std::move(tick)) {}

  /// The path from (t0, x0) towards t1; make() begins one that is not there yet.
  template <class Make>
  auto& path(std::type_index rhs, const Numbers& x0, const Number& t0, const Number& t1, int digits,
             const Make& make) {
    auto& path = paths_[{rhs, digits, t1 > t0, t0, x0}];
    if (!path) path = make();
    return static_cast<typename decltype(make())::element_type&>(*path);
  }
  /// By how much a motion may cost more than a solution that nobody watches: who watches may end it.
  long allowance() const { return tick_ ? 50 : 1; }
  /// To be called between pieces of work.
  void tick() const {
    if (tick_) tick_(done_);
  }
  /// So large a part of the request is done.
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
