#include "problem/staging.hpp"

#include <algorithm>
#include <cmath>

#include "reference/similar.hpp"

namespace oddity::problem {

namespace {

constexpr int of_time = 1'000'000, of_parameters = 2'000'000;
/// A body's letters: three places and the turn about z, each with its rate.
constexpr int letters_each = 4;

Measure in(const char* unit) { return *measure_of(unit); }

}  // namespace

class Staged::Making {
 public:
  Making(Staged& made, const File& file) : made_(made), file_(file), text_(*file.staged) {
    for (const ParameterText& p : file.parameters) letters_.parameters.push_back(p.name);
  }

  void all() {
    made_.gravity_ = vector(text_.gravity, in("m/s^2"));
    for (const BodyText& one : text_.bodies) body(one);
    for (const JointText& one : text_.joints) {
      const auto [a, b] = two_of(one.a, one.b);
      made_.joints_.push_back({kind(one.kind), a, b, vector(one.at, in("m")), axis(one), end_of(one)});
    }
    for (const SpringText& one : text_.springs) {
      const auto [a, b] = two_of(one.a, one.b);
      made_.springs_.push_back({a, b, number(one.stiffness, in("N/m")), number(one.rest, in("m")),
                                vector(one.at, in("m")), vector(one.end, in("m"))});
    }
    for (const BodyText& one : text_.bodies) add_letters(one.name);
    for (const ObservableText& o : file_.observables) observe(o);
    for (const auto& [name, formula] : text_.observe)
      if (std::ranges::find(file_.observables, name.text, &ObservableText::name) == file_.observables.end())
        file_.source.fail(name.place, "no observable " + name.text);
    made_.differs_ = text_.differs;
  }

 private:
  void body(const BodyText& one) {
    const auto moment = [&](std::size_t i) {
      return number(one.inertia[one.inertia.size() == 1 ? 0 : i], in("kg m^2"));
    };
    made_.bodies_.push_back({number(one.mass, in("kg")),
                             one.turn.text.empty() ? Number{} : number(one.turn, in("rad")),
                             {moment(0), moment(1), moment(2)},
                             vector(one.place, in("m")),
                             vector(one.velocity, in("m/s")),
                             vector(one.spin, in("rad/s"))});
  }
  engines::Joint::Kind kind(const Quoted& text) const {
    using engines::Joint;
    static const std::pair<const char*, Joint::Kind> all[] = {{"hinge", Joint::hinge},
                                                              {"ball", Joint::ball},
                                                              {"cylinder", Joint::cylinder},
                                                              {"slide", Joint::slide},
                                                              {"rod", Joint::rod}};
    for (const auto& [name, kind] : all)
      if (text.text == name) return kind;
    file_.source.fail(text.place, "a joint is a hinge, ball, cylinder, slide or rod");
  }
  void add_letters(const Quoted& body) {
    for (const char* part : {"_x", "_y", "_z", "_turn"}) {
      const std::string letter = body.text + part;
      if (std::ranges::find(letters_.parameters, letter) != letters_.parameters.end())
        file_.source.fail(body.place, "the parameter " + letter +
                                          " has the name of an observable of this body; take another name");
      letters_.unknowns.push_back(letter);
    }
  }
  std::pair<int, int> two_of(const Quoted& a, const Quoted& b) const {
    const int first = place_of(a), second = place_of(b);
    if (second == engines::ground)
      file_.source.fail(b.place, "b is a body; leave a out where the other end is on the ground");
    if (first == second) file_.source.fail(b.place, "a and b are one body; name another");
    return {first, second};
  }
  int place_of(const Quoted& body) const {
    if (body.text.empty() || body.text == "ground") return engines::ground;
    std::vector<std::string> names;
    for (const BodyText& one : text_.bodies) names.push_back(one.name.text);
    const auto found = std::ranges::find(names, body.text);
    if (found == names.end())
      file_.source.fail(body.place, "no body " + body.text + did_you_mean(body.text, names));
    return static_cast<int>(found - names.begin());
  }
  void observe(const ObservableText& o) {
    const auto its =
        std::ranges::find(text_.observe, o.name, [](const auto& pair) { return pair.first.text; });
    if (its == text_.observe.end())
      file_.source.fail(text_.place, "what is " + o.name + " of the bodies? add observe = { " + o.name +
                                         " = \"" + text_.bodies[0].name.text + "_x\" } to staged");
    made_.observed_.push_back(number(its->second, o.measure).value / Expression(o.size));
  }

