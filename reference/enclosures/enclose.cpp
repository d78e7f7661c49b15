#include "reference/enclosures/enclose.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "reference/truth.hpp"

namespace oddity {

namespace {

using truth::Ball;

/// The wanted and the required radius, relative to the largest component and to the component itself.
constexpr double wanted = 1e-41, needed = 1e-20;
/// If all components are at most this large, they are zero in a table's digits, and give no scale.
constexpr double vanishing = 1e-48;

struct Effort {
  slong bits;
  int digits;
};
/// Tried in turn, as long as the result is undecided or too wide.
constexpr Effort efforts[] = {{224, 46}, {352, 72}, {640, 120}, {2048, 120}};

double radius_of(const Ball& x) { return truth::greatest_size(x - truth::midpoint(x)); }

bool narrow(const truth::Numbers& balls) {
  double size = 0;
  for (const Ball& x : balls) size = std::max(size, truth::greatest_size(x));
  if (size < vanishing) size = 1;
  return std::ranges::all_of(balls, [&](const Ball& x) {
    const double radius = radius_of(x), own = truth::greatest_size(x);
    return radius <= wanted * size && (radius <= needed * own || own <= wanted * size);
  });
}

truth::Numbers enclosed(const truth::Truth& truth, const std::vector<double>& inputs) {
  std::string reason = "the balls are too wide";
  for (const Effort& effort : efforts) {
    Ball::bits = effort.bits;
    try {
      truth::Numbers balls = truth.enclosed(inputs, effort.digits);
      if (narrow(balls)) return balls;
    } catch (const truth::Undecided& error) {
      reason = error.what();
    }
  }
  throw std::runtime_error("no enclosure with " + std::to_string(std::prev(std::end(efforts))->bits) +
                           " bits: " + reason);
}

/// Empty if the table has no route that encloses it.
std::optional<truth::Truth> enclosed_truth(std::string_view table) {
  const auto& all = truth::registry();
  const auto found = std::ranges::find(all, table, &truth::Entry::name);
  if (found == all.end()) return {};
  truth::Truth truth = found->make();
  if (!truth.enclosed) return {};
  return truth;
}

/// Throws Undecided if the balls are too wide.
double distance(const truth::Numbers& balls, std::span<const double> values, double part) {
  double size = 0, distance = 0;
  for (const Ball& x : balls) size = std::max(size, truth::greatest_size(x));
  for (std::size_t i = 0; i < balls.size(); ++i) {
    if (radius_of(balls[i]) > part * (size == 0 ? 1 : size)) throw truth::Undecided("the balls are too wide");
    distance = std::max(distance, truth::greatest_size(balls[i] - Ball(values[i])));
  }
  return distance;
}

double distance(const truth::Truth& truth, const ToEnclose& asked, int digits,
                const std::function<void(double)>& tick) {
  const double part = std::pow(10, -asked.digits);
  if (asked.times.empty()) return distance(truth.enclosed(asked.inputs, digits), asked.values, part);
  const std::size_t components = asked.values.size() / asked.times.size();
  std::vector<double> inputs = asked.inputs;
  inputs.push_back(0);
  double largest = 0;
  for (std::size_t k = 0; k < asked.times.size(); ++k) {
    if (tick) tick(static_cast<double>(k) / static_cast<double>(asked.times.size()));
    inputs.back() = asked.times[k];
    const auto values = asked.values.subspan(k * components, components);
    largest = std::max(largest, distance(truth.enclosed(inputs, digits), values, part));
  }
  return largest;
}

}  // namespace

Enclosed enclosed_on_demand(const ToEnclose& asked, const std::function<void(double)>& tick) {
  const auto truth = enclosed_truth(asked.table);
  if (!truth) return {.by = "not enclosed: its table has no route that encloses it"};
  std::string reason;
  for (int more : {2, 10, 26, 60}) {
    const int digits = asked.digits + more;
    Ball::bits = 64 + 7 * digits / 2;
    try {
      return {distance(*truth, asked, digits, tick), "enclosed by " + truth->enclosure};
    } catch (const truth::Undecided& error) {
      reason = error.what();
    }
  }
  return {.by = "not enclosed: " + reason};
}

std::optional<std::vector<double>> distances_from_exact(std::string_view table,
                                                        const std::vector<double>& inputs,
                                                        const std::vector<std::string>& decimals) {
  const auto truth = enclosed_truth(table);
  if (!truth) return {};
  const truth::Numbers balls = enclosed(*truth, inputs);
  if (balls.size() != decimals.size())
    throw std::logic_error("an enclosure has " + std::to_string(balls.size()) +
                           " components, and its table " + std::to_string(decimals.size()));
  std::vector<double> distances;
  for (std::size_t i = 0; i < balls.size(); ++i)
    distances.push_back(truth::greatest_size(balls[i] - truth::decimal(decimals[i])));
  return distances;
}

}  // namespace oddity
