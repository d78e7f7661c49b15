#include "report/pages/code_text.hpp"

#include <cmath>
#include <sstream>

#include "reference/code_text.hpp"
#include "report/text/readable.hpp"

namespace oddity {

std::string header_line(const Scene& scene) {
  std::string line = "t [" + std::string(scene.axes.time) + "]";
  for (const std::string_view name : scene.axes.observables) line += "," + in_string(std::string(name));
  return line;
}

std::string integer_text(double x) { return std::to_string(std::lround(x)); }

std::string parameter_line(const Parameter& p, std::string_view type, std::string_view name,
                           std::string_view value) {
  std::string line(type);
  line.append(" ").append(name).append(" = ").append(value).append(";  // ");
  if (!p.unit.empty() && p.unit != "1") line.append(p.unit).append(": ");
  return line + in_comment(readable(std::string(p.says))) + "\n";
}

std::string as_comment(const std::string& text) {
  std::string comment;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    comment += line.empty() ? "//\n" : "// " + in_comment(line) + "\n";
  return comment;
}

}  // namespace oddity
