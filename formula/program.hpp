#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "formula/recorded.hpp"

namespace oddity::formula {

/// The letters that these results depend on.
std::set<std::string> letters_of(const Record&, const std::vector<std::vector<Recorded>>& results);

/// The computation of a function: lines of C#, and the terms of its results. A table of two columns is a
/// Table2 of Rows, a sum's variable a Total.
struct Statements {
  std::vector<std::string> lines, terms;
};

/// The operations of a record as code. A term without letters of `moving` is a constant; a term that is
/// used twice, or is long, gets a name.
class Program {
 public:
  using Results = std::vector<std::vector<Recorded>>;
  /// The results of the functions that are written, of those that are often called and of others, and names
  /// that are taken.
  Program(const Record& record, std::set<std::string> moving, const Results& often,
          std::set<std::string> taken, const Results& seldom = {});

  /// The lines that declare the constants, except those of helpers.
  std::vector<std::string> constants() const { return constants_of(no_helper); }
  Statements function(const std::vector<Recorded>& results);

  /// A function of the record that the others call. Its result is an array: an Array3 of three numbers.
  struct Helper {
    std::string name;
    std::vector<std::string> arguments;
    std::vector<std::string> constants;  ///< lines that declare those that it alone needs
    Statements body;
  };
  /// In an order in which each calls only those before it.
  std::vector<Helper> helpers();

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
  static constexpr int no_helper = -1;

  const Operation& at(int i) const { return record_.operations()[static_cast<std::size_t>(i)]; }
  bool is_cheap(int i) const;
  bool is_atom(int i) const { return at(i).what == "letter" || at(i).what == "number"; }
  void count(int i, std::vector<int>& uses) const;
  int cost(int i) const;
  void find_loops();
  void find_helpers(const Results& often, const Results& seldom);
  const std::string& helper_name(const std::string& function) const;
  std::vector<std::string> constants_of(int helper) const;
  Statements function_with_returns(const std::vector<int>& results);
  std::string table_name(std::size_t table) const { return "table" + std::to_string(table + 1); }
  static std::vector<std::string> packed(const std::string& type, const Lines&);
  std::string name_of(int i, bool constant, std::set<std::string>& taken) const;

  friend struct ProgramWriter;
  const Record& record_;
  std::vector<bool> fixed_;
  std::vector<int> loop_of_;  ///< the innermost loop on whose row an operation depends; -1: on none
  std::vector<std::string> helper_names_;  ///< names of functions; empty: it is not called
  std::vector<int> helper_of_;             ///< the function that alone needs an operation
  std::vector<std::set<int>> helpers_of_table_;
  Named constants_;
  std::map<int, Lines> constants_of_helpers_;
};

}  // namespace oddity::formula
