// Vectors in a problem's file: a model has the instructions of the same model in components, and shapes that
// do not fit are refused with their place.

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "chapters/random.hpp"
#include "chapters/scene.hpp"
#include "problem/file.hpp"
#include "problem/model.hpp"
#include "problem/scene.hpp"
#include "problem/truth.hpp"
#include "reference/text.hpp"
#include "report/study/run.hpp"
#include "report/verify/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/near.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;
using namespace oddity::problem;

namespace {

const std::string letters =
    "title = \"x\"\n[parameters]\nm = \"2 kg\"\nk = \"40 N/m\"\nL = \"1 m\"\nc = \"0.3 N s/m\"\na = \"30 deg\"\n[given]\n";
const std::string gravity = "g = [\"0 m/s^2\", \"-9.81 m/s^2\"]\n";

std::string vectors(const std::string& model, const std::string& given = gravity) {
  return letters + given + "[model.one]\n" + model + "\n[observe]\nr = \"m\"\n";
}
const std::string hung = "start = { r = [\"1.2 L sin(a)\", \"-1.2 L cos(a)\"], \"r'\" = 0 }\n";

Numbers numbers_of(const std::string& text) {
  const auto file = read("test.toml", text);
  std::vector<double> values;
  for (const ParameterText& p : file->parameters) values.push_back(p.value);
  return Model(*file, file->models[0]).with(values);
}

std::string refusal(const std::string& text) {
  const std::string said = complaint([&] { entry_of_text("test.toml", text); });
  return said.substr(0, said.find('\n'));
}

/// As many operations of each kind, and the same results to the last digit.
void check_same(const Program& one, const Program& other) {
  const auto kinds = [](const Program& of) {
    std::vector<Op> all;
    for (const Program::Instruction& instruction : of.code()) all.push_back(instruction.op);
    std::ranges::sort(all);
    return all;
  };
  CHECK(kinds(one) == kinds(other));
  REQUIRE(one.outputs().size() == other.outputs().size());
  if (one.outputs().empty()) return;
  Random random(52);
  for (int i = 0; i < 10; ++i) {
    std::vector<double> x, first(one.outputs().size()), second(first);
    while (x.size() + 1 < one.inputs()) x.push_back(random.between(-1, 1));
    one.run(x.data(), 0.3, first.data());
    other.run(x.data(), 0.3, second.data());
    CHECK(first == second);
  }
}
void check_same(const Numbers& one, const Numbers& other) {
  CHECK(one.start == other.start);
  CHECK(one.partitioned == other.partitioned);
  CHECK(one.unknowns == other.unknowns);
  check_same(one.rates, other.rates), check_same(one.observed, other.observed);
  check_same(one.conserved, other.conserved), check_same(one.off, other.off);
  check_same(one.guards, other.guards), check_same(one.afterwards, other.afterwards);
}

/// A model in vectors, and the same in components.
struct Twin {
  std::string vectors, components;
};

}  // namespace

TEST_CASE("A model in vectors moves as the same model in components", "[problem][vectors]") {
  const std::string components =
      "start = { x = \"1.2 L sin(a)\", y = \"-1.2 L cos(a)\", \"x'\" = 0, \"y'\" = 0 }\n";
  const Twin twins[]{
      {"equations = [\"m r'' = -k (1 - L/abs(r)) r - c r' + m g\"]\n" + hung,
       "equations = [\"m x'' = -k (1 - L/sqrt(x x + y y)) x - c x' + m gx\", \"m y'' = -k (1 - L/sqrt(x x + y y)) y - c y' + m gy\"]\n" +
           components},
      {"equations = ['m \\ddot r = -k (1 - \\frac{L}{\\sqrt{r\\cdot r}}) r + m g']\n" + hung,
       "equations = ['m \\ddot x = -k (1 - \\frac{L}{\\sqrt{x x + y y}}) x + m gx', 'm \\ddot y = -k (1 - \\frac{L}{\\sqrt{x x + y y}}) y + m gy']\n" +
           components},
      {"lagrangian = \"m/2 dot(r', r') + m dot(g, r) - k/2 (abs(r) - L)^2\"\ndissipation = \"c/2 dot(r', r')\"\nforces = { r = \"-c t r'/(1 s)\" }\n" +
           hung,
       "lagrangian = \"m/2 (x' x' + y' y') + m (gx x + gy y) - k/2 (sqrt(x x + y y) - L)^2\"\ndissipation = \"c/2 (x' x' + y' y')\"\n"
       "forces = { x = \"-c t x'/(1 s)\", y = \"-c t y'/(1 s)\" }\n" +
           components},
      {"lagrangian = \"m/2 dot(r', r') + m dot(g, r)\"\nconstraints = [\"abs(r) = 1.2 L\"]\n" + hung,
       "lagrangian = \"m/2 (x' x' + y' y') + m (gx x + gy y)\"\nconstraints = [\"sqrt(x x + y y) = 1.2 L\"]\n" +
           components},
      {"hamiltonian = \"dot(p, p)/(2*m) + k/2 (abs(r) - L)^2\"\nmomenta = { r = \"p\" }\nstart = { r = [\"2 L\", 0], p = [0, \"1 kg m/s\"] }\n",
       "hamiltonian = \"(px px + py py)/(2*m) + k/2 (sqrt(x x + y y) - L)^2\"\nmomenta = { x = \"px\", y = \"py\" }\n"
       "start = { x = \"2 L\", y = 0, px = \"0 kg m/s\", py = \"1 kg m/s\" }\n"},
      {"equations = [\"r'' = g\"]\nevents = [{ when = \"r_2 + 2*L\", then = { r = [\"r_1\", \"-2*L\"], \"r'\" = \"0.5 (r' - 2 r_2' (0, 1))\" } }]\n" +
           hung,
       "equations = [\"x'' = gx\", \"y'' = gy\"]\nevents = [{ when = \"y + 2*L\", then = { x = \"x\", y = \"-2*L\", \"x'\" = \"0.5 (x' - 2 y' 0)\", \"y'\" = \"0.5 (y' - 2 y' 1)\" } }]\n" +
           components},
  };
  for (const Twin& twin : twins) {
    INFO(twin.vectors);
    check_same(numbers_of(vectors(twin.vectors)),
               numbers_of(letters + "gx = \"0 m/s^2\"\ngy = \"-9.81 m/s^2\"\n[model.one]\n" +
                          twin.components + "\n[observe]\nx = \"m\"\ny = \"m\"\n"));
  }
}

