#include "reference/in_long_double.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <type_traits>

#include "reference/make/aside.hpp"
#include "reference/make/motions.hpp"
#include "reference/truth.hpp"

namespace oddity {

namespace {

constexpr bool is_double = std::is_same_v<truth::Number, double>;
constexpr int asked_digits = is_double ? digits_in_double : digits_in_long_double;
// Routes that are asked for 8 digits in double agree to 12 or more over an hour. Errors are up to twice their
// disagreement.
constexpr int rounded_digits = is_double ? 13 : asked_digits;
constexpr truth::Number times_disagreement = is_double ? 3 : 1;

/// An exception of the tick, as opposed to one of the routes.
struct Ended {
  std::exception_ptr by;
};

truth::Tick watched(const std::function<void(double)>& tick) {
  if (!tick) return {};
  return [&tick](double done) {
    try {
      tick(done);
    } catch (...) {
      throw Ended{std::current_exception()};
    }
  };
}

/// Values by the first route alone, one time after another.
truth::Numbers by_first_route(const truth::Truth& table, std::vector<double> inputs,
                              const std::vector<double>& times, int digits, const truth::Tick& tick) {
  truth::Motions motions(tick);
  inputs.push_back(0);
  truth::Numbers all;
  for (const double t : times) {
    inputs.back() = t;
    const truth::Numbers value = table.first(inputs, {digits, &motions});
    all.insert(all.end(), value.begin(), value.end());
  }
  return all;
}

/// Error bound up to each time. If roundings grow, the second route's may be a thousand times the first's.
/// The start's rounding is the same in all repeats, and no larger than that of one step. Of 100 chaotic
/// chains none was off by more than 0.7 of the spread of six repeats.
truth::Numbers error_by_repeats(const truth::Truth& table, const std::vector<double>& inputs,
                                const std::vector<double>& times, const truth::Tick& tick,
                                const truth::Numbers& value) {
  constexpr truth::Number safety = 2;
  std::vector<std::unique_ptr<truth::Aside<truth::Numbers>>> repeats;
  for (const int more : {-4, -3, -2, -1, 1, 2})
    repeats.push_back(std::make_unique<truth::Aside<truth::Numbers>>(tick, [&, more](const auto& until_over) {
      return by_first_route(table, inputs, times, asked_digits + more, until_over);
    }));
  truth::Numbers error_until(times.size(), 0);
  for (const auto& repeat : repeats) {
    const truth::Numbers again = repeat->get();
    const std::size_t parts = value.size() / times.size();
    truth::Number parted_by = 0;
    for (std::size_t i = 0; i < value.size(); ++i) {
      parted_by = std::max(parted_by, safety * std::abs(value[i] - again[i]));
      error_until[i / parts] = std::max(error_until[i / parts], parted_by);
    }
  }
  return error_until;
}

/// Lowers the bounds for times at which both routes still agree on the motion.
void bound_by_repeats(truth::Made& made, const truth::Numbers& error_until) {
  const truth::Number one_motion = truth::size_of(made.value) / 100;
  for (std::size_t k = 0; k < error_until.size(); ++k)
    if (made.error_until[k] <= one_motion)
      made.error_until[k] = std::min(made.error_until[k], error_until[k]);
  made.error = made.error_until.back();
}

Known known(const truth::Truth& table, const truth::Made& made) {
  Known all;
  all.source = "computed on the spot in " + std::string(is_double ? "double: " : "long double: ") +
               table.first_route + "; and " + table.second_route;
  const std::size_t parts = made.value.size() / made.error_until.size();
  double rounded_by = 0;
  for (const truth::Number& x : made.value) {
    all.value.push_back(static_cast<double>(x));
    rounded_by = std::max(rounded_by, std::abs(all.value.back()) * 0x1p-53);
    if (all.value.size() % parts == 0) {
      const truth::Number& error = made.error_until[all.value.size() / parts - 1];
      all.error_until.push_back(std::max(static_cast<double>(error), rounded_by));
    }
  }
  all.error = all.error_until.back();
  return all;
}

}  // namespace

/// Compiled twice, each time under the name of its numbers.
std::optional<Known> motion_in_number(std::string_view table, const std::vector<double>& inputs_but_time,
                                      std::span<const double> times, std::size_t compared,
                                      const std::function<void(double)>& tick, BoundedBy bound) {
  const auto& all = truth::registry();
  const auto found = std::ranges::find(all, table, &truth::Entry::name);
  if (found == all.end() || times.empty()) return {};
  const truth::Truth made_by = found->make();
  try {
    const std::vector<double> at(times.begin(), times.end());
    const truth::Tick watch = watched(tick);
    truth::Made made =
        truth::make_motion(made_by, inputs_but_time, at, asked_digits, compared, watch, rounded_digits);
    for (truth::Number& error : made.error_until) error *= times_disagreement;
    made.error *= times_disagreement;
    if (bound == BoundedBy::repeats)
      bound_by_repeats(made, error_by_repeats(made_by, inputs_but_time, at, watch, made.value));
    return known(made_by, made);
  } catch (const Ended& ended) {
    std::rethrow_exception(ended.by);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    return {};
  }
}

}  // namespace oddity
