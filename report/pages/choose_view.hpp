#pragma once

#include <string>

#include "report/study/choose.hpp"
#include "report/text/screen.hpp"

/// A choice, as text and for other programs.
namespace oddity {

/// What has to hold: "angle within 1 deg at every frame; with its energy right to 5 % ..."; or at other
/// times.
std::string what_holds(const Choice&, const std::string& when = "at every frame");
/// What was asked, and the answer with its margin.
std::string asked_text(const Choice&);
/// Over what part of the horizon asked for it is; empty: all of it.
std::string part_text(const Choice&);
std::string answer_text(const Choice&, const Screen& = {});
/// The choice as a sentence and a table, for a terminal; the table's first rows, or all.
std::string choice_text(const Choice&, bool all_rows, const Screen& = {});
/// How well the true motion is known, and by what.
std::string truth_text(const Choice&, const Screen& = {});
/// What was tried and where the time went.
std::string explanation_text(const Choice&);
/// An error by the need's criterion, in the units asked in.
std::string shown_errors(const Candidate&, const Choice&);
/// With an array of engines' trials, where there are any.
std::string choice_json(const Choice&, const std::string& engines = {});
std::string choice_csv(const Choice&);

}  // namespace oddity
