// XPPAUT's .ode files: how they are read, and that unsupported features are refused with their place.

#include <array>
#include <cmath>
#include <numbers>

#include "chapters/random.hpp"
#include "chapters/scene.hpp"
#include "problem/model.hpp"
#include "problem/ode_file.hpp"
#include "problem/scene.hpp"
#include "problem/truth.hpp"
#include "report/study/run.hpp"
#include "report/verify/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/near.hpp"
#include "tests/program.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;
using namespace oddity::problem;

namespace {

std::string refusal(const std::string& text) {
  const std::string said = complaint([&] { entry_of_text("test.ode", text); });
  return said.substr(0, said.find('\n'));
}

Numbers numbers_of(const std::string& text) {
  const auto file = read_ode("test.ode", text);
  std::vector<double> values;
  for (const ParameterText& p : file->parameters) values.push_back(p.value);
  return Model(*file, file->models[0]).with(values);
}

/// The rate of x at the start, or at another time.
double rate_of(const std::string& statements, double t = 0) {
  const Numbers numbers = numbers_of(statements);
  std::vector<double> x(numbers.start.begin(), numbers.start.end()), rates(x.size());
  numbers.rates.run(x.data(), t, rates.data());
  return rates[0];
}
/// The value of a formula at x = 1.5, with the parameters a = 2, b = -3.
double value_of(const std::string& formula) {
  return rate_of("x'=" + formula + "\ninit x=1.5\npar a=2,b=-3");
}

/// The state at a time, on which both routes to a true motion must agree.
std::vector<long double> state_at(const Numbers& numbers, double t) {
  const std::array<double, 2> times{0, t};
  const TrueMotion one = by_series(numbers, times), other = by_extrapolation(numbers, times);
  INFO(one.trouble << other.trouble);
  REQUIRE((one.trouble + other.trouble).empty());
  for (std::size_t i = 0; i < numbers.unknowns; ++i)
    CHECK(near(static_cast<double>(one.states[1][i]), static_cast<double>(other.states[1][i]), 1e-12));
  return one.states[1];
}

const std::string pendulum =
    "# a pendulum\nX'=v\ndv/dt = -K*sin(X) \\\n  - c*v\npar k=10 c=.1\ninit x=1\naux energy=v^2/2\n"
    "@ total=5,dt=.1\ndone\nwhat follows is not read";

}  // namespace

TEST_CASE("Formulas have the same value as in xppaut", "[problem][ode-files]") {
  // Observed in xppaut 6.11.
  CHECK(value_of("-2^2") == -4);
  CHECK(value_of("2^3^2") == 64);
  CHECK(value_of("8/4/2-3-4") == -6);
  CHECK(value_of("2**3+.5e1") == 13);
  CHECK(near(value_of("mod(-1,3)"), 2, 1e-15));
  CHECK(near(value_of("mod(7.25,a)"), 1.25, 1e-15));
  CHECK(near(value_of("flr(-1.5)"), -2, 1e-15));
  CHECK(near(value_of("ceil(1.2)"), 2, 1e-15));
  CHECK(value_of("heav(0)+10*sign(0)+100*heav(-x)") == 1);
  CHECK(value_of("if(1<a&a<3)then(5)else(6)") == 5);
  CHECK(value_of("if(a<1|not(x>2))then(5)else(6)") == 5);
  CHECK(value_of("3*2<7") == 3);  // a comparison binds like a power
  CHECK(value_of("1<2+3") == 4);
  CHECK(value_of("-1<2") == -1);
  CHECK(value_of("5>3>2") == 0);
  CHECK(value_of("x&2*3") == 3);
  CHECK(value_of("(x==1.5)+10*(x!=1.5)+100*(a<=2)+1000*(a>=2)") == 1101);
  CHECK(value_of("2*if(1<2)then(3)else(4)+1") == 7);
  CHECK(value_of("if(heav(x-1)<2)then(3)else(4)") == 3);
  CHECK(value_of("sum(1,3)of(i'*i')") == 14);
  CHECK(near(value_of("log(2)+ln(2)+log10(2)"), 2 * std::log(2) + std::log10(2), 1e-15));
  CHECK(near(value_of("atan2(1,-1)+max(a,b)-min(a,b)+abs(b)+PI"), 1.75 * std::numbers::pi + 8, 1e-14));
  CHECK(value_of("b^2+(x+b)^a") == 9 + 2.25);
  CHECK(std::isnan(value_of("b^a")));
  CHECK(near(value_of("x^1.5"), std::pow(1.5, 1.5), 1e-15));
  CHECK(near(value_of("x^(-1.5)"), std::pow(1.5, -1.5), 1e-15));
  CHECK(near(value_of("exp(-x^2)*tanh(x)"), std::exp(-2.25) * std::tanh(1.5), 1e-15));
}

