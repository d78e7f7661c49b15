#include "reference/in_long_double.hpp"

#include <algorithm>
#include <exception>

#include "reference/truth.hpp"

namespace oddity {

namespace {

/// What the tick throws is not the routes'.
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

Known known(const truth::Truth& table, const truth::Made& made) {
  Known all{{}, static_cast<double>(made.error), {}};
  all.source = "computed on the spot in long double: " + table.first_route + "; and " + table.second_route;
  for (const truth::Number& x : made.value) {
    all.value.push_back(static_cast<double>(x));
    all.error = std::max(all.error, std::abs(all.value.back()) * 0x1p-53);
  }
  return all;
}

}  // namespace

std::optional<Known> motion_in_long_double(std::string_view table, const std::vector<double>& inputs_but_time,
                                           std::span<const double> times, std::size_t compared,
                                           const std::function<void(double)>& tick) {
  const auto& all = truth::registry();
  const auto found = std::ranges::find(all, table, &truth::Entry::name);
  if (found == all.end()) return {};
  const truth::Truth made_by = found->make();
  try {
    return known(made_by, truth::make_motion(made_by, inputs_but_time, {times.begin(), times.end()},
                                             digits_in_long_double, compared, watched(tick)));
  } catch (const Ended& ended) {
    std::rethrow_exception(ended.by);
  } catch (const std::exception&) {
    return {};
  }
}

}  // namespace oddity
