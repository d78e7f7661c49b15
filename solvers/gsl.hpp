#pragma once

#include <concepts>
#include <exception>
#include <limits>
#include <memory>
#include <new>
#include <type_traits>

namespace oddity {

/// GSL's default handler aborts the process; this replaces it, once, with none. Every solver over GSL calls
/// it.
void disable_gsl_abort();

/// Deletes what a C library has allocated.
template <auto free>
struct Free {
  template <class T>
  void operator()(T* object) const {
    free(object);
  }
};

/// What a C library has allocated, or std::bad_alloc where it could not.
template <class T>
T* allocated(T* object) {
  if (!object) throw std::bad_alloc();
  return object;
}

/// A function of one number, by reference: no copy, no allocation, the shape that GSL wants.
class FunctionOfOne {
 public:
  FunctionOfOne(double (*f)(double))
      : function_(f), call_([](const FunctionOfOne& self, double x) { return self.function_(x); }) {}
  template <class F>
  requires(!std::same_as<std::remove_cvref_t<F>, FunctionOfOne> &&
           !std::is_function_v<std::remove_reference_t<F>>) FunctionOfOne(F&& f)
      : object_(const_cast<void*>(static_cast<const void*>(std::addressof(f)))),
        call_([](const FunctionOfOne& self, double x) -> double {
          return (*static_cast<std::remove_reference_t<F>*>(self.object_))(x);
        }) {}

  double operator()(double x) const { return call_(*this, x); }

 private:
  union {
    void* object_;
    double (*function_)(double);
  };
  double (*call_)(const FunctionOfOne&, double);
};

/// Counts the calls of a function, and hands them on in GSL's form. An exception must not pass through C: it
/// is kept for `rethrow`, and the function is the largest number from there on, whose error estimate
/// overflows: that ends every algorithm soon.
struct CountedFunction {
  FunctionOfOne f;
  long calls = 0;
  std::exception_ptr thrown = {};

  static double call(double x, void* self) noexcept {
    auto* counted = static_cast<CountedFunction*>(self);
    if (counted->thrown) return std::numeric_limits<double>::max();
    ++counted->calls;
    try {
      return counted->f(x);
    } catch (...) {
      counted->thrown = std::current_exception();
      return std::numeric_limits<double>::max();
    }
  }
  void rethrow() const {
    if (thrown) std::rethrow_exception(thrown);
  }
};

}  // namespace oddity
