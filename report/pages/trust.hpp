#pragma once

#include "report/study/results.hpp"
#include "report/study/trust.hpp"
#include "report/text/table_text.hpp"

/// What is proved, enclosed, witnessed, mutated, fuzzed and survived, and what that rests on.
namespace oddity {

/// For a screen: a row for each part, and what it rests on.
std::string trust_text(const Results&, const Trust&, const Screen&);
/// For other programs: a row for each part, and one for each of its kinds, rooms, targets or faults.
Table trust_table(const Results&, const Trust&);
/// The same as a page of the report.
std::string trust_page(const Results&, const Trust&);

}  // namespace oddity
