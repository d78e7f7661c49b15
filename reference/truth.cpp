#include "reference/truth.hpp"

#include <algorithm>
#include <stdexcept>

#include "reference/make/motions.hpp"

namespace oddity::truth {

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

/// Both routes at the same inputs: raises `error` to their disagreement, and to what so many digits leave
/// open of the largest component.
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

Made make_motion(const Truth& truth, const std::vector<double>& inputs_but_time,
                 const std::vector<double>& times, int digits, std::size_t compared, const Tick& tick) {
  Motions first(tick), second(tick);
  std::vector<double> inputs = inputs_but_time;
  inputs.push_back(0);
  Made made{{}, 0};
  const std::size_t stride = std::max<std::size_t>(1, times.size() / std::max<std::size_t>(1, compared));
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(times.size());
    for (Motions* route : {&first, &second}) route->come_to(part);
    inputs.back() = times[i];
    const Numbers value = truth.first(inputs, {digits, &first});
    const bool is_compared = (times.size() - 1 - i) % stride == 0;
    compare(truth, value, is_compared ? truth.second(inputs, {digits, &second}) : value, digits, made.error);
    made.value.insert(made.value.end(), value.begin(), value.end());
    if (is_compared) made.error_until.resize(i + 1, power_of_ten_above(made.error));
  }
  made.error = power_of_ten_above(made.error);
  return made;
}

}  // namespace oddity::truth
