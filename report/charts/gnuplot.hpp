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

/// At most so many letters, the last three of them dots where some are left out.
std::string shortened(const std::string& text, std::size_t most);
/// Literal text within XML.
std::string in_xml(const std::string& text);

/// A named block of data rows; without rows it holds one that is not drawn.
std::string block(const std::string& name, const std::string& rows);
/// The command that sends what is drawn into `file`.
std::string set_output(const std::filesystem::path& file);
/// The terminal and the file, 1000 wide.
std::string svg(double height, const std::filesystem::path& file);

/// What a picture says, in bold, and beneath it what it is of; the plot begins below.
std::string headline(const std::string& says, const std::string& title, double height);

/// An SVG file, the script that draws it into a file of another name, and what it is of.
struct Picture {
  std::filesystem::path file;
  std::function<std::string(const std::filesystem::path& into)> script;
  std::string title = {};
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
