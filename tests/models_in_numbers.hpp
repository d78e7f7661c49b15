#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/mpfi.hpp>
#include <cmath>
#include <cstddef>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "chapters/contents.hpp"
#include "extras/lanes/lanes.hpp"
#include "report/verify/catch.hpp"
#include "solvers/dual.hpp"
#include "solvers/ode/jacobian.hpp"
#include "solvers/taylor/series.hpp"

/// Every model of a scene in every number type, each compared with the same model in double.
namespace oddity::models_test {

/// Interval that encloses the exact result of a computation.
using Interval = boost::multiprecision::number<boost::multiprecision::mpfi_float_backend<18>,
                                               boost::multiprecision::et_off>;

/// A scene's parameters: the first ones of the exercise.
template <template <class> class Given, class T, class Number>
Given<T> given(const std::vector<Number>& values) {
  constexpr std::size_t n = sizeof(Given<double>) / sizeof(double);
  REQUIRE(values.size() >= n);
  return [&]<std::size_t... i>(std::index_sequence<i...>) { return Given<T>{T(values[i])...}; }
  (std::make_index_sequence<n>());
}

template <class Model>
concept Integrable = requires {
  typename Model::State;
};

template <std::size_t n, class T>
std::array<T, n> moved(std::array<T, n> x, const T& h, const std::array<T, n>& dx) {
  for (std::size_t i = 0; i < n; ++i) x[i] += h * dx[i];
  return x;
}

template <class T, std::size_t... n>
auto joined(const std::array<T, n>&... parts) {
  std::array<T, (n + ...)> all{};
  auto next = all.begin();
  ((next = std::ranges::copy(parts, next).out), ...);
  return all;
}

/// The model's observables at the end: of a closed form at once, otherwise by Runge-Kutta 4. For a model with
/// events also its guards there, and the state after the first event.
template <class T, class Model>
auto at_end(const Model& model, double end, int steps = 8) {
  if constexpr (Integrable<Model>) {
    auto x = model.start();
    auto a = x, b = x, c = x, d = x;
    const T h = T(end) / T(steps);
    for (int i = 0; i < steps; ++i) {
      const T t = T(i) * h, half = h / T(2);
      model(x, a, t);
      model(moved(x, half, a), b, T(t + half));
      model(moved(x, half, b), c, T(t + half));
      model(moved(x, h, c), d, T(t + h));
      for (std::size_t k = 0; k < x.size(); ++k) x[k] += h / T(6) * (a[k] + T(2) * (b[k] + c[k]) + d[k]);
    }
    if constexpr (requires { model.guards(x, T(end)); })
      return joined(model.observe(x, T(end)), model.guards(x, T(end)), model.at_event(0, x, T(end)).after);
    else
      return model.observe(x, T(end));
  } else {
    return model.at(T(end));
  }
}

template <class Numbers>
double largest(const Numbers& x) {
  double most = 0;
  for (double one : x) most = std::max(most, std::abs(one));
  return most;
}

template <template <class> class Given>
class Scene {
 public:
  explicit Scene(std::string_view number) {
    const auto entry = std::ranges::find(registry(), exercise_number(number), &Entry::number);
    REQUIRE(entry != registry().end());
    end_ = entry->exercise.scene->horizon / 200;
    for (const Parameter& p : entry->exercise.parameters) values_.push_back(p.value);
  }

  void in_every_number() const {
    constexpr std::size_t count = std::tuple_size_v<decltype(models(std::declval<Given<double>>()))>;
    [&]<std::size_t... i>(std::index_sequence<i...>) { (model<i>(), ...); }
    (std::make_index_sequence<count>());
  }

 private:
  template <class T>
  auto all(const std::vector<T>& values) const {
    return models(given<Given, T>(values));
  }
  template <std::size_t i, class T>
  auto seen(const std::vector<T>& values) const {
    return at_end<T>(std::get<i>(all(values)), end_);
  }
  /// The parameters, all changed by this share.
  std::vector<double> changed(double share) const {
    std::vector<double> values = values_;
    for (double& x : values) x += share * x;
    return values;
  }

  template <std::size_t i>
  void model() const {
    INFO("the scene's model " << i);
    const auto expected = seen<i>(values_);
    const double scale = largest(expected);
    REQUIRE(std::isfinite(scale));
    in_float<i>(expected, scale);
    in_duals<i>(expected, scale);
    in_lanes<i>();
    in_intervals<i>(expected, scale);
    if constexpr (Integrable<std::tuple_element_t<i, decltype(all(values_))>>) on_tape<i>(scale);
  }

