#include "problem/interpreted.hpp"

#include <array>
#include <cmath>

#include "solvers/ode/unknowns.hpp"

namespace oddity::problem {

namespace {

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

/// A file's model behind the seam of the algorithms.
template <std::size_t n>
class Interpreted final : public ModelInterfaceOf<n> {
 public:
  using typename ode::AnySystem<n>::State, typename ode::AnySystem<n>::Half;

  explicit Interpreted(std::shared_ptr<const Numbers> numbers) : numbers_(std::move(numbers)) {
    std::copy(numbers_->start.begin(), numbers_->start.end(), start_.begin());
    is_analytic_ = !numbers_->rates.has(Op::logarithm) && !numbers_->rates.has(Op::arc) &&
                   !numbers_->rates.has(Op::choice);
  }

  // ---- as the algorithms see it --------------------------------------------------------------------------

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
  bool analytic() const override { return is_analytic_; }
  taylor::Recording recording() const override {
    return taylor::record<n>([this](const auto& x, auto& dxdt, const taylor::Recorded& t) {
      numbers_->rates.run(x.data(), t, dxdt.data());
    });
  }

  std::size_t guard_count() const override { return numbers_->events.size(); }
  void guards(const State& x, double t, double* values) const override {
    numbers_->guards.run(x.data(), t, values);
  }
  using typename ode::AnySystem<n>::Next;
  Next happen(std::size_t i, State& x, double t) const override {
    std::vector<double> all(numbers_->afterwards.outputs().size());
    numbers_->afterwards.run(x.data(), t, all.data());
    std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(i * n), n, x.begin());
    const Follows& follows = numbers_->events[i];
    return follows.ends ? Next::end : follows.passes ? Next::pass : Next::go_on;
  }

  // ---- as the scene sees it ------------------------------------------------------------------------------

  bool partitioned() const override { return numbers_->partitioned; }
  bool constrained() const override { return !numbers_->off.outputs().empty(); }
  State start() const override { return start_; }
  void observe(const State& x, double t, std::vector<double>& seen) const override {
    const std::size_t before = seen.size();
    seen.resize(before + numbers_->observed.outputs().size());
    numbers_->observed.run(x.data(), t, seen.data() + before);
  }
  std::vector<double> place(const State& x, double t) const override {
    std::vector<double> places;
    observe(x, t, places);
    return places;
  }
  std::vector<Conserved<double>> conserved(const State& x, double t) const override {
    if (numbers_->conserved.outputs().empty()) return {};
    std::array<double, 2> both{};
    numbers_->conserved.run(x.data(), t, both.data());
    return {{both[0], both[1]}};
  }
  double off_constraint_at(const State& x, double t) const override {
    std::vector<double> off(numbers_->off.outputs().size());
    numbers_->off.run(x.data(), t, off.data());
    double most = 0;
    for (std::size_t i = 0; 2 * i < off.size(); ++i)
      if (!(std::abs(off[i]) <= most)) most = std::abs(off[i]);
    return most;
  }

 private:
  std::shared_ptr<const Numbers> numbers_;
  State start_{};
  bool is_analytic_ = true;
};

/// The same in float.
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

template <std::size_t n>
class InterpretedInFloat final : public detail::IntegratedInFloat<n> {
 public:
  InterpretedInFloat(const Horizon& horizon, std::shared_ptr<const Numbers> exact,
                     const std::shared_ptr<const Numbers>& rounded)
      : detail::IntegratedInFloat<n>(horizon, std::make_shared<const Interpreted<n>>(std::move(exact)),
                                     std::make_shared<const Interpreted<n>>(rounded)),
        system_(rounded) {
    for (std::size_t i = 0; i < n; ++i) start_[i] = static_cast<float>(rounded->start[i]);
  }

 private:
  const ode::AnySystem<n, float>& system() const override { return system_; }
  std::array<float, n> start() const override { return start_; }

  SystemInFloat<n> system_;
  std::array<float, n> start_{};
};

}  // namespace

std::shared_ptr<const ModelInFloat> interpreted_in_float(const Horizon& horizon,
                                                         std::shared_ptr<const Numbers> exact,
                                                         const std::shared_ptr<const Numbers>& rounded) {
#define ODDITY_INTERPRETED(n, unused) \
  if (exact->unknowns == (n)) return std::make_shared<const InterpretedInFloat<n>>(horizon, exact, rounded);
  ODDITY_FOR_UNKNOWNS(ODDITY_INTERPRETED, )
#undef ODDITY_INTERPRETED
  throw std::logic_error("no algorithms for so many unknowns");
}

AnyModel interpreted(std::shared_ptr<const Numbers> numbers) {
#define ODDITY_INTERPRETED(n, unused) \
  if (numbers->unknowns == (n)) return {std::make_shared<const Interpreted<n>>(numbers)};
  ODDITY_FOR_UNKNOWNS(ODDITY_INTERPRETED, )
#undef ODDITY_INTERPRETED
  throw std::logic_error("no algorithms for so many unknowns");
}

}  // namespace oddity::problem