  Vector vector(const std::vector<Quoted>& texts, const Measure& unit) {
    Vector all;
    for (std::size_t i = 0; i < texts.size(); ++i) all[i] = number(texts[i], unit);
    return all;
  }
  Vector axis(const JointText& joint) {
    const Vector z{Number{}, Number{}, Number{1}};
    return joint.axis.empty() ? z : vector(joint.axis, in(""));
  }
  Vector end_of(const JointText& joint) {
    Vector end = vector(joint.end, in("m"));
    if (joint.end.empty()) end[0].place = joint.kind.place;
    return end;
  }
  /// A formula of parameters and of the bodies' observables.
  Number number(const Quoted& text, const Measure& unit) {
    const Formula formula(file_.source, text, letters_);
    const Measure its = formula.measure([&](const Letter& letter) { return measure(letter, formula); });
    if (!fit(its, unit))
      formula.fail({}, "this is to be in " + name_of(unit) + ", and is in " + name_of(its));
    const Expression value = formula.value([&](const Letter& letter) -> Expression {
      if (letter.is == Letter::Is::quantity) return letter.value;
      if (letter.is == Letter::Is::time) return input(*made_.graph_, of_time);
      const auto i = static_cast<int>(letter.index);
      if (letter.is == Letter::Is::unknown)
        return input(*made_.graph_, 2 * i + static_cast<int>(letter.order));
      return input(*made_.graph_, of_parameters + i) * Expression(file_.parameters[letter.index].size);
    });
    return {value, text.place};
  }
  Measure measure(const Letter& letter, const Formula& formula) const {
    if (letter.is == Letter::Is::quantity) return letter.measure;
    if (letter.is == Letter::Is::parameter) return file_.parameters[letter.index].measure;
    const bool is_seen = letter.is == Letter::Is::unknown;
    if (letters_.unknowns.empty()) formula.fail(letter.span, "a staging depends on parameters alone");
    if (letter.order > 1)
      formula.fail(letter.span, "only the places of bodies and their rates can be observed");
    if (!is_seen) return in("s");
    const bool is_turn = letter.index % letters_each == letters_each - 1;
    return in(letter.order == 0 ? (is_turn ? "rad" : "m") : (is_turn ? "rad/s" : "m/s"));
  }

  Staged& made_;
  const File& file_;
  const StagedText& text_;
  Letters letters_;
};

Staged::Staged(const File& file) : source_(&file.source) {
  Making(*this, file).all();
  std::vector<double> values;
  for (const ParameterText& p : file.parameters) values.push_back(p.value);
  with(values);
}

engines::Staging Staged::with(const std::vector<double>& parameters) const {
  Graph graph;
  std::map<int, Expression> inputs{{of_time, input(graph, of_time)}};
  for (std::size_t i = 0; i < parameters.size(); ++i)
    inputs.emplace(of_parameters + static_cast<int>(i), parameters[i]);
  std::vector<int> keys;
  for (int key = 0; key < 2 * letters_each * static_cast<int>(bodies_.size()); ++key) {
    keys.push_back(key);
    inputs.emplace(key, input(graph, key));
  }
  keys.push_back(of_time);
  const auto number = [&](const Number& x) {
    const auto value = static_cast<double>(replaced(std::span(&x.value, 1), inputs)[0].number());
    if (!std::isfinite(value)) source_->fail(x.place, "with these parameters this is no finite number");
    return value;
  };
  const auto positive = [&](const Number& x) {
    const double value = number(x);
    if (!(value > 0))
      source_->fail(x.place, "engines take bodies of a mass and of moments of inertia above zero");
    return value;
  };
  const auto vector = [&](const Vector& x) {
    return engines::Vector{number(x[0]), number(x[1]), number(x[2])};
  };

  engines::Staging staging{{.gravity = vector(gravity_)}, {}, differs_};
  for (const Body& one : bodies_) {
    const double half = number(one.turn) / 2;
    engines::Body& body = staging.world.bodies.emplace_back();
    body.mass = positive(one.mass);
    body.inertia = {positive(one.inertia[0]), positive(one.inertia[1]), positive(one.inertia[2])};
    body.start = {
        vector(one.place), {std::cos(half), 0, 0, std::sin(half)}, vector(one.velocity), vector(one.spin)};
  }
  for (const Joint& one : joints_) {
    const engines::Joint& joint = staging.world.joints.emplace_back(
        engines::Joint{one.kind, one.a, one.b, vector(one.at), vector(one.axis), vector(one.end)});
    if (joint.axis == engines::Vector{})
      source_->fail(one.axis[0].place, "an axis has a direction, as [0, 0, 1]");
    if (joint.kind == engines::Joint::rod && joint.at == joint.end)
      source_->fail(one.end[0].place, "a rod has a length: at and end are two points");
  }
  for (const Spring& one : springs_)
    staging.world.springs.push_back(
        {one.a, one.b, vector(one.at), vector(one.end), number(one.stiffness), number(one.rest)});
  staging.observe = [program = Program(replaced(observed_, inputs), keys)](
                        std::span<const engines::State> seen, double t) {
    std::vector<double> letters;
    for (const engines::State& one : seen) {
      for (std::size_t i = 0; i < 3; ++i) letters.insert(letters.end(), {one.position[i], one.velocity[i]});
      letters.insert(letters.end(), {2 * std::atan2(one.orientation[3], one.orientation[0]), one.spin[2]});
    }
    std::vector<double> values(program.outputs().size());
    program.run(letters.data(), t, values.data());
    return values;
  };
  return staging;
}

}  // namespace oddity::problem
