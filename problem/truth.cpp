#include "problem/truth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "reference/text.hpp"
#include "solvers/stop.hpp"

namespace oddity::problem {

namespace {

using Number = long double;
using Values = std::vector<Number>;

constexpr const char* without_end =
    "events follow each other without end; a shorter horizon, or ends = true, leaves that out";

constexpr const char* too_many_steps =
    "it takes too many steps there, as it is stiff or switches without end";

std::string ends_at(Number t, const std::string& why) {
  return "the true motion ends at " + format_significant(static_cast<double>(t), 6) + ": " + why;
}

bool finite(const Values& x) {
  return std::ranges::all_of(x, [](Number one) { return std::isfinite(one); });
}

/// A right-hand side whose choices stay as they are until they are made again. Its outputs are the rates,
/// then the events' guards.
class Frozen {
 public:
  explicit Frozen(const Numbers& numbers)
      : rates_(numbers.rates_and_guards),
        unknowns_(numbers.unknowns),
        registers_(rates_.registers()),
        is_positive_(rates_.registers()),
        largest_(rates_.registers(), 0),
        let_pass_(rates_.registers(), 0),
        off_(rates_.registers(), 0),
        roundings_(unknowns_),
        terms_(rates_.registers()) {
    for (const auto& one : rates_.code())
      if (one.op == Op::choice) {
        choices_.push_back(&one);
        terms_[static_cast<std::size_t>(one.result)] = terms_of(one.a);
      }
  }

