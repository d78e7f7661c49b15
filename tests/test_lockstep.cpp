// Programs in lockstep: the accuracy of their functions, and the same bits however they are compiled.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include "chapters/random.hpp"
#include "chapters/scene.hpp"
#include "extras/lanes/lanes.hpp"
#include "report/pages/lockstep.hpp"
#include "report/plain/lockstep.hpp"
#include "report/verify/catch.hpp"
#include "tests/program.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;

namespace {

using Real = Lockstep<double>;
using Single = Lanes<double, lanes::One, 1>;
using Ranges = std::initializer_list<std::pair<double, double>>;

/// Error in units of the last place.
double units_off(double got, long double expected) {
  int exponent = 0;
  std::frexp(expected, &exponent);
  exponent = std::max(exponent, std::numeric_limits<double>::min_exponent);
  const long double unit = std::ldexp(1.0L, exponent - std::numeric_limits<double>::digits);
  return static_cast<double>(std::abs(static_cast<long double>(got) - expected) / unit);
}

constexpr int arguments = 25'000;  // in each range: a million in all

/// The largest error over a range.
double worst(double from, double to, const auto& ours, const auto& library) {
  Random random(7);
  double most = 0;
  for (int i = 0; i < arguments; ++i) {
    const double x = random.between(from, to);
    const double off = units_off(ours(Real(x)).value(), library(static_cast<long double>(x)));
    if (!(off <= most)) most = off;
  }
  return most;
}

void check(const char* name, const auto& ours, const auto& library, Ranges ranges) {
  for (const auto& [from, to] : ranges) {
    INFO(name << " from " << from << " to " << to);
    CHECK(worst(from, to, ours, library) <= 4);
  }
}

/// The printed rows of a program, and the line with the hash.
struct Printed {
  std::vector<double> observables;
  std::string hash;
};

Printed read(const std::string& output) {
  Printed printed;
  std::istringstream lines(output);
  std::string line;
  std::getline(lines, line);  // the names
  while (std::getline(lines, line)) {
    if (line.starts_with("bits of all")) {
      printed.hash = line.substr(line.rfind(' ') + 1);
      continue;
    }
    std::istringstream cells(line);
    std::string cell;
    std::getline(cells, cell, ',');  // the time
    while (std::getline(cells, cell, ',')) printed.observables.push_back(std::strtod(cell.c_str(), nullptr));
  }
  return printed;
}

/// A program with this text, compiled with options and run.
class Compiled {
 public:
  explicit Compiled(const std::string& text) { scratch_.file("program.cpp", text); }

  program::Ran run(const std::string& options) const {
    const std::string file = (scratch_.path() / "program").string();
    return program::shell(std::string(ODDITY_COMPILER) +
                          " -std=c++20 -Wall -Wextra -Werror -Wno-missing-braces " + options + " -o " + file +
                          " " + file + ".cpp && " + file);
  }

 private:
  ScratchFolder scratch_;
};

bool has_fma() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return false;
#endif
}

/// Compiler options: levels of optimization, and fused operations if the processor has them.
std::vector<std::string> ways() {
  std::vector<std::string> all{"-O0", "-O2", "-O3 -ffp-contract=on"};
  if (has_fma()) all.insert(all.end(), {"-O2 -march=x86-64-v3", "-O3 -march=x86-64-v3"});
  return all;
}

std::string without(std::string text, const std::string& part) {
  const auto at = text.find(part);
  REQUIRE(at != std::string::npos);
  return text.erase(at, part.size());
}

void check_same_bits(const std::string& question) {
  INFO(question);
  const program::Ran lockstep = program::printed("choose " + question + " --lockstep --code"),
                     usual = program::printed("choose " + question + " --code");
  REQUIRE(lockstep.status == 0);
  const Compiled program(lockstep.output);
  std::set<std::string> hashes;
  Printed printed;
  for (const std::string& way : ways()) {
    const program::Ran ran = program.run(way);
    INFO(way << "\n" << ran.output);
    REQUIRE(ran.status == 0);
    printed = read(ran.output);
    CHECK(printed.hash.size() == 16);
    hashes.insert(printed.hash);
  }
  CHECK(hashes.size() == 1);
  const Printed beside = read(Compiled(usual.output).run("-O2 -ffp-contract=off").output);
  REQUIRE(printed.observables.size() == beside.observables.size());
  double size = 0;
  for (std::size_t i = 0; i < beside.observables.size(); ++i) {
    size = std::max(size, std::abs(beside.observables[i]));
    CHECK(std::abs(printed.observables[i] - beside.observables[i]) <= 1e-11 * size);
  }
}

}  // namespace

