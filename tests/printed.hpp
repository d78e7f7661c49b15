#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "chapters/contents.hpp"
#include "report/study/choose.hpp"

/// Shared by the tests of printed code: a second of a motion, and the output of a printed program.
namespace oddity::printed {

constexpr double frames_per_second = 60, steps = 2;

inline Need need_of_a_second() {
  Need need{1};
  need.horizon = 1;
  need.frames_per_second = frames_per_second;
  return need;
}

/// All parameters changed a little, each by a different fraction.
inline Task task_of_source(const Entry& entry) {
  Task task(entry);
  double part = 0;
  for (const Parameter& p : entry.exercise.parameters) {
    part += 0.01;
    const double value = p.value + part * (p.value == 0 ? 1 : std::abs(p.value));
    if (!p.whole) task.parameters.set(p.name, value <= p.most ? value : p.value * (1 - part));
  }
  return task;
}

/// The largest difference of two motions, as a part of the largest value so far. Infinite where one alone has
/// no number.
inline double largest_difference(const Value& one, std::span<const double> other) {
  constexpr double none = std::numeric_limits<double>::infinity();
  double size = 0, worst = 0;
  for (std::size_t k = 0; k < one.size(); ++k) {
    if (std::isnan(one[k]) != std::isnan(other[k])) return none;
    if (std::isnan(one[k]) || one[k] == other[k]) continue;
    size = std::max(size, std::abs(one[k]));
    worst = std::max(worst, size > 0 ? std::abs(other[k] - one[k]) / size : none);
  }
  return worst;
}

/// Output and errors of a command; begins with "failed: " if the exit code is not 0.
inline std::string output_of(const std::string& command) {
  std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  std::string output;
  std::array<char, 1 << 16> buffer{};
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe))
    output.append(buffer.data(), n);
  if (pclose(pipe) != 0) output = "failed: " + command + "\n" + output;
  return output;
}

/// The observables of each case: all numbers of a row but the first, and but an orientation's.
inline std::vector<std::vector<double>> observables(const std::string& output) {
  std::vector<std::vector<double>> all;
  std::istringstream lines(output);
  std::size_t columns = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line == "case") {
      all.emplace_back();
      std::getline(lines, line);  // the names
      columns =
          static_cast<std::size_t>(std::ranges::count(line, ',')) - (line.ends_with(",qw,qx,qy,qz") ? 4 : 0);
      continue;
    }
    std::istringstream cells(line);
    std::string cell;
    std::getline(cells, cell, ',');
    for (std::size_t i = 0; i < columns && std::getline(cells, cell, ','); ++i)
      all.back().push_back(std::strtod(cell.c_str(), nullptr));
  }
  return all;
}

}  // namespace oddity::printed
