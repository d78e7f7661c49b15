#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "chapters/exercise.hpp"
#include "chapters/lost_bar.hpp"
#include "chapters/random.hpp"
#include "solvers/dual.hpp"

/// One degree of freedom q with v = q', and formulas about it. A function f(q, v, t) is generic in its number
/// type; its derivatives are taken by dual numbers.
namespace oddity {

template <class F>
double d_dq(const F& f, double q, double v, double t = 0) {
  return f(Dual<double>(q, 1), Dual<double>(v), Dual<double>(t)).slope;
}

template <class F>
double d_dv(const F& f, double q, double v, double t = 0) {
  return f(Dual<double>(q), Dual<double>(v, 1), Dual<double>(t)).slope;
}

/// d/dt of df/dv along a motion with q' = v, v' = a.
template <class F>
double momentum_rate(const F& f, double q, double v, double a, double t = 0) {
  using Along = Dual<double>;
  using Outer = Dual<Along>;
  return f(Outer(Along(q, v)), Outer(Along(v, a), Along(1)), Outer(Along(t, 1))).slope.slope;
}

/// v' by Lagrange's equation d/dt dL/dv = dL/dq.
template <class L>
double lagrange_acceleration(const L& lagrangian, double q, double v, double t = 0) {
  using Along = Dual<double>;
  using Outer = Dual<Along>;
  const double mass = lagrangian(Outer(Along(q)), Outer(Along(v, 1), Along(1)), Outer(Along(t))).slope.slope;
  return (d_dq(lagrangian, q, v, t) - momentum_rate(lagrangian, q, v, 0, t)) / mass;
}

/// The numbers as one value.
template <class... Numbers>
Value values(Numbers... x) {
  return {static_cast<double>(x)...};
}

/// A way to write a quantity as a formula in the letters of a sample. `terms` is the size of terms that
/// cancel whatever the letters are, where there are such.
template <class Sample>
struct Version {
  std::string text;
  std::function<Value(const Sample&)> of;
  std::function<double(const Sample&)> terms = {};
};

/// The size of a formula's terms at a sample: the sum over its letters of how much the value changes with a
/// letter's relative change. Terms that cancel in the value do not cancel here.
template <class Sample>
double size_of_terms(const Version<Sample>& version, const Sample& sample) {
  constexpr double change = 0x1p-20;
  const Value value = version.of(sample);
  double size = size_of(value) + (version.terms ? version.terms(sample) : 0);
  for (std::size_t i = 0; i < Sample(sample).letters().size(); ++i) {
    Sample moved = sample;
    *moved.letters()[i] *= 1 + change;
    size += distance(version.of(moved), value) / change;
  }
  return size;
}

/// The same for a function of an array of letters.
template <std::size_t n, class F>
double size_of_terms(const F& f, const std::array<double, n>& letters) {
  constexpr double change = 0x1p-20;
  const Value value = f(letters);
  double size = size_of(value);
  for (std::size_t i = 0; i < n; ++i) {
    auto moved = letters;
    moved[i] *= 1 + change;
    size += distance(Value(f(moved)), value) / change;
  }
  return size;
}

/// Two functions of the same letters at one sample, with the size of their terms.
template <std::size_t n, class Left, class Right>
void see(Worst& worst, const Left& left, const Right& right, const std::array<double, n>& letters,
         const std::string& where) {
  worst.see(left(letters), right(letters),
            std::max(size_of_terms(left, letters), size_of_terms(right, letters)), where);
}

/// Two versions of a quantity over the samples. Where it is compared with zero, the terms are what cancels,
/// of which a sample's size() is the sum. Else their size is found from a sample's letters() where it has
/// them, and is that of the largest value where it has not, times the sample's conditioning() if it has one.
template <class Sample>
Check compare(std::string quantity, const Version<Sample>& left, const Version<Sample>& right,
              const std::vector<Sample>& samples) {
  std::vector<Value> lefts, rights;
  double largest = 0;
  const auto evaluated = [&](const Version<Sample>& version, const Sample& sample) {
    Value value = version.of(sample);
    if (finite(value)) largest = std::max(largest, size_of(value));
    return value;
  };
  bool with_zero = true;
  for (const Sample& sample : samples) {
    lefts.push_back(evaluated(left, sample));
    rights.push_back(evaluated(right, sample));
    with_zero = with_zero && size_of(rights.back()) == 0;
  }
  Worst worst(std::move(quantity), left.text, right.text);
  const auto size = [&](const Sample& sample) {
    constexpr bool has_letters = requires(Sample & s) { s.letters(); };
    if constexpr (requires { sample.size(); })
      if (with_zero) return sample.size();
    if constexpr (has_letters)
      return std::max(size_of_terms(left, sample), size_of_terms(right, sample));
    else if constexpr (requires { sample.conditioning(); })
      return largest * sample.conditioning();
    else
      return largest;
  };
  for (std::size_t i = 0; i < samples.size(); ++i)
    worst.see(lefts[i], rights[i], size(samples[i]), samples[i].where());
  return worst.check();
}

/// The same over 200 random samples, made by Sample(Random&); where() tells a sample's letters.
template <class Sample>
Check compare(std::string quantity, const Version<Sample>& left, const Version<Sample>& right, double seed) {
  Random random(seed);
  std::vector<Sample> samples;
  for (int i = 0; i < 200; ++i) samples.emplace_back(random);
  return compare(std::move(quantity), left, right, samples);
}

/// The claim that `what` is as printed, judged by the version `truth`, with versions that must not be.
template <class Sample>
Claim formula_claim(std::string id, int line, const std::string& what, double seed,
                    const Version<Sample>& printed, const Version<Sample>& truth,
                    const std::vector<Version<Sample>>& near_misses) {
  Claim claim{std::move(id), line, what};
  claim.printed = {printed.text, {compare(what, printed, truth, seed)}};
  for (const Version<Sample>& near : near_misses)
    claim.near_misses.push_back({near.text, {compare(what, near, truth, seed)}});
  return claim;
}

/// A formula claim whose fraction bars the text at hand has lost. `says` states it as it stands.
template <class Sample>
void bars_lost(Claim& claim, std::string says, double seed, const Version<Sample>& as_it_stands,
               const Version<Sample>& truth, std::string why) {
  const std::string quantity = claim.printed.checks[0].quantity;
  claim = lost_bar(std::move(claim), {as_it_stands.text, {compare(quantity, as_it_stands, truth, seed)}},
                   std::move(why));
  claim.says = std::move(says);
}

}  // namespace oddity