  std::size_t unknowns() const { return unknowns_; }
  std::size_t outputs() const { return rates_.outputs().size(); }
  void operator()(const Values& x, Number t, Values& rate) {
    rates_.run_in(registers_.data(), x.data(), t, rate.data(),
                  [this](const Program::Instruction& one, Number, Number yes, Number no) {
                    return takes_yes(one) ? yes : no;
                  });
  }
  /// Makes the choices by the conditions at this point, or a little later where one is zero.
  void choose_at(const Values& x, Number t, Number little) {
    Values rate(outputs()), later = x;
    by_conditions(x, t, rate);
    const std::vector<char> now = is_positive_;
    std::vector<char> undecided(is_positive_.size(), 0);
    for (const auto* one : choices_)
      undecided[static_cast<std::size_t>(one->result)] = registers_[static_cast<std::size_t>(one->a)] == 0;
    // In two steps: from rest a place moves only by its acceleration.
    for (std::size_t i = 0; i < x.size(); ++i) later[i] += little / 2 * rate[i];
    by_conditions(later, t + little / 2, rate);
    for (std::size_t i = 0; i < x.size(); ++i) later[i] = x[i] + little * rate[i];
    by_conditions(later, t + little, rate);
    for (std::size_t i = 0; i < now.size(); ++i)
      if (!undecided[i]) is_positive_[i] = now[i];
  }
  /// The largest violation of a choice by its condition, in the registers of the last call; at most zero
  /// without a violation.
  Number largest_contradiction() const {
    Number most = -std::numeric_limits<Number>::infinity();
    for (const auto* one : choices_) most = std::max(most, contradiction(*one));
    return most;
  }
  void turn_contradicted() {
    for (const auto* one : choices_)
      if (contradiction(*one) > 0) is_positive_[static_cast<std::size_t>(one->result)] ^= 1;
  }
  /// A step begins where the last call was. Where several conditions turn at once, one may contradict its
  /// choice by roundings: that is let pass, as a step's own roundings are, until it goes further.
  void begin_step() {
    for (const auto* one : choices_) {
      const auto i = static_cast<std::size_t>(one->result);
      for (const int term : terms_[i])
        largest_[i] = std::max(largest_[i], std::abs(registers_[static_cast<std::size_t>(term)]));
      let_pass_[i] = 0;
      const Number off = contradiction(*one);
      let_pass_[i] = (off > 0 && off <= 1e-15L * largest_[i] ? off : 0) + 1e-16L * largest_[i];
    }
  }
  /// Bounds of the rates' roundings in the last call: of each operation, and of its arguments' roundings.
  const Values& roundings() {
    const auto at = [this](int i) { return registers_[static_cast<std::size_t>(i)]; };
    const auto off = [this](int i) -> Number& { return off_[static_cast<std::size_t>(i)]; };
    for (const auto& one : rates_.code()) {
      const Number a = at(one.a), b = at(one.b), r = at(one.result);
      const Number rounded = std::numeric_limits<Number>::epsilon() / 2 * std::abs(r);
      switch (one.op) {
        case Op::add:
        case Op::subtract:
          off(one.result) = off(one.a) + off(one.b) + rounded;
          break;
        case Op::multiply:
          off(one.result) = std::abs(b) * off(one.a) + std::abs(a) * off(one.b) + rounded;
          break;
        case Op::divide:
          off(one.result) = (off(one.a) + std::abs(r) * off(one.b)) / std::abs(b) + rounded;
          break;
        case Op::square_root:
          off(one.result) = off(one.a) / (2 * r) + rounded;
          break;
        case Op::sine_and_cosine:
          off(one.result + 1) = off(one.a) + std::numeric_limits<Number>::epsilon() / 2;
          [[fallthrough]];
        case Op::sine:
        case Op::cosine:
          off(one.result) = off(one.a) + rounded;
          break;
        case Op::exponential:
          off(one.result) = std::abs(r) * off(one.a) + rounded;
          break;
        case Op::logarithm:
          off(one.result) = off(one.a) / std::abs(a) + rounded;
          break;
        case Op::arc:
          off(one.result) = (std::abs(b) * off(one.a) + std::abs(a) * off(one.b)) / (a * a + b * b) + rounded;
          break;
        case Op::choice:
          off(one.result) = off(takes_yes(one) ? one.b : one.c);
          break;
        case Op::input:
        case Op::constant:
          break;
      }
    }
    for (std::size_t i = 0; i < unknowns_; ++i) roundings_[i] = off(rates_.outputs()[i]);
    return roundings_;
  }
  bool has_choices() const { return !choices_.empty(); }
  const std::vector<const Program::Instruction*>& choices() const { return choices_; }
  bool takes_yes(const Program::Instruction& one) const {
    return is_positive_[static_cast<std::size_t>(one.result)] != 0;
  }
  /// Reverses this choice, and others with the same condition.
  void turn(const Program::Instruction& one) {
    for (const auto* other : choices_)
      if (other->a == one.a) is_positive_[static_cast<std::size_t>(other->result)] ^= 1;
  }

 private:
  /// The registers whose sum is in this one, each once.
  std::vector<int> terms_of(int place) const {
    std::vector<const Program::Instruction*> producer(rates_.registers(), nullptr);
    for (const auto& one : rates_.code()) producer[static_cast<std::size_t>(one.result)] = &one;
    std::vector<char> seen(rates_.registers(), 0);
    std::vector<int> terms, left{place};
    while (!left.empty()) {
      const int at = left.back();
      left.pop_back();
      if (std::exchange(seen[static_cast<std::size_t>(at)], 1) != 0) continue;
      const auto* made = producer[static_cast<std::size_t>(at)];
      if (made && (made->op == Op::add || made->op == Op::subtract))
        left.insert(left.end(), {made->a, made->b});
      else
        terms.push_back(at);
    }
    return terms;
  }
  Number contradiction(const Program::Instruction& one) const {
    const Number condition = registers_[static_cast<std::size_t>(one.a)];
    return (takes_yes(one) ? -condition : condition) - let_pass_[static_cast<std::size_t>(one.result)];
  }
  void by_conditions(const Values& x, Number t, Values& rate) {
    rates_.run_in(registers_.data(), x.data(), t, rate.data(),
                  [this](const Program::Instruction& one, Number condition, Number yes, Number no) {
                    is_positive_[static_cast<std::size_t>(one.result)] = condition > 0;
                    return condition > 0 ? yes : no;
                  });
  }