TEST_CASE("A charge in a magnetic field flies along a helix, by a cross product", "[problem][vectors]") {
  const std::string text = vectors(
      "equations = [\"r' = v\", \"v' = w cross(v, B)\"]\n"
      "start = { r = [0, 0, 0], v = [\"1 m/s\", 0, \"0.5 m/s\"] }\n",
      "B = [0, 0, 1]\nw = \"3 rad/s\"\n");
  const Numbers numbers = numbers_of(text);
  const std::array<double, 2> times{0, 2};
  const auto state = by_series(numbers, times).states[1];
  const double w = 3, t = 2;
  CHECK(near(static_cast<double>(state[0]), std::sin(w * t) / w, 1e-15));
  CHECK(near(static_cast<double>(state[1]), (std::cos(w * t) - 1) / w, 1e-15));
  CHECK(near(static_cast<double>(state[2]), 0.5 * t, 1e-15));
}

TEST_CASE("An inertia tensor is a matrix, of which the equations are solved", "[problem][vectors]") {
  // Euler's equations in axes that are turned by 45 degrees about z: moments 1 and 3 there, 2 +- 1 here.
  const auto spun = [](const std::string& J, const std::string& start) {
    const Numbers numbers =
        numbers_of("title = \"x\"\n[parameters]\ns = \"1 rad/s\"\n[given]\nJ = \"" + J +
                   "\"\n[model.one]\nequations = [\"J w' = -cross(w, J w)\"]\nstart = { w = " + start +
                   " }\n[observe]\nw = \"rad/s\"\n[need]\nerror = \"1 rad/s\"\n");
    return by_series(numbers, std::array<double, 2>{0, 1.5}).states[1];
  };
  const auto here = spun("(2, -1, 0; -1, 2, 0; 0, 0, 4)", "[\"s\", 0, \"2*s\"]"),
             there = spun("(1, 0, 0; 0, 3, 0; 0, 0, 4)", "[\"s/sqrt(2)\", \"-s/sqrt(2)\", \"2*s\"]");
  const long double half = std::sqrt(0.5L);
  CHECK(near(static_cast<double>(here[0]), static_cast<double>(half * (there[0] - there[1])), 1e-15));
  CHECK(near(static_cast<double>(here[1]), static_cast<double>(half * (there[0] + there[1])), 1e-15));
  CHECK(near(static_cast<double>(here[2]), static_cast<double>(there[2]), 1e-15));
}

TEST_CASE("A vector is observed as the components of one point", "[problem][vectors]") {
  const std::string model = "equations = [\"m r'' = -k r\"]\n" + hung;
  const std::string other =
      "[model.two]\nequations = [\"m s'' = -k s\"]\nstart = { s = [\"1.2 L sin(a)\", \"-1.2 L cos(a)\"], \"s'\" = 0 }\n";
  const auto entry = [&](const std::string& observe, const std::string& more = "") {
    std::string text = vectors(model + more);
    return text.replace(text.find("[observe]"), text.npos,
                        observe + "[need]\nerror = \"1 mm\"\nhorizon = \"1 s\"\n");
  };
  const Scene& seen =
      *entry_of_text("test.toml", entry("[observe]\nr = \"m\"\nr_x = { unit = \"m\", is = \"r_1\" }\n"))
           .exercise.scene;
  CHECK(seen.axes.observables == std::vector<std::string_view>{"r_1", "r_2", "r_x"});
  REQUIRE(seen.axes.norms.size() == 2);
  CHECK(seen.axes.norms[0].components == std::vector<std::size_t>{0, 1});
  for (const std::string own :
       {"observe = { r = \"s\" }\n", "observe = { r = [\"s_1\", \"s_2\"] }\n",
        "observe = { r_1 = \"s_1\", r_2 = \"s_2\" }\n", "closed = { r = \"r0 cos(sqrt(k/m) t)\" }\n"}) {
    INFO(own);
    const bool is_closed = own.starts_with("closed");
    std::string text = entry("[observe]\nr = \"m\"\n", (is_closed ? "[model.two]\n" : other) + own);
    text.insert(text.find("[given]\n") + 8, "r0 = [\"1.2 L sin(a)\", \"-1.2 L cos(a)\"]\n");
    const Entry& two = entry_of_text("test.toml", text);
    const Quantity motion_of_two =
        motion(*two.exercise.scene, Parameters(two.exercise.parameters), {1, 4}, Reference::nothing());
    const Method& one = *method_of(motion_of_two, "one", "Runge-Kutta 4");
    const Method& second = is_closed ? *std::ranges::find(motion_of_two.methods, "two", &Method::model)
                                     : *method_of(motion_of_two, "two", "Runge-Kutta 4");
    const Value value = run(motion_of_two, one, 1.0 / 256).answer.value,
                its = run(motion_of_two, second, is_closed ? 0 : 1.0 / 256).answer.value;
    REQUIRE(value.size() == 8);
    for (std::size_t i = 0; i < 8; ++i) CHECK(near(value[i], its[i], is_closed ? 1e-7 : 0.0));
  }
  // A formula that is a vector, and its distance from one of a list.
  const Entry& tips = entry_of_text(
      "test.toml",
      entry("[observe]\nr = \"m\"\ntip = { unit = \"m\", is = \"r + L r/abs(r)\", point = \"tip\" }\n"
            "end = { unit = \"m\", is = [\"r_1 + L r_1/abs(r)\", \"r_2 + L r_2/abs(r)\"] }\n"));
  const Quantity moved =
      motion(*tips.exercise.scene, Parameters(tips.exercise.parameters), {1, 4}, Reference::nothing());
  const Value value = run(moved, *method_of(moved, "one", "Runge-Kutta 4"), 1.0 / 64).answer.value;
  REQUIRE(value.size() == 24);
  for (std::size_t i = 0; i < 24; i += 6)
    CHECK((value[i + 2] == value[i + 4] && value[i + 3] == value[i + 5]));
}

