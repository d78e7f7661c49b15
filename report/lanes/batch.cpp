#include "report/lanes/batch.hpp"

namespace oddity::lanes {

Batch::Batch(const SceneInLanes& scene, std::size_t model, Precision precision,
             std::vector<double> parameters)
    : scene_(scene),
      of_all_(model + (precision == Precision::in_float ? scene.models : 0)),
      beginning_(scene.beginnings[of_all_]),
      parameters_(std::move(parameters)),
      bodies_(parameters_.size() / scene.parameters),
      models_(bodies_ * beginning_.model_bytes),
      states_(bodies_ * beginning_.state_bytes) {
  begin_again();
}

void Batch::begin_again() {
  if (closed_form()) return;
  grouped_.reset();
  behind_ = false;
  for (std::size_t i = 0; i < bodies_; ++i)
    beginning_.begin(&parameters_[i * scene_.parameters], &models_[i * beginning_.model_bytes],
                     &states_[i * beginning_.state_bytes]);
}

const Compiled& Batch::compiled(Registers registers) const {
  return scene_.compiled[static_cast<int>(registers)][of_all_];
}

bool Batch::has(Fixed algorithm) const { return compiled(Registers::one).fixed[static_cast<int>(algorithm)]; }

void Batch::steps(Registers registers, Fixed algorithm, double t0, double h, long steps) {
  group(registers);
  compiled(registers).fixed[static_cast<int>(algorithm)](
      {reinterpret_cast<const std::byte*>(group_models_.data()),
       reinterpret_cast<std::byte*>(group_states_.data()), groups(registers)},
      t0, h, steps);
  behind_ = true;
}

void Batch::group(Registers registers) {
  if (grouped_ == registers) return;
  catch_up();
  const Grouping& grouping = compiled(registers).grouping;
  const auto lines = [&](std::size_t bytes) {
    return std::vector<Line>((groups(registers) * bytes + alignment - 1) / alignment);
  };
  group_models_ = lines(grouping.model_bytes);
  group_states_ = lines(grouping.state_bytes);
  grouping.in(bodies(), reinterpret_cast<std::byte*>(group_models_.data()),
              reinterpret_cast<std::byte*>(group_states_.data()));
  grouped_ = registers;
}

std::size_t Batch::groups(Registers registers) const {
  const std::size_t each = compiled(registers).grouping.bodies;
  return (bodies_ + each - 1) / each;
}

void Batch::catch_up() const {
  if (!behind_) return;
  compiled(*grouped_).grouping.out(reinterpret_cast<const std::byte*>(group_states_.data()), bodies());
  behind_ = false;
}

std::vector<Ended> Batch::own_steps(Registers registers, double t0, double t1, double tolerance,
                                    double first_step) {
  catch_up();
  grouped_.reset();
  std::vector<Ended> ended(bodies_);
  compiled(registers).own_steps(bodies(), t0, t1, tolerance, first_step, ended.data());
  return ended;
}

std::vector<double> Batch::observed(Registers registers, double t) const {
  std::vector<double> seen(bodies_ * observables());
  if (closed_form()) {
    compiled(registers).at(parameters_.data(), bodies_, t, seen.data());
    return seen;
  }
  catch_up();
  for (std::size_t i = 0; i < bodies_; ++i)
    beginning_.observe(&models_[i * beginning_.model_bytes], &states_[i * beginning_.state_bytes], t,
                       &seen[i * observables()]);
  return seen;
}

std::span<const std::byte> Batch::state(std::size_t body) const {
  catch_up();
  return std::span(states_).subspan(body * beginning_.state_bytes, beginning_.state_bytes);
}

std::vector<double> apart(const SceneInLanes& scene, std::span<const Parameter> parameters,
                          std::size_t bodies, double apart) {
  std::vector<double> all;
  for (std::size_t body = 0; body < bodies; ++body)
    for (std::size_t k = 0; k < scene.parameters; ++k)
      all.push_back(parameters[k].value * (1 + apart * static_cast<double>(body)));
  return all;
}

}  // namespace oddity::lanes
