#pragma once
#pragma GCC system_header  // the compiler need not warn of mutants

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <type_traits>

/// Functions called by sources that extras/mutation/schemata.cpp has rewritten. Each computes the original
/// expression, or the mutant whose number is in ODDITY_MUTANT. Mutants that would change the type do not
/// exist for that type, nor do any where the compiler computes. Written in C++17 plus concepts, as it is used
/// in solvers/ode/implicit.cpp.
namespace oddity::mutation {

/// Whether a run has reached a mutant: not its place; the mutant; or its place only with types for which it
/// does not exist.
enum Seen : unsigned char { unseen, seen, seen_without_it };

/// The mutant of this run, 0 for none, and whether each was reached: a file with one byte per mutant, named
/// by ODDITY_MUTANTS_REACHED. A killed run leaves it behind too.
struct Run {
  int chosen = 0;
  unsigned char* reached = nullptr;

  Run() {
    if (const char* number = std::getenv("ODDITY_MUTANT")) chosen = std::atoi(number);
    const char* file = std::getenv("ODDITY_MUTANTS_REACHED");
    const int opened = file ? open(file, O_RDWR) : -1;
    struct stat size;
    if (opened < 0 || fstat(opened, &size) != 0) return;
    void* bytes =
        mmap(nullptr, static_cast<std::size_t>(size.st_size), PROT_READ | PROT_WRITE, MAP_SHARED, opened, 0);
    if (bytes != MAP_FAILED) reached = static_cast<unsigned char*>(bytes);
    close(opened);
  }
};

/// Initialized before everything else at the start of the program.
inline __attribute__((init_priority(101))) const Run run;

/// Whether one of the `count` mutants from `first` on may be chosen, or has to be noted.
constexpr bool among(int first, int count) {
  if (__builtin_is_constant_evaluated()) return false;
  return run.reached || static_cast<unsigned>(run.chosen - first) < static_cast<unsigned>(count);
}

constexpr bool chosen(int mutant) {
  if (__builtin_is_constant_evaluated()) return false;
  // Written only once: otherwise threads would contend for the byte.
  if (run.reached && run.reached[mutant] != seen) run.reached[mutant] = seen;
  return run.chosen == mutant;
}

/// The mutant does not exist for these types.
constexpr void absent(int mutant) {
  if (__builtin_is_constant_evaluated()) return;
  if (run.reached && run.reached[mutant] == unseen) run.reached[mutant] = seen_without_it;
}

template <class A>
using Bare = std::remove_cv_t<std::remove_reference_t<A>>;
template <class A, class B>
concept Same = std::is_same_v<Bare<A>, Bare<B>>;

// Operators as functions, defined at their place in the source, where their names are looked up.
#define ODDITY_OPERATION(op) [](const auto& x, const auto& y) -> decltype(x op y) { return x op y; }
#define ODDITY_ASSIGNMENT(op) [](auto&& x, const auto& y) -> decltype(x op y) { return x op y; }
#define ODDITY_NEGATIVE [](const auto& x) -> decltype(-x) { return -x; }

/// op(a, b), with another operator, or either operand alone.
template <class A, class B, class Op, class Other>
constexpr auto operation(int first, const A& a, const B& b, const Op& op, const Other& other)
    -> decltype(op(a, b)) {
  using Result = decltype(op(a, b));
  if (among(first, 3)) {
    if constexpr (requires { requires Same<decltype(other(a, b)), Result>; }) {
      if (chosen(first)) return other(a, b);
    } else {
      absent(first);
    }
    if constexpr (Same<A, Result>) {
      if (chosen(first + 1)) return a;
    } else {
      absent(first + 1);
    }
    if constexpr (Same<B, Result>) {
      if (chosen(first + 2)) return b;
    } else {
      absent(first + 2);
    }
  }
  return op(a, b);
}

/// op(a, b) that changes a, with another operator, or left out.
template <class A, class B, class Op, class Other>
constexpr auto assignment(int first, A&& a, const B& b, const Op& op, const Other& other)
    -> decltype(op(a, b)) {
  using Result = decltype(op(a, b));
  if (among(first, 2)) {
    if constexpr (requires { requires std::is_same_v<decltype(other(a, b)), Result>; }) {
      if (chosen(first)) return other(a, b);
    } else {
      absent(first);
    }
    if constexpr (std::is_same_v<A, Result>) {
      if (chosen(first + 1)) return a;
    } else {
      absent(first + 1);
    }
  }
  return op(a, b);
}

template <class A, class Op>
constexpr auto negative(int mutant, const A& a, const Op& op) -> decltype(op(a)) {
  if constexpr (Same<A, decltype(op(a))>) {
    if (chosen(mutant)) return a;
  } else {
    absent(mutant);
  }
  return op(a);
}

// a op b as a condition: with the border moved, or the opposite.
#define ODDITY_MUTANT_COMPARISON(name, op, border, opposite)                       \
  template <class A, class B>                                                      \
  constexpr auto name(int first, const A& a, const B& b)->decltype(a op b) {       \
    using Result = decltype(a op b);                                               \
    if (among(first, 2)) {                                                         \
      if constexpr (requires { requires Same<decltype(a border b), Result>; }) {   \
        if (chosen(first)) return a border b;                                      \
      } else {                                                                     \
        absent(first);                                                             \
      }                                                                            \
      if constexpr (requires { requires Same<decltype(a opposite b), Result>; }) { \
        if (chosen(first + 1)) return a opposite b;                                \
      } else {                                                                     \
        absent(first + 1);                                                         \
      }                                                                            \
    }                                                                              \
    return a op b;                                                                 \
  }
ODDITY_MUTANT_COMPARISON(less, <, <=, >=)
ODDITY_MUTANT_COMPARISON(at_most, <=, <, >)
ODDITY_MUTANT_COMPARISON(greater, >, >=, <=)
ODDITY_MUTANT_COMPARISON(at_least, >=, >, <)
#undef ODDITY_MUTANT_COMPARISON

#define ODDITY_MUTANT_EQUALITY(name, op, opposite)                                         \
  template <class A, class B>                                                              \
  constexpr auto name(int first, const A& a, const B& b)->decltype(a op b) {               \
    if constexpr (requires { requires Same<decltype(a opposite b), decltype(a op b)>; }) { \
      if (chosen(first)) return a opposite b;                                              \
    } else {                                                                               \
      absent(first);                                                                       \
    }                                                                                      \
    return a op b;                                                                         \
  }
ODDITY_MUTANT_EQUALITY(equal, ==, !=)
ODDITY_MUTANT_EQUALITY(unequal, !=, ==)
#undef ODDITY_MUTANT_EQUALITY

/// A whole number plus one, another number doubled; 0 becomes 1.
template <class A>
constexpr A constant(int mutant, A a) {
  if (!chosen(mutant)) return a;
  return std::is_integral_v<A> || a == A(0) ? A(a + A(1)) : A(a + a);
}

/// The index minus one; 0 becomes 1.
template <class A>
constexpr A index(int mutant, A a) {
  if (!chosen(mutant)) return a;
  return a == A(0) ? A(1) : A(a - A(1));
}

}  // namespace oddity::mutation
