#pragma once

#include <memory>
#include <string>
#include <vector>

#include "problem/expression.hpp"
#include "problem/file.hpp"

/// A model of a problem's file: its equations solved for the highest rates, and everything computed from its
/// state.
namespace oddity::problem {

/// The consequence when a guard falls through zero.
struct Follows {
  bool ends = false;
  bool passes = false;  ///< the guard stays as it is, and falls on
};

/// A model with numbers for its parameters.
struct Numbers {
  std::size_t unknowns = 0;  ///< 0: a closed form
  std::vector<int> rate_of;  ///< the index of this unknown's rate; -1: it has none
  std::vector<long double> start;
  Program rates;          ///< functions of the state and the time
  Program accelerations;  ///< functions of the first half of the state and the time, if they depend on
                          ///< nothing else
  bool partitioned = false;
  Program observed;   ///< functions of the state and the time, or of the time
  Program conserved;  ///< the value, and its moving part; no outputs: none
  std::vector<Follows> events;
  Program guards;            ///< functions of the state and the time, one for each event
  Program rates_and_guards;  ///< both
  Program afterwards;        ///< the states after the events, in a row
  Program looked_up;         ///< the arguments of the tables in Model::tables(), of the state and the time
  Program off;               ///< the error of each constraint, then the rates of these
};

class Model {
 public:
  /// Throws WrongFile for errors in it: letters, units, a missing start, equations that cannot be solved.
  Model(const File&, const ModelText&);

  const std::string& name() const { return name_; }
  bool is_closed() const { return state_.empty(); }
  std::size_t unknowns() const { return state_.size(); }
  /// Parameters that its start depends on.
  const std::vector<std::size_t>& starts_with() const { return starts_with_; }
  /// The rates are linear in the state, with any dependence on time.
  bool is_linear() const { return is_linear_; }
  /// For each unknown of the second order, its observable; empty if one is not observed.
  const std::vector<std::size_t>& seen_as() const { return seen_as_; }
  bool conserves() const { return !conserved_.empty(); }
  bool is_constrained() const { return !off_.empty(); }
  bool has_events() const { return !events_.empty(); }
  /// The tables that are undefined outside their rows, one for each call.
  const std::vector<std::shared_ptr<const Table>>& tables() const { return tables_; }
  /// The numbers for these values of the parameters, in their units. Throws BadInput if the start is off a
  /// constraint, or if conditions are not met near it.
  Numbers with(const std::vector<double>& parameters) const;

  /// A struct of C++ whose members are the parameters it needs, for the loops of `choose --code`.
  struct Code {
    std::string type, text;
    std::vector<std::string> members;
  };
  /// `partitioned`: as in its numbers, the accelerations depend only on places. Throws BadInput if a letter
  /// cannot be written.
  Code code(const File&, bool partitioned) const;

 private:
  class Making;
  class Coding;

  std::string name_;
  std::vector<std::string> unknowns_;
  std::vector<long double> sizes_;  ///< sizes of the parameters' units
  std::shared_ptr<Graph> graph_ = std::make_shared<Graph>();
  std::vector<int> state_, rate_of_;        ///< keys of the unknowns, in the state's order
  std::vector<Expression> still_changing_;  ///< last changes of the starts that conditions determine
  std::vector<Expression> lengths_;         ///< lengths of the quaternions at the start
  std::vector<Expression> start_, rates_, observed_, conserved_, guards_, afterwards_, off_, looked_up_;
  std::vector<std::shared_ptr<const Table>> tables_;
  std::vector<Follows> events_;
  std::vector<std::size_t> starts_with_, seen_as_;
  bool is_linear_ = true;
};

/// Throws WrongFile if the model's start is off a constraint, or not near its conditions, at the file's own
/// values.
void require_start(const File&, const ModelText&, const Model&);

}  // namespace oddity::problem
