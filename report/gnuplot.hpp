#pragma once

#include <filesystem>
#include <string>

/// Pieces of gnuplot scripts.
namespace oddity {

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

/// The terminal and the file, 1000 wide.
std::string svg(double height, const std::filesystem::path& file);

/// What a picture says, in bold, and beneath it what it is of; the plot begins below.
std::string headline(const std::string& says, const std::string& title, double height);

}  // namespace oddity
