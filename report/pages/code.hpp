#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "report/pages/program.hpp"
#include "report/study/choose.hpp"

/// The choice of `choose` as code to paste.
namespace oddity {

/// The algorithms that can be printed.
std::vector<std::string_view> printable_algorithms();

/// Lines of a program without comments and blank ones.
long lines_of_code(const std::string& program);

/// Limit of a C++ file with the models' own source. A longer one is printed by its recorded operations.
inline constexpr long most_lines_of_source = 60;

/// One file of the standard library alone: the chosen model, the chosen algorithm's loop, and a main that
/// prints the observables at every frame. `command` is the command line that asked for it. Throws BadInput
/// where the choice has no model or algorithm that can be printed.
std::string code_of(const Task&, const Choice&, const std::string& command, Language = Language::cpp);
/// One file for a candidate, headed by a comment about it.
std::string code_of(const Task&, const Candidate&, const Need&, const std::string& about,
                    Language = Language::cpp);

/// The program of any model by one of printable_algorithms(), with placeholders. $model is the model's code
/// and the function oddity::asked::model(). $names is the head of the output. The others are $frames, $rate
/// (1/s) and, unless it is a closed form, $steps per frame.
std::string program_template(std::string_view algorithm);

// Where a need asks for lockstep, the program has the same bits by every compiler and on every processor: its
// numbers are those of report/plain/lockstep.hpp.

/// Reason why the model and the algorithm, which may be in float, have no such program: "calls GSL". Empty if
/// they have one.
std::string why_not_in_lockstep(const Task&, const std::string& model, const std::string& algorithm);
/// Elementary functions that such a program implements: "sin".
std::vector<std::string> functions_in_lockstep(const Task&, const Candidate&);
/// A program that prints the candidate's seconds per frame, in lockstep or as usual. It ignores differences
/// in the lengths of frames.
std::string timing_code_of(const Task&, const Candidate&, Need, bool lockstep);

}  // namespace oddity