TEST_CASE("Vectors that do not fit are refused with their place", "[problem][vectors]") {
  const auto of_equation = [](const std::string& equation) {
    return refusal(vectors("equations = [\"" + equation + "\"]\n" + hung));
  };
  CHECK(of_equation("m r'' = -k r + g") == "test.toml:11:30: N and m/s^2 do not add up");
  CHECK(of_equation("m r'' = -k r + m L") == "test.toml:11:30: a vector of 2 and a number do not add up");
  CHECK(of_equation("m r'' = -k L") ==
        "test.toml:11:23: the left side is a vector of 2, and the right side a number");
  CHECK(of_equation("m r_1'' = -k r") ==
        "test.toml:11:25: the left side is a number, and the right side a vector of 2");
  CHECK(of_equation("m r'' = -k r r r") ==
        "test.toml:11:28: two vectors have several products: write dot(a, b) or cross(a, b)");
  CHECK(of_equation("m r'' = -k r^3/L^2") ==
        "test.toml:11:26: a power is of a number, and this is a vector of 2: write dot(v, v) or abs(v)^2");
  CHECK(of_equation("m r'' = -k L/r") == "test.toml:11:28: divide by a number: this is a vector of 2");
  CHECK(of_equation("m r'' = -k sin(r)") == "test.toml:11:30: sin takes a number, and this is a vector of 2");
  CHECK(of_equation("m r'' = cross(r, g)") ==
        "test.toml:11:29: cross takes two vectors of 3, and not a vector of 2 and a vector of 2");
  CHECK(of_equation("m r'' = dot(r, (L, L, L)) r") ==
        "test.toml:11:27: dot takes two vectors of one length, and not a vector of 2 and a vector of 3");
  CHECK(of_equation("m r'' = -k max(r, L)") ==
        "test.toml:11:30: a number is needed here, and this is a vector of 2");
  CHECK(of_equation("m r'' = if(t < 1 s, r, r_1) k") ==
        "test.toml:11:38: this is a number, and otherwise a vector of 2");
  CHECK(of_equation("m r'' = -k r_3 g") == "test.toml:11:26: a vector of 2 has no component 3");
  CHECK(of_equation("m r'' = -k a_1") == "test.toml:11:26: no letter a_1; did you mean 'r_1' or 'g_1'?");
  CHECK(of_equation("m r_1'' = -k r_1") == "test.toml:10:8: no equation has a rate of r_2");
  CHECK(refusal(vectors("lagrangian = \"m/2 dot(r', r') - k r\"\n" + hung)) ==
        "test.toml:11:33: a number and a vector of 2 do not add up");
  CHECK(refusal(vectors("lagrangian = \"m r'\"\n" + hung)) ==
        "test.toml:11:15: a number is needed here, and this is a vector of 2");

  const auto of_start = [](const std::string& start) {
    return refusal(vectors("equations = [\"m r'' = -k r\"]\nstart = { " + start + " }\n"));
  };
  CHECK(of_start("r = [\"1 m\", 0], \"r'\" = [0, 0, 0]") ==
        "test.toml:12:34: r is a vector of 2, and this is a vector of 3");
  CHECK(of_start("r = [\"1 m\", 0], \"r'\" = \"1 m/s\"") ==
        "test.toml:12:35: r is a vector: start r' with a list, or with 0");
  CHECK(of_start("r = [\"1 m\", 0]") == "test.toml:10:8: no start for r': add \"r'\" = [...] to start");
  CHECK(of_start("r = [\"1 m\"], \"r'\" = 0") == "test.toml:12:15: a vector has 2 to 24 components");
  CHECK(of_start("r = [\"1 m\", 0], \"r'\" = 0, r_1 = 0") == "test.toml:12:37: r_1 is started twice");
  CHECK(of_start("r = [\"1 m\", \"1 s\"], \"r'\" = 0") == "test.toml:12:24: r_2 is in m, and this is s");
  CHECK(of_start("k = [\"1 m\", 0], \"r'\" = 0") ==
        "test.toml:12:11: k is no unknown: it is a parameter, an abbreviation or the time");
  CHECK(refusal(vectors("equations = [\"r'' = -g\"]\n" + hung, gravity + "r = \"1 m\"\n")) ==
        "test.toml:13:11: r is no unknown: it is a parameter, an abbreviation or the time");
  CHECK(refusal(vectors("equations = [\"r'' = g\"]\n" + hung, gravity + "g_1 = \"1 m/s^2\"\n")) ==
        "test.toml:10:1: g_1 is there twice; take another name");
  CHECK(refusal(vectors("lagrangian = \"m/2 dot(r', r')\"\nforces = { r = [\"1 N\", 0, 0] }\n" + hung)) ==
        "test.toml:12:16: the force on r is a vector of 2, and this is a vector of 3");
  CHECK(refusal(vectors("equations = [\"r'' = g\"]\nevents = [{ when = \"r_1\", then = { r = \"L\" } }]\n" +
                        hung)) == "test.toml:12:41: r is a vector of 2, and this is a number");
  CHECK(refusal(vectors("equations = [\"r'' = g\"]\nevents = [{ when = \"r\", then = { r = \"r\" } }]\n" +
                        hung)) == "test.toml:12:21: a number is needed here, and this is a vector of 2");
  std::string text = vectors("equations = [\"r'' = g\"]\nobserve = { r = [\"r_1\", \"r_2\", 0] }\n" + hung);
  CHECK(refusal(text) == "nothing");
  text.replace(text.rfind("\"m\""), 3, "{ unit = \"m\", is = [\"r_1\", \"r_2\"] }");
  CHECK(refusal(text) == "test.toml:12:17: r is a vector of 2, and this is a vector of 3");
}

