#include "problem/interpreted.hpp"

#include <array>

#include "problem/system.hpp"
#include "solvers/ode/unknowns.hpp"

namespace oddity::problem {

namespace {

/// A file's model for the scene.
template <std::size_t n>
class Interpreted final : public SystemOf<n, ModelInterfaceOf<n>> {
  using Base = SystemOf<n, ModelInterfaceOf<n>>;

 public:
  using typename Base::State;

  explicit Interpreted(std::shared_ptr<const Numbers> numbers) : Base(std::move(numbers)) {
    const Program& rates = this->numbers().rates;
    is_analytic_ = !rates.has(Op::logarithm) && !rates.has(Op::arc) && !rates.has(Op::choice);
  }

  bool analytic() const override { return is_analytic_; }
  taylor::Recording recording() const override {
    return taylor::record<n>([this](const auto& x, auto& dxdt, const taylor::Recorded& t) {
      this->numbers().rates.run(x.data(), t, dxdt.data());
    });
  }

  bool partitioned() const override { return this->numbers().partitioned; }
  bool constrained() const override { return !this->numbers().off.outputs().empty(); }
  State start() const override { return this->start_of_numbers(); }
  void observe(const State& x, double t, std::vector<double>& seen) const override {
    this->add_observed(x, t, seen);
  }
  std::vector<double> place(const State& x, double t) const override {
    std::vector<double> places;
    observe(x, t, places);
    return places;
  }
  std::vector<Conserved<double>> conserved(const State& x, double t) const override {
    return this->all_conserved(x, t);
  }
  std::vector<double> constraints_at(const State& x, double t) const override {
    return this->all_constraints(x, t);
  }
  double off_constraint_at(const State& x, double t) const override { return this->most_off(x, t); }

 private:
  bool is_analytic_ = true;
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
