#include "report/pages/catalog_page.hpp"

#include <cmath>
#include <vector>

#include "reference/text.hpp"
#include "report/text/markup.hpp"
#include "solvers/ode/catalog.hpp"

namespace oddity {

namespace {

std::string setting_of(ode::Kind kind) { return ode::has_tolerance(kind) ? "tolerance" : "step"; }

std::string limit_cell(double limit) {
  if (std::isnan(limit)) return "-";
  return std::isinf(limit) ? "all" : limit == 0 ? "none" : format_significant(limit, 7);
}

std::string evaluations_cell(const ode::CatalogEntry& a) {
  const std::string count = a.evaluations == 0 ? "varies" : std::to_string(a.evaluations);
  return count + (a.jacobian ? " + Jacobian" : "");
}

}  // namespace

std::string catalog_page() {
  std::vector<std::vector<std::string>> rows, findings;
  for (const ode::CatalogEntry& a : ode::catalog()) {
    rows.push_back({std::string(a.name), std::string(a.library), setting_of(a.kind),
                    a.order == 0 ? "varies" : std::to_string(a.order), evaluations_cell(a),
                    limit_cell(a.real_limit), limit_cell(a.imaginary_limit), escaped(std::string(a.theory))});
  }
  for (const ode::Finding& f : ode::findings())
    findings.push_back({std::string(f.library) + " " + std::string(f.version), code(std::string(f.in)),
                        escaped(std::string(f.found)), escaped(std::string(f.done)),
                        code("tests/libraries/" + std::string(f.shown_by) + ".cpp")});
  std::string text =
      "# The catalog of algorithms\n\n"
      "Every algorithm that integrates a motion here is certified by tests. They measure its order from both "
      "sides, with and without explicit time, forward and backward. They count its evaluations, and compare "
      "its limits of stability with the theory in this table. A limit is the "
      "largest " +
      prose("$h|\\lambda|$ at which $y'=\\lambda y$") +
      " does not grow, on the negative real axis and on the "
      "imaginary axis. An algorithm that is set by a tolerance chooses its steps; its limits, if any, "
      "are those of its plain step.\n\n" +
      table({"algorithm", "library", "set by", "order", "evaluations per step", "real limit",
             "imaginary limit", "theory"},
            rows, "356") +
      std::string(ode::work_of_series) + "\n\n" +
      "## Findings in the libraries\n\nA small test of the library alone shows each finding in "
      "the named version; with another version it prints its measurement. Faults are "
      "repaired from outside.\n\n" +
      table({"library", "in", "finding", "remedy here", "shown by"}, findings);
  if (const auto missing = ode::not_in_catalog(); !missing.empty())
    text += "Not in this build: " + escaped(std::string(missing), false) + ".\n\n";
  return text + "[All exercises](README.md)\n";
}

}  // namespace oddity