  const Program& rates_;
  std::size_t unknowns_;
  Values registers_;
  std::vector<char> is_positive_;        ///< by the choice's register
  Values largest_, let_pass_;            ///< by register: sizes of the condition's terms
  Values off_, roundings_;               ///< by register, and by rate
  std::vector<std::vector<int>> terms_;  ///< terms of each choice's condition
  std::vector<const Program::Instruction*> choices_;
};

/// The guards of a motion's events: whether each may fall, and its consequence.
class Guards {
 public:
  Guards(const Numbers& numbers, Number t) : numbers_(numbers), largest_(count(), 0), may_fall_(count(), 0) {
    const Values now = at(numbers.start, t);
    for (std::size_t i = 0; i < count(); ++i) may_fall_[i] = now[i] >= 0;
    see(now);
  }

  std::size_t count() const { return numbers_.events.size(); }
  bool may_fall(std::size_t i) const { return may_fall_[i] != 0; }
  bool has_just_happened(std::size_t i) const { return just_ == static_cast<int>(i); }
  /// Positive if a guard of this value has fallen. One that an event has left near zero has fallen if it is
  /// below the value there.
  Number fallen(std::size_t i, Number value, Number t) const {
    if (!may_fall(i)) return -std::numeric_limits<Number>::infinity();
    return has_just_happened(i) && t > since_ ? (left_ - value) / (t - since_) : -value;
  }
  Number most_fallen(const Number* values, Number t) const {
    Number most = -std::numeric_limits<Number>::infinity();
    for (std::size_t i = 0; i < count(); ++i) most = std::max(most, fallen(i, values[i], t));
    return most;
  }
  std::size_t first_fallen(const Number* values, Number t) const {
    std::size_t i = 0;
    while (i + 1 < count() && !(fallen(i, values[i], t) > 0)) ++i;
    return i;
  }
  void see(const Values& x, Number t) {
    if (count() > 0) see(at(x, t));
  }
  /// Applies event i to the state x. Returns whether the motion ends.
  bool happen(std::size_t i, Values& x, Number t) {
    Values all(numbers_.afterwards.outputs().size());
    numbers_.afterwards.run(x.data(), t, all.data());
    std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(i * x.size()), x.size(), x.begin());
    in_a_row_ = t - since_ <= 64 * std::numeric_limits<Number>::epsilon() * std::abs(t) ? in_a_row_ + 1 : 0;
    just_ = -1;
    since_ = t;
    if (numbers_.events[i].passes) {
      may_fall_[i] = 0;
    } else if (left_ = at(x, t)[i]; std::abs(left_) <= 1e-9L * largest_[i]) {
      just_ = static_cast<int>(i);
    }
    return numbers_.events[i].ends;
  }
  /// The events' times can no longer be distinguished.
  bool chatter() const { return in_a_row_ >= 16 * static_cast<int>(count()); }

 private:
  Values at(const Values& x, Number t) const {
    Values now(count());
    if (count() > 0) numbers_.guards.run(x.data(), t, now.data());
    return now;
  }
  void see(const Values& now) {
    for (std::size_t i = 0; i < count(); ++i) {
      largest_[i] = std::max(largest_[i], std::abs(now[i]));
      if (!(now[i] > 0)) continue;
      may_fall_[i] = 1;
      if (has_just_happened(i)) just_ = -1;
    }
  }