TEST_CASE("the functions of lockstep are within four units in the last place", "[lockstep]") {
#define FUNCTION(f) #f, [](auto x) { return f(x); }, [](long double x) { return std::f(x); }
  check(FUNCTION(sin), {{-4, 4}, {-1.5e6, 1.5e6}, {-1e-8, 1e-8}, {1e7, 2e7}, {-1e22, 1e22}, {1e300, 2e300}});
  check(FUNCTION(cos), {{-4, 4}, {-1.5e6, 1.5e6}, {1e7, 2e7}, {-1e15, 1e15}});
  check(FUNCTION(tan), {{-2, 2}, {-100, 100}});
  check(FUNCTION(exp), {{-1, 1}, {-708, 709}, {-745, -708}});
  check(FUNCTION(expm1), {{-1e-3, 1e-3}, {-1, 1}, {-50, 709}});
  check(FUNCTION(log), {{0.9, 1.1}, {1e-6, 1e-3}, {1, 1e30}, {0, std::numeric_limits<double>::min()}});
  check(FUNCTION(sinh), {{-1e-3, 1e-3}, {-1, 1}, {-80, 80}});
  check(FUNCTION(cosh), {{-1, 1}, {-80, 80}});
  check(FUNCTION(asinh), {{-1e-3, 1e-3}, {-1, 1}, {-1e6, 1e6}});
  check(FUNCTION(asin), {{-1, 1}, {-1e-3, 1e-3}});
  check(FUNCTION(acos), {{-1, 1}});
#undef FUNCTION
  for (const double x : {1.0, -1.0, 0.01, -30.0}) {
    check(
        "atan2 of y", [x](const Real& y) { return atan2(y, Real(x)); },
        [x](long double y) { return std::atan2(y, static_cast<long double>(x)); }, {{-3, 3}});
    check(
        "atan2 of x", [x](const Real& y) { return atan2(Real(x), y); },
        [x](long double y) { return std::atan2(static_cast<long double>(x), y); }, {{-3, 3}});
  }
}

TEST_CASE("angles close to whole right angles are reduced as exactly as others", "[lockstep]") {
  // the double nearest to a multiple of pi/2 [J.-M. Muller, Elementary Functions, 2nd edition, table 9.1]
  const double nearest = 6381956970095103 * std::ldexp(1.0, 797);
  CHECK(units_off(cos(Real(nearest)).value(), std::cos(static_cast<long double>(nearest))) <= 4);
  CHECK(units_off(cos(Real(-nearest)).value(), std::cos(static_cast<long double>(nearest))) <= 4);
  for (const double n : {1e7, 1e9, 1e12, 1e15})
    for (const double x : {n * 1.5707963267948966, n * 3.141592653589793}) {
      INFO(x);
      CHECK(units_off(sin(Real(x)).value(), std::sin(static_cast<long double>(x))) <= 4);
      CHECK(units_off(sin(Real(-x)).value(), -std::sin(static_cast<long double>(x))) <= 4);
      CHECK(units_off(cos(Real(x)).value(), std::cos(static_cast<long double>(x))) <= 4);
    }
}

TEST_CASE("the functions of lockstep have the limits of the library's", "[lockstep]") {
  constexpr double infinity = std::numeric_limits<double>::infinity(),
                   none = std::numeric_limits<double>::quiet_NaN();
  CHECK(exp(Real(infinity)).value() == infinity);
  CHECK(exp(Real(-infinity)).value() == 0);
  CHECK(exp(Real(0)).value() == 1);
  CHECK(log(Real(infinity)).value() == infinity);
  CHECK(log(Real(0)).value() == -infinity);
  CHECK(expm1(Real(-infinity)).value() == -1);
  CHECK(sinh(Real(-infinity)).value() == -infinity);
  CHECK(atan2(Real(0), Real(0)).value() == 0);
  CHECK(atan2(Real(0), Real(-1)).value() == 3.141592653589793);
  for (const double x : {none, infinity, -infinity}) {
    CHECK(std::isnan(sin(Real(x)).value()));
    CHECK(std::isnan(cos(Real(x)).value()));
  }
  for (const Real& x : {log(Real(-1)), log(Real(none)), exp(Real(none)), sqrt(Real(-1)), asin(Real(none)),
                        expm1(Real(none)), atan2(Real(none), Real(1))})
    CHECK(std::isnan(x.value()));
}

