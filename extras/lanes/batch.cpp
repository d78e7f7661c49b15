#include "extras/lanes/batch.hpp"

#include <algorithm>
#include <cstring>

#include "solvers/stop.hpp"

namespace oddity::lanes {

Batch::Batch(const SceneInLanes& scene, std::size_t model, Precision precision,
             std::vector<double> parameters)
    : scene_(scene),
      precision_(precision),
      of_all_(model + (precision == Precision::in_float ? scene.models : 0)),
      beginning_(scene.beginnings[of_all_]),
      parameters_(std::move(parameters)),
      bodies_(parameters_.size() / scene.parameters),
      models_(bodies_ * beginning_.model_bytes),
      states_(bodies_ * beginning_.state_bytes) {
  begin_again();
}

void Batch::begin_again(double part) {
  if (closed_form()) return;
  grouped_.reset();
  behind_ = false;
  for (std::size_t i = 0; i < bodies_; ++i)
    beginning_.begin(&parameters_[i * scene_.parameters], &models_[i * beginning_.model_bytes],
                     &states_[i * beginning_.state_bytes]);
  if (part == 1) return;
  if (precision_ == Precision::in_double)
    scale_states(part);
  else
    scale_states(static_cast<float>(part));
}

template <class T>
void Batch::scale_states(T factor) {
  for (std::size_t at = 0; at < states_.size(); at += sizeof(T)) {
    T x;
    std::memcpy(&x, &states_[at], sizeof x);
    x *= factor;
    std::memcpy(&states_[at], &x, sizeof x);
  }
}

const Compiled& Batch::compiled(Registers registers) const {
  return scene_.compiled[static_cast<int>(registers)][of_all_];
}

bool Batch::has(Fixed algorithm) const { return compiled(Registers::one).fixed[static_cast<int>(algorithm)]; }

void Batch::steps(Registers registers, Fixed algorithm, double t0, double h, long steps) {
  group(registers, Steps::fixed);
  for_pieces([&](const Groups& piece, std::size_t) {
    compiled(registers).fixed[static_cast<int>(algorithm)](piece, t0, h, steps);
  });
  behind_ = true;
}

bool Batch::own_steps(Registers registers, double t0, double t1, double tolerance, double first_step,
                      std::vector<Ended>* each) {
  group(registers, Steps::own);
  const std::size_t bodies = grouping(*grouped_).bodies;
  if (each) each->resize(groups().count * bodies);
  bool reached = true;
  for_pieces([&](const Groups& piece, std::size_t first) {
    Ended* ended = each ? each->data() + first * bodies : nullptr;
    if (!compiled(registers).own_steps(piece, t0, t1, tolerance, first_step, ended)) reached = false;
  });
  if (each) each->resize(bodies_);
  behind_ = true;
  return reached;
}

void Batch::group(Registers registers, Steps steps) {
  const Grouped wanted{registers, steps};
  if (grouped_ == wanted) return;
  catch_up();
  grouped_ = wanted;
  const Grouping& how = grouping(wanted);
  const auto lines = [&](std::size_t bytes) {
    return std::vector<Line>((groups().count * bytes + alignment - 1) / alignment);
  };
  group_models_ = lines(how.model_bytes);
  group_states_ = lines(how.state_bytes);
  const Groups all = groups();
  how.in(bodies(), reinterpret_cast<std::byte*>(group_models_.data()), all.states);
}

const Grouping& Batch::grouping(const Grouped& grouped) const {
  const Compiled& all = compiled(grouped.registers);
  return grouped.steps == Steps::fixed ? all.for_fixed_steps : all.for_own_steps;
}

Groups Batch::groups() {
  const std::size_t each = grouping(*grouped_).bodies;
  return {reinterpret_cast<const std::byte*>(group_models_.data()),
          reinterpret_cast<std::byte*>(group_states_.data()), (bodies_ + each - 1) / each};
}

template <class Work>
void Batch::for_pieces(const Work& work) {
  constexpr std::size_t most = 64;
  const Groups all = groups();
  const Grouping& how = grouping(*grouped_);
  for (std::size_t first = 0; first < all.count; first += most) {
    check_stop();
    work({all.models + first * how.model_bytes, all.states + first * how.state_bytes,
          std::min(most, all.count - first)},
         first);
  }
}

void Batch::catch_up() const {
  if (!behind_) return;
  grouping(*grouped_).out(reinterpret_cast<const std::byte*>(group_states_.data()), bodies());
  behind_ = false;
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