  const Numbers& numbers_;
  Values largest_;
  std::vector<char> may_fall_;
  int just_ = -1, in_a_row_ = 0;
  Number since_ = -std::numeric_limits<Number>::infinity(), left_ = 0;
};

/// The largest size so far of each unknown, and of its rate.
class Sizes {
 public:
  explicit Sizes(std::size_t n) : sizes_(n, 0) {}
  void see(const Values& x, const Values& rate, Number step) {
    for (std::size_t i = 0; i < x.size(); ++i)
      sizes_[i] = std::max({sizes_[i], std::abs(x[i]), std::abs(rate[i] * step)});
  }
  /// Raises the sizes where roundings of the rates are larger than the tolerance of a part in 2e17.
  void see_roundings(const Values& of_rates, Number step) {
    constexpr Number grown = 10 / 2e-17L;  // within an extrapolated step
    for (std::size_t i = 0; i < sizes_.size(); ++i)
      if (const Number least = grown * of_rates[i] * step; std::isfinite(least))
        sizes_[i] = std::max(sizes_[i], least);
  }
  Number operator[](std::size_t i) const { return sizes_[i] > 0 ? sizes_[i] : 1; }

 private:
  Values sizes_;
};

// ---- Taylor series ---------------------------------------------------------------------------------------

constexpr int order = 26;
using Row = std::array<Number, order + 1>;

/// The Taylor coefficients of all registers about a point.
class Series {
 public:
  explicit Series(const Program& rates) : rates_(rates), rows_(rates.registers()) {
    for (std::size_t i = 0; i < rates.constants().size(); ++i) {
      rows_[i].fill(0);
      rows_[i][0] = rates.constants()[i];
    }
  }
  void expand(const Values& x, Number t, const Frozen& choices) {
    const std::size_t n = x.size(), first = rates_.constants().size();
    for (std::size_t i = 0; i < n; ++i) rows_[first + i][0] = x[i];
    rows_[first + n].fill(0);
    rows_[first + n][0] = t;
    rows_[first + n][1] = 1;
    for (int k = 0; k < order; ++k) {
      for (const auto& one : rates_.code()) coefficient(one, k, choices);
      const auto at = static_cast<std::size_t>(k);
      for (std::size_t i = 0; i < n; ++i)
        rows_[first + i][at + 1] = row(rates_.outputs()[i])[at] / static_cast<Number>(k + 1);
    }
  }
  const Row& row(int i) const { return rows_[static_cast<std::size_t>(i)]; }
  const Row& output(std::size_t i) const { return row(rates_.outputs()[i]); }
  const Row& unknown(std::size_t i) const { return rows_[rates_.constants().size() + i]; }
  /// The value up to this order, which all registers have.
  static Number value(const Row& row, Number h, int terms) {
    Number sum = 0;
    for (int k = terms; k >= 0; --k) sum = sum * h + row[static_cast<std::size_t>(k)];
    return sum;
  }
  /// The change since the expansion point, over h.
  static Number value_over(const Row& row, Number h, int terms) {
    Number sum = 0;
    for (int k = terms; k >= 1; --k) sum = sum * h + row[static_cast<std::size_t>(k)];
    return sum;
  }

