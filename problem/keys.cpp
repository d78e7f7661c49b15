#include "problem/keys.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace oddity::problem {

namespace {

constexpr bool needed = true;

constexpr std::array file{
    Key{"version", "1", "number"},
    Key{"title", "the problem's name", "text", needed},
    Key{"question", "what is asked", "text"},
    Key{"parameters", "letters with a value, a unit and a range", "map text or parameter"},
    Key{"tables", "tables of numbers, called like functions", "map table"},
    Key{"given", "abbreviations", "map components"},
    Key{"model", "models, from the least to the richest", "map model"},
    Key{"observe", "quantities that every model computes", "map text or observable"},
    Key{"need", "the question for choose", "need"},
    Key{"sweep", "the parameter of the map that stability draws", "sweep"},
    Key{"staged", "the motion as bodies and joints, for third-party engines", "staged"},
    Key{"claim", "a solution's claims", "list claim"},
};
constexpr std::array parameter{
    Key{"value", "30 kN/m, 1 to 100", "text", needed},
    Key{"says", "what it is", "text"},
    Key{"whole", "it takes whole numbers only", "flag"},
};
constexpr std::array table{
    Key{"x", "the unit of the first number of a row", "text", needed},
    Key{"y", "the unit of the second", "text", needed},
    Key{"rows", "pairs of numbers, or lines of text", "rows", needed},
    Key{"spline", "linear, cubic or monotone", "text"},
    Key{"outside", "refuse, or hold: as at the end", "text"},
};
constexpr std::array observable{
    Key{"unit", "its unit", "text", needed},
    Key{"is", "its formula, unless it is the unknown of its name", "components"},
    Key{"point", "observables of one point are judged by its distance", "text"},
};
constexpr std::array model{
    Key{"equations", "m y'' = -k y", "texts"},
    Key{"lagrangian", "kinetic less potential energy", "text"},
    Key{"hamiltonian", "the energy, of places and momenta", "text"},
    Key{"momenta", "the momentum's name by its place, with a Hamiltonian", "map text"},
    Key{"forces", "generalized forces by place, with a Lagrangian or a Hamiltonian", "map components"},
    Key{"dissipation", "Rayleigh's function, with a Lagrangian", "text"},
    Key{"constraints", "x^2 + y^2 = L^2, with a Lagrangian", "texts"},
    Key{"start", "the unknowns and their rates at the start; a list makes a vector, a list of lists a matrix",
        "map components"},
    Key{"turns", "unit quaternions, each with its angular velocity in the axes of the body",
        "map texts or turn"},
    Key{"closed", "a closed form of each observable", "map components"},
    Key{"observe", "other formulas of the observables", "map components"},
    Key{"conserves", "an energy that is conserved", "conserves"},
    Key{"events", "changes where a formula goes through zero", "list event"},
};
constexpr std::array turn{
    Key{"rate", "the angular velocity, of three components", "texts", needed},
    Key{"axes", "its axes: body or space", "text"},
};
constexpr std::array conserves{
    Key{"kinetic", "its moving part", "text", needed},
    Key{"potential", "the rest", "text", needed},
};
constexpr std::array event{
    Key{"when", "the formula", "text", needed},
    Key{"direction", "falling, rising or both", "text"},
    Key{"then", "the state after it, from that before", "map components"},
    Key{"ends", "the motion stays as it is", "flag"},
    Key{"counts", "the name of a letter that counts it, from 0", "text"},
};
constexpr std::array need{
    Key{"error", "1 mm, or one for each unit", "texts"},
    Key{"horizon", "10 s", "text"},
    Key{"fps", "frames per second", "text"},
    Key{"vary", "the parameters that differ from start to start", "texts"},
};
constexpr std::array sweep{
    Key{"parameter", "its name", "text", needed},
    Key{"values", "from easy to hard", "texts", needed},
};
constexpr std::array staged{
    Key{"gravity", "three components", "texts"},
    Key{"body", "bodies", "list body", needed},
    Key{"joint", "joints", "list joint"},
    Key{"spring", "springs without mass", "list spring"},
    Key{"observe", "formulas of the observables in bob_x, bob_y, bob_z, bob_turn and their rates",
        "map text"},
    Key{"differs", "the difference that no fine step removes, if the motion is not the same", "text"},
};
constexpr std::array body{
    Key{"name", "bob", "text", needed},
    Key{"mass", "1 kg", "text", needed},
    Key{"inertia", "about the center of mass: one for all axes, or three", "texts", needed},
    Key{"place", "center of mass at the start, three components", "texts"},
    Key{"velocity", "at the start, three components", "texts"},
    Key{"turn", "about z at the start", "text"},
    Key{"spin", "at the start, three components", "texts"},
};
constexpr std::array joint{
    Key{"kind", "hinge, ball, cylinder, slide or rod", "text", needed},
    Key{"a", "a body; the ground by default", "text"},
    Key{"b", "a body", "text", needed},
    Key{"at", "a point of both at the start; for a rod, its end at a", "texts"},
    Key{"axis", "axis of a hinge, cylinder or slide; (0, 0, 1) by default", "texts"},
    Key{"end", "a rod's end at b", "texts"},
};
constexpr std::array spring{
    Key{"a", "a body; the ground by default", "text"},
    Key{"b", "a body", "text", needed},
    Key{"at", "its end at a, at the start", "texts"},
    Key{"end", "its end at b", "texts"},
    Key{"stiffness", "40 N/m", "text", needed},
    Key{"rest", "its length without a force", "text", needed},
};
constexpr std::array claim{
    Key{"name", "a short name, used once", "text"},
    Key{"says", "the claim in words", "text", needed},
    Key{"printed", "the formula, number or relation that is printed", "text", needed},
    Key{"meant", "the reading that was plainly meant", "text"},
    Key{"corrected", "the true reading", "text"},
    Key{"truth", "another route", "text or truth"},
    Key{"letters", "0.1 to 10 m; 1 to 9, whole; 9.81 m/s^2", "map text"},
    Key{"where", "a condition on the letters drawn", "text"},
    Key{"in_view", "where the printed one holds", "text"},
    Key{"why", "what is wrong", "text"},
    Key{"lost", "the meaning is lost in the copy at hand", "flag"},
    Key{"changes_that_hold", "why single changes may hold as well", "text"},
};
constexpr std::array truth{
    Key{"derivative", "the formula to differentiate", "text"},
    Key{"by", "the letter; for a value, its source", "text"},
    Key{"times", "how often", "text"},
    Key{"integral", "the integrand", "text"},
    Key{"sum", "the term", "text"},
    Key{"over", "the letter that runs", "text"},
    Key{"from", "its first value", "text"},
    Key{"to", "its last value", "text"},
    Key{"value", "a number with its unit", "text"},
    Key{"within", "how far it may be off", "text"},
};

constexpr std::array all{
    KeysOf{"file", file},     KeysOf{"parameter", parameter},
    KeysOf{"table", table},   KeysOf{"observable", observable},
    KeysOf{"model", model},   KeysOf{"conserves", conserves},
    KeysOf{"event", event},   KeysOf{"need", need},
    KeysOf{"sweep", sweep},   KeysOf{"claim", claim},
    KeysOf{"truth", truth},   KeysOf{"staged", staged},
    KeysOf{"body", body},     KeysOf{"joint", joint},
    KeysOf{"spring", spring}, KeysOf{"turn", turn},
};

}  // namespace

std::span<const KeysOf> all_keys() { return all; }

std::span<const Key> keys_of(std::string_view name) {
  const auto found = std::ranges::find(all, name, &KeysOf::name);
  if (found == all.end()) throw std::logic_error("no keys of a " + std::string(name));
  return found->keys;
}

}  // namespace oddity::problem
