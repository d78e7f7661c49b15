// Random needs over all scenes, each answered both as usual and thoroughly: every method at every setting,
// judged by references of 24 digits. Takes a quarter of an hour, so it runs only on request: oddity_tests
// '[choices]', for ODDITY_NEEDS (200) needs from ODDITY_FIRST (0) on. The table goes to the file
// ODDITY_CHOICES_TABLE as CSV, each row as soon as it is known.

#include <algorithm>
#include <array>
#include <ctime>
#include <fstream>

#include "chapters/random.hpp"
#include "chapters/scene.hpp"
#include "reference/bad_input.hpp"
#include "reference/csv.hpp"
#include "reference/text.hpp"
#include "report/cli/asked.hpp"
#include "report/study/choose.hpp"
#include "report/study/initial_conditions.hpp"
#include "report/verify/catch.hpp"
#include "tests/properties.hpp"

using namespace oddity;

namespace {

/// In words of the command line, so that anyone can ask the same.
struct Question {
  std::string exercise;
  std::vector<std::string> overrides;
  AskedNeed need;

  std::string text() const {
    std::string all = exercise;
    for (const std::string& one : overrides) all += " " + one;
    return all + " --error " + need.error + " --horizon " + need.horizon + " --fps " +
           need.frames_per_second + (need.cheapest ? " --cheapest" : "") +
           (need.one_step ? " --one-step" : "");
  }
};

std::vector<const Entry*> scenes() {
  std::vector<const Entry*> all;
  for (const Entry& entry : registry())
    if (entry.exercise.scene && of_the_book(entry.number)) all.push_back(&entry);
  return all;
}

/// From a hundredth to ten times the tolerance of a game, in every unit.
std::string random_error(const Scene& scene, const Parameters& parameters, Random& random) {
  const double times = std::abs(random.magnitude(0.01, 10));
  std::string all;
  const Quantity seen = motion(scene, parameters, Reference::nothing());
  for (std::string_view unit : seen.units())
    all += (all.empty() ? "" : ",") + format_significant(times * game_error(unit), 3) + std::string(unit);
  return all;
}

Question random_question(const Entry& entry, Random& random) {
  const Scene& scene = *entry.exercise.scene;
  Question question{to_string(entry.number), {}, {}};
  Parameters parameters(entry.exercise.parameters);
  for (std::string_view name : scene.perturbed_parameters) {
    const auto declared = std::ranges::find(parameters.declared(), name, &Parameter::name);
    const double value = declared->value * random.between(0.7, 1.3);
    const std::string text = format_significant(std::clamp(value, declared->least, declared->most), 3);
    question.overrides.push_back(std::string(name) + "=" + text);
  }
  question.need.error = random_error(scene, parameters, random);
  question.need.horizon = format_significant(random.between(1, 10), 2);
  question.need.frames_per_second = std::array{"30", "60", "120"}[static_cast<std::size_t>(random.below(3))];
  question.need.cheapest = random.unit() < 0.25;
  question.need.one_step = random.unit() < 0.25;
  return question;
}

/// An evaluation costs 1 to 4 ns, depending on the method's name: the same on every machine and in every run.
Time price_by_name(const Method& method, double setting) {
  double seed = 0;
  for (const char letter : method.model + method.algorithm)
    seed = std::fmod(31 * seed + static_cast<unsigned char>(letter), 1e9 + 7);
  const double each = 1e-9 * std::pow(4, Random(seed).unit());
  return {each * static_cast<double>(method.run(setting).evaluations), 0};
}

struct Answered {
  std::string says;
  double nanoseconds = not_a_number;  ///< a frame, by its price
  double cpu = 0;                     ///< s of CPU time for the answer
};

Answered answered(const Question& question, bool thorough, const Reference& truth) {
  const std::clock_t start = std::clock();
  Answered answer;
  try {
    AskedNeed asked = question.need;
    asked.thorough = thorough;
    const Task task = task_of(question.exercise, question.overrides);
    const Choice choice = choose(task, need_of(task, asked), truth, price_by_name);
    if (const auto& chosen = choice.chosen) {
      answer.says = chosen->model + ", " + chosen->algorithm;
      if (!chosen->resolution.empty())
        answer.says += ", " + chosen->resolution + " " + format_shortest(chosen->setting);
      answer.nanoseconds = 1e9 * chosen->seconds_per_frame;
    } else {
      answer.says = "nothing holds";
    }
  } catch (const BadInput& refused) {
    answer.says = refused.what();
  }
  answer.cpu = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return answer;
}

std::string verdict(const Answered& usual, const Answered& thorough) {
  if (usual.says == thorough.says) return "same";
  return usual.nanoseconds <= 1.25 * thorough.nanoseconds ? "another that costs no more" : "worse";
}

void compare(int number, const Question& question) {
  static const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  const char* table = std::getenv("ODDITY_CHOICES_TABLE");
  const Answered usual = answered(question, false, truth), thorough = answered(question, true, truth);
  const std::string found = verdict(usual, thorough);
  INFO(question.text() << "\nusually: " << usual.says << "\nthoroughly: " << thorough.says);
  CHECK(found != "worse");
  if (table)
    std::ofstream(table, std::ios::app)
        << number << "," << csv_cell(question.text()) << "," << csv_cell(usual.says) << ","
        << csv_cell(thorough.says) << "," << found << "," << format_significant(usual.nanoseconds, 4) << ","
        << format_significant(thorough.nanoseconds, 4) << "," << format_significant(usual.cpu, 3) << ","
        << format_significant(thorough.cpu, 3) << "\n";
}

/// Needs on the chain, where neighbours diverge a millionfold and more: routes in long double disagree by up
/// to the tolerance, and some starts no double can follow.
std::vector<Question> chaotic() {
  std::vector<Question> all;
  for (const auto& [start, error, horizon] : {std::array{"2", "0.01m", "10"},
                                              {"2.2", "0.05m", "10"},
                                              {"2.5", "0.01m", "10"},
                                              {"2.7", "0.001m", "8"},
                                              {"3", "0.01m", "10"},
                                              {"1.5", "0.01m", "16"},
                                              {"2.5", "0.01m", "16"},
                                              {"3", "0.01m", "12"}}) {
    Question one{"3.25", {std::string("theta1=") + start}, {}};
    one.need.error = error;
    one.need.horizon = horizon;
    one.need.frames_per_second = "60";
    all.push_back(one);
  }
  return all;
}

}  // namespace

TEST_CASE("the usual answer is the thorough one, or as good", "[.][choices]") {
  const auto all = scenes();
  const int first = in_environment("ODDITY_FIRST", 0);
  const int needs = in_environment("ODDITY_NEEDS", 200);
  Random random(2026);
  for (int number = 0; number < needs; ++number) {
    const Question question = random_question(*all[static_cast<std::size_t>(number) % all.size()], random);
    if (number >= first) compare(number, question);
  }
  int number = needs;
  for (const Question& question : chaotic()) compare(number++, question);
}
