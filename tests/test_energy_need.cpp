#include "report/study/candidate.hpp"
#include "report/verify/catch.hpp"

using namespace oddity;

namespace {

/// A place at rest and a rate at two times, with the energy of that rate: the true one is 1, here it is at
/// most 1.004.
Quantity moving() {
  Quantity q{"x", "m", "a length", {"by hand", Value{1, 1}}, 1e-12, {0.1, "a test"}};
  q.samples = 2;
  q.energy = [](std::span<const double> seen) { return Energy{seen[1], seen[1]}; };
  Method method{"model", "algorithm", no_resolution(), [](double) { return Answer{Value{1, 1}, 10}; }};
  method.places_and_rates = [](double) { return Value{1, 1.001, 1, 1.004}; };
  q.methods = {method};
  return q;
}

}  // namespace

TEST_CASE("a method holds by its energy if that is within the requested error of its true value",
          "[choose]") {
  std::vector<Start> starts{{"here", moving()}};
  starts[0].energy = std::make_shared<Lazy<TrueEnergy>>([] { return TrueEnergy{{1, 1}, 2, 1e-12}; });
  const auto judged = [&](double asked) {
    Need need{asked};
    need.criterion = Criterion::energy;
    return evaluate(starts, starts[0].motion.methods[0], 0, need);
  };
  CHECK(std::abs(judged(0.002).error - 1) < 1e-12);
  CHECK(std::abs(judged(0.004).error - 0.5) < 1e-12);
  CHECK(std::abs(judged(0.004).by.at(Criterion::energy) - 0.002) < 1e-12);
  CHECK(judged(0.0021).holds());
  CHECK_FALSE(judged(0.0019).holds());
}
