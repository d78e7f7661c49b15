#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "report/study/choose.hpp"

/// What `choose` has chosen, as C++ to paste.
namespace oddity {

/// Whether a listing's expression has this name as a word.
bool mentions(std::string_view expression, std::string_view name);
/// A listing's expression, which is in double, in another number type.
std::string in_number_type(std::string_view expression, std::string_view number);

/// The algorithms that can be printed.
std::vector<std::string_view> printable_algorithms();

/// One C++20 file of the standard library alone: the chosen model, the chosen algorithm's loop, and a main
/// that prints the observables at every frame; `command` is the command line that asked for it. Throws
/// BadInput where the choice has no model or algorithm that can be printed.
std::string code_of(const Task&, const Choice&, const std::string& command);
/// The same of a candidate, headed by a comment about it.
std::string code_of(const Task&, const Candidate&, const Need&, const std::string& about);

}  // namespace oddity