 private:
  static Number inside(const Row& a, const Row& b, int from, int to, int k) {
    Number sum = 0;
    for (int j = from; j <= to; ++j)
      sum += a[static_cast<std::size_t>(j)] * b[static_cast<std::size_t>(k - j)];
    return sum;
  }
  /// The sum of j a_j b_(k-j) over 0 < j <= last.
  static Number by_slope(const Row& a, const Row& b, int last, int k) {
    Number sum = 0;
    for (int j = 1; j <= last; ++j)
      sum += static_cast<Number>(j) * a[static_cast<std::size_t>(j)] * b[static_cast<std::size_t>(k - j)];
    return sum;
  }
  static Number by_slope(const Row& a, const Row& b, int k) { return by_slope(a, b, k, k); }
  void coefficient(const Program::Instruction& one, int order_k, const Frozen& choices) {
    const auto k = static_cast<std::size_t>(order_k);
    const auto K = static_cast<Number>(order_k);
    const Row& a = rows_[static_cast<std::size_t>(one.a)];
    const Row& b = rows_[static_cast<std::size_t>(one.b)];
    const Row& c = rows_[static_cast<std::size_t>(one.c)];
    Row& r = rows_[static_cast<std::size_t>(one.result)];
    switch (one.op) {
      case Op::add:
        r[k] = a[k] + b[k];
        break;
      case Op::subtract:
        r[k] = a[k] - b[k];
        break;
      case Op::multiply:
        r[k] = inside(a, b, 0, order_k, order_k);
        break;
      case Op::divide:
        r[k] = (a[k] - inside(r, b, 0, order_k - 1, order_k)) / b[0];
        break;
      case Op::square_root:
        r[k] = k == 0 ? std::sqrt(a[0]) : (a[k] - inside(r, r, 1, order_k - 1, order_k)) / (2 * r[0]);
        break;
      case Op::sine_and_cosine: {
        Row& cosine = rows_[static_cast<std::size_t>(one.result) + 1];
        r[k] = k == 0 ? std::sin(a[0]) : by_slope(a, cosine, order_k) / K;
        cosine[k] = k == 0 ? std::cos(a[0]) : -by_slope(a, r, order_k) / K;
        break;
      }
      case Op::exponential:
        r[k] = k == 0 ? std::exp(a[0]) : by_slope(a, r, order_k) / K;
        break;
      case Op::logarithm:
        r[k] = k == 0 ? std::log(a[0]) : (a[k] - (by_slope(r, a, order_k - 1, order_k)) / K) / a[0];
        break;
      case Op::arc:  // (b b + a a) r' = b a' - a b'
        r[k] = k == 0 ? std::atan2(a[0], b[0])
                      : ((by_slope(a, b, order_k) - by_slope(b, a, order_k)) -
                         by_slope(r, c, order_k - 1, order_k)) /
                            (K * c[0]);
        break;
      case Op::choice:
        r[k] = choices.takes_yes(one) ? b[k] : c[k];
        break;
      case Op::sine:
      case Op::cosine:
      case Op::input:
      case Op::constant:
        break;
    }
  }

  const Program& rates_;
  std::vector<Row> rows_;
};

constexpr Number tolerance = 1e-19L;

/// The largest valid step of the series: its last two terms are below the tolerance, as are those of
/// conditions and guards, which have one order less.
Number reach_of(const Series& series, const Sizes& sizes, std::size_t n, const Frozen& choices,
                std::size_t guards, Number span) {
  Number reach = std::numeric_limits<Number>::infinity();
  for (int k : {order - 2, order - 1, order}) {
    const auto last = static_cast<std::size_t>(k);
    Number most = 0;
    const auto see = [&](const Row& row) {
      // a register that starts at zero, and at rest, is measured by its growth
      if (k < order && row[last] != 0)
        most = std::max(most, std::abs(row[last]) / std::max({std::abs(row[0]), std::abs(row[1]) * span,
                                                              std::abs(row[2]) * span * span}));
    };
    for (std::size_t i = 0; i < n && k >= order - 1; ++i)
      most = std::max(most, std::abs(series.unknown(i)[last]) / sizes[i]);
    for (const auto* one : choices.choices()) see(series.row(one->a));
    for (std::size_t i = 0; i < guards; ++i) see(series.output(n + i));
    if (most > 0) reach = std::min(reach, std::pow(tolerance / most, 1 / static_cast<Number>(k)));
  }
  return reach;
}

/// The first point up to h at which this becomes positive; empty without one.
template <class F>
std::optional<Number> first_positive(const F& at, Number h) {
  constexpr int samples = 8;
  for (int i = 1; i <= samples; ++i) {
    Number from = h * (i - 1) / samples, to = h * i / samples;
    if (!(at(to) > 0)) continue;
    for (int half = 0; half < 80 && to > from; ++half) {
      const Number middle = (from + to) / 2;
      if (middle <= from || middle >= to) break;
      (at(middle) > 0 ? to : from) = middle;
    }
    return to;
  }
  return {};
}

/// The first turn within a step: a condition contradicts its choice, a guard falls, or neither.
struct Turn {
  Number after;  ///< the step, or this part of it
  const Program::Instruction* choice = nullptr;
  std::optional<std::size_t> event = {};
};

Turn first_turn(const Series& series, const Frozen& choices, const Guards& guards, Number h) {
  constexpr int terms = order - 1;
  Turn first{h};
  int seen = -1;  // choices of one condition, such as a table's coefficients, are adjacent
  for (const auto* one : choices.choices()) {
    if (std::exchange(seen, one->a) == one->a) continue;
    const Number sign = choices.takes_yes(*one) ? -1 : 1;
    const Row& condition = series.row(one->a);
    // On the wrong side of zero by a rounding, where several conditions turn at once, and moving to the right
    // side.
    const bool has_turned =
        sign * condition[0] > 0 && std::abs(condition[0]) <= 1e-15L * std::abs(condition[1] * h);
    const auto off = [&](Number s) {
      return sign *
             (has_turned ? Series::value_over(condition, s, terms) : Series::value(condition, s, terms));
    };
    if (const auto at = first_positive(off, first.after)) first = {*at, one};
  }
  for (std::size_t i = 0; i < guards.count(); ++i) {
    if (!guards.may_fall(i)) continue;
    const Row& guard = series.output(choices.unknowns() + i);
    const auto fallen = [&](Number s) {
      // after an event, the guard over the time since: the event itself must not count again
      return guards.has_just_happened(i) ? -Series::value_over(guard, s, terms)
                                         : -Series::value(guard, s, terms);
    };
    if (const auto at = first_positive(fallen, first.after)) first = {*at, nullptr, i};
  }
  return first;
}

}  // namespace

