#include "report/charts/gnuplot.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>

#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "reference/text.hpp"
#include "report/charts/run_program.hpp"
#include "report/cli/settings.hpp"

namespace oddity {

namespace {

/// What gnuplot says, in one line: it shows the command, a caret beneath it, and what is wrong.
std::string in_one_line(const std::string& words) {
  std::string line;
  for (char c : words)
    if (static_cast<unsigned char>(c) > ' ')
      line += c;
    else if (!line.empty() && line.back() != ' ')
      line += ' ';
  constexpr std::size_t most = 300;
  return line.size() > most ? "... " + line.substr(line.size() - most) : line;
}

void run_plotter(const Plotter& plotter, const std::string& script, std::size_t pictures) {
  try {
    const Ended ended =
        run_program({plotter.program, "-d"}, script, plotter.limit * static_cast<long>(pictures));
    if (!ended.ok)
      throw BadInput("the charts could not be drawn: " + plotter.program + " ended with " + ended.how +
                     (ended.words.empty() ? "" : ": " + in_one_line(ended.words)));
  } catch (const std::system_error& error) {
    throw BadInput("the charts could not be drawn: " + std::string(error.what()));
  }
}

/// What a viewer shows of a picture as a whole, in place of gnuplot's name.
void set_title(const std::filesystem::path& svg, const std::string& title) {
  std::ifstream in(svg, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  constexpr std::string_view gnuplots = "<title>Gnuplot</title>";
  const auto at = text.find(gnuplots);
  if (title.empty() || at == std::string::npos) return;
  text.replace(at, gnuplots.size(), "<title>" + in_xml(title) + "</title>");
  in.close();
  if (!(std::ofstream(svg, std::ios::binary) << text << std::flush))
    throw BadInput("cannot write " + svg.string() + ": is the disk full?");
}

/// Whether the file has its end, which a full disk may have swallowed.
bool is_finished(const std::filesystem::path& file) {
  constexpr std::streamoff last_lines = 16;
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  if (!in || in.tellg() < last_lines) return false;
  std::string tail(last_lines, ' ');
  in.seekg(-last_lines, std::ios::end);
  in.read(tail.data(), last_lines);
  return tail.find("</svg>") != std::string::npos;
}

}  // namespace

std::string quoted(const std::string& text) {
  std::string out = "'";
  for (char c : text) {
    if (c == '\n')
      out += "'.\"\\n\".'";
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      out += ' ';
    else
      out += c == '\'' ? "''" : std::string(1, c);
  }
  return out + "'";
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
  if (text.size() <= most) return text;
  std::size_t end = most - 3;
  while (end > 0 && (text[end] & 0xC0) == 0x80) --end;  // within a letter of several bytes
  return text.substr(0, end) + "...";
}

std::string in_xml(const std::string& text) {
  std::string out;
  for (char c : text) out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  return out;
}

std::string block(const std::string& name, const std::string& rows) {
  return name + " << EOD\n" + (rows.empty() ? "1 NaN NaN\n" : rows) + "EOD\n";
}

std::string set_output(const std::filesystem::path& file) {
  // An absolute path: gnuplot would take "|..." for a command to run.
  return "set output " + quoted(std::filesystem::absolute(file).string()) + "\n";
}

std::string svg(double height, const std::filesystem::path& file) {
  return "set terminal svg size 1000," + std::to_string(std::lround(height)) +
         " dynamic font 'Helvetica,13' background '#ffffff'\n" + set_output(file);
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

Plotter gnuplot_plotter() { return {gnuplot(), std::chrono::seconds(60)}; }

void draw(const std::vector<Picture>& pictures, const Plotter& plotter) {
  if (pictures.empty()) return;
  std::deque<PartFile> parts;
  std::string script;
  for (const Picture& picture : pictures) script += picture.script(parts.emplace_back(picture.file).path());
  run_plotter(plotter, script, pictures.size());
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (!is_finished(parts[i].path()))
      throw BadInput("cannot write " + pictures[i].file.string() +
                     ": it came out unfinished; is the disk full?");
  for (std::size_t i = 0; i < parts.size(); ++i) set_title(parts[i].path(), pictures[i].title);
  for (PartFile& part : parts) part.keep();
}

}  // namespace oddity
