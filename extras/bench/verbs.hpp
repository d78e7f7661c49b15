#pragma once

#include <string>
#include <vector>

#include "report/study/run.hpp"
#include "report/text/table_text.hpp"

/// `oddity bench --verbs`: what each verb takes, as a program of its own, and how its work grows.
namespace oddity {

struct VerbCost {
  std::string words;  ///< "sweep run": without folders and options
  double seconds, cpu_seconds, peak_bytes;
  std::string failure;  ///< how it ended, unless with 0
};

/// CPU seconds against how much there was to do, from little to much.
struct Growth {
  std::string of;  ///< "verify, by trials"
  std::vector<double> amounts, cpu_seconds;

  /// Of log(seconds) against log(amount); 1 where twice as much takes twice as long.
  double slope() const;
};

struct VerbsBench {
  std::vector<VerbCost> verbs;
  std::vector<Growth> growth;
};

/// In a folder that is gone afterwards; nothing of the last run's is written to.
VerbsBench bench_verbs(const Progress& progress = {});

std::string verbs_view(const VerbsBench&, const Screen& = {});
/// A row for each number.
Table verbs_table(const VerbsBench&);

}  // namespace oddity
