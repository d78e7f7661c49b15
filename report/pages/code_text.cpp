#include "report/pages/code_text.hpp"

#include <cmath>
#include <sstream>

#include "report/text/readable.hpp"

namespace oddity {

std::string header_line(const Scene& scene) {
  std::string line = "t [" + std::string(scene.axes.time) + "]";
  for (const std::string_view name : scene.axes.observables) line += "," + std::string(name);
  return line;
}

std::string integer_text(double x) { return std::to_string(std::lround(x)); }

std::string parameter_line(const Parameter& p, std::string_view type, std::string_view name,
                           std::string_view value) {
  std::string line(type);
  line.append(" ").append(name).append(" = ").append(value).append(";  // ");
  if (!p.unit.empty() && p.unit != "1") line.append(p.unit).append(": ");
  return line + readable(std::string(p.says)) + "\n";
}

std::string as_comment(const std::string& text) {
  std::string comment;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) comment += line.empty() ? "//\n" : "// " + line + "\n";
  return comment;
}

std::string with_lines_apart(std::string code) {
  for (auto at = code.find("\\\n"); at != std::string::npos; at = code.find("\\\n", at))
    code.insert(at + 1, ".");
  return code;
}

}  // namespace oddity
