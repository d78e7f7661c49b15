#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "problem/formula.hpp"
#include "problem/table.hpp"

/// A problem's file as it is written; README.md has the keys.
namespace oddity::problem {

/// The most that is read of one [bytes].
constexpr std::size_t most_of_a_file = 1'000'000;

struct ParameterText {
  std::string name, unit, says;
  double value = 0;  ///< in its unit
  double least, most;
  bool whole = false;
  long double size = 1;  ///< of its unit
  Measure measure = {};
};

using Named = std::vector<std::pair<Quoted, Quoted>>;  ///< in the file's order

enum class Direction { falling, rising, both };

/// What happens where a formula goes through zero.
struct EventText {
  Quoted when;
  Direction direction = Direction::falling;
  Named then = {};    ///< the state after it, of the state before; what is not named stays
  bool ends = false;  ///< the motion stays as it is from there on
};

struct ModelText {
  Quoted name;
  std::vector<Quoted> equations = {}, constraints = {};
  std::vector<Quoted> conditions =
      {};  ///< formulas that stay zero, of unknowns without an equation of their own
  std::vector<std::string> found = {};  ///< these unknowns, whose start is near what is given for it
  std::optional<Quoted> lagrangian = {}, hamiltonian = {}, dissipation = {}, kinetic = {}, potential = {};
  Named forces = {}, momenta = {}, start = {}, closed = {}, observe = {};  ///< momenta by their places
  std::vector<EventText> events = {};
};

/// A letter of a claim, drawn from its range; of one value where the ends are the same.
struct LetterText {
  std::string name, unit;
  double least, most;  ///< in its unit
  bool whole = false;
  long double size = 1;
  Measure measure = {};
};

/// What a claim is judged by.
struct TruthText {
  enum class Is { formula, derivative, integral, sum, value };
  Is is = Is::formula;
  Quoted what;     ///< the formula, or what is differentiated, integrated or added up
  Quoted by = {};  ///< the letter that it is differentiated by, or runs
  Quoted from = {}, to = {};
  int times = 1;            ///< that it is differentiated
  Quoted within = {};       ///< of a value, how far it may be off; no text: not at all
  std::string source = {};  ///< of a value: where it is from
};

struct ClaimText {
  Place place;
  std::string name, says, why, changes_that_hold;
  std::optional<Quoted> printed = {}, meant = {}, corrected = {}, where = {}, in_view = {};
  std::optional<TruthText> truth = {};
  std::vector<LetterText> letters = {};
  bool lost = false;  ///< the copy at hand has lost what was meant
};

struct ObservableText {
  std::string name, unit, point;
  Quoted formula;
  Place place;
  long double size = 1;
  Measure measure = {};
};

/// How other people's engines have the motion (solvers/world.hpp). A vector has three texts.
struct BodyText {
  Quoted name, mass, turn;  ///< turn: about z, at the start
  std::vector<Quoted> inertia, place, velocity, spin;
};
struct JointText {
  Quoted kind, a, b;  ///< no text: the ground
  std::vector<Quoted> at, axis, end;
};
struct SpringText {
  Quoted a, b, stiffness, rest;
  std::vector<Quoted> at, end;
};
struct StagedText {
  Place place;
  std::vector<Quoted> gravity = {};
  std::vector<BodyText> bodies = {};
  std::vector<JointText> joints = {};
  std::vector<SpringText> springs = {};
  Named observe = {};
  std::string differs = {};
};

struct File {
  Source source;
  std::string title, question;
  std::vector<ParameterText> parameters;
  std::vector<std::shared_ptr<const Table>> tables;
  Named given;
  std::vector<ModelText> models;
  std::vector<ObservableText> observables;
  std::vector<ClaimText> claims;
  std::optional<StagedText> staged = {};
  std::string error, horizon = "10", frames_per_second = "60";  ///< as `choose` takes them
  std::vector<double> errors;          ///< in the units of the observables, by their order
  double end = 10;                     ///< s
  std::vector<std::string> vary = {};  ///< parameters that differ from start to start
  std::string sweep = {};
  std::vector<double> sweep_values = {};
  std::string error_says = {}, horizon_says = {};  ///< why these, where the file asks nothing
  bool is_plain = false;                           ///< all numbers are pure, the time too
};

/// Reads a text; throws WrongFile.
std::unique_ptr<const File> read(const std::string& name, const std::string& text);
/// Throws WrongFile where there is a motion and nothing that may differ from start to start.
void require_parameters(const File&);

}  // namespace oddity::problem
