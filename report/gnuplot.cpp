#include "report/gnuplot.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "reference/text.hpp"

namespace oddity {

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c == '\n' ? "\\n" : std::string(1, c);
  }
  return out + "\"";
}

std::string plain(const std::string& text) {
  std::string out;
  for (char c : text) {
    if (std::string_view("{}^_@&~\\").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

std::string bold(const std::string& text) { return "{/:Bold " + plain(text) + "}"; }

std::string shortened(const std::string& text, std::size_t most) {
  return text.size() <= most ? text : text.substr(0, most - 3) + "...";
}

std::string in_xml(const std::string& text) {
  std::string out;
  for (char c : text) out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  return out;
}

std::string block(const std::string& name, const std::string& rows) {
  return name + " << EOD\n" + (rows.empty() ? "1 NaN NaN\n" : rows) + "EOD\n";
}

std::string svg(double height, const std::filesystem::path& file) {
  return "set terminal svg size 1000," + std::to_string(std::lround(height)) +
         " dynamic font 'Helvetica,13' background '#ffffff'\nset output " + quoted(file.string()) + "\n";
}

std::string headline(const std::string& says, const std::string& title, double height) {
  const std::size_t most = 84;  // letters, in the full size
  const int size = says.size() <= most ? 15 : std::max(10, static_cast<int>(15 * most / says.size()));
  const auto line = [&](int number, const std::string& text, double down, int points) {
    return "set label " + std::to_string(number) + " " + quoted(text) + " at screen 0.012, screen " +
           shortest(1 - down / height) + " left font '," + std::to_string(points) + "'\n";
  };
  return line(1, bold(says), 17, size) + line(2, plain(shortened(title, 140)), 37, 12) +
         "set tmargin at screen " + shortest(1 - 58 / height) + "\n";
}

}  // namespace oddity
