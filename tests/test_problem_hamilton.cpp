// A Hamiltonian in a problem's file: its motion is the Lagrangian's, and invalid input is refused.

#include <cmath>

#include "problem/model.hpp"
#include "problem/scene.hpp"
#include "problem/truth.hpp"
#include "report/verify/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/near.hpp"

using namespace oddity;
using namespace oddity::problem;

namespace {

/// A pendulum with a motor at its joint; w is its angular velocity.
std::string pendulum(const std::string& model) {
  return "title = \"x\"\n[parameters]\nm = \"2 kg\"\nL = \"0.7 m\"\ng = \"9.81 m/s^2\"\nF = \"3 N m\"\n"
         "[model.one]\n" +
         model + "\n[observe]\nq = \"rad\"\n[need]\nhorizon = \"5 s\"\n[given]\nw = \"q'\"\n";
}
const std::string energy = "hamiltonian = \"p^2/(2*m L^2) - m g L cos(q)\"\nmomenta = { q = \"p\" }\n";
const std::string started = "start = { q = \"1 rad\", p = \"0.5 kg m^2/s\" }";

TrueMotion motion_of(const std::string& model) {
  const auto file = read("test.toml", pendulum(model));
  return by_series(Model(*file, file->models[0]).with({2, 0.7, 9.81, 3}), std::vector{0.0, 1.0, 2.5, 5.0});
}
std::string refusal(const std::string& model) {
  const std::string said = complaint([&] { entry_of_text("test.toml", pendulum(model)); });
  return said.substr(0, said.find('\n'));
}

}  // namespace

TEST_CASE("A Hamiltonian's motion is the Lagrangian's, with and without a force", "[problem][hamilton]") {
  for (const std::string force :
       {"", "forces = { q = \"F cos(3 1/s t)\" }\n", "forces = { q = \"F - 0.3 N m s q'\" }\n",
        "forces = { q = \"F - 0.3 N m s w - 0.1 N m s^2 q' w\" }\n"}) {
    const TrueMotion one = motion_of(energy + force + started);
    const TrueMotion other = motion_of("lagrangian = \"m/2 L^2 q'^2 + m g L cos(q)\"\n" + force +
                                       "start = { q = \"1 rad\", \"q'\" = \"0.5 kg m^2/s/(m L^2)\" }");
    REQUIRE(one.trouble.empty());
    for (std::size_t i = 0; i < one.states.size(); ++i) {
      CHECK(near(static_cast<double>(one.states[i][0]), static_cast<double>(other.states[i][0]), 1e-14));
      CHECK(near(static_cast<double>(one.states[i][1]), static_cast<double>(2 * 0.49L * other.states[i][1]),
                 1e-13));
    }
  }
}

TEST_CASE("A Hamiltonian that nothing drives is conserved, and checks equations given with it",
          "[problem][hamilton]") {
  const auto conserves = [](const std::string& more) {
    const auto file = read("test.toml", pendulum(energy + more + started));
    return Model(*file, file->models[0]).conserves();
  };
  CHECK(conserves(""));
  CHECK_FALSE(conserves("forces = { q = \"F\" }\n"));
  CHECK(refusal("conserves = { kinetic = \"m/2 L^2 w^2\", potential = \"-m g L cos(q)\" }\n" + energy +
                started) == "nothing");
  const std::string right = "equations = [\"m L^2 q' = p\", \"p' = -m g L sin(q)\"]\n";
  CHECK(refusal(right + energy + started) == "nothing");
  CHECK(refusal("equations = [\"m L^2 q' = p\", \"p' = m g L sin(q)\"]\n" + energy + started) ==
        "test.toml:9:16: the Hamiltonian's p' is not that of the equations, at a random state");
}

TEST_CASE("An invalid Hamiltonian is refused with the place of the error", "[problem][hamilton]") {
  const std::string plain = "hamiltonian = \"p^2/(2*m L^2)\"\n";
  CHECK(refusal(plain + started) ==
        "test.toml:7:8: a hamiltonian has momenta = { x = \"p\" }, the momentum of each place");
  CHECK(refusal(plain + "momenta = { q = \"P\" }\n" + started) ==
        "test.toml:9:18: no unknown P; did you mean 'p'?");
  CHECK(refusal(plain + "momenta = { q = \"q\" }\n" + started) == "test.toml:9:13: q is in two pairs");
  CHECK(refusal(energy + "start = { q = \"1 rad\", p = \"0.5 kg m^2/s\", z = \"0 m\" }") ==
        "test.toml:8:16: z is no place and no momentum: add it to momenta");
  CHECK(refusal("hamiltonian = \"m L^2 q'^2\"\nmomenta = { q = \"p\" }\n" + started) ==
        "test.toml:8:22: a Hamiltonian is of places and momenta, and this is a rate");
  CHECK(refusal("hamiltonian = \"m/2 L^2 w^2\"\nmomenta = { q = \"p\" }\n" + started) ==
        "test.toml:8:24: a Hamiltonian is of places and momenta, and this is a rate");
  const std::string momenta_rate = "a force is of places, their rates and momenta: write this by them";
  CHECK(refusal(energy + "forces = { q = \"F - 0.5 p'\" }\n" + started) ==
        "test.toml:10:25: " + momenta_rate);
  CHECK(refusal(energy + "forces = { q = \"-1 N m s^2 w'\" }\n" + started) ==
        "test.toml:10:28: " + momenta_rate);
  CHECK(refusal("conserves = { kinetic = \"p'^2\", potential = \"p'^2\" }\n" + energy + started) ==
        "test.toml:8:26: an energy is of the state and the time, and this has a highest rate");
  CHECK(refusal("hamiltonian = \"p^2\"\nmomenta = { q = \"p\" }\n" + started)
            .find("the unit of the energy is to be") != std::string::npos);
  CHECK(refusal(energy + "forces = { p = \"F\" }\n" + started) ==
        "test.toml:10:12: a force is on a place, and p is a momentum");
  CHECK(refusal(energy + "dissipation = \"F\"\n" + started) ==
        "test.toml:7:8: dissipation and constraints go with a lagrangian; put them into the equations");
  CHECK(refusal(energy + "lagrangian = \"m\"\n" + started).find("make two models of them") !=
        std::string::npos);
}
