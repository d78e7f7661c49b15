#pragma once

#include <concepts>
#include <exception>
#include <limits>
#include <memory>
#include <new>
#include <type_traits>

namespace oddity {

/// GSL's default error handler aborts the process; this turns it off, once. Every solver over GSL calls it.
void disable_gsl_abort();

/// Deleter for an object that a C library has allocated.
template <auto free>
struct Free {
  template <class T>
  void operator()(T* object) const {
    free(object);
  }
};

/// Returns the object, or throws std::bad_alloc if the C library could not allocate it.
template <class T>
T* allocated(T* object) {
  if (!object) throw std::bad_alloc();
  return object;
}

/// A function of one number, by reference: no copy, no allocation, in GSL's form.
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

/// Counts the calls of a function and passes them on in GSL's form. An exception must not pass through C, so
/// it is kept for `rethrow`. From there on the function returns the largest double: its error estimate
/// overflows, which soon ends every algorithm.
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
