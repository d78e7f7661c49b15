#include "report/gnuplot.hpp"

#include <array>
#include <cmath>
#include <string_view>

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

std::string block(const std::string& name, const std::string& rows) {
  return name + " << EOD\n" + (rows.empty() ? "1 NaN NaN\n" : rows) + "EOD\n";
}

std::string svg(double height, const std::filesystem::path& file) {
  return "set terminal svg size 1000," + std::to_string(std::lround(height)) +
         " dynamic font 'Helvetica,12' background '#ffffff'\nset output " + quoted(file.string()) + "\n";
}

std::string model_line(std::size_t i) {
  constexpr std::array colours{"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"};
  return std::string("lc rgb '") + colours[i % colours.size()] + "'" + (i < colours.size() ? "" : " dt 2");
}

}  // namespace oddity
