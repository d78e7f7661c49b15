// The elementary functions of lanes, compared with the C library's in long double.

#include <cmath>
#include <limits>

#include "chapters/random.hpp"
#include "extras/lanes/lanes.hpp"
#include "report/verify/catch.hpp"

using namespace oddity;

namespace {

template <class T>
using Single = Lanes<T, lanes::One, 1>;

/// Error in units of the last place.
template <class T>
double units_off(T got, long double expected) {
  int exponent = 0;
  std::frexp(expected, &exponent);
  exponent = std::max(exponent, std::numeric_limits<T>::min_exponent);
  const long double unit = std::ldexp(1.0L, exponent - std::numeric_limits<T>::digits);
  return static_cast<double>(std::abs(static_cast<long double>(got) - expected) / unit);
}

/// The largest error of the number type's function over the range, and whether each lane has the bits of a
/// single number.
template <class T, class F, class G>
double worst(T from, T to, const F& ours, const G& library) {
  using Wide = Lanes<T>;
  Random random(7);
  double most = 0;
  for (int i = 0; i < 4000; ++i) {
    Wide x;
    for (std::size_t lane = 0; lane < Wide::size(); ++lane)
      x.set(lane, static_cast<T>(random.between(static_cast<double>(from), static_cast<double>(to))));
    const Wide y = ours(x);
    for (std::size_t lane = 0; lane < Wide::size(); ++lane) {
      const T alone = ours(Single<T>(x[lane]))[0];
      CHECK(y[lane] == alone);
      most = std::max(most, units_off(alone, library(static_cast<long double>(x[lane]))));
    }
  }
  return most;
}

template <class T>
void near_the_library() {
  const T far = std::is_same_v<T, double> ? T(1.5e6) : T(6000),
          largest = std::is_same_v<T, double> ? T(708) : T(87);
  const auto check = [](const char* name, T from, T to, const auto& ours, const auto& library) {
    INFO(name << " from " << from << " to " << to);
    CHECK(worst<T>(from, to, ours, library) <= 3);
  };
#define FUNCTION(f) #f, [](auto x) { return f(x); }, [](long double x) { return std::f(x); }
  const auto with = [&](const char* name, const auto& ours, const auto& library,
                        std::initializer_list<std::pair<T, T>> ranges) {
    for (const auto& [from, to] : ranges) check(name, from, to, ours, library);
  };
  with(FUNCTION(sin), {{T(-4), T(4)}, {-far, far}, {T(-1e-8), T(1e-8)}, {T(1e7), T(2e7)}});
  with(FUNCTION(cos), {{T(-4), T(4)}, {-far, far}, {T(1e7), T(2e7)}});
  with(FUNCTION(exp), {{T(-1), T(1)}, {-largest, largest}, {T(-1.05) * largest, -largest}});
  with(FUNCTION(expm1), {{T(-1e-3), T(1e-3)}, {T(-1), T(1)}, {T(-50), largest}});
  with(FUNCTION(log),
       {{T(0.9), T(1.1)}, {T(1e-6), T(1e-3)}, {T(1), T(1e30)}, {T(0), std::numeric_limits<T>::min()}});
  with(FUNCTION(sinh), {{T(-1e-3), T(1e-3)}, {T(-1), T(1)}, {T(-80), T(80)}});
  with(FUNCTION(cosh), {{T(-1), T(1)}, {T(-80), T(80)}});
  with(FUNCTION(asinh), {{T(-1e-3), T(1e-3)}, {T(-1), T(1)}, {T(-1e6), T(1e6)}});
  with(FUNCTION(asin), {{T(-1), T(1)}, {T(-1e-3), T(1e-3)}});
#undef FUNCTION
  for (T x : {T(1), T(-1), T(0.01), T(-30)}) {
    using Argument = long double;
    check(
        "atan2 of y", T(-3), T(3), [x](auto y) { return atan2(y, decltype(y)(x)); },
        [x](long double y) { return std::atan2(y, Argument(x)); });
    check(
        "atan2 of x", T(-3), T(3), [x](auto y) { return atan2(decltype(y)(x), y); },
        [x](long double y) { return std::atan2(Argument(x), y); });
  }
  const T turn = T(6.283185307179586);
  check(
      "remainder", T(-1000), T(1000), [=](auto x) { return remainder(x, decltype(x)(turn)); },
      [=](long double x) { return std::remainder(x, static_cast<long double>(turn)); });
}

template <class T>
void at_the_ends() {
  using S = Single<T>;
  constexpr T infinity = std::numeric_limits<T>::infinity(), none = std::numeric_limits<T>::quiet_NaN();
  CHECK(exp(S(infinity))[0] == infinity);
  CHECK(exp(S(-infinity))[0] == 0);
  CHECK(exp(S(0))[0] == 1);
  CHECK(log(S(infinity))[0] == infinity);
  CHECK(log(S(0))[0] == -infinity);
  CHECK(expm1(S(0))[0] == 0);
  CHECK(sinh(S(0))[0] == 0);
  CHECK(atan2(S(0), S(0))[0] == 0);
  CHECK(atan2(S(0), S(-1))[0] == T(3.141592653589793));
  CHECK(copysign(S(2), S(-1))[0] == -2);
  for (const S& x : {S(none), S(infinity), S(-infinity)}) {
    CHECK(std::isnan(sin(x)[0]));
    CHECK(std::isnan(cos(x)[0]));
  }
  for (const S& x : {log(S(-1)), log(S(none)), exp(S(none)), sqrt(S(-1)), asin(S(none)), expm1(S(none))})
    CHECK(std::isnan(x[0]));
  for (T x = T(1e-4); x < T(1e4); x *= T(1.01))
    CHECK(std::abs(inverse_fifth_root(S(x))[0] * std::pow(x, T(0.2)) - 1) < T(0.02));
}

}  // namespace

TEST_CASE("the functions of lanes are within three units in the last place", "[lanes]") {
  near_the_library<double>();
  near_the_library<float>();
}

TEST_CASE("the functions of lanes have the limits of the library's", "[lanes]") {
  at_the_ends<double>();
  at_the_ends<float>();
}

TEST_CASE("lanes are selected one by one, and a branch that none needs is not computed", "[lanes]") {
  using L = Lanes<double>;
  L x;
  for (std::size_t lane = 0; lane < L::size(); ++lane) x.set(lane, static_cast<double>(lane));
  const L y = select(x < L(1), L(7), x);
  CHECK(y[0] == 7);
  for (std::size_t lane = 1; lane < L::size(); ++lane) CHECK(y[lane] == static_cast<double>(lane));
  int computed = 0;
  const auto no = [&] { return ++computed, L(0); };
  CHECK(either(
            x < L(1e3), [&] { return x; }, no)[0] == 0);
  CHECK(computed == 0);
  CHECK(either(
            x < L(1), [&] { return L(3); }, no)[0] == 3);
  CHECK(computed == 1);
  CHECK(any_of(x < L(1)));
  CHECK_FALSE(any_of(!(x < L(1e3))));
}