namespace {

/// A quaternion alone, with this angular velocity; it starts turned by 40 degrees about (1, 2, 2)/3.
std::string turning(const std::string& turns, const std::string& given = "", const std::string& more = "") {
  return "title = \"x\"\n[parameters]\nu = \"3 rad/s\"\n[given]\nh = \"20 deg\"\n" + given +
         "[model.one]\nturns = { q = " + turns +
         " }\nstart = { q = [\"cos(h)\", \"sin(h)/3\", \"2*sin(h)/3\", \"2*sin(h)/3\"]" + more +
         " }\n[observe]\ne = { unit = \"1\", is = \"turned(q, (1, 0, 0))\" }\n[need]\nerror = \"0.01\"\n";
}
std::vector<long double> seen_of(const std::string& text, double t) {
  const Numbers numbers = numbers_of(text);
  const TrueMotion motion = by_series(numbers, std::array<double, 2>{0, t});
  REQUIRE(motion.states.size() == 2);
  std::vector<long double> seen(numbers.observed.outputs().size());
  numbers.observed.run(motion.states[1].data(), static_cast<long double>(t), seen.data());
  return seen;
}

}  // namespace

TEST_CASE("A quaternion moves by its four equations", "[problem][vectors][quaternions]") {
  std::string text = turning("[\"u\", \"u cos(2 1/s t)\", \"2*u\"]");
  const Numbers turned = numbers_of(text);
  const std::string equations =
      "equations = [\"q_1' = (0 - (q_2 u + q_3 v + q_4 (2*u)))/2\", \"q_2' = (q_1 u + (q_3 (2*u) - q_4 v))/2\", "
      "\"q_3' = (q_1 v + (q_4 u - q_2 (2*u)))/2\", \"q_4' = (q_1 (2*u) + (q_2 v - q_3 u))/2\"]";
  const auto begin = text.find("turns = "), end = text.find('\n', begin);
  text.replace(begin, end - begin, equations);
  text.insert(text.find("[model.one]"), "v = \"u cos(2 1/s t)\"\n");
  const Numbers by_components = numbers_of(text);
  CHECK(turned.start == by_components.start);
  check_same(turned.rates, by_components.rates);
}

TEST_CASE("A quaternion turns a body in its own axes or in those of space",
          "[problem][vectors][quaternions]") {
  // About a fixed axis of the body it turns as about the same axis of space, turned as it is at the start.
  const auto by_body = seen_of(turning("[0, 0, \"u\"]"), 1.3),
             by_space = seen_of(turning("{ rate = \"turned(q0, (0, 0, u))\", axes = \"space\" }",
                                        "q0 = [\"cos(h)\", \"sin(h)/3\", \"2*sin(h)/3\", \"2*sin(h)/3\"]\n"),
                                1.3);
  const long double angle = 3.9L;
  // the vector (cos 3.9, sin 3.9, 0) turned by 40 degrees about (1, 2, 2)/3, by Rodrigues' formula
  const std::array<long double, 3> v{std::cos(angle), std::sin(angle), 0}, n{1.0L / 3, 2.0L / 3, 2.0L / 3};
  const long double turn = std::acos(-1.0L) * 2 / 9, along = n[0] * v[0] + n[1] * v[1] + n[2] * v[2];
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const long double expected = v[i] * std::cos(turn) + (n[j] * v[k] - n[k] * v[j]) * std::sin(turn) +
                                 n[i] * along * (1 - std::cos(turn));
    CHECK(std::abs(by_body[i] - expected) < 1e-15L);
    CHECK(std::abs(by_space[i] - expected) < 1e-15L);
  }
}

TEST_CASE("A heavy top moves by a quaternion as by Euler's angles", "[problem][vectors][quaternions]") {
  const std::string letters =
      "title = \"x\"\n[parameters]\nI = \"0.002 kg m^2\"\nC = \"0.001 kg m^2\"\nm = \"0.5 kg\"\nl = \"4 cm\"\n"
      "g = \"9.81 m/s^2\"\nspin = \"2000 rpm\"\na = \"30 deg\"\n[given]\nJ = \"(I, 0, 0; 0, I, 0; 0, 0, C)\"\n";
  const std::string observed =
      "[observe]\naxis = { unit = \"1\", is = \"turned(q, (0, 0, 1))\" }\n[need]\nerror = \"0.01\"\n";
  const std::string by_quaternion =
      "[model.one]\nequations = [\"J w' = cross(J w, w) + cross((0, 0, l), turned(conjugate(q), (0, 0, -m g)))\"]\n"
      "turns = { q = \"w\" }\nstart = { q = [\"cos(a/2)\", \"sin(a/2)\", 0, 0], w = [0, 0, \"spin\"] }\n";
  const std::string by_angles =
      "[model.one]\nlagrangian = \"I/2 (theta'^2 + phi'^2 sin(theta)^2) + C/2 (psi' + phi' cos(theta))^2 - m g l cos(theta)\"\n"
      "start = { theta = \"a\", phi = \"0 rad\", psi = \"0 rad\", \"theta'\" = 0, \"phi'\" = 0, \"psi'\" = \"spin\" }\n"
      "observe = { axis = [\"sin(theta) sin(phi)\", \"-sin(theta) cos(phi)\", \"cos(theta)\"] }\n";
  const auto one = seen_of(letters + by_quaternion + observed, 1.5),
             other = seen_of(letters + by_angles + observed, 1.5);
  CHECK(std::abs(other[0]) > 0.1L);
  for (std::size_t i = 0; i < 3; ++i) CHECK(std::abs(one[i] - other[i]) < 1e-14L);
}

