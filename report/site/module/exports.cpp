// Functions that the page calls (assets/engine.js). It writes its numbers at the address of `input`, and
// reads the answer at the returned addresses before the next call.

#include <algorithm>

#include "report/site/module/json.hpp"
#include "report/site/module/scene.hpp"
#include "solvers/ode/all.hpp"

namespace oddity::module {

namespace {

std::vector<double> input;
Motion motion;
std::vector<double> drawn;

/// The last model made for each of a scene's: a page changes the method more often than the parameters.
struct Made {
  std::vector<double> parameters;
  std::unique_ptr<const Model> model;
};
std::vector<std::vector<Made>> kept;

const Model& made(std::size_t scene, std::size_t index, std::span<const double> parameters) {
  kept.resize(scenes().size());
  kept[scene].resize(scenes()[scene].models.size());
  Made& last = kept[scene][index];
  if (!last.model || !std::equal(parameters.begin(), parameters.end(), last.parameters.begin()))
    last = {{parameters.begin(), parameters.end()}, scenes()[scene].models[index].with(parameters)};
  return *last.model;
}

std::vector<double> defaults(const Scene& scene) {
  std::vector<double> values;
  for (const Letter& letter : scene.letters) values.push_back(letter.value);
  return values;
}

// ---- the description --------------------------------------------------------------------------------------

std::string_view name_of(ode::Kind kind) {
  switch (kind) {
    case ode::Kind::fixed:
      return "fixed";
    case ode::Kind::partitioned:
      return "partitioned";
    case ode::Kind::velocities_first:
      return "velocities first";
    case ode::Kind::controlled:
      return "controlled";
    case ode::Kind::implicit_fixed:
      return "implicit fixed";
    case ode::Kind::implicit_controlled:
      return "implicit controlled";
    case ode::Kind::self_stepping:
      return "driven";
  }
  return "";
}

template <class Algorithm>
int order_of() {
  if constexpr (requires { Algorithm::order; })
    return Algorithm::order;
  else
    return 0;
}

struct Algorithm {
  std::string_view name;
  ode::Kind kind;
  int order;
  bool in_float;
};

std::vector<Algorithm> algorithms() {
  std::vector<Algorithm> all;
  ode::for_each_algorithm([&]<class A>() {
    all.push_back({A::name, A::kind, order_of<A>(), A::facts.in_float});
  });
  return all;
}

std::string text_of(const Algorithm& a) {
  return "{\"name\":" + quoted(a.name) + ",\"kind\":" + quoted(name_of(a.kind)) +
         ",\"order\":" + std::to_string(a.order) +
         ",\"resolution\":" + quoted(ode::has_tolerance(a.kind) ? "tolerance" : "step") +
         ",\"inFloat\":" + flag(a.in_float) + "}";
}

std::string text_of(const Listed& listed, const Model& model) {
  return "{\"name\":" + quoted(listed.name) + ",\"algorithm\":" + quoted(listed.algorithm) +
         ",\"closedForm\":" + flag(model.closed_form()) + ",\"partitioned\":" + flag(model.partitioned()) +
         ",\"velocities\":" + flag(model.has_velocities()) + ",\"constrained\":" + flag(model.constrained()) +
         ",\"events\":" + flag(model.has_events()) + "}";
}

std::string text_of(std::size_t index) {
  const Scene& scene = scenes()[index];
  const auto parameters = defaults(scene);
  std::string models;
  for (std::size_t i = 0; i < scene.models.size(); ++i)
    models += (i ? "," : "") + text_of(scene.models[i], made(index, i, parameters));
  return "{\"number\":" + quoted(scene.number) + ",\"observables\":" + std::to_string(scene.observables) +
         ",\"drawn\":" + flag(scene.draw != nullptr) +
         ",\"parameters\":" + listed(scene.letters, [](const Letter& l) { return quoted(l.name); }) +
         ",\"models\":[" + models + "]}";
}

}  // namespace

void forget_models() { kept.clear(); }

ODDITY_EXPORT(describe) const char* describe() {
  static std::string text;
  std::string all;
  for (std::size_t i = 0; i < scenes().size(); ++i) all += (i ? "," : "") + text_of(i);
  text = "{\"algorithms\":" + listed(algorithms(), [](const Algorithm& a) { return text_of(a); }) +
         ",\"kinds\":" + listed(Drawing::kind_names, [](std::string_view name) { return quoted(name); }) +
         ",\"scenes\":[" + all + "]}";
  return text.c_str();
}

/// Makes room for `count` numbers, which the functions below read.
ODDITY_EXPORT(input) double* input_of(std::size_t count) {
  input.resize(count);
  return input.data();
}

/// The scene's default parameters.
ODDITY_EXPORT(defaults) const double* defaults_of(std::size_t scene) {
  input = defaults(scenes()[scene]);
  return input.data();
}

/// The input is the parameters and then the times. Returns the number of states computed.
ODDITY_EXPORT(run)
std::size_t run(std::size_t scene, std::size_t model, const char* algorithm, bool in_float, double setting) {
  const std::span<const double> numbers(input);
  const std::size_t count = scenes()[scene].letters.size();
  motion = made(scene, model, numbers.first(count))
               .run(algorithm, in_float ? Precision::in_float : Precision::in_double, setting,
                    numbers.subspan(count));
  return motion.states;
}
ODDITY_EXPORT(whole) std::size_t whole() { return motion.whole; }
ODDITY_EXPORT(observed) const double* observed() { return motion.observed.data(); }
ODDITY_EXPORT(drift) const double* drift() { return motion.drift.empty() ? nullptr : motion.drift.data(); }
ODDITY_EXPORT(off) const double* off() { return motion.off.empty() ? nullptr : motion.off.data(); }
ODDITY_EXPORT(evaluations) double evaluations() { return static_cast<double>(motion.evaluations); }
ODDITY_EXPORT(ending) int ending() { return static_cast<int>(motion.ending); }
ODDITY_EXPORT(message) const char* message() { return motion.message.c_str(); }

/// The input is the parameters, the time and the observables. Returns these numbers: whether the drawing is
/// in space, and the number of primitives. Then follow for each its kind, size, whether it leaves a trail,
/// the address and length of its letter, the number of points, and the points. Null if the scene defines no
/// drawing.
ODDITY_EXPORT(draw) const double* draw(std::size_t index) {
  const Scene& scene = scenes()[index];
  if (!scene.draw) return nullptr;
  const std::span<const double> numbers(input);
  const std::size_t count = scene.letters.size();
  Drawing drawing;
  scene.draw({scene.letters, numbers.first(count)}, numbers[count], numbers.subspan(count + 1), drawing);
  drawn = {static_cast<double>(drawing.is_in_space()), static_cast<double>(drawing.primitives().size())};
  for (const Drawing::Primitive& p : drawing.primitives()) {
    drawn.insert(drawn.end(), {static_cast<double>(p.kind), p.size, static_cast<double>(p.leaves_trail),
                               static_cast<double>(reinterpret_cast<std::size_t>(p.letter.data())),
                               static_cast<double>(p.letter.size()), static_cast<double>(p.points.size())});
    for (const Place& at : p.points) drawn.insert(drawn.end(), {at.x, at.y, at.z});
  }
  return drawn.data();
}

}  // namespace oddity::module
