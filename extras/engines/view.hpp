#pragma once

#include <string>
#include <vector>

#include "report/study/engines.hpp"
#include "report/text/screen.hpp"
#include "report/text/table_text.hpp"

/// Results of third-party engines on the scenes, and the models that replace them.
namespace oddity {

/// A table per scene, of each engine's defaults and best variant, or of all variants. Columns: worst error at
/// these rates [1/s], the rate from which it is sufficient, its order, and its cost there compared with the
/// cheapest model.
std::string engines_text(const std::vector<EngineContest>&, const std::vector<double>& rates, bool all,
                         const Screen&);
/// A row for each trial.
Table engines_table(const std::vector<EngineContest>&);
/// Rows for reference/approved/engines.csv: scene, engine, version, variant, measured order, stated order,
/// and the rate [1/s] from which it is sufficient. Then follow its outcome at one step a frame, and whether
/// runs and snapshots give the same bits.
std::string engine_rows(const std::vector<EngineContest>&);

/// Results of this engine for the scene of a choice, a line per variant.
std::string engine_answer(const EngineContest&, const Screen&);

}  // namespace oddity