TEST_CASE("A free body turns over in the time of an elliptic integral", "[problem][vectors][quaternions]") {
  // Landau and Lifshitz, Mechanics, 37: the period of the angular velocity in the body's axes.
  const auto file = read("handle", text_of(std::filesystem::path(ODDITY_SOURCE) / "chapters" / "examples" /
                                           "problems" / "turning_handle.toml"));
  const Model model(*file, file->models.back());
  std::vector<double> values;
  for (const ParameterText& p : file->parameters) values.push_back(p.value);
  const Numbers numbers = model.with(values);
  const long double I1 = 40e-6L, I2 = 60e-6L, I3 = 90e-6L, w1 = numbers.start[0], w2 = numbers.start[1],
                    w3 = numbers.start[2];
  const long double twice = I1 * w1 * w1 + I2 * w2 * w2 + I3 * w3 * w3,
                    square = I1 * I1 * w1 * w1 + I2 * I2 * w2 * w2 + I3 * I3 * w3 * w3;
  REQUIRE(square > twice * I2);
  const long double rate = std::sqrt((I3 - I2) * (square - twice * I1) / (I1 * I2 * I3)),
                    k2 = (I2 - I1) * (twice * I3 - square) / ((I3 - I2) * (square - twice * I1));
  long double a = 1, b = std::sqrt(1 - k2);
  for (int i = 0; i < 8; ++i) {
    const long double mean = (a + b) / 2;
    b = std::sqrt(a * b), a = mean;
  }
  const auto period = static_cast<double>(2 * std::acos(-1.0L) / (a * rate));  // 4 K/rate
  const TrueMotion motion = by_series(numbers, std::array<double, 3>{0, period / 2, period});
  REQUIRE(motion.states.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    const long double sign = i == 2 ? 1 : -1;  // half a period turns it over
    CHECK(std::abs(motion.states[1][i] - sign * numbers.start[i]) < 1e-10L);
    CHECK(std::abs(motion.states[2][i] - numbers.start[i]) < 1e-10L);
  }
}

TEST_CASE("A quaternion that cannot be is refused with its place", "[problem][vectors][quaternions]") {
  CHECK(refusal(turning("[0, 0, \"u\"]")) == "nothing");
  CHECK(refusal(turning("\"u\"")) ==
        "test.toml:7:16: the angular velocity of q is a vector of 3, and this is a number");
  CHECK(refusal(turning("[0, 0, \"1 m\"]")) == "test.toml:7:16: the left side is 1/s, and the right side m");
  CHECK(refusal(turning("{ axes = \"body\" }")) ==
        "test.toml:7:11: q turns: rate = \"w\" is its angular velocity");
  CHECK(refusal(turning("{ rate = \"v\", axes = \"world\" }", "v = [0, 0, \"u\"]\n")) ==
        "test.toml:8:37: axes is one of: body, space");
  CHECK(refusal(turning("[0, 0, \"u\"], v = [0, 0, \"u\"]")) ==
        "test.toml:7:28: v turns: start it with a quaternion, as v = [1, 0, 0, 0]");
  std::string text = turning("[0, 0, \"u\"]");
  text.replace(text.find("cos(h)"), 6, "1.5000");
  CHECK(refusal(text) ==
        "test.toml:7:11: at the start a quaternion that turns has the length 1, and this one 1.5385");
  text = turning("[0, 0, \"u\"]");
  text.replace(text.find("turned(q, (1, 0, 0))"), 20, "turned(q, (1, 0, 0, 0))");
  CHECK(refusal(text) == "test.toml:10:35: turned takes a vector of 3 here, and this is a vector of 4");
  text = turning("[0, 0, \"u\"]");
  text.insert(text.find("turns = "), "lagrangian = \"dot(q', q')\"\n");
  CHECK(refusal(text).find("turns go with equations") != std::string::npos);
}

namespace {

/// A model of a matrix R without unit.
std::string matrices(const std::string& model, const std::string& given = "",
                     const std::string& observe = "R = \"1\"\n") {
  return "title = \"x\"\n[parameters]\nm = \"2 kg\"\nk = \"40 N/m\"\nl = \"0.5 m\"\nw = \"3 rad/s\"\n[given]\n" +
         given + "[model.one]\n" + model + "[observe]\n" + observe + "[need]\nerror = [\"0.01\"]\n";
}
const std::string identity = "start = { R = [[1, 0], [0, 1]] }\n",
                  identity_at_rest = "start = { R = [[1, 0], [0, 1]], \"R'\" = [[0, \"w\"], [\"-w\", 0]] }\n";

}  // namespace

