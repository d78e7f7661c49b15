// Problems' files: how they are read, the scenes that they make, and that a file's answers are those of the
// same scene in C++.

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

#include "chapters/scene.hpp"
#include "problem/file.hpp"
#include "problem/model.hpp"
#include "problem/scene.hpp"
#include "problem/template.hpp"
#include "problem/truth.hpp"
#include "reference/code_text.hpp"
#include "reference/text.hpp"
#include "report/study/choose.hpp"
#include "report/verify/catch.hpp"
#include "solvers/taylor/series.hpp"
#include "tests/complaint.hpp"
#include "tests/near.hpp"
#include "tests/program.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;
using namespace oddity::problem;

namespace {

const std::filesystem::path folder =
    std::filesystem::path(ODDITY_SOURCE) / "chapters" / "examples" / "problems";
const std::string pendulum =
    std::string(ODDITY_SOURCE) + "/chapters/03_rigid_body_motion/05_pendulum/scene.toml";

std::string with(const std::string& equation, const std::string& start = R"({ y = "0 m", "y'" = "1 m/s" })",
                 const std::string& more = "") {
  return "title = \"test\"\n[parameters]\nm = \"2 kg\"\nk = \"30 kN/m, 1 to 100\"\nc = \"2.5 kN s/m\"\ng = \"9.81 m/s^2\"\n"
         "[given]\nz = \"if(t < 0.2 s, 5 cm sin(pi t/(0.2 s)), 0)\"\n[model.one]\nequations = [\"" +
         equation + "\"]\nstart = " + start + "\n" + more + "[observe]\ny = \"m\"\n";
}

/// The highest rate that the equation gives at y = 0.3 m, y' = -0.7 m/s, t = 0.1 s.
double rate_of(const std::string& equation) {
  const auto file = read("test.toml", with(equation));
  const Model model(*file, file->models[0]);
  std::vector<double> values;
  for (const ParameterText& p : file->parameters) values.push_back(p.value);
  const std::array<double, 2> x{0.3, -0.7};
  std::array<double, 2> rate{};
  model.with(values).rates.run(x.data(), 0.1, rate.data());
  return rate[1];
}

std::string refusal(const std::string& text) {
  return complaint([&] { entry_of_text("test.toml", text); });
}
std::string refusal_of(const std::string& equation) { return refusal(with(equation)); }

/// The message without the line and the caret.
std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

std::string text_of_example(const std::string& name) { return text_of(folder / (name + ".toml")); }

}  // namespace

TEST_CASE("A unit follows a numeral, and only functions are called", "[problem]") {
  const double y = 0.3, v = -0.7, m = 2, k = 30e3, c = 2.5e3, g = 9.81, pi = std::numbers::pi;
  const double z = 0.05 * std::sin(pi * 0.1 / 0.2), z_rate = 0.05 * std::cos(pi * 0.1 / 0.2) * pi / 0.2;
  CHECK(near(rate_of("m y'' = -k (y - z) - c (y' - z')"), (-k * (y - z) - c * (v - z_rate)) / m, 1e-9));
  CHECK(near(rate_of("y'' = 5 cm/(2 s)^2"), 0.0125, 1e-15));
  CHECK(near(rate_of("y'' = 9.81 m/s^2 - 3 1/s y'"), 9.81 + 2.1, 1e-14));
  CHECK(near(rate_of("y'' = 2*g - m g/(2*m)"), 1.5 * g, 1e-14));
  CHECK(near(rate_of("y'' = g/2 - 36 km/h^2"), g / 2 - 36e3 / 3600 / 3600, 1e-14));
  CHECK(near(rate_of("y'' = 60 rpm y'"), 2 * pi * v, 1e-14));
  CHECK(near(rate_of("y'' = y^2 g/(1 m)^2"), 0.09 * g, 1e-14));
  CHECK(near(rate_of("y'' = abs(y') 1 1/s + max(y, 1 m) 1 1/s^2"), 1.7, 1e-14));
  CHECK(near(rate_of("y'' = if(y' > 0, g, -g) + sign(y') g"), -2 * g, 1e-14));
  CHECK(near(rate_of("y'' = g atan2(y, 2 m) + g asin(y/(1 m)) + g ln(2) + g tanh(1/2)"),
             g * (std::atan2(0.3, 2) + std::asin(0.3) + std::log(2) + std::tanh(0.5)), 1e-13));
  CHECK(near(rate_of("(m + 1 kg) y'' + 2*m y'' = -c y'"), -c * v / 7, 1e-10));
  CHECK(near(rate_of(R"(y'' = -\\frac{k}{m} y - \\frac{c}{m}\\dot y)"), (-k * y - c * v) / m, 1e-9));
}

