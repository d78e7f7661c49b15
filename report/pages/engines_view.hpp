#pragma once

#include <string>
#include <vector>

#include "report/pages/screen.hpp"
#include "report/pages/table_text.hpp"
#include "report/study/engines.hpp"

/// What other people's engines do on the scenes, and what replaces them.
namespace oddity {

/// A table a scene: each engine's worst error at these rates [1/s], the rate from which it holds, its order,
/// and its cost there beside the least model's.
std::string engines_text(const std::vector<EngineContest>&, const std::vector<double>& rates, const Screen&);
/// A row for each trial.
Table engines_table(const std::vector<EngineContest>&);
/// The same tables as a page, with what is said of each engine.
std::string engines_page(const std::vector<EngineContest>&, const std::vector<double>& rates);

}  // namespace oddity
