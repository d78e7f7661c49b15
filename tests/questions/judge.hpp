#pragma once

#include <string>

#include "tests/questions/question.hpp"

namespace questions {

/// The program asked, and where what it prints is compiled.
struct Program {
  std::string oddity, folder, compiler = "g++";
};

/// What an answer is worth.
struct Verdict {
  enum Kind { right, not_run, refused, nothing_holds, out_of_time, wrong } kind;
  std::string says;        ///< "path: 0.011 m where 0.01 was asked"; of what is wrong, first its kind
  double seconds = 0;      ///< that the answer took
  double known_until = 1;  ///< the part of the motion up to which it was judged
};
const char* name_of(Verdict::Kind);

/// Asks the program, runs the code that it prints, and compares with the question's own motion.
Verdict judge(const Question&, const Program&);

/// What the program prints on standard output. Throws std::runtime_error where it fails.
std::string output_of(const Program&, const std::vector<std::string>& words);

/// Compares the judge's motions with the reference tables, a row for each scene; how many differ.
int compare_with_tables(const std::string& folder);

}  // namespace questions
