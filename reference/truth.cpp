#include "reference/truth.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>

#include "reference/make/aside.hpp"
#include "reference/make/motions.hpp"

namespace oddity::truth {

namespace {

/// Initializes the limits of Boost's numbers before there is a second thread. Boost 1.74 does it at first
/// use, and marks them as ready too early: another thread may read a half-written one ("numeric overflow" in
/// Jacobi's functions).
[[maybe_unused]] const bool limits_are_made = [] {
  using Limits = std::numeric_limits<Number>;
  for (const Number& limit :
       {Limits::min(), Limits::max(), Limits::lowest(), Limits::epsilon(), Limits::round_error(),
        Limits::infinity(), Limits::quiet_NaN(), Limits::denorm_min()})
    static_cast<void>(limit);
  return true;
}();

}  // namespace

Number power_of_ten_above(const Number& x) {
  if (x == 0) return 0;
  return pow(Number(10), ceil(log10(x)));
}

Number size_of(const Numbers& value) {
  Number size = 0;
  for (const Number& x : value) size = std::max<Number>(size, abs(x));
  return size < pow(Number(10), 12 - static_cast<int>(working_digits)) ? Number(1) : size;
}

namespace {

/// Raises `error` to the disagreement of both routes at the same inputs, and to the rounding of the largest
/// component to `digits`.
void compare(const Truth& truth, const Numbers& first, const Numbers& second, int digits, Number& error) {
  if (first.size() != truth.components.size() || second.size() != first.size())
    throw std::logic_error("a route made " + std::to_string(second.size()) + " components of " +
                           std::to_string(truth.components.size()));
  for (std::size_t i = 0; i < second.size(); ++i) {
    if (!isfinite(first[i]) || !isfinite(second[i]))
      throw std::domain_error("the " + std::string(isfinite(second[i]) ? "first" : "second") +
                              " route gives no finite " + truth.components[i].name);
    error = std::max<Number>(error, abs(first[i] - second[i]));
  }
  error = std::max<Number>(error, size_of(first) * pow(Number(10), -digits));
}

}  // namespace

Made make_row(const Truth& truth, const std::vector<double>& inputs, int digits) {
  Made made{truth.first(inputs, digits), 0};
  compare(truth, made.value, truth.second(inputs, digits), digits, made.error);
  made.error = power_of_ten_above(made.error);
  return made;
}

namespace {

/// Values of a route at the selected times, each with all its components; empty at the others.
std::vector<Numbers> along(const Route& route, std::vector<double> inputs, const std::vector<double>& times,
                           int digits, const std::function<bool(std::size_t)>& at, const Tick& tick) {
  Motions motions(tick);
  inputs.push_back(0);
  std::vector<Numbers> values(times.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!at(i)) continue;
    motions.come_to(static_cast<double>(i) / static_cast<double>(times.size()));
    inputs.back() = times[i];
    values[i] = route(inputs, {digits, &motions});
  }
  return values;
}

}  // namespace

Made make_motion(const Truth& truth, const std::vector<double>& inputs_but_time,
                 const std::vector<double>& times, int digits, std::size_t compared, const Tick& tick,
                 std::optional<int> rounded) {
  const std::size_t stride = std::max<std::size_t>(1, times.size() / std::max<std::size_t>(1, compared));
  const auto is_compared = [&](std::size_t i) { return (times.size() - 1 - i) % stride == 0; };
  std::optional<std::vector<Numbers>> second;
  Aside<std::vector<Numbers>> making_second(tick, [&](const Tick& until_over) {
    return along(truth.second, inputs_but_time, times, digits, is_compared, until_over);
  });
  const Tick tick_and_look = [&](double done) {
    if (!second && making_second.is_ready()) second = making_second.get();
    tick(done);
  };
  const auto always = [](std::size_t) { return true; };
  const std::vector<Numbers> first =
      along(truth.first, inputs_but_time, times, digits, always, tick ? tick_and_look : Tick());
  if (!second) second = making_second.get();
  Made made{{}, 0};
  for (std::size_t i = 0; i < times.size(); ++i) {
    compare(truth, first[i], is_compared(i) ? (*second)[i] : first[i], rounded.value_or(digits), made.error);
    made.value.insert(made.value.end(), first[i].begin(), first[i].end());
    if (is_compared(i)) made.error_until.resize(i + 1, power_of_ten_above(made.error));
  }
  made.error = power_of_ten_above(made.error);
  return made;
}

}  // namespace oddity::truth
