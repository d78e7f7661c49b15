#pragma once

#include <set>
#include <string>
#include <vector>

#include "formula/recorded.hpp"

namespace oddity::formula {

/// The letters that these results depend on.
std::set<std::string> letters_of(const Record&, const std::vector<std::vector<Recorded>>& results);

/// The name, with a suffix where it is taken. Takes it.
std::string free_name(std::string name, std::set<std::string>& taken);

/// The computation of a function: lines of C#, and the terms of its results. A table of two columns is a
/// Table2 of Rows, a sum's variable a Total.
struct Statements {
  std::vector<std::string> lines, terms;
};

/// The operations of a record as code. A term without letters of `moving` is a constant; a term that is
/// used twice, or is long, gets a name.
class Program {
 public:
  /// The results of the functions that are written and often called, and names that are taken.
  Program(const Record& record, std::set<std::string> moving, const std::vector<std::vector<Recorded>>& often,
          std::set<std::string> taken);

  /// The lines that declare the constants.
  std::vector<std::string> constants() const;
  Statements function(const std::vector<Recorded>& results);

 private:
  /// A named term, or a line as it is.
  struct Line {
    std::string text;
    bool is_declared = true;
  };
  using Lines = std::vector<Line>;
  struct Named {
    std::vector<std::string> names;  ///< names of operations; empty: none
    std::vector<int> uses;
    std::set<std::string> taken;
    Lines lines;
  };

  const Operation& at(int i) const { return record_.operations()[static_cast<std::size_t>(i)]; }
  bool is_cheap(int i) const;
  bool is_atom(int i) const { return at(i).what == "letter" || at(i).what == "number"; }
  void count(int i, std::vector<int>& uses) const;
  int cost(int i) const;
  void find_loops();
  std::string table_name(std::size_t table) const { return "table" + std::to_string(table + 1); }
  static std::vector<std::string> packed(const std::string& type, const Lines&);
  std::string name_of(int i, bool constant, std::set<std::string>& taken) const;

  friend struct ProgramWriter;
  const Record& record_;
  std::vector<bool> fixed_;
  std::vector<int> loop_of_;  ///< the innermost loop on whose row an operation depends; -1: on none
  Named constants_;
};

}  // namespace oddity::formula
