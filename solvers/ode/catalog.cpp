#include "solvers/ode/catalog.hpp"

#include <limits>
#include <vector>

#include "solvers/ode/all.hpp"

namespace oddity::ode {

namespace {

constexpr double all = std::numeric_limits<double>::infinity();
constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr std::string_view odeint = "Boost.Odeint", gsl = "GSL";
constexpr std::string_view no_fixed_step = "no fixed step";
constexpr std::string_view polynomial = "roots of |R(z)| = 1, R the stability polynomial of the tableau";
constexpr std::string_view trace = "half the trace of the step's matrix is -1";
constexpr std::string_view characteristic = "largest root of the characteristic polynomial";

/// What an algorithm's type does not say. There is none for an algorithm that has no line below.
struct Facts {
  std::string_view library;
  int evaluations;
  bool jacobian;
  double real_limit, imaginary_limit;
  std::string_view theory, remark = "";
};

template <class Algorithm>
extern const Facts facts;

constexpr std::string_view make_controlled =
    "Boost 1.74's make_controlled hands the relative tolerance on as the largest step, which is correct and "
    "slow "
    "without end: the controller is put together here";

template <>
constexpr Facts facts<ExplicitEuler>{odeint, 1, false, 2, 0, "R(z) = 1 + z"};
template <>
constexpr Facts facts<SymplecticEuler>{odeint, 1, false, none, 2, trace};
template <>
constexpr Facts facts<VelocityVerlet>{odeint, 1, false, none, 2, trace, "one evaluation more to start"};
template <>
constexpr Facts facts<RungeKutta4>{odeint, 4, false, 2.785294, 2.828427, polynomial};
template <>
constexpr Facts facts<CashKarp54>{odeint, 6, false, 3.734360, 0, polynomial, make_controlled};
template <>
constexpr Facts facts<DormandPrince54>{odeint, 6, false, 3.306568, 0.997189, polynomial, make_controlled};
template <>
constexpr Facts facts<Fehlberg78>{odeint, 13, false, 5.007589, 2.365158, polynomial, make_controlled};
template <>
constexpr Facts facts<BulirschStoer>{
    odeint,
    0,
    false,
    none,
    none,
    no_fixed_step,
    "Odeint weighs its orders by their cost over the signed step: backward it takes up to 150 times the "
    "evaluations, so time itself is turned round instead"};
template <>
constexpr Facts facts<ModifiedMidpoint>{odeint,        3, false, 3.087378, 0, "R(z) = 1 + z + z^2/2 + z^3/8",
                                        "two substeps"};
template <>
constexpr Facts facts<McLachlan4>{odeint,
                                  4,
                                  false,
                                  none,
                                  2.967808,
                                  trace,
                                  "Odeint computes a fifth force, of weight zero: it is not evaluated here. "
                                  "The header lacks an include of its "
                                  "base"};
template <>
constexpr Facts facts<AdamsBashforth4>{
    odeint,
    1,
    false,
    0.3,
    0.429987,
    characteristic,
    "Odeint goes on with its history when the step changes, as if the past steps had been as long: here the "
    "history starts anew, with three steps of Runge-Kutta 4"};
template <>
constexpr Facts facts<AdamsBashforthMoulton6>{odeint,
                                              2,
                                              false,
                                              0.698003,
                                              0.526717,
                                              characteristic,
                                              "Odeint starts with Runge-Kutta 4, which leaves order 5 of 6 "
                                              "or 8 (measured 5.0): here Fehlberg 7(8) starts, "
                                              "anew whenever the step changes, and the order is 6"};
template <>
constexpr Facts facts<ImplicitEuler>{
    odeint,
    1,
    true,
    all,
    all,
    "R(z) = 1 / (1 - z)",
    "from its second Newton iteration on Odeint factorizes the matrix that it has factorized before: one "
    "iteration is taken"};
template <>
constexpr Facts facts<Rosenbrock4>{odeint,
                                   6,
                                   true,
                                   none,
                                   none,
                                   no_fixed_step,
                                   "in Boost 1.74 the coefficient d4 has the wrong sign, and the order is 1 "
                                   "where the right-hand side knows the "
                                   "time: time is given as one more unknown, and the order is 4"};
template <>
constexpr Facts facts<Rk8pd>{
    gsl,
    13,
    false,
    5.166634,
    0,
    polynomial,
    "GSL's step control takes NaN for no error: a derivative that is not finite fails "
    "the step, here and in GSL's others"};
template <>
constexpr Facts facts<Msadams>{
    gsl,
    0,
    false,
    none,
    none,
    no_fixed_step,
    "at a tolerance of 0.1 it blows up on its own, 12 % before a pole; its error is up to 230 tolerances"};
template <>
constexpr Facts facts<Msbdf>{gsl, 0, true, none, none, no_fixed_step, "its error is up to 900 tolerances"};
template <>
constexpr Facts facts<Bsimp>{gsl,
                             0,
                             true,
                             none,
                             none,
                             no_fixed_step,
                             "GSL chooses its order once, for a tolerance of 1e-8, whatever the tolerance "
                             "is: 12, at 138 evaluations a "
                             "step, and so a loose tolerance saves nothing. With steps as long as the motion "
                             "its error estimate is below "
                             "its error by up to 200 times"};
#ifdef ODDITY_SUNDIALS
constexpr std::string_view sundials = "SUNDIALS";
template <>
constexpr Facts facts<CvodeAdams>{sundials, 0, false, none, none, no_fixed_step};
template <>
constexpr Facts facts<CvodeBdf>{
    sundials, 0, true, none, none, no_fixed_step, "its error is up to 900 tolerances"};
template <>
constexpr Facts facts<ArkodeZonneveld43>{sundials, 5, false, 2.785294, 2.828427, polynomial};
template <>
constexpr Facts facts<ArkodeVerner65>{
    sundials,
    8,
    false,
    4.064777,
    1.306765,
    polynomial,
    "ERKStep of SUNDIALS 6.4 takes the last stage for the next step's first, as it stands at the step's end, "
    "though it is another state (llnl/sundials#311): measured order 3. The table is given "
    "the "
    "step's end as a ninth stage, and the order is 6"};
#endif

template <class Algorithm>
constexpr int order_of() {
  if constexpr (requires { Algorithm::order; })
    return Algorithm::order;
  else
    return 0;
}

}  // namespace

std::span<const CatalogEntry> catalog() {
  static const std::vector<CatalogEntry> entries = [] {
    std::vector<CatalogEntry> list;
    for_each_algorithm([&]<class Algorithm>() {
      const Facts& f = facts<Algorithm>;
      list.push_back({Algorithm::name, Algorithm::kind, order_of<Algorithm>(), f.library, f.evaluations,
                      f.jacobian, f.real_limit, f.imaginary_limit, f.theory, f.remark});
    });
    return list;
  }();
  return entries;
}

std::string_view not_in_catalog() {
  return has_sundials
             ? ""
             : "CVODE Adams, CVODE BDF, ARKODE Zonneveld 4(3) and ARKODE Verner 6(5): SUNDIALS was not "
               "found when this program was built (on Debian, apt install libsundials-dev)";
}

}  // namespace oddity::ode
