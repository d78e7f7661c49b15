#pragma once

#include <concepts>
#include <memory>
#include <type_traits>

namespace oddity {

/// GSL's default handler aborts the process; this replaces it, once, with none. Every solver over GSL calls
/// it.
void quiet_gsl();

/// A function of one number, by reference: no copy, no allocation, the shape that GSL wants.
class FunctionOfOne {
 public:
  FunctionOfOne(double (*f)(double))
      : object_(reinterpret_cast<void*>(f)), call_([](double x, void* object) -> double {
          return reinterpret_cast<double (*)(double)>(object)(x);
        }) {}
  template <class F>
  requires(!std::same_as<std::remove_cvref_t<F>, FunctionOfOne> &&
           !std::is_function_v<std::remove_reference_t<F>>) FunctionOfOne(F&& f)
      : object_(const_cast<void*>(static_cast<const void*>(std::addressof(f)))),
        call_([](double x, void* object) -> double {
          return (*static_cast<std::remove_reference_t<F>*>(object))(x);
        }) {}

  double operator()(double x) const { return call_(x, object_); }

 private:
  void* object_;
  double (*call_)(double, void*);
};

/// Counts the calls of a function, and hands them on in GSL's form.
struct CountedFunction {
  FunctionOfOne f;
  long calls = 0;
  static double call(double x, void* self) {
    auto* counted = static_cast<CountedFunction*>(self);
    ++counted->calls;
    return counted->f(x);
  }
};

}  // namespace oddity
