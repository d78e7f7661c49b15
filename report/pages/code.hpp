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

/// The program of any model by one of printable_algorithms(), for whoever has a model's code: $model stands for that
/// and the function oddity::asked::model(), $names for the head of what is printed; then $frames, $rate (1/s) and, but
/// of a closed form, $steps to a frame.
std::string program_template(std::string_view algorithm);

// Where a need asks for lockstep, the program has the same bits by every compiler and on every processor: its
// numbers are those of report/plain/lockstep.hpp.

/// Why there is no such program of this model and algorithm, which may be in float: "calls GSL". Empty:
/// there is.
std::string why_not_in_lockstep(const Task&, const std::string& model, const std::string& algorithm);
/// The elementary functions that such a program has of its own: "sin".
std::vector<std::string> functions_in_lockstep(const Task&, const Candidate&);
/// A program that prints the seconds that a frame of the candidate takes, in lockstep or as usual. Frames of
/// different lengths are timed as if they were not.
std::string timing_code_of(const Task&, const Candidate&, Need, bool lockstep);

}  // namespace oddity