TrueMotion by_series(const Numbers& numbers, std::span<const double> times) {
  return by_series_within(numbers, times, most_steps);
}

TrueMotion by_series_within(const Numbers& numbers, std::span<const double> times, long most) {
  const std::size_t n = numbers.unknowns;
  TrueMotion motion{{numbers.start}};
  Frozen choices(numbers);
  Guards guards(numbers, times.front());
  Series series(numbers.rates_and_guards);
  Sizes sizes(n);
  Values x = numbers.start, rate(n), now(n);
  Number t = times.front();
  const Number span = times.back() - t;
  choices.choose_at(x, t, span * 1e-9L);
  std::size_t next = 1;
  for (long steps = 0; next < times.size(); ++steps) {
    check_stop_at_times();
    if (steps == most) return motion.trouble = ends_at(t, too_many_steps), motion;
    series.expand(x, t, choices);
    for (std::size_t i = 0; i < n; ++i) rate[i] = series.unknown(i)[1];
    if (!finite(x) || !finite(rate)) return motion.trouble = ends_at(t, "it is not finite there"), motion;
    sizes.see(x, rate, span / 64);
    const Number h = std::min(reach_of(series, sizes, n, choices, guards.count(), span / 64),
                              static_cast<Number>(times.back()) - t);
    if (!(h > 0) || t + h == t) return motion.trouble = ends_at(t, "it is singular there"), motion;
    const Turn turn = first_turn(series, choices, guards, h);
    for (; next < times.size() && times[next] <= t + turn.after * (1 + 1e-18L); ++next) {
      for (std::size_t i = 0; i < n; ++i) now[i] = Series::value(series.unknown(i), times[next] - t, order);
      if (!finite(now)) return motion.trouble = ends_at(t, "it is not finite there"), motion;
      motion.states.push_back(now);
    }
    for (std::size_t i = 0; i < n; ++i) x[i] = Series::value(series.unknown(i), turn.after, order);
    t += turn.after;
    if (turn.choice) choices.turn(*turn.choice);
    if (!turn.event) {
      guards.see(x, t);
    } else {
      if (guards.happen(*turn.event, x, t)) motion.states.resize(times.size(), x), next = times.size();
      if (guards.chatter()) return motion.trouble = ends_at(t, without_end), motion;
      choices.choose_at(x, t, span * 1e-9L);
    }
  }
  return motion;
}

// ---- extrapolation ---------------------------------------------------------------------------------------

