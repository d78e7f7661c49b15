#pragma once

#include <string>

#include "tests/questions/question.hpp"

namespace questions {

/// The program under test, and where its code is compiled.
struct Program {
  std::string oddity, folder, compiler = "g++";
};

/// Verdict on an answer.
struct Verdict {
  enum Kind { right, not_run, refused, nothing_holds, out_of_time, wrong } kind;
  std::string says;        ///< "path: 0.011 m where 0.01 was asked"; for a wrong answer, the kind of fault
                           ///< comes first
  double seconds = 0;      ///< time of the answer
  double known_until = 1;  ///< the part of the motion up to which it was judged
};
const char* name_of(Verdict::Kind);

/// Asks the program, runs the code that it prints, and compares with the question's own motion.
Verdict judge(const Question&, const Program&);

/// Standard output of the program. Throws std::runtime_error if it fails.
std::string output_of(const Program&, const std::vector<std::string>& words);

/// Compares the judge's motions with the reference tables, a row for each scene. Returns how many differ.
int compare_with_tables(const std::string& folder);

}  // namespace questions