TEST_CASE("Names in a file are read in any case and order", "[problem][ode-files]") {
  CHECK(near(rate_of("x'=f(x,Q)\nf(u,a)=u*a+g(a)\ng(x)=x+B\nq=2*b\n!b=c/4\nnumber c=12\ninit X=5"),
             5 * 6 + 6 + 3, 1e-15));
  CHECK(rate_of("x'=T\n@ t0=3", 2) == 5);
  CHECK(rate_of("x(0)=4\ndx/dt=x*p\nnumber p=-1.5") == -6);
  // A function's letters are local.
  CHECK(rate_of("x'=f(2)\nf(x)=g(3)\ng(u)=x+u\ninit x=10") == 13);
  // x[1..3]' are three equations; [j] is a number, or the end of a name.
  const std::string chain =
      "x0'=0\n%[1..2]\nx[j]'=x[j-1]+[j]+k[j]\ny[j]'=0\n%\nx3'=sum(0,2)of(shift(x0,i'))\nk[1..2]=[j]*10\ninit x[0..2]=7";
  const Numbers numbers = numbers_of(chain);
  REQUIRE(numbers.unknowns == 6);
  std::vector<double> x(numbers.start.begin(), numbers.start.end()), rates(6);
  numbers.rates.run(x.data(), 0.0, rates.data());
  CHECK(rates == std::vector<double>{0, 18, 0, 29, 0, 7 + 7 + 0});  // shift follows the equations' order
  const auto file = read_ode("folder/test.ode", pendulum);
  CHECK(file->title == "a pendulum");
  CHECK(file->parameters.size() == 4);
  CHECK(file->parameters[2].name == "x_0");
  CHECK((file->horizon == "5" && file->frames_per_second == "10"));
}

TEST_CASE("Unsupported features are refused with their place", "[problem][ode-files]") {
  CHECK(refusal("x'=-delay(x,2)") == "test.ode:1:5: there are no delays here");
  CHECK(refusal("x'=w\nwiener w") == "test.ode:2:1: there are no random numbers here");
  CHECK(refusal("x'=ran(1)") == "test.ode:1:4: there are no random numbers here");
  CHECK(refusal("markov z 2\n{0} {1}\n{1} {0}") == "test.ode:1:1: there are no random numbers here");
  CHECK(refusal("u(t)=1+int{exp(-t)#u}") == "test.ode:1:8: there are no integral equations here");
  CHECK(refusal("u(t)=1-int[.5]{u}") == "test.ode:1:8: there are no integral equations here");
  CHECK(refusal("x'=1\nbndry x-1") == "test.ode:2:1: there are no boundary values here");
  CHECK(refusal("x(t+1)=x/2") == "test.ode:1:1: there are no maps here, whose time goes in steps");
  CHECK(refusal("x'=x/2\n@ meth=discrete") ==
        "test.ode:2:8: there are no maps here, whose time goes in steps");
  CHECK(refusal("table w % 3 0 1 t") == "test.ode:1:1: there are no tables here");
  CHECK(refusal("x'=besselj(0,x)") == "test.ode:1:4: there are no Bessel functions here");
  CHECK(refusal("x[0..29]'=1").find("test.ode:1:1: model as written has 30 unknowns") == 0);
  // No file named in it is opened.
  CHECK(refusal("#include /etc/passwd") == "test.ode:1:1: other files are not opened");
  CHECK(refusal("options /etc/passwd") == "test.ode:1:1: other files are not opened");
  CHECK(refusal("x'=y\nexport {x} {y}") == "test.ode:2:1: other files are not opened");
  // A condition that ties the end to the start asks for a period of the same motion.
  CHECK(refusal("x'=-x\ninit x=1\nb x-x'") == "nothing");
}