namespace {

/// Steps of the modified midpoint rule in 2, 4, 6 ... parts, extrapolated to zero step [Hairer, Norsett and
/// Wanner, Solving Ordinary Differential Equations I, II.9].
class Extrapolation {
 public:
  Extrapolation(Frozen& rates, const Guards& guards) : rates_(rates), guards_(guards) {
    for (auto* all : {&before_, &here_, &after_}) all->resize(rates.unknowns());
    rate_.resize(rates.outputs());
    for (Values& column : columns_) column.resize(rates.unknowns());
  }

  /// x after h; returns the error in tolerances.
  Number step(const Values& x, Number t, Number h, const Sizes& sizes, Values& result) {
    const std::size_t n = x.size();
    Number error = 0;
    for (int k = 0; k < columns; ++k) {
      midpoint(x, t, h, 2 * (k + 1));
      error = 0;
      for (std::size_t i = 0; i < n; ++i) {
        Number newest = here_[i];
        for (int j = 0; j < k; ++j) {
          // The kept value is from the row above; it is replaced by this row's.
          const auto above = static_cast<Number>(k + 1), below = static_cast<Number>(k - j);
          Number& kept = columns_[static_cast<std::size_t>(j)][i];
          const Number ratio = above / below, better = newest + (newest - kept) / (ratio * ratio - 1);
          kept = newest;
          if (j == k - 1) error = std::max(error, std::abs(better - newest) / (sizes[i] * 2e-17L));
          newest = better;
        }
        columns_[static_cast<std::size_t>(k)][i] = newest;
        result[i] = newest;
      }
    }
    return finite(result) ? error : std::numeric_limits<Number>::infinity();
  }
  static constexpr int columns = 9, most_parts = 2 * columns;
  /// Values within the last step, after each of its parts except the last: above zero where a condition
  /// contradicts its choice or a guard has fallen. The finest of the step's columns decides.
  using Within = std::array<Number, most_parts>;
  const Within& within() const { return within_; }

 private:
  void midpoint(const Values& x, Number t, Number h, int parts) {
    const Number part = h / static_cast<Number>(parts);
    before_ = x;
    rates_(x, t, rate_);
    for (std::size_t i = 0; i < x.size(); ++i) here_[i] = x[i] + part * rate_[i];
    for (int m = 1; m < parts; ++m) {
      const Number then = t + static_cast<Number>(m) * part;
      rates_(here_, then, rate_);
      if (parts == most_parts)
        within_[static_cast<std::size_t>(m)] =
            std::max(rates_.largest_contradiction(), guards_.most_fallen(rate_.data() + x.size(), then));
      for (std::size_t i = 0; i < x.size(); ++i) after_[i] = before_[i] + 2 * part * rate_[i];
      std::swap(before_, here_);
      std::swap(here_, after_);
    }
  }

  Frozen& rates_;
  const Guards& guards_;
  Within within_{};
  Values before_, here_, after_, rate_;
  std::array<Values, columns> columns_;
};

}  // namespace