TEST_CASE("A model in matrices moves as the same model in components", "[problem][matrices]") {
  const std::string
      observed = "a = \"1\"\nb = \"1\"\nc = \"1\"\nd = \"1\"\n",
      start = "start = { a = 1, b = 0, c = 0, d = 1 }\n",
      second_start =
          "start = { a = 1, b = 0, c = 0, d = 1, \"a'\" = 0, \"b'\" = \"w\", \"c'\" = \"-w\", \"d'\" = 0 }\n",
      turning =
          "equations = [\"a' = a 0 + b w\", \"b' = a (-w) + b 0\", \"c' = c 0 + d w\", \"d' = c (-w) + d 0\"]\n",
      by_formula = "W = \"(0, -w; w, 0)\"\n", by_list = "W = [[0, \"-w\"], [\"w\", 0]]\n";
  const std::string S = "S = [[1, 0.5], [-1, 2]]\n", s = "s = 1\np = 0.5\nu = -1\nv = 2\n";
  struct Both {
    Twin model, given;
  };
  const Both all[]{
      {{"equations = [\"R' = R W\"]\n" + identity, turning + start}, {by_formula, ""}},
      {{"equations = [\"R' = R W\"]\n" + identity, turning + start}, {by_list, ""}},
      {{"equations = ['\\dot R = R W']\n" + identity, turning + start}, {by_list, ""}},
      {{"equations = [\"R' = R W\"]\nevents = [{ when = \"R_12\", then = { R = \"transposed(R)/2\" } }]\n" +
            identity,
        turning +
            "events = [{ when = \"b\", then = { a = \"a/2\", b = \"c/2\", c = \"b/2\", d = \"d/2\" } }]\n" +
            start},
       {by_formula, ""}},
      {{"equations = [\"R' = R W\"]\nevents = [{ when = \"W_21 - R_12 w\", then = { R = [[1, \"R_21\"], [\"W_12/w\", 0]] } }]\n" +
            identity,
        turning + "events = [{ when = \"w - b w\", then = { a = 1, b = \"c\", c = \"-w/w\", d = 0 } }]\n" +
            start},
       {by_formula, ""}},
      {{"equations = [\"m R'' = -k (transposed(R) - 2*S R/3)\"]\n" + identity_at_rest,
        "equations = [\"m a'' = -k (a - ((2*s) a + (2*p) c)/3)\", \"m b'' = -k (c - ((2*s) b + (2*p) d)/3)\", "
        "\"m c'' = -k (b - ((2*u) a + (2*v) c)/3)\", \"m d'' = -k (d - ((2*u) b + (2*v) d)/3)\"]\n" +
            second_start},
       {S, s}},
      {{"equations = [\"m R'' = -k (transposed(R) - S R)\"]\n" + identity_at_rest,
        "equations = [\"m a'' = -k (a - (s a + p c))\", \"m b'' = -k (c - (s b + p d))\", "
        "\"m c'' = -k (b - (u a + v c))\", \"m d'' = -k (d - (u b + v d))\"]\n" +
            second_start},
       {S, s}},
      {{"lagrangian = \"m l^2/2 (dot(R' (1, 0), R' (1, 0)) + dot(R' (0, 1), R' (0, 1))) - k l^2/2 dot(R (1, 2), R (1, 2))\"\n"
        "forces = { R = [[\"-k l^2 R_11\", 0], [0, \"-k l^2 R_22\"]] }\n" +
            identity_at_rest,
        "lagrangian = \"m l^2/2 ((a' a' + c' c') + (b' b' + d' d')) - k l^2/2 ((a 1 + b 2) (a 1 + b 2) + (c 1 + d 2) (c 1 + d 2))\"\n"
        "forces = { a = \"-k l^2 a\", d = \"-k l^2 d\" }\n" +
            second_start},
       {"", ""}},
  };
  for (const Both& one : all) {
    INFO(one.model.vectors);
    check_same(numbers_of(matrices(one.model.vectors, one.given.vectors)),
               numbers_of(matrices(one.model.components, one.given.components, observed)));
  }
}

TEST_CASE("A matrix of several columns multiplies a vector of as many", "[problem][matrices]") {
  const std::string by_matrix =
      "equations = [\"A' = -w A\", \"r' = w A v\"]\nstart = { A = [[1, 0, 2], [0, 1, 0]], r = [0, 1] }\n";
  const std::string by_numbers =
      "equations = [\"a' = -w a\", \"b' = -w b\", \"c' = -w c\", \"d' = -w d\", \"e' = -w e\", \"f' = -w f\", "
      "\"x' = (w a) 1 + (w b) 2 + (w c) 3\", \"y' = (w d) 1 + (w e) 2 + (w f) 3\"]\n"
      "start = { a = 1, b = \"0 rad\", c = 2, d = \"0 rad\", e = 1, f = \"0 rad\", x = 0, y = 1 }\n";
  check_same(numbers_of(matrices(by_matrix, "v = [1, 2, 3]\n", "r = \"1\"\n")),
             numbers_of(matrices(by_numbers, "", "x = \"1\"\ny = \"1\"\n")));
}

TEST_CASE("A matrix turns a body as its quaternion does", "[problem][matrices][quaternions]") {
  const auto tip = [](const std::string& model) {
    return seen_of(
        matrices(model, "u = [\"w\", \"w cos(2 1/s t)\", \"2*w\"]\n",
                 "tip = { unit = \"m\", is = \"" +
                     std::string(model.starts_with("turns") ? "turned(q, (l, 0, 2*l))" : "R (l, 0, 2*l)") +
                     "\" }\n"),
        1.3);
  };
  const auto by_quaternion = tip("turns = { q = \"u\" }\nstart = { q = [1, 0, 0, 0] }\n"),
             by_matrix =
                 tip("equations = [\"R' = R (0, -u_3, u_2; u_3, 0, -u_1; -u_2, u_1, 0)\"]\n"
                     "start = { R = [[1, 0, 0], [0, 1, 0], [0, 0, 1]] }\n");
  REQUIRE(by_matrix.size() == 3);
  CHECK(std::abs(by_matrix[1]) > 0.01L);
  for (std::size_t i = 0; i < 3; ++i) CHECK(std::abs(by_matrix[i] - by_quaternion[i]) < 1e-15L);
}

