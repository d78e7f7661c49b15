// A problem's file that stages its scene for engines: the pendulum's staging is that of 3.5, and an invalid
// one is refused.

#include <cmath>

#include "chapters/contents.hpp"
#include "chapters/scene.hpp"
#include "problem/scene.hpp"
#include "problem/staging.hpp"
#include "report/verify/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/near.hpp"
#include "tests/program.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;
using namespace oddity::problem;

namespace {

const std::string body =
    "[[staged.body]]\nname = \"rod\"\nmass = \"1 kg\"\n"
    "inertia = [\"0.1875 kg L^2\", \"0.01 kg L^2\", \"0.1875 kg L^2\"]\n"
    "place = [\"0.75 L sin(a)\", \"-0.75 L cos(a)\", 0]\nturn = \"a\"\n";
const std::string hinged = "[[staged.joint]]\nkind = \"hinge\"\nb = \"rod\"\n";

std::string pendulum(const std::string& staged) {
  return "title = \"x\"\n[parameters]\nL = \"1.3 m\"\ng = \"9.81 m/s^2\"\na = \"50 deg\"\n[model.one]\n"
         "equations = [\"L p'' = -g sin(p)\"]\nstart = { p = \"a\", \"p'\" = 0 }\n[observe]\np = \"rad\"\n" +
         staged;
}
const std::string whole = "[staged]\ngravity = [0, \"-g\", 0]\nobserve = { p = \"atan2(rod_x, -rod_y)\" }\n";

std::string refusal(const std::string& staged) {
  const std::string said = complaint([&] { entry_of_text("test.toml", pendulum(staged)); });
  return said.substr(0, said.find('\n'));
}
std::vector<double> numbers_of(const engines::Staging& staging) {
  std::vector<double> all;
  const auto add = [&](const auto& some) { all.insert(all.end(), some.begin(), some.end()); };
  add(staging.world.gravity);
  for (const engines::Body& b : staging.world.bodies) {
    all.push_back(b.mass);
    add(b.inertia), add(b.start.position), add(b.start.orientation), add(b.start.velocity), add(b.start.spin);
  }
  for (const engines::Joint& j : staging.world.joints) {
    for (const int one : {static_cast<int>(j.kind), j.a, j.b}) all.push_back(one);
    add(j.at), add(j.axis), add(j.end);
  }
  engines::State seen;
  seen.position = {0.3, -0.4, 0.1};
  add(staging.observe(std::vector{seen}, 0));
  return all;
}

}  // namespace

TEST_CASE("The pendulum that a file stages is the one that 3.5 stages", "[problem][staged]") {
  const Entry& entry = entry_of_text("test.toml", pendulum(whole + body + hinged));
  REQUIRE(entry.exercise.scene->staging);
  const auto own = numbers_of(entry.exercise.scene->staging(Parameters(entry.exercise.parameters)));
  for (const Entry& other : registry()) {
    if (to_string(other.number) != "3.5") continue;
    Parameters p(other.exercise.parameters);
    p.set("L", 1.3), p.set("g", 9.81), p.set("a", std::acos(-1.0) * 50 / 180);
    const auto its = numbers_of(other.exercise.scene->staging(p));
    REQUIRE(own.size() == its.size());
    for (std::size_t i = 0; i < own.size(); ++i) CHECK(near(own[i], its[i], 1e-15));
  }
}

TEST_CASE("A spring, a turn and a rate of a body are as in the file", "[problem][staged]") {
  const Entry& entry = entry_of_text(
      "test.toml",
      pendulum("[staged]\nobserve = { p = \"rod_turn + rod_y' 2 rad s/m + rod_turn' 3 s\" }\n" + body +
               "[[staged.spring]]\nb = \"rod\"\nat = [\"1 cm\", 0, 0]\nend = [\"L\", 0, 0]\n"
               "stiffness = \"1 kN/m\"\nrest = \"5 cm\"\n"));
  const auto staging = entry.exercise.scene->staging(Parameters(entry.exercise.parameters));
  const engines::Spring& spring = staging.world.springs.at(0);
  CHECK(near(spring.at[0], 0.01, 1e-17));
  CHECK(near(spring.end[0], 1.3, 1e-15));
  CHECK(near(spring.stiffness, 1000, 1e-12));
  CHECK(near(spring.rest, 0.05, 1e-16));
  const engines::State seen{{}, {std::cos(0.2), 0, 0, std::sin(0.2)}, {0, 5, 0}, {0, 0, 7}};
  CHECK(near(staging.observe(std::vector{seen}, 0)[0], 0.4 + 10 + 21, 1e-14));
}

