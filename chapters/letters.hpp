#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "chapters/expression.hpp"
#include "chapters/random.hpp"
#include "chapters/typeset.hpp"

/// The letters of a sample, stated once: their names on a page and in Coq, their numbers, and where these are
/// drawn from.
///
///     template <class T>
///     struct SwingOf {
///       T m, L, angle;
///       Letters<T> table() {
///         return {{"m", m, {0.3, 3}}, {"L", L, {0.5, 2}}, {R"(\theta)", angle, either_sign(0.1, 1)}};
///       }
///     };
namespace oddity {

/// The numbers of a letter, as expressions.
struct ShortenedValue {
  std::vector<Shortened> all;
  ShortenedValue(Shortened x) : all{std::move(x)} {}
  ShortenedValue(double x) : all{Shortened(x)} {}
  ShortenedValue(std::initializer_list<Shortened> xs) : all(xs) {}
  ShortenedValue(std::vector<Shortened> xs) : all(std::move(xs)) {}
  template <std::size_t n>
  ShortenedValue(const std::array<Shortened, n>& xs) : all(xs.begin(), xs.end()) {}
};
/// Return type of typeset(), in doubles or expressions.
template <class T>
using TypesetIn = std::conditional_t<std::same_as<T, Shortened>,
                                     std::vector<std::pair<std::string, ShortenedValue>>, TypesetLetters>;

/// Where a letter is drawn from, uniformly by default. Each component of a vector is drawn.
struct Range {
  double low = 0, high = 0;
  enum class By { uniform, size_and_sign, size } by = By::uniform;

  double draw(Random& random) const {
    if (by == By::uniform) return random.between(low, high);
    const double x = random.magnitude(low, high);
    return by == By::size ? std::abs(x) : x;
  }
};
/// A size between low and high, log-uniform, of either sign.
inline Range either_sign(double low, double high) { return {low, high, Range::By::size_and_sign}; }
/// A positive number, log-uniform.
inline Range positive_size(double low, double high) { return {low, high, Range::By::size}; }

template <class T>
struct Letter {
  const char* name;  ///< in TeX
  T* first;
  std::size_t count = 1;
  Range from = {};
  const char* coq = nullptr;  ///< the name in Coq, by default that in TeX without marks

  Letter(const char* tex, T& x, Range range = {}, const char* in_coq = nullptr)
      : name(tex), first(&x), from(range), coq(in_coq) {}
  template <std::size_t n>
  Letter(const char* tex, std::array<T, n>& x, Range range = {}, const char* in_coq = nullptr)
      : name(tex), first(x.data()), count(n), from(range), coq(in_coq) {}
};
template <class T>
using Letters = std::vector<Letter<T>>;

namespace detail {

template <class Sample>
concept Tabled = requires(Sample& s) {
  s.table();
};
template <class Sample>
using NumberOf = std::remove_pointer_t<decltype(std::declval<Sample&>().table()[0].first)>;

}  // namespace detail

/// A sample whose letters can be changed one by one.
template <class Sample>
concept Lettered = detail::Tabled<Sample> || requires(Sample& s) {
  s.letters();
};
/// A sample with letters on a page.
template <class Sample>
concept Typeset = detail::Tabled<Sample> || requires(const Sample& s) {
  s.typeset();
};

/// Pointers to its independent letters.
template <Lettered Sample>
auto letters_of(Sample& sample) {
  if constexpr (detail::Tabled<Sample>) {
    std::vector<detail::NumberOf<Sample>*> all;
    for (const auto& letter : sample.table())
      for (std::size_t i = 0; i < letter.count; ++i) all.push_back(letter.first + i);
    return all;
  } else {
    return sample.letters();
  }
}

/// Its letters on a page: those of table(), then those of typeset().
template <Typeset Sample>
auto typeset_of(const Sample& sample) {
  if constexpr (detail::Tabled<Sample>) {
    using T = detail::NumberOf<Sample>;
    Sample copy = sample;
    TypesetIn<T> all;
    for (const Letter<T>& letter : copy.table())
      all.emplace_back(letter.name, std::vector<T>(letter.first, letter.first + letter.count));
    if constexpr (requires { sample.typeset(); }) {
      TypesetIn<T> more = sample.typeset();
      all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    }
    return all;
  } else {
    return sample.typeset();
  }
}

/// A sample drawn by its table(), or by its constructor. Throws std::logic_error for a letter without a
/// range.
template <class Sample>
Sample drawn(Random& random) {
  if constexpr (std::constructible_from<Sample, Random&>) {
    return Sample(random);
  } else {
    Sample sample{};
    for (const auto& letter : sample.table()) {
      if (!(letter.from.low < letter.from.high))
        throw std::logic_error(std::string(letter.name) + " has no range to be drawn from");
      for (std::size_t i = 0; i < letter.count; ++i) letter.first[i] = letter.from.draw(random);
    }
    return sample;
  }
}
/// Samples that begin with this seed.
template <class Sample>
std::vector<Sample> draw(int count, double seed) {
  Random random(seed);
  std::vector<Sample> samples;
  for (int i = 0; i < count; ++i) samples.push_back(drawn<Sample>(random));
  return samples;
}

/// Names of the letters of a table() in Coq: "theta1" for "\theta_1", and "x1", "x2" for a vector "x".
template <detail::Tabled Sample>
std::vector<std::string> names_in_coq() {
  std::vector<std::string> names;
  Sample sample{};
  for (const auto& letter : sample.table()) {
    std::string name;
    for (const char c : std::string_view(letter.coq ? letter.coq : letter.name))
      if (std::string_view(R"(\_{} )").find(c) == std::string_view::npos) name += c;
    if (letter.count == 1) names.push_back(name);
    for (std::size_t i = 1; letter.count > 1 && i <= letter.count; ++i)
      names.push_back(name + std::to_string(i));
  }
  return names;
}

}  // namespace oddity
