#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "chapters/numbers.hpp"
#include "problem/model.hpp"
#include "solvers/ode/any_system.hpp"

/// A file's model behind the type-erased interface of the algorithms, for the program and for the page.
namespace oddity::problem {

template <std::size_t n>
ode::Velocities<n> velocities_of(const Numbers& numbers) {
  ode::Velocities<n> all;
  all.of.fill(n);
  for (std::size_t i = 0; i < n; ++i)
    if (const int rate = numbers.rate_of[i]; rate >= 0) {
      all.of[i] = static_cast<std::size_t>(rate);
      all.is[all.of[i]] = all.known = true;
    }
  return all;
}

/// `Base` is an AnySystem, with any further interface of a model.
template <std::size_t n, class Base>
class SystemOf : public Base {
 public:
  using typename Base::Half, typename Base::Next, typename Base::State;

  explicit SystemOf(std::shared_ptr<const Numbers> numbers) : numbers_(std::move(numbers)) {
    std::copy(numbers_->start.begin(), numbers_->start.end(), start_.begin());
  }

  void operator()(const State& x, State& dxdt, double t) const override {
    numbers_->rates.run(x.data(), t, dxdt.data());
  }
  void acceleration(const Half& q, Half& a) const override {
    if constexpr (n % 2 == 0) numbers_->accelerations.run(q.data(), 0.0, a.data());
  }
  ode::Velocities<n> velocities() const override { return velocities_of<n>(*numbers_); }
  bool differentiable() const override { return true; }
  long jacobian(const State& x, double* matrix, double* dfdt, double t) const override {
    const auto generic = [this](const std::array<Dual<double>, n>& y, std::array<Dual<double>, n>& dydt,
                                const Dual<double>& time) {
      numbers_->rates.run(y.data(), time, dydt.data());
    };
    return ode::jacobian(generic, x, matrix, dfdt, t);
  }
  std::size_t guard_count() const override { return numbers_->events.size(); }
  void guards(const State& x, double t, double* values) const override {
    numbers_->guards.run(x.data(), t, values);
  }
  Next happen(std::size_t i, State& x, double t) const override {
    std::vector<double> all(numbers_->afterwards.outputs().size());
    numbers_->afterwards.run(x.data(), t, all.data());
    std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(i * n), n, x.begin());
    const Follows& follows = numbers_->events[i];
    return follows.ends ? Next::end : follows.passes ? Next::pass : Next::go_on;
  }

 protected:
  const Numbers& numbers() const { return *numbers_; }
  const State& start_of_numbers() const { return start_; }

  /// Adds the observables to `seen`.
  void add_observed(const State& x, double t, std::vector<double>& seen) const {
    const std::size_t before = seen.size();
    seen.resize(before + numbers_->observed.outputs().size());
    numbers_->observed.run(x.data(), t, seen.data() + before);
  }
  std::vector<Conserved<double>> all_conserved(const State& x, double t) const {
    if (numbers_->conserved.outputs().empty()) return {};
    std::array<double, 2> both{};
    numbers_->conserved.run(x.data(), t, both.data());
    return {{both[0], both[1]}};
  }
  std::vector<double> all_constraints(const State& x, double t) const {
    std::vector<double> with_rates(numbers_->off.outputs().size());
    numbers_->off.run(x.data(), t, with_rates.data());
    with_rates.resize(with_rates.size() / 2);
    return with_rates;
  }
  double most_off(const State& x, double t) const {
    double most = 0;
    for (const double off : all_constraints(x, t))
      if (!(std::abs(off) <= most)) most = std::abs(off);
    return most;
  }

 private:
  std::shared_ptr<const Numbers> numbers_;
  State start_{};
};

/// The system in float.
template <std::size_t n>
class SystemInFloat final : public ode::AnySystem<n, float> {
 public:
  using typename ode::AnySystem<n, float>::State, typename ode::AnySystem<n, float>::Half;

  explicit SystemInFloat(std::shared_ptr<const Numbers> numbers) : numbers_(std::move(numbers)) {}
  void operator()(const State& x, State& dxdt, float t) const override {
    numbers_->rates.run(x.data(), t, dxdt.data());
  }
  void acceleration(const Half& q, Half& a) const override {
    if constexpr (n % 2 == 0) numbers_->accelerations.run(q.data(), 0.0f, a.data());
  }
  ode::Velocities<n> velocities() const override { return velocities_of<n>(*numbers_); }
  bool differentiable() const override { return false; }
  long jacobian(const State&, double*, double*, double) const override {
    throw std::logic_error("a system in float has no Jacobian");
  }

 private:
  std::shared_ptr<const Numbers> numbers_;
};

}  // namespace oddity::problem