TEST_CASE("An invalid staging is refused with the place of the error", "[problem][staged]") {
  CHECK(refusal(whole) == "test.toml:11:1: nothing is staged: add [[staged.body]]");
  CHECK(refusal("[staged]\n" + body) ==
        "test.toml:11:1: what is p of the bodies? add observe = { p = \"rod_x\" } to staged");
  CHECK(refusal(whole + body + "[[staged.joint]]\nkind = \"hinge\"\nb = \"rood\"\n") ==
        "test.toml:22:6: no body rood; did you mean 'rod'?");
  CHECK(refusal(whole + body + "[[staged.joint]]\nkind = \"weld\"\nb = \"rod\"\n") ==
        "test.toml:21:9: a joint is a hinge, ball, cylinder, slide or rod");
  CHECK(refusal(whole + body + "velocity = [\"1 m\", 0, 0]\n") ==
        "test.toml:20:14: this is to be in m/s, and is in m");
  CHECK(refusal(whole + body + "spin = [\"1 rad/s\"]\n") ==
        "test.toml:20:10: spin has three components: [\"0 m\", \"1 m\", \"0 m\"]");
  CHECK(refusal(whole + "[[staged.body]]\nname = \"rod\"\nmass = \"0 kg\"\ninertia = \"1 kg m^2\"\n") ==
        "test.toml:16:9: engines take bodies of a mass and of moments of inertia above zero");
  for (const char* mass : {"1e300 kg*1e300", "1 kg/0"})
    CHECK(refusal(whole + "[[staged.body]]\nname = \"rod\"\nmass = \"" + mass +
                  "\"\ninertia = \"1 kg m^2\"\n") ==
          "test.toml:16:9: with these parameters this is no finite number");
  CHECK(refusal("[staged]\ngravity = [0, \"0/0 g\", 0]\nobserve = { p = \"rod_turn\" }\n" + body) ==
        "test.toml:12:16: with these parameters this is no finite number");
  const auto named = [](const std::string& name) {
    return "[[staged.body]]\nname = \"" + name + "\"\nmass = \"1 kg\"\ninertia = \"1 kg m^2\"\n";
  };
  CHECK(refusal(whole + body + named("rod")) == "test.toml:21:9: rod is there twice; take another name");
  CHECK(refusal(whole + named("L")) == "test.toml:15:9: L is there twice; take another name");
  CHECK(refusal(whole + named("ground")) == "test.toml:15:9: the ground is no body; take another name");
  CHECK(refusal(whole + named("")) == "test.toml:15:9: a letter's name has letters, digits and _, and is ''");
  const auto joined = [](const std::string& joint) { return whole + body + "[[staged.joint]]\n" + joint; };
  CHECK(refusal(joined("kind = \"hinge\"\nb = \"ground\"\n")) ==
        "test.toml:22:6: b is a body; leave a out where the other end is on the ground");
  CHECK(refusal(joined("kind = \"hinge\"\na = \"rod\"\nb = \"rod\"\n")) ==
        "test.toml:23:6: a and b are one body; name another");
  CHECK(refusal(joined("kind = \"hinge\"\nb = \"rod\"\naxis = [\"a - a\", 0, 0]\n")) ==
        "test.toml:23:10: an axis has a direction, as [0, 0, 1]");
  CHECK(refusal(joined("kind = \"rod\"\nb = \"rod\"\n")) ==
        "test.toml:21:9: a rod has a length: at and end are two points");
  CHECK(refusal(whole + body +
                "[[staged.spring]]\na = \"rod\"\nb = \"rod\"\nstiffness = \"1 N/m\"\nrest = \"0 m\"\n") ==
        "test.toml:22:6: a and b are one body; name another");
  std::string many;
  for (int i = 0; i < 8000; ++i) many += named("b" + std::to_string(i));
  CHECK(refusal(whole + many) == "test.toml:14:1: of [[staged.body]] there are at most 100");
}

TEST_CASE("A body's letters differ from the parameters", "[problem][staged]") {
  std::string text = pendulum(whole + body);
  text.insert(text.find("a = "), "rod_x = \"1 m\"\n");
  CHECK(complaint([&] {
          entry_of_text("test.toml", text);
        }).starts_with("test.toml:16:9: the parameter rod_x"));
}

TEST_CASE("A staging is checked again for other parameters", "[problem][staged]") {
  const Entry& entry = entry_of_text("test.toml", pendulum(whole + body + hinged));
  Parameters p(entry.exercise.parameters);
  p.set("L", 0);
  CHECK(complaint([&] {
          entry.exercise.scene->staging(p);
        }).starts_with("test.toml:17:13: engines take bodies"));
}

TEST_CASE("engines refuses a file without staging, and names the missing part",
          "[problem][staged][commands]") {
  const ScratchFolder scratch;
  const auto refused = program::run("engines " + scratch.file("mine.toml", pendulum("")).string());
  CHECK(refused.status == 2);
  CHECK(program::says(refused, "add [staged] with its bodies and joints"));
}
