#pragma once

#include <string>
#include <vector>

#include "report/study/engines.hpp"
#include "report/text/screen.hpp"
#include "report/text/table_text.hpp"

/// What other people's engines do on the scenes, and what replaces them.
namespace oddity {

/// A table a scene, of each engine's defaults and its best variant, or of all: the worst error at these rates
/// [1/s], the rate from which it holds, its order, and its cost there beside the least model's.
std::string engines_text(const std::vector<EngineContest>&, const std::vector<double>& rates, bool all,
                         const Screen&);
/// A row for each trial.
Table engines_table(const std::vector<EngineContest>&);
/// What is put on record of them, for reference/approved/engines.csv: scene, engine, version, variant,
/// measured order, stated order, the rate [1/s] from which it is enough, how it ends at one step a frame, and
/// whether runs and snapshots give the same bits.
std::string engine_rows(const std::vector<EngineContest>&);

/// What one who has this engine gets, a line a variant, beside what was chosen for the scene.
std::string engine_answer(const EngineContest&, const Screen&);

}  // namespace oddity