TrueMotion by_extrapolation(const Numbers& numbers, std::span<const double> times) {
  const std::size_t n = numbers.unknowns;
  TrueMotion motion{{numbers.start}};
  Frozen frozen(numbers);
  Guards guards(numbers, times.front());
  Extrapolation extrapolation(frozen, guards);
  Sizes sizes(n);
  Values x = numbers.start, rate(frozen.outputs()), after(n), ignored(frozen.outputs());
  Number t = times.front(), h = (times.back() - t) / 256;
  const Number span = times.back() - t;
  frozen.choose_at(x, t, span * 1e-9L);
  /// The largest contradiction of a choice, or fall of a guard.
  const auto off = [&](const Values& here, Number then) {
    frozen(here, then, ignored);
    return std::max(frozen.largest_contradiction(), guards.most_fallen(ignored.data() + n, then));
  };
  const auto off_after = [&](Number step) {
    extrapolation.step(x, t, step, sizes, after);
    return off(after, t + step);
  };
  /// First place of a fault within a step to `after`, from the values within the step. 0: none.
  const auto first_turn = [&](Number step) -> Number {
    constexpr int parts = Extrapolation::most_parts;
    const Extrapolation::Within within = extrapolation.within();
    Number good = 0, bad = off(after, t + step) > 0 ? step : 0;
    for (int m = 1; m < parts; ++m) {
      const Number part = step * m / parts;
      if (within[static_cast<std::size_t>(m)] > 0 && off_after(part) > 0) {
        bad = part;
        break;
      }
      good = part;
    }
    if (bad == 0) return 0;
    Number below = good == 0 ? -1 : off_after(good), above = off_after(bad);
    for (; below > 0; below = good == 0 ? -1 : off_after(good)) {  // the values within are less exact
      bad = std::exchange(good, std::max(good - step / parts, Number(0)));
      above = below;
    }
    // Tries points a little to either side of the secant's, in turn, and sometimes the middle, so that both
    // ends converge.
    for (int turns = 0; turns < 200; ++turns) {
      const Number secant = good + (bad - good) * below / (below - above);
      const Number to = turns % 2 == 0 ? bad : good, beside = secant + (to - secant) * 1e-3L;
      const bool by_halves = good == 0 || turns % 4 == 3 || !(beside > good && beside < bad);
      const Number at = by_halves ? (good + bad) / 2 : beside;
      if (!(at > good && at < bad)) break;
      const Number there = off_after(at);
      (there > 0 ? bad : good) = at;
      (there > 0 ? above : below) = there;
    }
    return bad;
  };
  std::size_t next = 1;
  for (long steps = 0; next < times.size(); ++steps) {
    check_stop_at_times();
    if (steps == most_steps) return motion.trouble = ends_at(t, too_many_steps), motion;
    frozen(x, t, rate);
    frozen.begin_step();
    if (!finite(rate)) return motion.trouble = ends_at(t, "it is not finite there"), motion;
    sizes.see(x, rate, span / 64);
    sizes.see_roundings(frozen.roundings(), span / 64);
    const Number left = static_cast<Number>(times[next]) - t;
    const bool last = h >= left * (1 - 1e-15L);
    Number taken = last ? left : h;
    if (t + taken == t && !last) return motion.trouble = ends_at(t, "it is singular there"), motion;
    const Number error = extrapolation.step(x, t, taken, sizes, after);
    const Number factor =
        error > 0 ? std::pow(0.3L / error, 1 / static_cast<Number>(2 * Extrapolation::columns - 1)) : 4;
    if (!(error <= 1)) {
      h = taken * std::clamp(factor, Number(0.1), Number(0.8));
      if (!(std::isfinite(h)) || h < span * 1e-16L)
        return motion.trouble = ends_at(t, "it is singular there"), motion;
      continue;
    }
    if (frozen.has_choices() || guards.count() > 0) {
      const Values end = after;
      if (const Number turn = first_turn(taken); turn > 0) {
        off_after(turn);
        frozen.turn_contradicted();
        x = after;
        t += turn;
        if (turn >= left) motion.states.push_back(x), ++next;
        if (guards.most_fallen(ignored.data() + n, t) > 0) {
          if (guards.happen(guards.first_fallen(ignored.data() + n, t), x, t))
            motion.states.resize(times.size(), x), next = times.size();
          if (guards.chatter()) return motion.trouble = ends_at(t, without_end), motion;
          frozen.choose_at(x, t, span * 1e-9L);
        } else {
          guards.see(x, t);
        }
        continue;
      }
      after = end;
    }
    x = after;
    t = last ? static_cast<Number>(times[next]) : t + taken;
    guards.see(x, t);
    if (last) motion.states.push_back(x), ++next;
    const Number longer = taken * std::clamp(factor, Number(0.5), Number(3));
    h = last ? std::max(h, longer) : longer;
  }
  return motion;
}

}  // namespace oddity::problem
