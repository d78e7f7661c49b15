#include "report/site/module/own/played.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "problem/system.hpp"
#include "solvers/ode/unknowns.hpp"

namespace oddity::module {

namespace {

using problem::Numbers;

/// The page answers while one types: a motion may take at most some hundreds of milliseconds.
constexpr double most_operations = 1e8;
constexpr const char* too_long = "it takes more than a page computes at once";

template <std::size_t n>
class Played final : public problem::SystemOf<n, ModelInterfaceOf<n>> {
  using Base = problem::SystemOf<n, ModelInterfaceOf<n>>;

 public:
  using typename Base::State;

  Played(const std::shared_ptr<const Numbers>& exact, const std::shared_ptr<const Numbers>& rounded)
      : Base(exact), in_float_(rounded), each_(static_cast<double>(exact->rates.code().size() + n + 10)) {
    for (std::size_t i = 0; i < n; ++i) start_in_float_[i] = static_cast<float>(rounded->start[i]);
  }
  void operator()(const State& x, State& dxdt, double t) const override {
    operations_ += each_;
    Base::operator()(x, dxdt, t);
  }
  void acceleration(const typename Base::Half& q, typename Base::Half& a) const override {
    operations_ += each_;
    Base::acceleration(q, a);
  }
  long jacobian(const State& x, double* matrix, double* dfdt, double t) const override {
    operations_ += 2 * static_cast<double>(n) * each_;
    return Base::jacobian(x, matrix, dfdt, t);
  }
  bool partitioned() const override { return this->numbers().partitioned; }
  bool constrained() const override { return !this->numbers().off.outputs().empty(); }

 private:
  State start() const override { return this->start_of_numbers(); }
  void observe(const State& x, double t, std::vector<double>& seen) const override {
    this->add_observed(x, t, seen);
  }
  std::vector<Conserved<double>> conserved(const State& x, double t) const override {
    return this->all_conserved(x, t);
  }
  double off_constraint(const State& x, double t) const override { return this->most_off(x, t); }
  ode::Trajectory<State> integrate(std::string_view algorithm, std::span<const double> times, double setting,
                                   const ode::Watch<n>& watch) const override {
    operations_ = 0;
    const auto enough = [&](double t0, const State& x0, double t1, const State& x1) {
      return operations_ > most_operations || watch(t0, x0, t1, x1);
    };
    auto motion =
        ode::integrate_with_events<n>(algorithm, *this, start(), times, setting, ode::Watch<n>(enough))
            .trajectory;
    if (operations_ > most_operations && motion.reached()) {
      motion.ending = Ending::raised;
      motion.message = too_long;
    }
    return motion;
  }
  const ode::AnySystem<n, float>& system_in_float() const override { return in_float_; }
  std::array<float, n> start_in_float() const override { return start_in_float_; }

  problem::SystemInFloat<n> in_float_;
  std::array<float, n> start_in_float_{};
  double each_;
  mutable double operations_ = 0;
};

/// A closed form, for Formula.
struct Closed {
  std::shared_ptr<const Numbers> numbers;

  template <class T>
  std::vector<T> at(T t) const {
    std::vector<T> values(numbers->observed.outputs().size());
    numbers->observed.run(&t, t, values.data());
    return values;
  }
};

class Refused final : public Model {
 public:
  explicit Refused(std::string why) : why_(std::move(why)) {}
  bool closed_form() const override { return false; }
  bool partitioned() const override { return false; }
  bool has_velocities() const override { return false; }
  bool constrained() const override { return false; }
  bool has_events() const override { return false; }
  Motion run(std::string_view, Precision, double, std::span<const double>) const override {
    Motion motion;
    motion.ending = Ending::raised;
    motion.message = why_;
    return motion;
  }

 private:
  std::string why_;
};

}  // namespace

std::unique_ptr<const Model> played(const problem::Model& model, std::span<const double> parameters) {
  std::vector<double> rounded(parameters.begin(), parameters.end());
  for (double& value : rounded) value = static_cast<double>(static_cast<float>(value));
  try {
    const auto numbers = std::make_shared<const Numbers>(model.with({parameters.begin(), parameters.end()}));
    if (model.is_closed())
      return std::make_unique<const Formula<Closed, Closed>>(
          Closed{numbers}, Closed{std::make_shared<const Numbers>(model.with(rounded))});
    const auto in_float =
        model.is_constrained() ? numbers : std::make_shared<const Numbers>(model.with(rounded));
#define ODDITY_PLAYED(n, unused) \
  if (numbers->unknowns == (n)) return std::make_unique<const Played<n>>(numbers, in_float);
    ODDITY_FOR_UNKNOWNS(ODDITY_PLAYED, )
#undef ODDITY_PLAYED
    return std::make_unique<const Refused>("no algorithms for so many unknowns");
  } catch (const BadInput& error) {
    return std::make_unique<const Refused>(error.what());
  }
}

}  // namespace oddity::module
