#pragma once

#include <span>
#include <string>

#include "report/study/engines.hpp"
#include "report/study/results.hpp"
#include "report/study/trust.hpp"

/// Pages of the site about all exercises: the evidence for the verdicts, stability limits, and third-party
/// engines.
namespace oddity {

std::string trust_html(const Results&, const Trust&);
std::string stability_html(const Results&);
std::string engines_html(const Results&, std::span<const EngineContest>);

}  // namespace oddity
