#include "solvers/ode/catalog.hpp"

#include <vector>

#include "solvers/ode/all.hpp"

namespace oddity::ode {

namespace {

constexpr std::string_view odeint = "Boost.Odeint", gsl = "GSL", sundials = "SUNDIALS";
constexpr std::string_view boost_1_74 = "1.74", gsl_2_7 = "2.7.1", sundials_6_4 = "6.4.1";
constexpr std::string_view judged = "nothing: trials are judged by their true errors";
constexpr std::string_view history_restart = "the history restarts whenever the step changes";
constexpr Finding all_findings[] = {
    {odeint, boost_1_74, "controlled_runge_kutta, bulirsch_stoer", "odeint_nan",
     "take NaN for no error: x' = x^2 from 1 is integrated through its pole at t = 1 to t = 2, which returns "
     "normally, with NaN",
     "every accepted state is checked"},
    {odeint, boost_1_74, "make_controlled", "odeint_make_controlled",
     "compiles with the header of a stepper alone, generation_runge_kutta_dopri5.hpp, and then takes the "
     "relative tolerance for the largest step. One second of a pendulum at 1e-4 takes more than 1000 times "
     "the steps. With generation_controlled_runge_kutta.hpp as well it is right",
     "the controller is put together without it"},
    {odeint, boost_1_74, "bulirsch_stoer", "odeint_bulirsch_stoer_backward",
     "takes more than 150 times the evaluations when time runs backward, for 10 s of a pendulum at a "
     "tolerance of 1e-12",
     "it integrates in -t instead, at the cost of forward time"},
    {odeint, boost_1_74, "runge_kutta_fehlberg78", "odeint_fehlberg78",
     "estimates its error by stages that lie at the step's two ends, with weights that cancel at each: it sees "
     "none where the right-hand side knows time alone. Of x' = cos t over 10 s it errs by more than 1e-5 at "
     "every tolerance from 0.01 to 1e-12, the same",
     "no model that has such a rate is solved by it"},
    {odeint, boost_1_74, "symplectic_rkn_sb3a_m4_mclachlan", "odeint_mclachlan",
     "asks for the forces 5 times per step; the last answer has the weight zero",
     "the fifth is not evaluated"},
    {odeint, boost_1_74, "adams_bashforth", "odeint_adams_bashforth_in_place",
     "has order 1 in place, as its default starter writes its result over its input. The first step of 0.1 "
     "of x'' = -x errs by more than 0.1 in place, and by less than 1e-7 otherwise",
     "Runge-Kutta 4 starts"},
    {odeint, boost_1_74, "adams_bashforth", "odeint_adams_bashforth_new_step",
     "goes on with its history when the step changes, as if the past steps had been as long: with the step "
     "halved on the way, four steps have order 2",
     history_restart},
    {odeint, boost_1_74, "adams_bashforth_moulton", "odeint_adams_moulton_starter",
     "starts with Runge-Kutta 4, which leaves order 5 to six steps and to eight", "Fehlberg 7(8) starts"},
    {odeint, boost_1_74, "implicit_euler", "odeint_implicit_euler",
     "factorizes, from its second Newton iteration on, the matrix that it has factorized before. A step of "
     "0.3 s of a pendulum takes 30 evaluations to 1e-12, where the matrix as it was takes 10",
     "one iteration is taken"},
    {odeint, boost_1_74, "rosenbrock4", "odeint_rosenbrock4",
     "has its coefficient d4 with the wrong sign: its order is 1 where the right-hand side knows the time, "
     "and 4 with the sign turned",
     "time is given as one more unknown"},
    {gsl, gsl_2_7, "gsl_odeiv2_evolve_apply", "gsl_nan",
     "takes NaN for no error: rk8pd and bsimp integrate x' = sqrt(x) - 1 from 0.5 beyond x = 0 and return "
     "success, with NaN",
     "a derivative that is not finite fails the step"},
    {gsl, gsl_2_7, "msadams, msbdf", "gsl_multistep_pole",
     "leave the solution of x' = x^2 from 1 before its pole at t = 1. At a tolerance of 0.1 x is beyond 1e15 "
     "before t = 0.85, where it should be below 7",
     judged},
    {gsl, gsl_2_7, "msadams, msbdf", "gsl_multistep_error",
     "control the error of a step, not of the motion. After 10 s of x'' = -x at a tolerance of 1e-11 msadams "
     "errs by more than 200 tolerances, msbdf by more than 500, and rk8pd by less than 1",
     judged},
    {gsl, gsl_2_7, "bsimp", "gsl_bsimp_order",
     "chooses its order once, whatever the tolerance: 12, at 139 evaluations per step. A tolerance of 0.01 "
     "costs as many evaluations as one of 1e-6, for 10 s of x'' = -x",
     judged},
    {gsl, gsl_2_7, "gsl_integration_cquad", "gsl_cquad",
     "does not compare its estimate with the request. The integral of 1/sqrt|x - 0.3| over [0, 1] to 1e-10 "
     "ends with success, with an error and an estimate above 1e-8. From 1 to 0 its estimate is below zero. "
     "Without a budget, it takes more than 1,000,000 evaluations of 1/x over [-1, 2]",
     "the estimate is checked, the ends are put in order, and a budget ends it"},
    {gsl, gsl_2_7, "gsl_integration_glfixed_table_alloc", "gsl_glfixed",
     "computes weights without a table to ten digits only: those of 50 points miss their sum by more than "
     "1e-11, while the nodes have all digits. Those of 64 points, from a table, are right",
     "the weights are computed again"},
    {gsl, gsl_2_7, "bsimp", "gsl_bsimp_error",
     "errs by more than 100 tolerances where a step is longer than half the motion's period: x' = x cos t "
     "over 8 s at 1e-6",
     judged},
    {sundials, sundials_6_4, "CV_BDF", "cvode_error",
     "controls the error of a step, not of the motion: after 10 s of x'' = -x at a tolerance of 1e-10 it errs "
     "by more than 100 tolerances",
     judged},
    {sundials, sundials_6_4, "ERKStep, ARKODE_VERNER_8_5_6", "arkode_verner",
     "has order 3 of 6: the last stage is taken for the next step's first, as both are at the step's end, "
     "though they are different states (llnl/sundials#311)",
     "the table is given the step's end as a ninth stage, and the order is 6"},
};

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
      list.push_back({Algorithm::facts, Algorithm::name, Algorithm::kind, order_of<Algorithm>()});
    });
    return list;
  }();
  return entries;
}

std::span<const Finding> findings() { return all_findings; }

std::string_view not_in_catalog() {
  return has_sundials
             ? ""
             : "CVODE Adams, CVODE BDF, ARKODE Zonneveld 4(3) and ARKODE Verner 6(5): SUNDIALS was not "
               "found when this program was built (on Debian, apt install libsundials-dev)";
}

}  // namespace oddity::ode
