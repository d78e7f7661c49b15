#pragma once

#include <string>
#include <vector>

#include "report/study/run.hpp"
#include "report/text/table_text.hpp"

/// `oddity bench --verbs`: cost of each command, run as a separate program, and how its work grows.
namespace oddity {

struct VerbCost {
  std::string words;  ///< "sweep run": without folders and options
  double seconds, cpu_seconds, peak_bytes;
  std::string failure;  ///< how it ended, if not with exit code 0
};

/// CPU seconds over the amount of work, from little to much.
struct Growth {
  std::string of;  ///< "verify, by trials"
  std::vector<double> amounts, cpu_seconds;

  /// Slope of log(seconds) over log(amount); 1 where twice the work takes twice as long.
  double slope() const;
};

struct VerbsBench {
  std::vector<VerbCost> verbs;
  std::vector<Growth> growth;
};

/// Runs in a folder that is removed afterwards; does not write to the previous results.
VerbsBench bench_verbs(const Progress& progress = {});

std::string verbs_view(const VerbsBench&, const Screen& = {});
/// A row for each number.
Table verbs_table(const VerbsBench&);

}  // namespace oddity
