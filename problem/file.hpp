#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "problem/formula.hpp"
#include "problem/table.hpp"

/// The text of a problem's file, by key; README.md lists the keys.
namespace oddity::problem {

/// Size limit of a file [bytes].
constexpr std::size_t most_of_a_file = 1'000'000;

struct ParameterText {
  std::string name, unit, says;
  double value = 0;  ///< in its unit
  double least, most;
  bool whole = false;
  long double size = 1;  ///< size of its unit
  Measure measure = {};
};

using Named = std::vector<std::pair<Quoted, Quoted>>;  ///< in the file's order

enum class Direction { falling, rising, both };

/// A change of state where a formula goes through zero.
struct EventText {
  Quoted when;
  Direction direction = Direction::falling;
  Named then = {};     ///< the state after it, by the state before; unnamed parts stay
  bool ends = false;   ///< the motion stays constant from there on
  Quoted counts = {};  ///< the letter that counts it; empty text: none
};

/// A unit quaternion, and its angular velocity.
struct TurnText {
  Quoted of, rate;
};

struct ModelText {
  Quoted name;
  std::vector<Quoted> equations = {}, constraints = {};
  std::vector<Quoted> conditions = {};  ///< formulas that stay zero, for unknowns without an equation
  std::vector<std::string> found = {};  ///< unknowns whose start is searched near the given one
  std::optional<Quoted> lagrangian = {}, hamiltonian = {}, dissipation = {}, kinetic = {}, potential = {};
  Named forces = {}, momenta = {}, start = {}, closed = {}, observe = {};  ///< momenta by their places
  Named vectors = {};  ///< unknowns that are vectors or matrices, as lists of components: r = (r_1, r_2)
  std::vector<TurnText> turns = {};  ///< they have their equations
  std::vector<EventText> events = {};
};

/// A letter of a claim, drawn from its range; constant if both ends are the same.
struct LetterText {
  std::string name, unit;
  double least, most;  ///< in its unit
  bool whole = false;
  long double size = 1;
  Measure measure = {};
};

/// The basis for judging a claim.
struct TruthText {
  enum class Is { formula, derivative, integral, sum, value };
  Is is = Is::formula;
  Quoted what;     ///< the formula or value; otherwise the differentiated, integrated or summed expression
  Quoted by = {};  ///< the variable of the derivative, integral or sum
  Quoted from = {}, to = {};
  int times = 1;            ///< order of the derivative
  Quoted within = {};       ///< tolerance of a value; empty text: none
  std::string source = {};  ///< source of a value
};

struct ClaimText {
  Place place;
  std::string name, says, why, changes_that_hold;
  std::optional<Quoted> printed = {}, meant = {}, corrected = {}, where = {}, in_view = {};
  std::optional<TruthText> truth = {};
  std::vector<LetterText> letters = {};
  bool lost = false;  ///< our copy has lost the intended formula
};

struct ObservableText {
  std::string name, unit, point;
  Quoted formula;
  Place place;
  std::string vector = {};    ///< the name of the vector or matrix that it is a component of
  std::size_t component = 0;  ///< its index in it
  Size vector_size = {};      ///< rows and columns of this vector or matrix
  bool is_of_vector = false;  ///< the formula is that of all components
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
  std::vector<double> errors;          ///< in the units of the observables, in their order
  double end = 10;                     ///< s
  std::vector<std::string> vary = {};  ///< parameters that differ from start to start
  std::string sweep = {};
  std::vector<double> sweep_values = {};
  std::string error_reason = {}, horizon_reason = {};  ///< reasons for these, if the file does not give them
  bool is_plain = false;                               ///< all numbers are pure, also the time
};

/// The name of a component: "r_2'" for the vector r' and the index 1, "R_21" for a matrix R of 2 by 2 and 2.
std::string component_name(const std::string& whole, std::size_t index, Size);
/// Reads a text; throws WrongFile.
std::unique_ptr<const File> read(const std::string& name, const std::string& text);
/// Throws WrongFile if there is a motion and no parameter that may differ from start to start.
void require_parameters(const File&);

}  // namespace oddity::problem