TEST_CASE("An error in a file is reported with its line and column", "[problem]") {
  CHECK(first_line(refusal_of("m y'' = -k y - c y")) == "test.toml:10:30: N and m kg/s do not add up");
  CHECK(first_line(refusal_of("y'' = -g + y'")) == "test.toml:10:26: m/s^2 and m/s do not add up");
  CHECK(first_line(refusal_of("m y'' = g")) ==
        "test.toml:10:23: the left side is N, and the right side m/s^2");
  CHECK(first_line(refusal_of("y'' = -mg")) == "test.toml:10:22: no letter mg; did you mean m g?");
  CHECK(refusal_of("y'' = -1/2 m y'").find("write 2*m for the letter") != std::string::npos);
  CHECK(first_line(refusal_of("y'' = g sin(y)")) ==
        "test.toml:10:27: a pure number is expected here, and this is m");
  CHECK(refusal_of("y''^2 = g^2").find("not linear in y''") != std::string::npos);
  CHECK(refusal_of("y' = 1 m/s").find("the equations are of order 1 in y: leave y' out") !=
        std::string::npos);
  CHECK(refusal_of("y''' = 1 m/s^3").find("no start for y''") != std::string::npos);
  std::string eighth = with("v'''' = 1 m/s^8");
  eighth.insert(eighth.find("z = "), "v = \"y''''\"\n");
  CHECK(first_line(refusal(eighth)) ==
        "test.toml:10:8: rates are of order 7 at most, and y'''''''' is needed");
  CHECK(refusal_of("0*y'' = g").find("no equation") == std::string::npos);
  CHECK(refusal_of("0*y'' = g").find("singular") != std::string::npos);
  CHECK(first_line(refusal_of("y'' = g + 1e308 m/s^2*1e10")) ==
        "test.toml:10:25: a number that is too large or too small");
  CHECK(refusal_of("y'' = g (").find("expected") != std::string::npos);
  CHECK(refusal_of("y'' - g").find("expected an equation") != std::string::npos);
  CHECK(refusal(with("y'' = -g", R"({ y = 0 })")).find("no start for y'") != std::string::npos);
  CHECK(refusal(with("y'' = -g", R"({ y = "1 s", "y'" = 0 })")).find("y is in m, and this is s") !=
        std::string::npos);
  CHECK(refusal(with("y'' = -g", R"({ y = "q", "y'" = 0 })")).find("no letter q") != std::string::npos);
  CHECK(refusal(with("m y'' = -k y", R"({ y = "1 m", "y'" = 0 })",
                     "conserves = { kinetic = \"m/2 y'^2\", potential = \"k y^2\" }\n"))
            .find("is not conserved") != std::string::npos);
  CHECK(first_line(refusal(with("m y'' = -k y", R"({ y = "1 m", "y'" = 0 })",
                                "conserves = { kinetic = \"m y''\", potential = \"k y\" }\n"))) ==
        "test.toml:12:26: an energy is of the state and the time, and this has a highest rate");
  CHECK(first_line(refusal("title = \"x\"\n[parametres]\n")) ==
        "test.toml:2:2: no key parametres; did you mean 'parameters'?");
  CHECK(refusal("title = \"x\"\n[parameters]\nm = \"2 kgs\"\n").find("no unit 'kgs'") != std::string::npos);
  CHECK(refusal("title = \"x\"\n[parameters]\nm = \"2 kg, 3 to 4\"\n").find("outside its range") !=
        std::string::npos);
  CHECK(refusal("title = [").find("test.toml:1:") == 0);
  CHECK(refusal("") == "test.toml:1:1: no title: add title = \"...\"\n  \n  ^");
  // The caret is below the place of the error.
  std::istringstream shown(refusal_of("y'' = -mg"));
  std::string says, line, caret;
  std::getline(shown, says), std::getline(shown, line), std::getline(shown, caret);
  CHECK(line.substr(caret.find('^'), 2) == "mg");
}

TEST_CASE("A letter that toml++ cannot read outside of quotes is refused with its place", "[problem]") {
  for (const char* letter : {"\xef\xb9\xbf", "\xc2\xa0", "\xe3\x80\x81", "\xd2\x99"}) {
    const std::string said = refusal(std::string("title = \"x\"\n ") + letter);
    CHECK(said.substr(0, said.find('\n')) ==
          "test.toml:2:2: outside of quotes a name has letters from a to z: put quotes around this one");
  }
  const std::string quoted = R"(title = "\"\u00e4" # \" '
question = '''it's an "ä"
ä'''
)";
  CHECK(refusal(quoted + "\n \xc3\xa4 = 1").find("test.toml:5:2: outside of quotes") == 0);
}

TEST_CASE("A text of several lines may end in more quotes", "[problem]") {
  for (const std::string quote : {"\"", "'"})
    for (const std::string& more : {std::string(), quote, quote + quote}) {
      const std::string three = quote + quote + quote;
      CHECK(first_line(refusal("title = { a = " + three + "b" + more + three + ", b = " + quote + "\u00e4" +
                               quote + " }")) == "test.toml:1:9: expected a text, in quotes");
    }
}

TEST_CASE("A name of very many parts is refused in a sentence", "[problem]") {
  const auto dotted = [](int parts) {
    std::string name = "a";
    for (int i = 1; i < parts; ++i) name += ".a";
    return name;
  };
  CHECK(first_line(refusal(dotted(300'000) + " = 1")) == "test.toml:1:514: a name has at most 256 dots");
  CHECK(first_line(refusal("[" + dotted(300'000) + "]")) == "test.toml:1:515: a name has at most 256 dots");
  CHECK(refusal(dotted(200) + " = { " + dotted(100) + " = 1 }").find("at most 256 dots") !=
        std::string::npos);
  CHECK(refusal(dotted(257) + " = 1").find("no key a") != std::string::npos);
  std::string numbers = "a = [0.5";
  for (int i = 0; i < 300; ++i) numbers += ", 0.5";
  CHECK(refusal(numbers + "]").find("no key a") != std::string::npos);
}

TEST_CASE("A name has no control characters, and is not a name of formulas", "[problem]") {
  CHECK(first_line(refusal("title = \"x\"\n[model.\"a\\nb\"]\n")) ==
        "test.toml:2:8: a name is on one line, without control characters");
  for (const char* name : {"t", "pi", "if", "asinh", "arcsin"})
    CHECK(first_line(refusal("title = \"x\"\n[parameters]\n" + std::string(name) + " = \"1 m\"\n")) ==
          "test.toml:3:1: " + std::string(name) + " has a meaning already; take another name");
}

TEST_CASE("A rate whose name has no quotes is refused, with the quotes as the remedy", "[problem]") {
  const std::string said = refusal(with("y'' = -g", "{ y = \"0 m\", y' = 0 }"));
  CHECK(said.substr(0, said.find('\n')) == "test.toml:11:23: a name with a prime is in quotes: \"y'\"");
}

TEST_CASE("A formula's depth and width are limited", "[problem]") {
  const auto repeated = [](const std::string& text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) all += text;
    return all;
  };
  // Repeats a refusal: nothing must be left over from the one before.
  for (int i = 0; i < 40; ++i)
    CHECK(refusal_of("y'' = " + repeated("abs(", 40) + "g" + repeated(")", 40)).find("at most 30 calls") !=
          std::string::npos);
  CHECK(near(rate_of("y'' = " + repeated("abs(", 25) + "g" + repeated(")", 25)), 9.81, 1e-14));
  CHECK(refusal_of("y'' = " + repeated("(", 100) + "g" + repeated(")", 100)).find("at most 60 levels") !=
        std::string::npos);
  CHECK(near(rate_of("y'' = g" + repeated(" + g", 99)), 981, 1e-10));
}

TEST_CASE("Abbreviations of abbreviations are computed once", "[problem]") {
  std::string given = "a0 = \"1 m/s^2\"\n";
  for (int i = 1; i < 18; ++i) {
    const std::string before = "a" + std::to_string(i - 1);
    given += "a" + std::to_string(i) + " = \"(" + before + " + " + before + " + " + before + ")/3\"\n";
  }
  const auto file = read("test.toml", "title = \"x\"\n[parameters]\nm = \"1 kg\"\n[given]\n" + given +
                                          "[model.one]\nequations = [\"y'' = a17\"]\nstart = { y = \"0 m\", "
                                          "\"y'\" = 0 }\n[observe]\ny = \"m\"\n");
  const std::array<double, 2> x{};
  std::array<double, 2> rate{};
  Model(*file, file->models[0]).with({1}).rates.run(x.data(), 0.0, rate.data());
  CHECK(near(rate[1], 1, 1e-14));
}

TEST_CASE("Garbled files are refused or read, and nothing else happens", "[problem]") {
  Random random(52);
  for (const std::string name : {"quarter_car", "double_pendulum", "spring_animation"}) {
    const std::string whole = text_of_example(name);
    REQUIRE_FALSE(whole.empty());
    for (int i = 0; i < 150; ++i) {
      std::string text = whole;
      for (int changes = 1 + random.below(3); changes > 0; --changes) {
        const auto at = static_cast<std::size_t>(random.below(static_cast<int>(text.size())));
        constexpr std::string_view signs = "()=+-*/^'\"{}[],.0 1e9 m\\|\n<\x80";
        const char sign = signs[static_cast<std::size_t>(random.below(static_cast<int>(signs.size())))];
        if (random.unit() < 0.5)
          text[at] = sign;
        else
          text.erase(at, 1 + static_cast<std::size_t>(random.below(4)));
      }
      const std::string said = complaint([&] { entry_of_text("test.toml", text); });
      INFO(said);
      CHECK((said == "nothing" || said.find("test.toml:") == 0));
    }
  }
}

TEST_CASE("A Lagrangian gives the equations that it is written for", "[problem]") {
  const std::string lagrangian = R"(lagrangian = "m/2 (r'^2 + r^2 p'^2) + m g r cos(p) - k/2 (r - L)^2")";
  const auto model = [&](const std::string& equations) {
    return "title = \"x\"\n[parameters]\nm = \"1.3 kg\"\nk = \"40 N/m\"\nL = \"1 m\"\ng = \"9.81 m/s^2\"\n[model.one]\n" +
           lagrangian + "\n" + equations + R"(start = { r = "1.2 L", p = "0.5 rad", "r'" = 0, "p'" = 0 })" +
           "\n[observe]\nr = \"m\"\n";
  };
  const std::string first =
      R"x(equations = ["m r'' = m r p'^2 + m g cos(p) - k (r - L)", "r p'' = -2*r' p' - g sin(p)"])x";
  CHECK(refusal(model(first + "\n")) == "nothing");
  const std::string wrong =
      R"x(equations = ["m r'' = m r p'^2 + m g cos(p) - k (r - L)", "r p'' = -r' p' - g sin(p)"])x";
  CHECK(refusal(model(wrong + "\n")).find("the Lagrangian's p'' is not that of the equations") !=
        std::string::npos);
  CHECK(refusal(model("")) == "nothing");
}

TEST_CASE("A program has the same value in every number type", "[problem]") {
  for (const std::string name :
       {"double_pendulum", "rope", "gyroscope", "cart_and_pole", "orbit_with_drag"}) {
    const auto file = read(name, text_of_example(name));
    const Model model(*file, file->models.back());
    std::vector<double> values;
    for (const ParameterText& p : file->parameters) values.push_back(p.value);
    const Numbers numbers = model.with(values);
    const std::size_t n = numbers.unknowns;
    std::vector<double> x(numbers.start.begin(), numbers.start.end()), rate(n);
    std::vector<long double> in_long(numbers.start), rate_in_long(n);
    for (std::size_t i = 0; i < n; ++i) {
      x[i] += 0.1 * (1 + std::abs(x[i])) * std::sin(static_cast<double>(i + 1));
      in_long[i] = x[i];
    }
    numbers.rates.run(x.data(), 0.3, rate.data());
    numbers.rates.run(in_long.data(), 0.3L, rate_in_long.data());
    for (std::size_t i = 0; i < n; ++i) {
      INFO(name << " " << i);
      CHECK(near(rate[i], static_cast<double>(rate_in_long[i]), 1e-12 * (1 + std::abs(rate[i]))));
    }
  }
}

TEST_CASE("A state is padded with unknowns at rest, which change nothing", "[problem]") {
  // Ten oscillators with the rates 1 to 10, and ten numbers that fall.
  std::string equations, start, falling, from;
  for (int i = 1; i <= 10; ++i) {
    const std::string y = "y" + std::to_string(i), rate = std::to_string(i);
    equations += (i > 1 ? ", " : "") + ("\"" + y) + "'' = -(" + rate + " w)^2 " + y + "\"";
    start += (i > 1 ? ", " : "") + y + " = \"a\", \"" + y + "'\" = 0";
    falling += (i > 1 ? ", " : "") + ("\"" + y) + "' = -" + rate + " w " + y + "\"";
    from += (i > 1 ? ", " : "") + y + " = \"a\"";
  }
  const auto numbers_of = [](const std::string& model) {
    const auto file =
        read("test.toml", "title = \"x\"\n[parameters]\na = \"1\"\nw = \"1 1/s\"\n[model.one]\n" + model +
                              "[observe]\ny3 = \"1\"\n[need]\nerror = \"1\"\n");
    return Model(*file, file->models[0]).with({1.5, 1});
  };
  const std::array<double, 2> times{0, 2};
  const Numbers swinging = numbers_of("equations = [" + equations + "]\nstart = { " + start + " }\n");
  CHECK(swinging.unknowns == 24);
  CHECK(swinging.partitioned);
  const auto swung = by_series(swinging, times).states[1];
  CHECK(near(static_cast<double>(swung[2]), 1.5 * std::cos(6.0), 1e-12));
  CHECK(near(static_cast<double>(swung[12 + 2]), -4.5 * std::sin(6.0), 1e-12));
  CHECK(swung[10] == 0);

  const Numbers fallen = numbers_of("equations = [" + falling + "]\nstart = { " + from + " }\n");
  CHECK(fallen.unknowns == 12);
  CHECK_FALSE(fallen.partitioned);
  CHECK(near(static_cast<double>(by_series(fallen, times).states[1][2]), 1.5 * std::exp(-6.0), 1e-12));
}

TEST_CASE("The true motion of a file is that of the table", "[problem]") {
  const Entry& entry = entry_of_file(pendulum);
  const Reference truth(std::filesystem::path(ODDITY_SOURCE) / "reference");
  for (const double a : {0.5, 1.5, 3.0}) {
    Parameters p(entry.exercise.parameters);
    p.set("a", a);
    const Horizon horizon{10, 20};
    const Quantity seen = motion(*entry.exercise.scene, p, horizon, truth);
    const Known known = trajectory(truth, "03_05_swing", {a, 1, 9.81}, horizon);
    CHECK(seen.reference_error < 1e-13);
    for (std::size_t i = 0; i < known.value.size(); ++i)
      CHECK(near(seen.reference.value[i], known.value[i], seen.reference_error + known.error));
  }
}

TEST_CASE("Both routes to a true motion find the change of a choice", "[problem]") {
  // y'' = -1 above y = 0, +1 below, from y = 1/2 at rest: parabolas of a period of 4, known in closed form.
  const std::string text =
      "title = \"x\"\n[parameters]\nh = \"0.5 m\"\n[model.one]\nequations = [\"y'' = if(y > 0, -1 m/s^2, 1 m/s^2)\"]\n"
      "start = { y = \"h\", \"y'\" = 0 }\n[observe]\ny = \"m\"\n";
  const auto file = read("test.toml", text);
  const Numbers numbers = Model(*file, file->models[0]).with({0.5});
  std::vector<double> times;
  for (int i = 0; i <= 97; ++i) times.push_back(0.37 * i);
  for (const auto route : {by_series, by_extrapolation}) {
    const TrueMotion motion = route(numbers, times);
    CHECK(motion.trouble.empty());
    REQUIRE(motion.states.size() == times.size());
    for (std::size_t i = 0; i < times.size(); ++i) {
      const double t = std::fmod(times[i] + 1, 4), s = t < 2 ? t - 1 : t - 3;
      const double y = (t < 2 ? 1 : -1) * (1 - s * s) / 2;
      CHECK(near(static_cast<double>(motion.states[i][0]), y, 1e-13));
    }
  }
}

namespace {

/// A ball of unit mass above a floor, as a model with these events; g = 1 m/s^2.
std::string ball(const std::string& events, const std::string& more = "") {
  return "title = \"ball\"\n[parameters]\nh = \"0.5 m\"\ne = \"0.5\"\n[model.one]\nequations = [\"y'' = -1 m/s^2\"" +
         more + "]\nstart = { y = \"h\", \"y'\" = 0 }\nevents = [" + events +
         "]\n[observe]\ny = \"m\"\n[need]\nhorizon = \"2 s\"\n";
}
TrueMotion moved(const std::string& text, decltype(by_series)* route, std::span<const double> times) {
  const auto file = read("test.toml", text);
  return route(Model(*file, file->models[0]).with({0.5, 0.5}), times);
}

}  // namespace

TEST_CASE("Both routes to a true motion follow events", "[problem]") {
  // From a height of 1/2 it lands at t = 1 with a speed of 1, then flies for 2 e, 2 e^2, ...
  std::vector<double> times;
  for (int i = 0; i <= 58; ++i) times.push_back(0.05 * i);
  const auto height = [](double t) {
    double speed = 1, since = t - 1;
    if (since < 0) return (1 - t * t) / 2;
    for (speed /= 2; since > 2 * speed; speed /= 2) since -= 2 * speed;
    return since * (speed - since / 2);
  };
  for (const auto route : {by_series, by_extrapolation}) {
    const TrueMotion bounces =
        moved(ball(R"({ when = "y", then = { y = "0 m", "y'" = "-e y'" } })"), route, times);
    CHECK(bounces.trouble.empty());
    REQUIRE(bounces.states.size() == times.size());
    for (std::size_t i = 0; i < times.size(); ++i)
      CHECK(near(static_cast<double>(bounces.states[i][0]), height(times[i]), 1e-14));

    const TrueMotion lands = moved(ball(R"({ when = "y", ends = true })"), route, times);
    REQUIRE(lands.states.size() == times.size());
    CHECK(near(static_cast<double>(lands.states.back()[0]), 0, 1e-15));
    CHECK(near(static_cast<double>(lands.states.back()[1]), -1, 1e-15));

    // Set back to the top each time, it keeps its speed: a fall from 1/2 to 0 that goes on.
    const TrueMotion wraps = moved(ball(R"({ when = "y", then = { y = "h" } })"), route, times);
    REQUIRE(wraps.states.size() == times.size());
    for (std::size_t i = 0; i < times.size(); ++i) {
      const double fallen = times[i] * times[i] / 2;
      const double y = 0.5 - std::fmod(fallen, 0.5);
      if (std::abs(y - 0.5) > 1e-9) CHECK(near(static_cast<double>(wraps.states[i][0]), y, 1e-13));
    }

    const TrueMotion rests =
        moved(ball(R"({ when = "y", then = { y = "0 m", "y'" = "-e y'" } })"), route, std::array{0.0, 4.0});
    CHECK(rests.trouble.find("events follow each other without end") != std::string::npos);
    CHECK(rests.trouble.find("ends at 3:") != std::string::npos);
  }
}

TEST_CASE("An event that does not change its guard happens once for each fall of the guard", "[problem]") {
  // a counts the passages of a pendulum-like swing y'' = -y through zero: both ways, or upwards alone
  const auto counted = [](const std::string& direction, decltype(by_series)* route) {
    const std::string text =
        "title = \"x\"\n[parameters]\nh = \"1 m\"\n[model.one]\nequations = [\"y'' = -y/(1 s^2)\", \"a' = 0 m/s\"]\n"
        "start = { y = \"h\", \"y'\" = 0, a = \"0 m\" }\nevents = [{ when = \"y\", direction = \"" +
        direction + "\", then = { a = \"a + 1 m\" } }]\n[observe]\ny = \"m\"\na = \"m\"\n";
    const auto file = read("test.toml", text);
    const std::array times{0.0, 20.0};  // 20 = 6.37 half periods
    const TrueMotion motion = route(Model(*file, file->models[0]).with({1}), times);
    CHECK(motion.trouble.empty());
    CHECK(near(static_cast<double>(motion.states.back()[0]), std::cos(20.0), 1e-14));
    return static_cast<double>(motion.states.back()[1]);  // unknowns come first
  };
  for (const auto route : {by_series, by_extrapolation}) {
    CHECK(counted("both", route) == 6);
    CHECK(counted("rising", route) == 3);
    CHECK(counted("falling", route) == 3);
  }
}

namespace {

/// The ball above, with a count of its landings, as another kind of model.
std::string counted_ball(const std::string& model, const std::string& more = "") {
  return "title = \"ball\"\n[parameters]\nh = \"0.5 m\"\ne = \"0.5\"\n[model.one]\n" + model +
         "\n[observe]\ny = \"m\"\nlandings = \"1\"\n[need]\nerror = [\"1 mm\", \"0.5\"]\nhorizon = \"2.6 s\"\n" +
         more;
}
const std::string falls = "equations = [\"y'' = -1 m/s^2\"]\nstart = { y = \"h\", \"y'\" = 0 }\n";
const std::string lands =
    R"(events = [{ when = "y", then = { y = "0 m", "y'" = "-e y'" }, counts = "landings" }])";

}  // namespace

TEST_CASE("A letter counts an event in every kind of model", "[problem]") {
  const std::string by_lagrangian =
      "lagrangian = \"1 kg/2 y'^2 - 1 N y\"\nstart = { y = \"h\", \"y'\" = 0 }\n" + lands;
  const std::string by_hamiltonian =
      "hamiltonian = \"p^2/(2*1 kg) + 1 N y\"\nmomenta = { y = \"p\" }\nstart = { y = \"h\", p = \"0 kg m/s\" }\n"
      R"(events = [{ when = "y", then = { y = "0 m", p = "-e p" }, counts = "landings" }])";
  const std::vector<double> times{0, 0.9, 1.1, 1.9, 2.1, 2.4, 2.6};  // it lands at 1, 2, 2.5, 2.75
  const std::vector<long double> landings{0, 0, 1, 1, 2, 2, 3};
  for (const std::string& model : {falls + lands, by_lagrangian, by_hamiltonian})
    for (const auto route : {by_series, by_extrapolation}) {
      INFO(model);
      const auto file = read("test.toml", counted_ball(model));
      const Numbers numbers = Model(*file, file->models[0]).with({0.5, 0.5});
      CHECK(numbers.partitioned == (model != by_hamiltonian));
      const TrueMotion motion = route(numbers, times);
      REQUIRE(motion.states.size() == times.size());
      for (std::size_t i = 0; i < times.size(); ++i) {
        std::array<long double, 2> seen{};
        numbers.observed.run(motion.states[i].data(), static_cast<long double>(times[i]), seen.data());
        CHECK(seen[1] == landings[i]);
      }
    }
}

TEST_CASE("A method counts an event, which need have no other consequence", "[problem]") {
  // Downwards through h/2 on each flight but those that are too low; a count drives nothing.
  const std::string half = R"({ when = "y - h/2", counts = "landings" })";
  const auto counted = [](const std::string& text, const std::string& algorithm) {
    const Entry& entry = entry_of_text("test.toml", text);
    const Quantity seen = motion(*entry.exercise.scene, Parameters(entry.exercise.parameters), {2.4, 1, 10},
                                 Reference::nothing());
    const Value value = run(seen, *method_of(seen, "one", algorithm), 1.0 / 64).answer.value;
    std::vector<double> counts;
    for (std::size_t i = 1; i < value.size(); i += 2) counts.push_back(value[i]);
    return counts;
  };
  for (const std::string algorithm : {"Runge-Kutta 4", "velocity Verlet"}) {
    const auto landings = counted(counted_ball(falls + lands), algorithm);
    REQUIRE(landings.size() == 24);
    CHECK(landings[8] == 0);   // at 0.9 s
    CHECK(landings[10] == 1);  // at 1.1 s
    CHECK(landings.back() == 2);
    const auto passages = counted(counted_ball(falls + "events = [" + half + "]\n"), algorithm);
    CHECK(passages[6] == 0);  // at 0.7 s; it is at h/2 after 0.707 s
    CHECK(passages[7] == 1);
    CHECK(passages.back() == 1);
  }
  // both events, in one count; and a count that an event's formula uses
  const auto both =
      counted(counted_ball(falls + lands.substr(0, lands.size() - 1) + ", " + half + "]\n"), "Runge-Kutta 4");
  CHECK(both.back() == 3);
  const std::string twice =
      R"toml(events = [{ when = "y", then = { "y'" = "if(landings < 1, -y', 0)" }, counts = "landings" }])toml";
  CHECK(counted(counted_ball(falls + twice), "Runge-Kutta 4")[20] == 1);
}

TEST_CASE("An error without a unit is that of pure numbers, where others have one", "[problem][commands]") {
  const ScratchFolder scratch;
  const std::string file = scratch.file("counted.toml", counted_ball(falls + lands)).string();
  // No frame is at a landing, where a count is not known.
  CHECK(program::printed("choose " + file + " h=0.47m").status == 0);
  CHECK(program::printed("choose " + file + " h=0.47m --error 1cm,0.5").status == 0);
  const auto refused = program::run("choose " + file + " h=0.47m --error 1cm");
  CHECK(refused.status == 2);
  CHECK(program::says(refused, "and none is given in 1"));
}

TEST_CASE("A count that cannot be is refused with its place", "[problem]") {
  const auto says = [](const std::string& model) { return first_line(refusal(counted_ball(model))); };
  CHECK(says(falls + R"(events = [{ when = "y", counts = "y" }])") ==
        "test.toml:8:35: y has a start: a count needs another name");
  CHECK(says(falls + R"(events = [{ when = "y", counts = "h" }])") ==
        "test.toml:8:35: h is no unknown: it is a parameter, an abbreviation or the time");
  CHECK(says(falls + R"(events = [{ when = "y", counts = "a b" }])") ==
        "test.toml:8:35: a letter's name has letters, digits and _, and is 'a b'");
  CHECK(says(falls + R"(events = [{ when = "y", then = { landings = 2 }, counts = "landings" }])") ==
        "test.toml:8:34: landings counts events, and nothing else changes it");
  std::string in_metres = counted_ball(falls + lands);
  in_metres.replace(in_metres.find("landings = \"1\""), 14, "landings = \"m\"");
  CHECK(refusal(in_metres).find("landings counts events: observe it as a pure number") != std::string::npos);
  CHECK(refusal(counted_ball(falls)).find("no letter landings") != std::string::npos);
}

namespace {

std::string on_a_rod(const std::string& old = "", const std::string& now = "") {
  std::string text = text_of(folder / "pendulum_on_a_rod.toml");
  if (const auto at = text.find(old); !old.empty()) text.replace(at, old.size(), now);
  return text;
}

}  // namespace

TEST_CASE("A constraint gives the motion that an angle has", "[problem]") {
  const std::string file = (folder / "pendulum_on_a_rod.toml").string();
  const Entry& entry = entry_of_file(file);
  const Quantity seen =
      motion(*entry.exercise.scene, Parameters(entry.exercise.parameters), {2}, Reference::nothing());
  const Method &angle = *method_of(seen, "angle", "Dormand-Prince 5(4)"),
               &held = *method_of(seen, "Cartesian with a constraint", "Dormand-Prince 5(4)");
  const Trial one = run(seen, angle, 1e-10), other = run(seen, held, 1e-10);
  REQUIRE(one.answer.value.size() == other.answer.value.size());
  for (std::size_t i = 0; i < one.answer.value.size(); ++i)
    CHECK(near(one.answer.value[i], other.answer.value[i], 1e-8));
}

TEST_CASE("Constraints hold a bead on a rotating hoop, also where one of its coordinates is zero",
          "[problem]") {
  const std::string text = R"toml(title = "x"
[parameters]
R = "10 cm"
w = "100 rpm"
m = "10 g"
a = "20 deg"
[model.angle]
lagrangian = "m R^2/2 (p'^2 + w^2 sin(p)^2) + m 9.81 m/s^2 R cos(p)"
start = { p = "a", "p'" = 0 }
observe = { x = "R sin(p) cos(w t)", y = "R sin(p) sin(w t)", z = "-R cos(p)" }
[model.held]
lagrangian = "m/2 (x'^2 + y'^2 + z'^2) - m 9.81 m/s^2 z"
constraints = ["x^2 + y^2 + z^2 = R^2", "y cos(w t) = x sin(w t)"]
start = { x = "R sin(a)", y = "0 m", z = "-R cos(a)", "x'" = 0, "y'" = "w R sin(a)", "z'" = 0 }
[observe]
x = "m"
y = "m"
z = "m"
)toml";
  const auto file = read("test.toml", text);
  std::vector<double> times;
  for (int i = 0; i <= 20; ++i) times.push_back(0.1 * i);
  const std::vector<double> values{10, 100, 10, 20};
  const Numbers angle = Model(*file, file->models[0]).with(values),
                held = Model(*file, file->models[1]).with(values);
  const TrueMotion one = by_series(angle, times), other = by_extrapolation(held, times);
  CHECK(one.trouble.empty());
  REQUIRE(other.trouble.empty());
  for (std::size_t i = 0; i < times.size(); ++i) {
    std::array<long double, 3> here{}, there{};
    angle.observed.run(one.states[i].data(), static_cast<long double>(times[i]), here.data());
    held.observed.run(other.states[i].data(), static_cast<long double>(times[i]), there.data());
    for (std::size_t k = 0; k < 3; ++k) CHECK(std::abs(here[k] - there[k]) < 1e-13L);
  }
}

TEST_CASE("How far a model leaves its constraint is the visible distance", "[problem]") {
  const std::string file = (folder / "pendulum_on_a_rod.toml").string();
  const Entry& entry = entry_of_file(file);
  const Quantity seen =
      motion(*entry.exercise.scene, Parameters(entry.exercise.parameters), {2}, Reference::nothing());
  const Method& held = *method_of(seen, "Cartesian with a constraint", "explicit Euler");
  REQUIRE(held.off_constraint);
  CHECK_FALSE(method_of(seen, "angle", "explicit Euler")->off_constraint);
  const Value value = run(seen, held, 1.0 / 64).answer.value;
  double most = 0;
  for (std::size_t i = 0; i < value.size(); i += 2) {
    const double r = std::hypot(value[i], value[i + 1]);
    most = std::max(most, std::abs(r * r - 1) / (2 * r));
  }
  CHECK(most > 0.01);
  CHECK(near(held.off_constraint(1.0 / 64), most, 1e-12));
}

TEST_CASE("An impossible constraint is refused with its place", "[problem]") {
  const auto says = [](const std::string& old, const std::string& now, const std::string& why) {
    INFO(now);
    const std::string said = refusal(on_a_rod(old, now));
    INFO(said);
    CHECK(said.find(why) != std::string::npos);
    CHECK(said.find("test.toml:") == 0);
  };
  says("x = \"L sin(a)\", y", "x = \"1.01 L sin(a)\", y", "the start is off constraint 1 by");
  says("\"x'\" = 0, \"y'\"", "\"x'\" = \"1 m/s\", \"y'\"", "the start moves off constraint 1 by");
  says("x^2 + y^2 = L^2", "x'^2 + y^2 = L^2", "a constraint is of places");
  says("x^2 + y^2 = L^2", "x^2 + y^2 = L", "the left side is m^2, and the right side m");
  says("x^2 + y^2 = L^2\"", "x^2 + y^2 = L^2\", \"2 x^2 + 2 y^2 = 2 L^2\"", "leave 2 unknowns no motion");
  // a repeated one, with a third unknown
  const std::string twice = refusal(R"toml(title = "x"
[parameters]
L = "1 m"
[model.a]
lagrangian = "1 kg/2 (x'^2 + y'^2 + z'^2)"
constraints = ["x^2 + y^2 = L^2", "2 x^2 + 2 y^2 = 2 L^2"]
start = { x = "L", y = "0 m", z = "0 m", "x'" = 0, "y'" = "1 m/s", "z'" = 0 }
[observe]
x = "m"
)toml");
  CHECK(twice.find("the matrix is singular") != std::string::npos);
  says("lagrangian = \"m/2 (x'", "equations = [\"x''=0\"]#", "constraints go with a lagrangian");
}

TEST_CASE("A file's model in float differs by roundings only", "[problem]") {
  for (const std::string name : {"quarter_car.toml", "elastic_pendulum.toml", "spring_animation.toml"}) {
    INFO(name);
    const std::string file = (folder / name).string();
    const Entry& entry = entry_of_file(file);
    const Quantity seen =
        motion(*entry.exercise.scene, Parameters(entry.exercise.parameters), {1}, Reference::nothing());
    int compared = 0;
    for (const Method& single : seen.methods_in_float) {
      if (single.algorithm != in_float("Runge-Kutta 4")) continue;
      const double step = single.resolution.settings.back();
      const Value one = run(seen, single, step).answer.value,
                  two = run(seen, *method_of(seen, single.model, "Runge-Kutta 4"), step).answer.value;
      double most = 0;
      for (std::size_t i = 0; i < one.size(); ++i) most = std::max(most, std::abs(one[i] - two[i]));
      CHECK(most > 0);
      CHECK(most <= single.roundings(step));
      ++compared;
    }
    CHECK(compared > 0);
  }
}

namespace {

/// Printed code of a file's model, or the reason why it cannot be printed.
std::string code_of_text(const std::string& text) {
  const std::string name = "test.toml";
  const Entry& entry = entry_of_text(name, text);
  const Listing& listing = entry.exercise.scene->listing;
  if (listing.models.empty()) return std::string(listing.not_printable.front().second);
  return listing.text(Parameters(entry.exercise.parameters), listing.models.front().first);
}

}  // namespace

TEST_CASE("Printed numbers are never whole numbers, which C++ would divide without a remainder",
          "[problem][code]") {
  const std::string code = code_of_text(with("m y'' = -k y + if(t < 1 s, 1, 0) 1 N/2"));
  INFO(code);
  CHECK(code.find("? 1.0 : 0.0) / 2.0") != std::string::npos);
}

TEST_CASE("A letter or a model whose name has a meaning in C++ does no harm", "[problem][code]") {
  const auto renamed = [](std::string text, const std::string& letter, const std::string& now) {
    for (auto at = text.find(letter); at != std::string::npos; at = text.find(letter, at + now.size()))
      text.replace(at, letter.size(), now);
    return text;
  };
  const std::string text = with("m y'' = -k y");
  CHECK(code_of_text(renamed(text, "k ", "M_E ")) == "as C++ has another meaning for the letter M_E");
  CHECK(code_of_text(renamed(text, "k ", "observe ")) == "as C++ has another meaning for the letter observe");
  CHECK(code_of_text(renamed(text, "model.one", "model.state")).find("struct ModelState {") !=
        std::string::npos);
}

TEST_CASE("A text at the end of a comment does not change the code below", "[problem][code]") {
  const auto renamed = [](const std::string& title) {
    std::string text = with("m y'' = -k y");
    return text.replace(text.find("title = "), text.find('\n'), "title = \"x " + title + '"');
  };
  const std::string plain = code_of_text(renamed("z"));
  const std::string code = plain.substr(plain.find("struct "));
  for (const char* end : {"\\\\", "\\\\ \\t ", "\\r int i;", "\\n int i;", "\\u007f", "\\\\\\n"}) {
    const std::string its = code_of_text(renamed(end));
    INFO(its);
    CHECK(its.substr(its.find("struct ")) == code);
    std::istringstream lines(its.substr(0, its.find("struct ")));
    for (std::string line; std::getline(lines, line);) {
      CHECK((line.empty() || line.starts_with("//") || line.starts_with("namespace")));
      CHECK((line.empty() || (line.back() != '\\' && line.back() != ' ')));
      CHECK(std::ranges::none_of(line, is_control));
    }
  }
}

TEST_CASE("A printed program has the observables' names in its head as text alone",
          "[problem][code][commands]") {
  const ScratchFolder scratch;
  std::string text = with("m y'' = -k y");
  const auto at = text.find("\ny = \"m\"");
  REQUIRE(at != std::string::npos);
  text.replace(at, 9, "\n'y\"); %n$frames\\' = { unit = \"m\", is = \"y\" }");
  const auto printed =
      program::printed("choose " + scratch.file("mine.toml", text).string() + " --error 1cm --code");
  CHECK(program::says(printed, "printf(\"t [s],y_); _n_frames_\\n\")"));
}

TEST_CASE("An error in an event is reported with its place", "[problem]") {
  CHECK(refusal(ball(R"({ when = "y" })")).find("nothing happens in this event") != std::string::npos);
  CHECK(refusal(ball(R"({ then = { y = "0 m" } })")).find("goes through zero: when") != std::string::npos);
  CHECK(refusal(ball(R"({ when = "y", then = { y = "0 s" } })")).find("y is in m, and this is s") !=
        std::string::npos);
  CHECK(refusal(ball(R"({ when = "y''", ends = true })")).find("this has a highest rate") !=
        std::string::npos);
  CHECK(refusal(ball(R"({ when = "y", then = { "y''" = "0 m/s^2" } })")).find("is no part of the state") !=
        std::string::npos);
  CHECK(refusal(ball(R"({ when = "y", then = { z = "0 m" } })")).find("no unknown z") != std::string::npos);
  CHECK(refusal(ball(R"({ when = "y", ends = "true" })")).find("true or false") != std::string::npos);
  CHECK(refusal(ball(R"({ when = "y", ends = true, direction = "down" })")).find("falling, rising or both") !=
        std::string::npos);
  CHECK(refusal(ball(R"("y")")).find("events are tables") != std::string::npos);
}

TEST_CASE("A motion that ends is reported to end", "[problem]") {
  const std::string text =
      "title = \"x\"\n[parameters]\nv = \"1 m\"\n[model.one]\nequations = [\"y' = y^2/(1 m s)\"]\n"
      "start = { y = \"v\" }\n[observe]\ny = \"m\"\n";
  const std::string name = "test.toml";
  const Entry& entry = entry_of_text(name, text);
  const Reference truth(std::filesystem::path(ODDITY_SOURCE) / "reference");
  const std::string said = complaint([&] {
    motion(*entry.exercise.scene, Parameters(entry.exercise.parameters), {2, 8}, truth);
  });
  CHECK(said.find("the true motion ends at 1") != std::string::npos);
}

TEST_CASE("The pendulum's file has the energy of 3.5", "[problem]") {
  const Entry& own = entry_of_file(pendulum);
  const Entry& book = *std::ranges::find(registry(), exercise_number("3.5"), &Entry::number);
  Parameters mine(own.exercise.parameters), theirs(book.exercise.parameters);
  for (const double L : {1.0, 1.7}) {
    mine.set("L", L), theirs.set("L", L);
    std::vector<double> change;
    for (const std::vector<double>& x : {std::vector{0.3, 1.0}, std::vector{-1.2, 0.4}}) {
      const Energy one = own.exercise.scene->laws.energy(mine, x),
                   two = book.exercise.scene->laws.energy(theirs, x);
      CHECK(near(one.kinetic * L, two.kinetic, 1e-12));  // the file's is over the length
      change.push_back(one.whole * L - two.whole);
    }
    CHECK(near(change[0], change[1], 1e-12));
  }
}

// ---- the examples
// -------------------------------------------------------------------------------------------

namespace {

/// "# Answer: MODEL, ALGORITHM, SETTING: errs by ERROR UNIT."
struct Answered {
  std::string model, algorithm;
  double setting = 0, error = 0;
};
std::vector<Answered> answers_of(const std::string& text) {
  std::vector<Answered> all;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::string begin = "# Answer: ";
    if (!line.starts_with(begin)) continue;
    REQUIRE(line.back() == '.');
    line.pop_back();
    line.erase(0, begin.size());
    const auto first = line.find(", "), second = line.find(", ", first + 2), third = line.find(": errs by ");
    REQUIRE((first < second && second < third && third != std::string::npos));
    const std::string setting = line.substr(second + 2, third - second - 2);
    const double whole =
        setting.starts_with("1/") ? 1 / *parse_number(setting.substr(2)) : *parse_number(setting);
    const std::string error = line.substr(third + 10);
    all.push_back({line.substr(0, first), line.substr(first + 2, second - first - 2), whole,
                   *parse_number(error.substr(0, error.find(' ')))});
  }
  return all;
}

}  // namespace

TEST_CASE("Each example's stated answers are true", "[problem]") {
  const Reference truth(std::filesystem::path(ODDITY_SOURCE) / "reference");
  int examples = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    if (file.path().extension() != ".toml") continue;
    ++examples;
    const std::string text = text_of(file.path());
    const std::string name = file.path().filename().string();
    const Entry& entry = entry_of_text(name, text);
    if (!entry.exercise.scene) {
      INFO(name);
      const Findings found = entry.exercise.study(Parameters(entry.exercise.parameters), truth);
      CHECK(found.claims.size() >= 2);
      for (const Claim& claim : found.claims)
        CHECK(text.find("# Answer: " + claim.id.substr(claim.id.find('-') + 1) + ": " +
                        std::string(name_of(verdict(claim))) + ".\n") != std::string::npos);
      continue;
    }
    const Asked asked = asked_by(entry);
    const Scene& scene = *entry.exercise.scene;
    const double rate = *parse_number(asked.frames_per_second.substr(0, asked.frames_per_second.find(' '))) /
                        (asked.frames_per_second.ends_with("min") ? 60 : 1);
    const Quantity seen =
        motion(scene, Parameters(entry.exercise.parameters), {scene.horizon, 1, rate}, truth);
    INFO(file.path().string());
    CHECK(seen.reference_error < 1e-6 * *std::ranges::min_element(seen.needs));
    const auto answers = answers_of(text);
    CHECK(answers.size() >= 2);
    bool holds = false, fails = false;
    for (const Answered& one : answers) {
      const Method* method = method_of(seen, one.model, one.algorithm);
      INFO(one.model << ", " << one.algorithm << ", " << one.setting);
      REQUIRE(method != nullptr);
      const Trial trial = run(seen, *method, one.setting);
      CHECK(format_significant(trial.error, 2) == format_significant(one.error, 2));
      (trial.in_needs <= 1 ? holds : fails) = true;
    }
    CHECK(holds);
    CHECK(fails);
  }
  CHECK(examples >= 10);
}

TEST_CASE("The file written by new runs unchanged", "[problem]") {
  CHECK(refusal(std::string(begun)) == "nothing");
}

TEST_CASE("The program accepts a file's name in place of an exercise", "[problem][commands]") {
  const ScratchFolder scratch;
  const std::string file = (scratch.path() / "mine.toml").string();
  const auto made = program::run("new " + file);
  CHECK(made.status == 0);
  CHECK(program::run("new " + file).status == 2);
  const auto chosen = program::printed("choose " + file);
  CHECK(chosen.status == 0);
  CHECK(program::says(chosen, "spring and friction by"));
  CHECK(program::printed("choose " + file + " k=60N/m --error 1cm --horizon 3s").status == 0);
  CHECK(program::printed("choose - < " + file).output.find("spring and friction by") != std::string::npos);
  const auto trials = program::printed("solve " + file + " --csv");
  CHECK(trials.status == 0);
  CHECK(program::says(trials, "mine,motion"));
  CHECK(program::printed("stability " + file + " --csv --horizon 5s").status == 0);
  CHECK(program::printed("chart " + file + " --csv").status == 0);
  const std::string wrong = scratch.file("wrong.toml", with("y'' = -g + y'")).string();
  const auto refused = program::run("chart " + wrong + " --out " + (scratch.path() / "charts").string());
  CHECK(refused.status == 2);
  CHECK(program::says(refused, "wrong.toml:10:26: m/s^2 and m/s do not add up"));
  CHECK_FALSE(std::filesystem::exists(scratch.path() / "charts"));
  CHECK(program::run("choose nowhere.toml").status == 2);
  CHECK(program::run("sweep plan " + (scratch.path() / "map").string() + " " + file + " --over k=10..50:10")
            .status == 0);
}

TEST_CASE("Only a regular file of limited size is read, without waiting", "[problem][commands]") {
  const ScratchFolder scratch;
  const auto refused = [&](const std::string& name, const std::string& why) {
    const auto ended = program::run("choose " + name);
    CHECK(ended.status == 2);
    CHECK(program::says(ended, why));
  };
  const std::string pipe = (scratch.path() / "pipe.toml").string();
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  refused(pipe, "pipe.toml");
  std::filesystem::create_directory(scratch.path() / "folder.toml");
  refused((scratch.path() / "folder.toml").string(), "folder.toml");
  std::filesystem::create_symlink("/dev/zero", scratch.path() / "zero.toml");
  refused((scratch.path() / "zero.toml").string(), "zero.toml");
  refused(scratch.file("large.toml", std::string(most_of_a_file + 1, '#')).string(), "large.toml");
  refused((scratch.path() / "missing.toml").string(), "missing.toml");
  refused("- </dev/zero", "standard input: a problem's file has at most a megabyte");
}

TEST_CASE("site writes a file's page where the words of the command name it", "[problem][commands]") {
  const ScratchFolder scratch;
  const std::string home = scratch.path().string(), own = home + "/.cache/oddity/site";
  const auto in_scratch = [&](const std::string& words) {
    return program::shell("cd " + home + " && HOME=" + home + " XDG_CACHE_HOME= ./oddity --reference " +
                          ODDITY_SOURCE + "/reference " + words);
  };
  REQUIRE(program::shell("cp $oddity " + home + "/oddity").status == 0);
  scratch.file("mine.toml", with("y'' = -g"));
  scratch.file("...toml", with("y'' = -g"));
  const auto refused = in_scratch("site ''");
  CHECK(refused.status == 2);
  CHECK(program::says(refused, "file: it needs a problem's file"));
  CHECK_FALSE(std::filesystem::exists(own));
  CHECK(in_scratch("site mine.toml --out " + own).status == 0);
  CHECK(std::filesystem::exists(own + "/index.html"));
  CHECK_FALSE(std::filesystem::exists(scratch.path() / "mine"));
  CHECK(in_scratch("site ...toml").status == 0);
  CHECK(std::filesystem::exists(scratch.path() / "input" / "index.html"));
  CHECK(in_scratch("site --single ...toml").status == 0);
  CHECK(std::filesystem::exists(scratch.path() / "input.html"));
}

TEST_CASE("site writes nothing for a file that is refused", "[problem][commands]") {
  const ScratchFolder scratch;
  const auto refuse = [&](const std::string& name, const std::string& text) {
    const std::string file = scratch.file(name, text).string();
    const std::string out = (scratch.path() / "new" / "pages").string();
    CHECK(program::run("choose " + file).status == 2);
    CHECK(program::run("site " + file + " --out " + out).status == 2);
    CHECK(program::run("site --single " + file + " --out " + out + "/page.html").status == 2);
    CHECK_FALSE(std::filesystem::exists(scratch.path() / "new"));
  };
  refuse("wrong.toml", with("y'' = -q"));
  refuse("ends.toml", with("y'' = g y^2/(1 m)^2"));
}
