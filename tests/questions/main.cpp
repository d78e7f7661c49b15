// Questions to `oddity choose`, each answer judged by a program that shares no code with it: README.md.

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "tests/questions/judge.hpp"

namespace {

using namespace questions;

/// Splits a line into words like a shell, with single quotes only.
std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  bool quoted = false, begun = false;
  for (char c : line) {
    if (c == '\'') {
      quoted = !quoted;
      if (!begun) words.emplace_back();
      begun = true;
    } else if (c == ' ' && !quoted) {
      begun = false;
    } else {
      if (!begun) words.emplace_back();
      begun = true;
      words.back() += c;
    }
  }
  return words;
}

/// Judges questions, prints a line for each false answer, or for all, and counts.
class Court {
 public:
  Court(Program program, bool all) : program_(std::move(program)), all_(all) {}

  Verdict hear(const Question& question) {
    Verdict verdict;
    try {
      verdict = judge(question, program_);
    } catch (const std::exception& error) {
      throw std::runtime_error(question.text() + ": " + error.what());
    }
    ++count_[verdict.kind];
    if (all_ || verdict.kind == Verdict::wrong) {
      std::printf("%s\n  %s: %s (%.1f s%s)\n", question.text().c_str(), name_of(verdict.kind),
                  verdict.says.c_str(), verdict.seconds,
                  verdict.known_until < 1 ? ", judged up to the judge's own horizon" : "");
      std::fflush(stdout);
    }
    if (verdict.kind == Verdict::wrong) ++kinds_[verdict.says.substr(0, verdict.says.find(':'))];
    return verdict;
  }
  /// Returns 0 if no answer was false.
  int close() const {
    int asked = 0;
    for (const auto& [kind, n] : count_) asked += n;
    std::printf("asked %d", asked);
    for (const auto& [kind, n] : count_) std::printf(", %s %d", name_of(kind), n);
    std::printf("\n");
    for (const auto& [kind, n] : kinds_) std::printf("  %s: %d\n", kind.c_str(), n);
    return kinds_.empty() ? 0 : 1;
  }

 private:
  Program program_;
  bool all_;
  std::map<Verdict::Kind, int> count_;
  std::map<std::string, int> kinds_;
};

/// Judges the questions of a file. Returns how many did not end as the word before each states.
int hear_record(Court& court, const std::string& file, const Ranges& ranges) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("there is no file " + file);
  int otherwise = 0;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::vector<std::string> words = words_of(line);
    const std::string expected = words.front();
    words.erase(words.begin());
    const Verdict verdict = court.hear(question_of(words, ranges));
    const bool answered = verdict.kind == Verdict::right || verdict.kind == Verdict::not_run;
    if (verdict.kind == Verdict::wrong || expected == "any" || (expected == "answered" && answered) ||
        (expected == "refused" && verdict.kind == Verdict::refused))
      continue;
    ++otherwise;
    std::printf("%s\n  has to be %s, and is %s: %s\n", line.c_str(), expected.c_str(), name_of(verdict.kind),
                verdict.says.c_str());
  }
  return otherwise;
}

int usage() {
  std::cerr
      << "oddity_questions tables FOLDER          compares the judge's motions with the reference tables\n"
         "oddity_questions ask ODDITY COUNT SEED [SECONDS]  random questions, each for SECONDS\n"
         "oddity_questions record ODDITY FILE     the questions of a file, one a line\n"
         "VERBOSE=1 shows all.\n";
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  try {
    if (words.size() == 2 && words[0] == "tables") return compare_with_tables(words[1]) == 0 ? 0 : 1;
    if (words.size() < 3) return usage();
    std::string folder = (std::filesystem::temp_directory_path() / "oddity_questions_XXXXXX").string();
    if (!mkdtemp(folder.data())) throw std::runtime_error("no temporary folder for compiled programs");
    const Program program{words[1], folder};
    const Ranges ranges = ranges_of(JsonReader(output_of(program, {"list", "--json"})).whole());
    Court court(program, std::getenv("VERBOSE") != nullptr);
    int otherwise = 0;
    if (words[0] == "record") {
      otherwise = hear_record(court, words[2], ranges);
    } else if (words[0] == "ask" && words.size() >= 4) {
      Asks asks;
      const std::string help = output_of(program, {"choose", "--help"});
      asks.starts = help.find("--starts") != std::string::npos;
      asks.also = help.find("--energy") != std::string::npos;
      asks.frames = help.find("--frame-seed") != std::string::npos;
      if (words.size() > 4) asks.limit = std::stod(words[4]);
      Random random(std::stoull(words[3]));
      for (int i = 0; i < std::stoi(words[2]); ++i) court.hear(random_question(random, ranges, asks));
    } else {
      return usage();
    }
    std::filesystem::remove_all(folder);
    return court.close() || otherwise > 0 ? 1 : 0;
  } catch (const std::exception& error) {
    std::cerr << "oddity_questions: " << error.what() << "\n";
    return 2;
  }
}
