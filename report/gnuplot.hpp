#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// Pieces of gnuplot scripts, and how they are run.
namespace oddity {

/// A string expression of gnuplot's with this text, in which nothing is expanded or run. Lines stay apart;
/// other control characters become spaces.
std::string quoted(const std::string& text);
/// Literal text where gnuplot takes enhanced text, and the same in bold.
std::string plain(const std::string& text);
std::string bold(const std::string& text);
/// A named block of data rows; without rows it holds one that is not drawn.
std::string block(const std::string& name, const std::string& rows);
/// The command that sends what is drawn into `file`.
std::string set_output(const std::filesystem::path& file);
/// The terminal and the file, 1000 wide.
std::string svg(double height, const std::filesystem::path& file);
/// Colour and dashes of a quantity's i-th model. The colours are Okabe and Ito's, which colour-blind readers
/// can tell apart, less the yellow that white swallows; an eighth model has the first colour again, dashed.
std::string model_line(std::size_t i);

/// An SVG file, and the script that draws it into a file of another name.
struct Picture {
  std::filesystem::path file;
  std::function<std::string(const std::filesystem::path& into)> script;
};

/// What draws: gnuplot, unless a test has something else.
struct Plotter {
  std::string program;
  std::chrono::milliseconds limit;  ///< of its time, for each picture
};
Plotter gnuplot_plotter();

/// Draws the pictures; each file is whole, or none is changed. Throws BadInput with gnuplot's words when it
/// cannot be run, fails, is ended, takes too long, or leaves a picture unfinished.
void draw(const std::vector<Picture>&, const Plotter& = gnuplot_plotter());

}  // namespace oddity