TEST_CASE("An error in an .ode file is reported with its place", "[problem][ode-files]") {
  CHECK(refusal("") == "test.ode:1:1: no equation: add one such as x' = -x");
  CHECK(refusal("x'=-drg*x\npar drag=1") == "test.ode:1:5: no letter drg; did you mean 'drag'?");
  CHECK(refusal("x'=-x\naux y=foo(x)") == "test.ode:2:7: no function foo");
  CHECK(refusal("x'=x(1)").find("x is no function: write x*(...)") != std::string::npos);
  CHECK(refusal("x'=1 \\\n  +(2") == "test.ode:2:6: expected )");
  CHECK(refusal("x'=2*-3").find("test.ode:1:6: a sign follows an operator") == 0);
  CHECK(refusal("x'=2 x") == "test.ode:1:6: the statement ends before this");
  CHECK(refusal("x'=1\npar a=1/2").find("test.ode:2:7: expected a number, and no formula") == 0);
  CHECK(refusal("x'=1\ninit y=2") == "test.ode:2:6: no variable y; a start is of one");
  CHECK(refusal("x'=1\npar x=2") == "test.ode:2:5: x is there twice");
  CHECK(refusal("x'=f(x)\nf(u)=f(u)").find("a function cannot call itself") != std::string::npos);
  CHECK(refusal("x'=q\nq=r\nr=q").find("test.ode:2:1: an abbreviation of itself") == 0);
  CHECK(refusal("x'=max(x)") == "test.ode:1:4: max takes 2, and has 1");
  CHECK(refusal("x'=x[j]").find("test.ode:1:5: no range is given for j") == 0);
  CHECK(refusal("x[a..b]'=1").find("test.ode:1:2: a range is of whole numbers") == 0);
  CHECK(refusal("x[0..2]'=x[j-1]") == "test.ode:1:11: the index is below zero");
  CHECK(rate_of("x[1..2]'=2*[j-3]") == -4);
  CHECK(refusal("x'=1\nglobal 1 {x-1} {k=0}\npar k=1").find("an event changes variables here") !=
        std::string::npos);
  CHECK(refusal("x'=1\n@ total=-3") == "test.ode:2:9: total is positive, and at most 1e9");
  CHECK(refusal("x'=1\ninitial x=2") == "nothing");
  CHECK(refusal("x'=1\nparm k=2").find("did you mean 'par'") != std::string::npos);
  CHECK(refusal("x'=x^2\ninit x=1000").find("the true motion ends at 0.001: ") != std::string::npos);
  // Expansion of functions comes to an end.
  std::string doubling = "f0(x)=x+x\n";
  for (int i = 1; i < 60; ++i)
    doubling +=
        "f" + std::to_string(i) + "(x)=f" + std::to_string(i - 1) + "(f" + std::to_string(i - 1) + "(x))\n";
  CHECK(refusal(doubling + "x'=f59(x)").find("when functions and sums are written out") != std::string::npos);
  CHECK(refusal("x[0..99999]'=1").find("20,000 statements") != std::string::npos);
  CHECK(refusal("x'=" + std::string(200, '(') + "1").find("at most 100 levels") != std::string::npos);
}

TEST_CASE("Garbled .ode files are refused or read, and nothing else happens", "[problem][ode-files]") {
  const std::string whole =
      pendulum.substr(0, pendulum.find("done")) +
      "global 1 {x-2} {v=-v;x=2}\nf(u)=if(u>1&u<3)then(heav(u))else(mod(u,2))\ny[1..3]'=-y[j]+f(y1)+sum(1,2)of(shift(y1,i'))\n";
  Random random(53);
  for (int i = 0; i < 400; ++i) {
    std::string text = whole;
    for (int changes = 1 + random.below(3); changes > 0; --changes) {
      const auto at = static_cast<std::size_t>(random.below(static_cast<int>(text.size())));
      constexpr std::string_view signs = "()=+-*/^'{}[],.0 1e9 xj%@#!\\|\n<;\x80";
      if (random.unit() < 0.5)
        text[at] = signs[static_cast<std::size_t>(random.below(static_cast<int>(signs.size())))];
      else
        text.erase(at, 1 + static_cast<std::size_t>(random.below(4)));
    }
    const std::string said = complaint([&] {
      const auto file = read_ode("test.ode", text);
      Model(*file, file->models[0]);
    });
    INFO(said << "\n" << text);
    CHECK((said == "nothing" || said.find("test.ode:") == 0));
  }
}