TEST_CASE("A matrix is observed as the components of one point", "[problem][matrices]") {
  const std::string turning = "equations = [\"R' = R W\"]\n" + identity, W = "W = \"(0, -w; w, 0)\"\n",
                    turn = "(cos(w t), -sin(w t); sin(w t), cos(w t))",
                    observed =
                        "R = \"1\"\ntip = { unit = \"1\", is = \"R (1, 0)\" }\n"
                        "P = { unit = \"1\", is = [[\"R_11\", \"R_12\"], [0, \"R_22\"]] }\n";
  for (const std::string two :
       {"closed = { R = \"T\", tip = \"T (1, 0)\", P = [[\"T_11\", \"T_12\"], [0, \"T_22\"]] }\n",
        "equations = [\"Q' = W Q\"]\nstart = { Q = [[1, 0], [0, 1]] }\n"
        "observe = { R = \"Q\", tip = \"Q (1, 0)\", P = [[\"Q_11\", \"Q_12\"], [0, \"Q_22\"]] }\n"}) {
    INFO(two);
    const Entry& entry = entry_of_text(
        "test.toml", matrices(turning + "[model.two]\n" + two, W + "T = \"" + turn + "\"\n", observed));
    const Scene& scene = *entry.exercise.scene;
    CHECK(scene.axes.observables == std::vector<std::string_view>{"R_11", "R_12", "R_21", "R_22", "tip_1",
                                                                  "tip_2", "P_11", "P_12", "P_21", "P_22"});
    REQUIRE(scene.axes.norms.size() == 3);
    CHECK(scene.axes.norms[0].components == std::vector<std::size_t>{0, 1, 2, 3});
    const Quantity moved = motion(scene, Parameters(entry.exercise.parameters), {1, 4}, Reference::nothing());
    const bool is_closed = two.starts_with("closed");
    const Method& second = is_closed ? *std::ranges::find(moved.methods, "two", &Method::model)
                                     : *method_of(moved, "two", "Runge-Kutta 4");
    const Value value = run(moved, *method_of(moved, "one", "Runge-Kutta 4"), 1.0 / 256).answer.value,
                its = run(moved, second, is_closed ? 0 : 1.0 / 256).answer.value;
    REQUIRE(value.size() == 40);
    CHECK(std::abs(value[31]) > 0.1);
    for (std::size_t i = 0; i < 40; ++i) CHECK(std::abs(value[i] - its[i]) < 1e-7);
  }
}