TEST_CASE("a function of lockstep has the same bits as in lanes", "[lockstep][lanes]") {
  Random random(11);
  for (int i = 0; i < 2000; ++i) {
    const double x = random.between(-20, 20), y = random.between(-20, 20), part = random.between(-1, 1);
    const auto same = [&](const char* name, const Real& ours, const Single& lane) {
      INFO(name << " of " << x << ", " << y << ", " << part);
      CHECK(ours.value() == lane[0]);
    };
#define FUNCTION(f, x) same(#f, f(Real(x)), f(Single(x)));
    FUNCTION(sin, x)
    FUNCTION(cos, x)
    FUNCTION(exp, x)
    FUNCTION(expm1, x)
    FUNCTION(log, x * x)
    FUNCTION(sinh, x)
    FUNCTION(cosh, x)
    FUNCTION(asinh, x)
    FUNCTION(asin, part)
#undef FUNCTION
    same("atan2", atan2(Real(y), Real(x)), atan2(Single(y), Single(x)));
    same("remainder", remainder(Real(x), Real(part)), remainder(Single(x), Single(part)));
    same("hypot", hypot(Real(x), Real(y)), hypot(Single(x), Single(y)));
  }
}

TEST_CASE("the hash is FNV-1a of the bytes, and the same for any NaN", "[lockstep]") {
  // hash of the eight bytes of 1.0 by definition: 0xcbf29ce484222325, then an exclusive or and a product for
  // each byte
  unsigned long long expected = 0xcbf29ce484222325;
  for (const unsigned byte : {0u, 0u, 0u, 0u, 0u, 0u, 0xf0u, 0x3fu})
    expected = (expected ^ byte) * 0x100000001b3;
  BitsHash one;
  one.add(std::array<Real, 1>{1});
  CHECK(one.value() == expected);
  BitsHash quiet, negative, number;
  quiet.add(std::array<Real, 1>{std::numeric_limits<double>::quiet_NaN()});
  negative.add(std::array<Real, 1>{-std::numeric_limits<double>::quiet_NaN()});
  number.add(std::array<Real, 1>{-1});
  CHECK(quiet.value() == negative.value());
  CHECK(quiet.value() != number.value());
}

TEST_CASE("a program in lockstep has the same bits with any compiler options, and the usual program's motion",
          "[lockstep][commands]") {
  check_same_bits("3.5 --error 1deg --horizon 2 --exclude closed");
  check_same_bits("3.9 --error 1mm --horizon 2");
  check_same_bits("3.31 --error 1cm,1deg --horizon 2 --only stick");  // a model that takes its own steps
}

TEST_CASE("without its guard the program's bits depend on the compiler's options", "[lockstep][commands]") {
  const std::string code =
      program::printed("choose 3.5 --error 1deg --horizon 2 --exclude closed --lockstep --code").output;
  CHECK(Compiled(code).run("-O1 -ffast-math").status != 0);
  CHECK(program::says(Compiled(code).run("-O1 -ffast-math"), "compile it without -ffast-math"));
#if defined(__GNUC__) && !defined(__clang__)
  if (has_fma()) {
    const Compiled unguarded(without(code, "asm(\"\" : \"+x\"(product));"));
    const program::Ran fused = unguarded.run("-O2 -march=x86-64-v3");
    CHECK(fused.status == 1);
    CHECK(program::says(fused, "operations are not rounded each for itself"));
  }
#endif
}

TEST_CASE("choose lists the assumptions and the limits of lockstep", "[lockstep][commands]") {
  const program::Ran text =
      program::printed("choose 3.5 --error 1deg --horizon 2 --exclude closed --lockstep");
  INFO(text.output);
  CHECK(text.status == 0);
  CHECK(program::says(text, "lockstep: its program has the same bits"));
  CHECK(program::says(text, "and its own sin; "));
  CHECK(program::says(text, "any method that calls Boost.Odeint"));
  const program::Ran json =
      program::printed("choose 3.5 --error 1deg --horizon 2 --exclude closed --lockstep --json");
  CHECK(program::says(json, "\"calls GSL\": ["));
  CHECK_FALSE(program::says(json, "\"algorithm\": \"Fehlberg 7(8)\""));
  CHECK(program::says(program::printed("choose 3.5 --error 1deg --horizon 2 --json"), "\"lockstep\": null"));
  const program::Ran none = program::run("choose 3.5 --error 1deg --lockstep --only Fehlberg");
  CHECK(none.status == 2);
  CHECK(program::says(none, "--lockstep leaves no method: Fehlberg 7(8) calls Boost.Odeint"));
}

TEST_CASE("if the time limit leaves nothing, the cost of lockstep is not measured", "[lockstep]") {
  const Entry& pendulum = *std::ranges::find(registry(), Number{3, 5}, &Entry::number);
  Choice choice;
  choice.need.lockstep = true;
  choice.need.horizon = 1;
  choice.need.frames_per_second = 60;
  choice.chosen = Candidate{"one angle", "Runge-Kutta 4", "step"};
  choice.chosen->setting = 1 / 60.0;
  const InLockstep found = lockstep_of(Task(pendulum), choice, 0);
  CHECK(found.measured == "its cost is not measured, as the time limit left no more");
  CHECK_FALSE(found.times_usual);
  CHECK(found.functions == std::vector<std::string>{"sin"});
}
