#pragma once

#include "report/study/results.hpp"
#include "report/study/trust.hpp"
#include "report/text/table_text.hpp"

/// The basis of all results: proofs, enclosures, witnesses, mutants, fuzzing, survived faults.
namespace oddity {

/// For a screen: a row per part, and its basis.
std::string trust_text(const Results&, const Trust&, const Screen&);
/// For other programs: a row per part, and one for each of its kinds, modules, targets or faults.
Table trust_table(const Results&, const Trust&);
/// As a page of the report.
std::string trust_page(const Results&, const Trust&);

}  // namespace oddity
