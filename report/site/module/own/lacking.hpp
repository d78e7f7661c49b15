// Parts of C++20 that the standard library for WebAssembly lacks, included ahead of every source. LLVM 14, in
// Debian 12, has few of std::ranges' algorithms, and no release before 20 reads a double.

#pragma once

#include <version>

#ifdef _LIBCPP_HAS_NO_FILESYSTEM
#include <cstddef>
#include <istream>
#include <string>

namespace std {

/// Named by toml++ to open files, which the page never does. LLVM 19, in Debian 13, has no files.
template <>
class basic_ifstream<char> : public basic_istream<char> {
 public:
  basic_ifstream() : basic_istream<char>(nullptr) {}
  struct Buffer {
    void pubsetbuf(char*, size_t) {}
  };
  Buffer* rdbuf() { return &buffer_; }
  void open(const string&, ios_base::openmode) {}
  bool is_open() const { return false; }

 private:
  Buffer buffer_;
};

}  // namespace std
#endif

#if _LIBCPP_VERSION < 15000
#include <algorithm>
#include <functional>
#include <iterator>
#include <ranges>

namespace std::ranges {

/// The function applied to the projection of an element.
template <class Function, class Projection>
auto seen_by(Function& function, Projection& projection) {
  return [&](auto&& one) -> bool { return std::invoke(function, std::invoke(projection, one)); };
}
template <class Compare, class Projection>
auto compared_by(Compare& compare, Projection& projection) {
  return [&](auto&& a, auto&& b) -> bool {
    return std::invoke(compare, std::invoke(projection, a), std::invoke(projection, b));
  };
}

template <class Range, class Test, class Projection = std::identity>
constexpr auto find_if(Range&& range, Test test, Projection projection = {}) {
  auto at = begin(range);
  while (at != end(range) && !std::invoke(test, std::invoke(projection, *at))) ++at;
  return at;
}
template <class Range, class Value, class Projection = std::identity>
constexpr auto find(Range&& range, const Value& value, Projection projection = {}) {
  return ranges::find_if(
      range, [&](const auto& one) { return one == value; }, projection);
}
template <class Range, class Test, class Projection = std::identity>
constexpr bool any_of(Range&& range, Test test, Projection projection = {}) {
  return ranges::find_if(range, test, projection) != end(range);
}
template <class Range, class Test, class Projection = std::identity>
constexpr bool none_of(Range&& range, Test test, Projection projection = {}) {
  return !ranges::any_of(range, test, projection);
}
template <class Range, class Test, class Projection = std::identity>
constexpr bool all_of(Range&& range, Test test, Projection projection = {}) {
  return ranges::none_of(
      range, [&](const auto& one) { return !std::invoke(test, one); }, projection);
}
template <class Range, class Test, class Projection = std::identity>
auto count_if(Range&& range, Test test, Projection projection = {}) {
  return std::count_if(begin(range), end(range), seen_by(test, projection));
}
template <class Range, class Value>
auto count(Range&& range, const Value& value) {
  return std::count(begin(range), end(range), value);
}
template <class Range, class Out, class Test>
void copy_if(Range&& range, Out out, Test test) {
  std::copy_if(begin(range), end(range), out, [&](const auto& one) { return std::invoke(test, one); });
}
template <class A, class B, class Same = std::equal_to<>, class ProjectionA = std::identity,
          class ProjectionB = std::identity>
bool equal(A&& a, B&& b, Same same = {}, ProjectionA of_a = {}, ProjectionB of_b = {}) {
  return std::equal(begin(a), end(a), begin(b), end(b), [&](const auto& x, const auto& y) {
    return same(std::invoke(of_a, x), std::invoke(of_b, y));
  });
}
template <class A, class B>
bool is_permutation(A&& a, B&& b) {
  return std::is_permutation(begin(a), end(a), begin(b), end(b));
}
template <class Range, class Value>
void replace(Range&& range, const Value& old, const Value& other) {
  std::replace(begin(range), end(range), old, other);
}
template <class Range, class Value>
void fill(Range&& range, const Value& value) {
  std::fill(begin(range), end(range), value);
}
template <class Range, class Compare = std::less<>, class Projection = std::identity>
void sort(Range&& range, Compare compare = {}, Projection projection = {}) {
  std::sort(begin(range), end(range), compared_by(compare, projection));
}
template <class Range, class Compare = std::less<>, class Projection = std::identity>
void stable_sort(Range&& range, Compare compare = {}, Projection projection = {}) {
  std::stable_sort(begin(range), end(range), compared_by(compare, projection));
}
template <class Range>
constexpr auto max_element(Range&& range) {
  return std::max_element(begin(range), end(range));
}
template <class Range, class Value>
auto lower_bound(Range&& range, const Value& value) {
  return std::lower_bound(begin(range), end(range), value);
}
template <class A, class B, class Out>
void set_intersection(A&& a, B&& b, Out out) {
  std::set_intersection(begin(a), end(a), begin(b), end(b), out);
}
template <class Range>
auto next_permutation(Range&& range) {
  struct Found {
    bool found;
  };
  return Found{std::next_permutation(begin(range), end(range))};
}

}  // namespace std::ranges
#endif

#if _LIBCPP_VERSION < 200000
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>

namespace std {

/// A decimal number without blanks, sign '+', hexadecimals, or words but inf and nan.
inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  const char* at = first;
  if (at != last && *at == '-') ++at;
  const auto is_digit = [&](const char* c) { return c != last && *c >= '0' && *c <= '9'; };
  const auto begins = [&](const char* word) {
    const char* c = at;
    for (; *word; ++word, ++c)
      if (c == last || (*c | 0x20) != *word) return false;
    return true;
  };
  if (begins("inf") || begins("nan")) {
    const double size = begins("inf") ? HUGE_VAL : std::nan("");
    value = at == first ? size : -size;
    return {at + (begins("infinity") ? 8 : 3), errc()};
  }
  const char* const digits = at;
  while (is_digit(at)) ++at;
  std::size_t count = static_cast<std::size_t>(at - digits);
  if (at != last && *at == '.' && (count > 0 || is_digit(at + 1))) {
    const char* const point = at++;
    while (is_digit(at)) ++at;
    count += static_cast<std::size_t>(at - point) - 1;
  }
  if (count == 0) return {first, errc::invalid_argument};
  if (at != last && (*at == 'e' || *at == 'E')) {
    const char* power = at + 1;
    if (power != last && (*power == '-' || *power == '+')) ++power;
    if (is_digit(power)) {
      at = power;
      while (is_digit(at)) ++at;
    }
  }
  const double read = std::strtod(string(first, at).c_str(), nullptr);
  const bool is_zero = string(digits, at).find_first_of("123456789") == string::npos || *digits == 'e';
  if (std::isinf(read) || (read == 0 && !is_zero)) return {at, errc::result_out_of_range};
  value = read;
  return {at, errc()};
}

}  // namespace std
#endif
