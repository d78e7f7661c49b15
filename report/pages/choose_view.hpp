#pragma once

#include <string>

#include "report/study/choose.hpp"
#include "report/text/screen.hpp"

/// A choice as text, JSON and CSV.
namespace oddity {

/// The need's tolerances: "angle within 1 deg at every frame; with its energy right to 5 % ...".
std::string what_holds(const Choice&, const std::string& when = "at every frame");
/// The need in a sentence.
std::string asked_text(const Choice&);
/// The part of the horizon that was judged; empty if all of it was.
std::string part_text(const Choice&);
/// The chosen method, with its rule, margin and alternatives.
std::string answer_text(const Choice&, const Screen& = {});
/// The choice for a terminal, with the table's first rows or all.
std::string choice_text(const Choice&, bool all_rows, const Screen& = {});
/// The accuracy of the true motion, and its source.
std::string truth_text(const Choice&, const Screen& = {});
/// The methods tried, and the time spent on each stage.
std::string explanation_text(const Choice&);
/// An error by the need's criterion, in the units asked in.
std::string shown_errors(const Candidate&, const Choice&);
/// With an array of engines' trials, where there are any.
std::string choice_json(const Choice&, const std::string& engines = {});
std::string choice_csv(const Choice&);

}  // namespace oddity