TEST_CASE("The parts of an event are executed in order, as in xppaut", "[problem][ode-files]") {
  const Numbers numbers = numbers_of("x'=1\ny'=0\nz'=0\nglobal 1 x-.5 {y=y+1;z=y}\ninit y=3");
  CHECK(state_at(numbers, 1) == std::vector<long double>{1, 4, 4});
  const Numbers ends = numbers_of("x'=1\nglobal 1 {x-.5} {arret=1}");
  CHECK(near(static_cast<double>(state_at(ends, 1)[0]), 0.5, 1e-15));
}

TEST_CASE("Conditions determine their unknowns, at the start and along the motion", "[problem][ode-files]") {
  const Numbers numbers = numbers_of("x'=-x\n0=y-x^2\n0=z^3+z-y\nsolv y=3,z=.5\ninit x=1");
  CHECK(near(static_cast<double>(numbers.start[1]), 1, 1e-15));
  CHECK(near(static_cast<double>(numbers.start[2]), 0.68232780382801933, 1e-15));
  const auto later = state_at(numbers, 1);
  const long double y = std::exp(-2.0L), z = later[2];
  CHECK(near(static_cast<double>(later[1]), static_cast<double>(y), 1e-14));
  CHECK(near(static_cast<double>(z * z * z + z), static_cast<double>(y), 1e-14));

  CHECK(refusal("x'=y\n0=x+y") ==
        "test.ode:2:1: conditions (0 = ...) are 1, and the unknowns that solve names for them 0");
  CHECK(refusal("x'=-x\n0=y^2+1+x^2\nsolve y=1") ==
        "test.ode:2:1: at the start the conditions are not met near the given values of their unknowns");
  CHECK(refusal("0=y-1\nsolve y") == "test.ode:1:1: no equation: add one such as x' = -x");
  CHECK(refusal("x'=-x\n0=x-1\nsolve y") == "test.ode:1:1: no condition has y");
}

TEST_CASE("Jumps of mod and flr are found in time", "[problem][ode-files]") {
  // x' = mod(t, 1): a half per unit of time.
  CHECK(near(static_cast<double>(state_at(numbers_of("x'=mod(t,1)"), 3.5)[0]), 1.5 + 0.125, 1e-14));
  CHECK(near(static_cast<double>(state_at(numbers_of("x'=flr(2*t)\ninit x=1"), 1.75)[0]),
             1 + 0.5 * (1 + 2) + 0.75, 1e-14));
  CHECK(near(static_cast<double>(state_at(numbers_of("x'=if(t>.25&t<.75|t>2)then(1)else(0)"), 3)[0]), 1.5,
             1e-14));
}

TEST_CASE("A true motion goes on where a guard rests at zero, and where two choices change at once",
          "[problem][ode-files]") {
  // Thrown up, stopped where it would pass 1/2, and falling from there from rest: 1/2 - g (t - s)^2/2.
  const Numbers stopped = numbers_of("y'=v\nv'=-10\nglobal 1 y-.5 {v=0}\ninit v=4");
  const double s = (4 - std::sqrt(16 - 10.0)) / 10;
  const auto fallen = state_at(stopped, 1);
  CHECK(near(static_cast<double>(fallen[0]), 0.5 - 5 * (1 - s) * (1 - s), 1e-13));
  // A wheel of four quarters, one open at a time.
  const Numbers wheel = numbers_of("u'=.37+.01*sin(t)\nc[0..3]'=heav(cos(u-pi*[j]/2)-cos(pi/4))\ninit u=.05");
  const auto open = state_at(wheel, 30);
  CHECK(near(static_cast<double>(open[1] + open[2] + open[3] + open[4]), 30, 1e-11));
}

TEST_CASE("Both routes end within a rounding where a wheel turns back as two of its buckets change",
          "[problem][ode-files]") {
  const Numbers wheel = numbers_of(
      "f(u)=heav(cos(u)-cos(pi/6))\nm[0..5]'=.5*f(a-2*pi*[j]/6)-.1*m[j]\na'=w\n"
      "w'=-w+sum(0,5)of(shift(m0,i')*sin(a-2*pi*i'/6))\ninit a=.05");
  const std::vector<double> times{0, 15, 30, 60};
  const TrueMotion one = by_series(wheel, times), other = by_extrapolation(wheel, times);
  REQUIRE(other.trouble.empty());
  for (std::size_t i = 0; i < wheel.unknowns; ++i)
    CHECK(near(static_cast<double>(one.states[3][i]), static_cast<double>(other.states[3][i]), 1e-13));
}

