#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace oddity {

/// A jolt from outside: an observable, or its rate, changes at once.
struct Kick {
  enum class Change { adds, sets, scales };
  double time;
  std::size_t observable;
  bool of_rate;
  Change change;
  double value;
};
/// In the order of their times.
struct Kicks : std::vector<Kick> {
  /// Model and algorithm of the methods that follow the truth; none: they are chosen on each motion.
  std::vector<std::pair<std::string, std::string>> ways = {};
};

/// Why a model has no state after a kick.
inline constexpr std::string_view not_seen_so =
                                      "the model has no state with the observables that the kick asks for",
                                  is_undetermined =
                                      "the observables do not determine the kick's effect on the rest of the "
                                      "model's state";

/// While it lives, the models that are integrated on this thread have these kicks.
///
///   const KicksHere here(kicks);
///   const Answer answer = method.run(setting);
///   if (!here.are_taken()) refuse();  // it is a closed form, or keeps its own time
class KicksHere {
 public:
  explicit KicksHere(const Kicks& kicks) : kicks_(kicks), before_(here_) { here_ = this; }
  KicksHere(const KicksHere&) = delete;
  KicksHere& operator=(const KicksHere&) = delete;
  ~KicksHere() { here_ = before_; }

  bool are_taken() const { return taken_; }
  /// Kicks for the model that takes them; null without kicks.
  static const Kicks* take() {
    if (!here_) return nullptr;
    here_->taken_ = true;
    return &here_->kicks_;
  }

 private:
  static inline thread_local KicksHere* here_ = nullptr;

  const Kicks& kicks_;
  KicksHere* before_;
  bool taken_ = false;
};

}  // namespace oddity
