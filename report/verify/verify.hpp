#pragma once

#include "report/cli/commands.hpp"

namespace oddity {

/// The verification suite: one Catch2 test case per exercise, judged from the results of one parallel run,
/// and one for the register. Its reporter `markdown` writes the report of the run.
int verify(const SuiteRequest&);

}  // namespace oddity
