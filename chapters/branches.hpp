#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "chapters/expression.hpp"

/// Records a function that compares its values, as a tree of all its execution paths.
namespace oddity {

/// One execution path: the comparisons, as Coq's decisions, and the outcome of each.
struct Way {
  struct Answer {
    std::string asked;
    bool yes;
  };
  std::vector<Answer> answers = {};
  std::size_t next = 0;

  bool answer(std::string asked) {
    if (next == answers.size()) answers.push_back({std::move(asked), true});
    return answers[next++].yes;
  }
  /// Moves on to the next path; false after the last one.
  bool turn() {
    while (!answers.empty() && !answers.back().yes) answers.pop_back();
    next = 0;
    if (answers.empty()) return false;
    answers.back().yes = false;
    return true;
  }
};

/// A recording number on one path.
class Branching {
 public:
  Branching(double x) : x_(x) {}
  Branching(Expression x, Way& way) : x_(std::move(x)), way_(&way) {}
  const Expression& expression() const { return x_; }

  friend Branching operator+(const Branching& a, const Branching& b) { return {a.x_ + b.x_, a, b}; }
  friend Branching operator-(const Branching& a, const Branching& b) { return {a.x_ - b.x_, a, b}; }
  friend Branching operator*(const Branching& a, const Branching& b) { return {a.x_ * b.x_, a, b}; }
  friend Branching operator/(const Branching& a, const Branching& b) { return {a.x_ / b.x_, a, b}; }
  friend Branching operator-(const Branching& a) { return {-a.x_, a, a}; }
  friend bool operator<(const Branching& a, const Branching& b) { return a.asks("Rlt_dec", b); }
  friend bool operator<=(const Branching& a, const Branching& b) { return a.asks("Rle_dec", b); }
  friend bool operator>(const Branching& a, const Branching& b) { return a.asks("Rgt_dec", b); }
  friend bool operator>=(const Branching& a, const Branching& b) { return a.asks("Rge_dec", b); }

 private:
  Branching(Expression x, const Branching& a, const Branching& b)
      : x_(std::move(x)), way_(a.way_ != nullptr ? a.way_ : b.way_) {}
  bool asks(const std::string& decision, const Branching& b) const {
    return Branching(x_, *this, b).way_->answer(decision + " (" + x_.coq() + ") (" + b.x_.coq() + ")");
  }

  Expression x_;
  Way* way_ = nullptr;
};

/// The result of f(way) as Coq text, with an `if` for each comparison.
template <class F>
std::string tree_of(const F& f) {
  std::string text, closing;
  std::vector<Way::Answer> before;
  Way way;
  do {
    const std::string leaf = f(way);
    std::size_t same = 0;
    while (same < before.size() && before[same].yes == way.answers[same].yes) ++same;
    if (!before.empty()) text += " else ", ++same;
    for (std::size_t i = same; i < way.answers.size(); ++i)
      text += "(if " + way.answers[i].asked + "\n  then ";
    text += leaf;
    before = way.answers;
    for (std::size_t i = way.answers.size(); i > 0 && !way.answers[i - 1].yes; --i) text += ")";
  } while (way.turn());
  return text;
}

}  // namespace oddity