TEST_CASE("Matrices that do not fit are refused with their place", "[problem][matrices]") {
  const auto of_equation = [](const std::string& equation) {
    return refusal(matrices("equations = [\"" + equation + "\"]\n" + identity,
                            "W = \"(0, -w; w, 0)\"\nA = [[1, 2, 3], [4, 5, 6]]\nv = [1, 2, 3, 4]\n"));
  };
  CHECK(of_equation("R' = R W") == "nothing");
  CHECK(of_equation("R' = R + W") == "test.toml:12:24: a pure number and 1/s do not add up");
  CHECK(of_equation("R' = w (R + v)") ==
        "test.toml:12:27: a matrix of 2 by 2 and a vector of 4 do not add up");
  CHECK(of_equation("R' = w (R + 1)") == "test.toml:12:20: a matrix of 2 by 2 and a number do not add up");
  CHECK(of_equation("R' = w v") ==
        "test.toml:12:20: the left side is a matrix of 2 by 2, and the right side a vector of 4");
  CHECK(of_equation("R' = w A") ==
        "test.toml:12:20: the left side is a matrix of 2 by 2, and the right side a matrix of 2 by 3");
  CHECK(of_equation("R' = W A R") ==
        "test.toml:12:24: a matrix of 2 by 3 and a matrix of 2 by 2 have no product");
  CHECK(of_equation("R' = A W") ==
        "test.toml:12:22: a matrix of 2 by 3 and a matrix of 2 by 2 have no product");
  CHECK(of_equation("R' = w dot((1, 2) R, (1, 0)) R") ==
        "test.toml:12:33: a vector of 2 and a matrix of 2 by 2 have no product: write the matrix first");
  CHECK(of_equation("R' = w/R") == "test.toml:12:22: divide by a number: this is a matrix of 2 by 2");
  CHECK(of_equation("R' = w R^2") ==
        "test.toml:12:22: a power is of a number, and this is a matrix of 2 by 2: write a product");
  CHECK(of_equation("R' = w abs(R) R") ==
        "test.toml:12:26: abs takes a number or a vector, and this is a matrix of 2 by 2");
  CHECK(of_equation("R' = w dot(v, R) R") ==
        "test.toml:12:26: dot takes two vectors of one length, and not a vector of 4 and a matrix of 2 by 2");
  CHECK(of_equation("R' = w transposed(w) R") == "test.toml:12:33: a number is not transposed");
  CHECK(of_equation("R' = w if(t < 1 s, R, v)") ==
        "test.toml:12:37: this is a vector of 4, and otherwise a matrix of 2 by 2");
  CHECK(of_equation("R' = w turned(R, (1, 0, 0))") ==
        "test.toml:12:29: turned takes a vector of 4 here, and this is a matrix of 2 by 2");
  CHECK(of_equation("R' = w R_13 R") ==
        "test.toml:12:22: a matrix of 2 by 2 has no component 13: 12 is that of row 1 and column 2");
  CHECK(of_equation("R' = w R_1 R") ==
        "test.toml:12:22: a matrix of 2 by 2 has no component 1: 12 is that of row 1 and column 2");
  CHECK(of_equation("R' = w W_3 R") ==
        "test.toml:12:22: a matrix of 2 by 2 has no component 3: 12 is that of row 1 and column 2");
  CHECK(of_equation("R_11' = w") == "test.toml:11:8: no equation has a rate of R_12");

  const auto of_start = [](const std::string& start) {
    return refusal(matrices("equations = [\"R'' = -w^2 R\"]\nstart = { " + start + " }\n"));
  };
  CHECK(of_start("R = [[1, 0], [0, 1]], \"R'\" = 0") == "nothing");
  CHECK(of_start("R = [[1, 0], [0, 1, 2]], \"R'\" = 0") ==
        "test.toml:10:24: this row has 3 components, and the first 2");
  CHECK(of_start("R = [[1, 0], 1], \"R'\" = 0") ==
        "test.toml:10:24: this is no list, and the other rows of this matrix are lists");
  CHECK(of_start("R = [1, [0, 1]], \"R'\" = 0") ==
        "test.toml:10:16: this is no list, and the other rows of this matrix are lists");
  CHECK(of_start("R = [[1, [2]], [0, 1]], \"R'\" = 0") == "test.toml:10:20: expected a text, in quotes");
  CHECK(of_start("R = [[1], [0]], \"R'\" = 0") == "test.toml:10:15: a matrix has 2 to 9 rows and columns");
  CHECK(of_start("R = [[1, 0]], \"R'\" = 0") == "test.toml:10:15: a matrix has 2 to 9 rows and columns");
  CHECK(of_start("R = [[], []], \"R'\" = 0") == "test.toml:10:15: a matrix has 2 to 9 rows and columns");
  CHECK(of_start("R = [[1, 0], [0, 1]], \"R'\" = [[0, 0, 0], [0, 0, 0]]") ==
        "test.toml:10:40: R is a matrix of 2 by 2, and this is a matrix of 2 by 3");
  CHECK(of_start("R = [[1, 0], [0, 1]], \"R'\" = [0, 0, 0, 0]") ==
        "test.toml:10:40: R is a matrix of 2 by 2, and this is a vector of 4");
  CHECK(of_start("R = [[1, 0], [0, 1]], \"R'\" = \"w\"") ==
        "test.toml:10:41: R is a matrix: start R' with a list of lists, or with 0");
  CHECK(of_start("R = [[1, 0], [0, 1]]") ==
        "test.toml:8:8: no start for R': add \"R'\" = [[...], [...]] to start");
  CHECK(of_start("R = [[1, 0], [0, 1]], \"R'\" = 0, R_12 = 0") == "test.toml:10:43: R_12 is started twice");
  CHECK(of_start("R = [[1, 0], [\"1 m\", 1]], \"R'\" = 0") ==
        "test.toml:10:26: R_21 is in a pure number, and this is m");
  const std::string five = "[1, 0, 0, 0, 0]";
  CHECK(refusal(matrices("equations = [\"R' = w R\"]\nstart = { R = [" + five + ", " + five + ", " + five +
                         ", " + five + ", " + five + "] }\n")) ==
        "test.toml:8:8: model one has 25 unknowns and rates, and the algorithms are compiled for at most 24");
  CHECK(refusal(matrices("equations = [\"R' = w R\"]\n" + identity, "R_11 = 1\n")) ==
        "test.toml:11:11: R_11 is no unknown: it is a parameter, an abbreviation or the time");
  CHECK(refusal(matrices("equations = [\"R' = w R\"]\n" + identity, "W_12 = 1\nW = [[1, 0], [0, 1]]\n")) ==
        "test.toml:9:1: W_12 is there twice; take another name");
  CHECK(refusal(matrices(
            "equations = [\"R' = w R\"]\nevents = [{ when = \"R_12\", then = { R = [1, 0, 0, 1] } }]\n" +
            identity)) == "test.toml:10:41: R is a matrix of 2 by 2, and this is a vector of 4");
  CHECK(refusal(matrices("hamiltonian = \"w R_11 + w p_1\"\nmomenta = { R = \"p\" }\n"
                         "start = { R = [[1, 0], [0, 1]], p = [\"1 J s\", 0, 0, 0] }\n")) ==
        "test.toml:10:18: R is a matrix of 2 by 2, and p is a vector of 4");
  CHECK(refusal(matrices("turns = { R = [\"w\", 0, 0] }\n" + identity)) ==
        "test.toml:9:11: R turns: start it with a quaternion, as R = [1, 0, 0, 0]");
  CHECK(refusal(matrices("equations = [\"R' = w R\"]\n" + identity, "",
                         "R = { unit = \"1\", is = \"R + R_11\" }\n")) ==
        "test.toml:12:29: a matrix of 2 by 2 and a number do not add up");
  CHECK(refusal(matrices("equations = [\"R' = w R\"]\nobserve = { R = \"R (1, 0)\" }\n" + identity +
                         "[model.two]\nequations = [\"R' = w R\"]\n" + identity)) ==
        "test.toml:16:1: a matrix of 2 by 2 has no component 1: 12 is that of row 1 and column 2");
}

TEST_CASE("An equation in TeX has the order that it shows", "[problem][vectors]") {
  const std::string text =
      "title = \"x\"\n[parameters]\nk = \"2 1/s\"\n[model.one]\nequations = ['\\dot x = -k x']\n"
      "start = { x = 1 }\n[observe]\nx = \"1\"\n[need]\nerror = [\"0.01\"]\n";
  CHECK(numbers_of(text).unknowns >= 1);
}
