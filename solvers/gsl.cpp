#include "solvers/gsl.hpp"

#include <gsl/gsl_errno.h>

namespace oddity {

void disable_gsl_abort() {
  static const auto previous = gsl_set_error_handler_off();
  static_cast<void>(previous);
}

}  // namespace oddity