TEST_CASE("Roundings of a small rate do not stop the second route to a true motion", "[problem][ode-files]") {
  // tanh is a difference of terms near 1, and y remains below 1e-9: y = 1e-9 t exp(-t).
  const Numbers numbers = numbers_of("x'=-x\ny'=-y+tanh(1e-9*x)\ninit x=1");
  const std::array<double, 2> times{0, 5};
  for (const TrueMotion& motion : {by_series(numbers, times), by_extrapolation(numbers, times)}) {
    INFO(motion.trouble);
    REQUIRE(motion.trouble.empty());
    CHECK(std::abs(motion.states[1][1] - 5e-9L * std::exp(-5.0L)) < 1e-17L);
  }
}

TEST_CASE("A horizon ends before the motion does, and the reason is given", "[problem][ode-files]") {
  const auto asked = [](const std::string& name, const std::string& text) {
    return asked_by(entry_of_text(name, text));
  };
  // 1/(1 - t): the error is a thousandth of the range up to the horizon.
  const Asked singular = asked("singular.ode", "x'=x^2\ninit x=1\n@ dt=.5");
  const double end = std::stod(singular.horizon);
  CHECK((end > 0.9 && end < 0.99));
  CHECK(near(std::stod(singular.error), (1 / (1 - end) - 1) / 1000, 0.1));
  CHECK(singular.horizon_reason.find(
            "(its total is 20), as the true motion ends at 1: it is singular there") != std::string::npos);
  CHECK(std::stod(singular.frames_per_second) * end > 99);  // so that no frame is beyond the motion's end
  // x follows sin(t), with a time constant of a millionth.
  const Asked stiff = asked("stiff.ode", "x'=-1000000*(x-sin(t))\ninit x=1\n@ total=20");
  CHECK(std::stod(stiff.horizon) < 1);
  CHECK(stiff.horizon_reason.find("too many steps there, as it is stiff or switches without end") !=
        std::string::npos);
  const Asked whole = asked("whole.ode", "x'=-x\ninit x=1\n@ total=5,dt=.1");
  CHECK((whole.horizon == "5" && whole.horizon_reason == "up to its total of 5"));
}

TEST_CASE("A trial of a long model is stopped after fewer evaluations than one of a short model",
          "[problem][ode-files]") {
  const auto ending = [](const std::string& name, const std::string& more) {
    const Entry& entry = entry_of_text(name, "x'=y" + more + "\ny'=-x\ninit x=1\n@ total=1");
    const Quantity motion =
        entry.exercise.scene->motion(Parameters(entry.exercise.parameters), {2500}, Reference::nothing());
    const Method* method = method_of(motion, "as written", "Runge-Kutta 4");
    REQUIRE(method);
    return method->run(1e-3).ending;
  };
  std::string sum;
  for (int i = 1; i <= 60; ++i) sum += "+sin(x+" + std::to_string(i) + ")*cos(y)/1000";
  CHECK(ending("short.ode", "") == Ending::reached);
  CHECK(ending("long.ode", sum) == Ending::stalled);
}

TEST_CASE("The program accepts an .ode file's name in place of an exercise",
          "[problem][ode-files][commands]") {
  const ScratchFolder scratch;
  const std::string file = scratch.file("mine.ode", pendulum).string();
  const auto chosen = program::printed("choose " + file);
  CHECK(chosen.status == 0);
  CHECK(program::says(
      chosen, "an error of 0.006, a thousandth of the widest range, that of v; up to its total of 5"));
  CHECK(program::says(chosen, "over 5 s at 10 frames per second"));
  CHECK(program::printed("choose " + file + " --error 0.1 --horizon 2").output.find("states no need") ==
        std::string::npos);
  CHECK(program::printed("choose " + file + " --json").output.starts_with("{"));
  CHECK(program::says(program::printed("choose " + file + " k=20 x_0=.5 --code"), "struct AsWritten"));
  CHECK(program::says(program::printed("solve " + file + " --csv"), "mine,motion"));
  CHECK(program::printed("stability " + file + " --csv").status == 0);
  CHECK(program::printed("chart " + file + " --csv").status == 0);
  CHECK(program::says(program::printed("list " + file), "x at the start"));
  const auto refused = program::run("choose " + scratch.file("wrong.ode", "x'=-delay(x,1)").string());
  CHECK(refused.status == 2);
  CHECK(program::says(refused, "wrong.ode:1:5: there are no delays here"));
}
