#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/fit.hpp"
#include "report/results.hpp"

namespace oddity {

/// A gnuplot script that draws a quantity's work-precision diagram as SVG into `file`: error against counted
/// evaluations, or against time with its spread. Models by colour, algorithms by mark, with the fitted orders
/// in the legend; the Pareto front; each failure under a sign of its kind, those without a number in a strip
/// above the frame. By evaluations it holds no times.
std::string chart_script(const QuantityResult&, const std::string& title, Cost,
                         const std::filesystem::path& file);

/// A gnuplot script that draws the motion of a quantity that has a trajectory: its observables over time, or
/// "x" and "y" as a path; the true motion with the reference on it, and what each model makes of it.
std::string trajectory_script(const QuantityResult&, const std::string& title,
                              const std::filesystem::path& file);

}  // namespace oddity
