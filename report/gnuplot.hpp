#pragma once

#include <filesystem>
#include <string>

/// Pieces of gnuplot scripts.
namespace oddity {

std::string quoted(const std::string& text);
/// Literal text where gnuplot takes enhanced text, and the same in bold.
std::string plain(const std::string& text);
std::string bold(const std::string& text);

/// A named block of data rows; without rows it holds one that is not drawn.
std::string block(const std::string& name, const std::string& rows);

/// The terminal and the file, 1000 wide.
std::string svg(double height, const std::filesystem::path& file);

/// Colour and dashes of a quantity's i-th model. The colours are Okabe and Ito's, which colour-blind readers
/// can tell apart, less the yellow that white swallows; an eighth model has the first colour again, dashed.
std::string model_line(std::size_t i);

}  // namespace oddity
