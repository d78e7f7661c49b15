#include <sstream>

#include "chapters/contents.hpp"
#include "report/site/players.hpp"
#include "report/verify/catch.hpp"

using namespace oddity;

namespace {

std::string together(std::size_t files) {
  std::string all;
  for (const std::string& text : module_source(files)) all += text;
  return all;
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

std::string literal(std::string_view text) { return "R\"oddity(" + std::string(text) + ")oddity\""; }

}  // namespace

TEST_CASE("the module has each scene with all models of its listing, in any number of files", "[module]") {
  for (std::size_t files : {1u, 4u}) {
    REQUIRE(module_source(files).size() == files);
    const std::string source = together(files);
    for (const Entry& entry : registry()) {
      if (!entry.exercise.scene) continue;
      const Listing& listing = entry.exercise.scene->listing;
      INFO(to_string(entry.number));
      CHECK(count(source, "{" + literal(to_string(entry.number)) + ", ") == 1);
      const std::string function =
          "model_" + std::to_string(entry.number.chapter) + "_" + std::to_string(entry.number.index) + "_";
      CHECK(count(source, "> " + function) == listing.models.size() + listing.with_events.size());
      for (const auto* models : {&listing.models, &listing.with_events})
        for (const auto& [name, expression] : *models)
          CHECK(count(source, "return " + std::string(expression) + ";") > 0);
      for (const Parameter& p : entry.exercise.parameters) CHECK(count(source, "{" + literal(p.name)) > 0);
    }
  }
}

TEST_CASE("the module's models are in double and in float, and a closed form keeps its algorithm",
          "[module]") {
  const std::string source = together(1);
  CHECK(count(source, "return pendulum::OneAngle<double>{{a, L, g}};") == 1);
  CHECK(count(source, "return pendulum::OneAngle<float>{{a, L, g}};") == 1);
  CHECK(count(source, "{" + literal("one angle") + ", " + literal("") + ", model_3_5_") == 1);
  CHECK(count(source, literal("Kepler's equation") + ", " + literal("Newton from pi")) == 1);
  // Its name contains a comma, but no algorithm.
  CHECK(count(source, literal("matrix, w of the printed listing") + ", " + literal("")) == 1);
}

TEST_CASE("a float has no parameter in double", "[module]") {
  std::istringstream lines(together(1));
  bool in_float = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("static_cast<float>") != std::string::npos) in_float = true;
    if (line.find("static_cast<double>") != std::string::npos) in_float = false;
    if (line.find("  return ") != std::string::npos && in_float)
      CHECK(line.find("double") == std::string::npos);
  }
}
