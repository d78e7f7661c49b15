#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "chapters/contents.hpp"
#include "formula/recorded.hpp"

/// Models of the scenes' listings, run once with numbers that record their operations.
namespace oddity {

/// Parameters as letters of these names, or as known numbers; the time of a closed form.
struct ToRecord {
  std::vector<std::string> names;
  std::vector<double> values;
  double t = 0;
  bool with_letters = true;
};

struct RecordedModel {
  std::shared_ptr<formula::Record> record = std::make_shared<formula::Record>();
  std::vector<formula::Recorded> start = {}, rates = {};  ///< none: a closed form
  std::vector<formula::Recorded> acceleration = {};       ///< for (q, v) at q, if the model has one
  std::vector<formula::Recorded> observed = {};
  /// The orientation's quaternion of a model that has the angular velocity: at the start, its rates, and as
  /// observed. It would be the state's last four unknowns.
  std::vector<formula::Recorded> orientation_at_start = {}, turning = {}, orientation = {};
  /// Functions of the state x and its rates r, if the steps test whether the model comes to rest.
  std::vector<formula::Recorded> speed = {}, braking = {}, coasted = {};
  std::vector<int> velocity_of = {};  ///< the unknown that is the rate of each; -1: none is
  std::vector<bool> is_velocity = {};
  bool branched_at_start = false;  ///< a branch depended on the parameters alone
  bool branched = false;           ///< a branch depended on the state or the time
};

/// Name of an unknown: x[i] in the state, q[i] for the coordinates of an acceleration.
std::string state_letter(char name, std::size_t i);

namespace detail {

template <std::size_t n, class Values>
std::array<formula::Recorded, n> letters(formula::Record& record, char name, const Values& values,
                                         std::size_t first = 0) {
  std::array<formula::Recorded, n> all;
  for (std::size_t i = 0; i < n; ++i)
    all[i] = formula::Recorded::letter(record, state_letter(name, first + i), values[i].value());
  return all;
}

template <class Numbers>
std::vector<formula::Recorded> listed(const Numbers& numbers) {
  return {numbers.begin(), numbers.end()};
}

std::vector<formula::Recorded> given(formula::Record&, const ToRecord&);
/// Finds velocities by the names of the rates, or as declared.
void find_velocities(RecordedModel&, std::span<const std::size_t> declared, bool are_declared);

void record_turning(RecordedModel&, const std::array<formula::Recorded, 4>& now,
                    const std::array<formula::Recorded, 3>& angular_velocity,
                    const std::array<formula::Recorded, 4>& start);

template <class Model>
void record_motion(RecordedModel& made, const Model& model, const formula::Recorded& t) {
  constexpr std::size_t n = std::tuple_size_v<typename Model::State>;
  const auto start = model.start();
  made.branched_at_start = made.record->has_branched;
  made.record->has_branched = false;
  const auto x = letters<n>(*made.record, 'x', start);
  auto rates = x;
  model(x, rates, t);
  if constexpr (
      std::array<formula::Recorded, n / 2> q{}, dv{}; requires { model.acceleration(q, dv); }) {
    q = letters<n / 2>(*made.record, 'q', start);
    model.acceleration(q, dv);
    made.acceleration = listed(dv);
  }
  if constexpr (requires { model.turning(x, t); })
    record_turning(made, letters<4>(*made.record, 'x', model.p.orientation(), n), model.turning(x, t),
                   model.p.orientation());
  if constexpr (requires { model.coasted(x, rates); }) {
    const auto r = letters<n>(*made.record, 'r', rates);
    made.speed = {model.speed(x)}, made.braking = {model.braking(x, r)};
    made.coasted = listed(model.coasted(x, r));
  }
  made.start = listed(start), made.rates = listed(rates), made.observed = listed(model.observe(x, t));
  if constexpr (requires { Model::velocities.size(); })
    find_velocities(made, Model::velocities, true);
  else
    find_velocities(made, {}, false);
}

}  // namespace detail

/// make(values) constructs the model.
template <class Make>
RecordedModel recorded(const Make& make, const ToRecord& asked) {
  RecordedModel made;
  const std::vector<formula::Recorded> values = detail::given(*made.record, asked);
  const auto model = make(std::span<const formula::Recorded>(values));
  const auto t = formula::Recorded::letter(*made.record, "t", asked.t);
  if constexpr (requires { model.start(); }) {
    detail::record_motion(made, model, t);
  } else {
    made.branched_at_start = made.record->has_branched;
    made.record->has_branched = false;
    made.observed = detail::listed(model.at(t));
  }
  made.branched = made.record->has_branched;
  return made;
}

/// A scene's model of its listing.
struct Recorder {
  Number scene;
  std::string_view model;
  RecordedModel (*record)(const ToRecord&);
};
/// Generated from the listings (report/recorded/).
std::span<const Recorder> recorders();

}  // namespace oddity
