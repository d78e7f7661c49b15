#include "problem/table.hpp"

#include <gsl/gsl_spline.h>

#include <memory>

#include "solvers/gsl.hpp"

namespace oddity::problem {

namespace {

const gsl_interp_type* type_of(Spline spline) {
  return spline == Spline::linear  ? gsl_interp_linear
         : spline == Spline::cubic ? gsl_interp_cspline
                                   : gsl_interp_steffen;
}

}  // namespace

std::size_t fewest_rows(Spline spline) { return gsl_interp_type_min_size(type_of(spline)); }

std::vector<Table::Piece> pieces_of(Spline spline, const std::vector<double>& x,
                                    const std::vector<double>& y) {
  disable_gsl_abort();
  const std::unique_ptr<gsl_spline, Free<gsl_spline_free>> through(
      allocated(gsl_spline_alloc(type_of(spline), x.size())));
  gsl_spline_init(through.get(), x.data(), y.data(), x.size());
  std::vector<Table::Piece> pieces;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    const double h = x[i + 1] - x[i];
    // At a knot GSL takes the piece that begins there.
    const double slope = gsl_spline_eval_deriv(through.get(), x[i], nullptr),
                 half = gsl_spline_eval_deriv2(through.get(), x[i], nullptr) / 2;
    const double cubed = spline == Spline::linear ? 0 : ((y[i + 1] - y[i]) / h - slope - half * h) / (h * h);
    pieces.push_back({x[i], {y[i], slope, half, cubed}});
  }
  return pieces;
}

}  // namespace oddity::problem