  template <std::size_t i, class Expected>
  void in_float(const Expected& expected, double scale) const {
    const auto got = seen<i>(std::vector<float>(values_.begin(), values_.end()));
    for (std::size_t k = 0; k < got.size(); ++k)
      CHECK(std::abs(static_cast<double>(got[k]) - expected[k]) <= 1e-4 * scale);
  }

  template <std::size_t i, class Expected>
  void in_duals(const Expected& expected, double scale) const {
    using Model = std::tuple_element_t<i, decltype(all(values_))>;
    using First = Dual<double>;
    using Second = Dual<First>;
    std::vector<First> first;
    std::vector<Second> second;
    for (double x : values_) {
      first.emplace_back(x, x);
      second.emplace_back(First(x, x), First(x, 0.0));
    }
    const double share = 0x1p-16;
    const auto up = seen<i>(changed(share)), down = seen<i>(changed(-share));
    const auto one = seen<i>(first);
    const auto two = seen<i>(second);
    for (std::size_t k = 0; k < one.size(); ++k) {
      CHECK(std::abs(one[k].value - expected[k]) <= 1e-12 * scale);
      CHECK(std::abs(two[k].value.slope - one[k].slope) <= 1e-12 * (scale + std::abs(one[k].slope)));
      const double slope = (up[k] - down[k]) / (2 * share);
      const double bend = (up[k] - 2 * expected[k] + down[k]) / (share * share);
      CHECK(std::abs(one[k].slope - slope) <= 1e-6 * (scale + std::abs(slope)));
      // At a kink there may be no second derivative, and a scene may start at one.
      if constexpr (!requires { Model::not_analytic; })
        CHECK(std::abs(two[k].slope.slope - bend) <= 1e-4 * (scale + std::abs(bend)));
    }
  }

  template <std::size_t i>
  void in_lanes() const {
    std::vector<Lanes<double>> lanes;
    for (double x : values_) {
      Lanes<double> apart;
      for (std::size_t lane = 0; lane < apart.size(); ++lane)
        apart.set(lane, x + 1e-3 * static_cast<double>(lane) * x);
      lanes.push_back(apart);
    }
    const auto got = seen<i>(lanes);
    for (std::size_t lane = 0; lane < Lanes<double>::size(); ++lane) {
      const auto alone = seen<i>(changed(1e-3 * static_cast<double>(lane)));
      for (std::size_t k = 0; k < got.size(); ++k)
        CHECK(std::abs(got[k][lane] - alone[k]) <= 1e-12 * largest(alone));
    }
  }

  template <std::size_t i, class Expected>
  void in_intervals(const Expected& expected, double scale) const {
    std::vector<Interval> values(values_.begin(), values_.end());
    const auto got = seen<i>(values);
    for (std::size_t k = 0; k < got.size(); ++k) {
      CHECK(width(got[k]) <= 1e-9 * scale);
      CHECK(lower(got[k]) - 1e-12 * scale <= expected[k]);
      CHECK(upper(got[k]) + 1e-12 * scale >= expected[k]);
    }
  }

  /// Compares Taylor series with many small steps.
  template <std::size_t i>
  void on_tape(double scale) const {
    const auto model = std::get<i>(all(values_));
    using Model = decltype(model);
    auto x = model.start();
    constexpr std::size_t n = std::tuple_size_v<decltype(x)>;
    static_assert(ode::Differentiable<std::remove_cv_t<Model>, std::array<double, n>>);
    if constexpr (requires { Model::not_analytic; }) {
      return;
    } else {
      constexpr int steps = 8, order = 16;
      taylor::Series series{taylor::Program(taylor::record<n>(model))};
      const double h = end_ / steps;
      for (int step = 0; step < steps; ++step) {
        series.expand(x.data(), step * h, order);
        series.at(h, x.data());
      }
      const auto got = model.observe(x, end_);
      const auto expected = at_end<double>(model, end_, 512);
      for (std::size_t k = 0; k < got.size(); ++k) CHECK(std::abs(got[k] - expected[k]) <= 1e-9 * scale);
    }
  }

  std::vector<double> values_;
  double end_;
};

}  // namespace oddity::models_test
