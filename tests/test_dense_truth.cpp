// The true motion at every frame: against integrations that share nothing with its makers, against the
// tables, and as it is kept from run to run.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include "chapters/contents.hpp"
#include "chapters/random.hpp"
#include "chapters/scene.hpp"
#include "reference/bad_input.hpp"
#include "reference/truth.hpp"
#include "report/parallel.hpp"
#include "tests/catch.hpp"
#include "tests/near.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;
namespace fs = std::filesystem;

namespace {

const fs::path tables = fs::path(ODDITY_SOURCE) / "reference";

const Reference& known() {
  static const Reference all(tables);
  return all;
}

// ---- against integrations ---------------------------------------------------------------------------------

/// The scene's parameters, each of its starts up to a tenth off.
Parameters beside(const Exercise& exercise, Random& random) {
  Parameters p(exercise.parameters);
  for (std::string_view name : exercise.scene->starts) {
    const Parameter& declared = *std::ranges::find(exercise.parameters, name, &Parameter::name);
    const double size = p[name] == 0 ? 1 : std::abs(p[name]);
    p.set(name, std::clamp(p[name] + size * random.between(-0.1, 0.1), declared.least, declared.most));
  }
  return p;
}

/// A start of a scene, and how the model that comes nearest to the truth does so.
struct Case {
  const Entry* entry;
  Parameters parameters;
  Horizon horizon{0, 1, 60};
  std::string nearest = "none";
  double error = std::numeric_limits<double>::infinity();  ///< the largest at any frame
  double known_to = 0;       ///< what the two integrations differ by, and the reference's own error
  double one_frame_off = 0;  ///< the error of the same motion read a frame late
};

/// The same motion, each frame shown what belongs to the one before.
Value late(const Value& motion, int frames) {
  const std::size_t parts = motion.size() / static_cast<std::size_t>(frames);
  Value shifted = motion;
  for (std::size_t i = motion.size(); i-- > parts;) shifted[i] = shifted[i - parts];
  return shifted;
}

/// The model that Fehlberg 7(8) at 1e-13 brings nearest. By how much it differs from the same model by
/// Dormand-Prince 5(4) at 1e-9 is the error of the coarser one, and bounds that of the finer one, but for a
/// rounding per frame.
void follow(Case& c) {
  const Quantity dense = motion(*c.entry->exercise.scene, c.parameters, c.horizon, known());
  Value nearest;
  for (const Method& method : dense.methods) {
    if (method.algorithm != "Fehlberg 7(8)") continue;
    const Answer fine = method.run(1e-13);
    const double error = fine.reached() ? distance(fine.value, dense.reference.value) : std::nan("");
    if (!(error < c.error)) continue;
    c.nearest = method.model;
    c.error = error;
    nearest = fine.value;
  }
  const Method* coarser = method_of(dense, c.nearest, "Dormand-Prince 5(4)");
  if (!coarser) return;
  c.known_to = distance(nearest, coarser->run(1e-9).value) + dense.reference_error +
               rounding(size_of(nearest), dense.samples).allowed;
  c.one_frame_off = distance(late(nearest, dense.samples), dense.reference.value);
}

std::vector<Case> two_starts_of_each_scene() {
  std::vector<Case> cases;
  for (const Entry& entry : registry()) {
    if (!entry.exercise.scene) continue;
    Random random(100.0 * entry.number.chapter + entry.number.index);
    for (int start = 0; start < 2; ++start)
      cases.push_back(
          {&entry, beside(entry.exercise, random), {std::min(entry.exercise.scene->horizon, 3.0), 1, 60}});
  }
  return cases;
}

}  // namespace

TEST_CASE("at every frame the true motion is where a model comes to that shares nothing with it", "[truth]") {
  std::vector<Case> cases = two_starts_of_each_scene();
  parallel_for_each(cases, follow);
  for (const Case& c : cases) {
    INFO(to_string(c.entry->number) << ": " << c.nearest << " is off by " << c.error << " and knows to "
                                    << c.known_to);
    CHECK(c.error <= c.known_to);
    CHECK(c.known_to < 1e-6 * c.one_frame_off);
  }
}

// ---- against the tables -----------------------------------------------------------------------------------

namespace {

/// A motion of a table: its inputs but the time, and the times it has rows for.
struct Tabulated {
  const truth::Entry* entry;
  std::vector<double> inputs, times;
};

/// A chaotic motion asks for many digits, and one with friction for extrapolation: they take a minute.
const std::set<std::string_view> slow_tables{"03_25_growth", "03_31_slide"};

/// The motions of which a table has several times, at most `most` of each table.
std::vector<Tabulated> tabulated_motions(std::size_t most) {
  std::vector<Tabulated> all;
  for (const truth::Entry& entry : truth::registry()) {
    const truth::Truth maker = entry.make();
    if (maker.inputs.back() != "t") continue;
    std::map<std::vector<double>, std::vector<double>> motions;
    for (std::vector<double> row : maker.rows) {
      const double t = row.back();
      row.pop_back();
      motions[row].push_back(t);
    }
    std::size_t taken = 0;
    for (auto& [inputs, times] : motions) {
      std::ranges::sort(times);
      if (times.size() > 1 && times.front() >= 0 && taken++ < most) all.push_back({&entry, inputs, times});
    }
  }
  return all;
}

/// Each time, and, so that the motion is none of the table's, those halfway between.
std::vector<double> with_those_between(const std::vector<double>& times) {
  std::vector<double> all;
  for (double t : times) {
    if (!all.empty()) all.push_back((all.back() + t) / 2);
    all.push_back(t);
  }
  return all;
}

/// How far a motion made anew is off the table's rows, in the sum of their errors.
double off_the_rows(const Tabulated& motion) {
  const Known dense = known().motion(motion.entry->name, motion.inputs, with_those_between(motion.times));
  if (dense.source.find("on the spot") == std::string::npos) return std::nan("");
  const std::size_t parts = dense.value.size() / (2 * motion.times.size() - 1);
  double off = 0;
  for (std::size_t k = 0; k < motion.times.size(); ++k) {
    std::vector<double> row = motion.inputs;
    row.push_back(motion.times[k]);
    const Known stored = known()(motion.entry->name, row);
    for (std::size_t i = 0; i < parts; ++i)
      off = std::max(
          off, std::abs(dense.value[2 * k * parts + i] - stored.value[i]) / (dense.error + stored.error));
  }
  return off;
}

void require_on_the_rows(const std::vector<Tabulated>& motions) {
  std::vector<std::pair<const Tabulated*, double>> off;
  for (const Tabulated& motion : motions) off.emplace_back(&motion, std::nan(""));
  parallel_for_each(off, [](auto& one) { one.second = off_the_rows(*one.first); });
  for (const auto& [motion, errors] : off) {
    INFO(motion->entry->name << " to t = " << motion->times.back());
    CHECK(errors <= 1);
  }
}

}  // namespace

TEST_CASE("a motion made anew goes through the rows of its table", "[truth]") {
  std::vector<Tabulated> motions = tabulated_motions(1);
  std::erase_if(motions, [](const Tabulated& motion) { return slow_tables.contains(motion.entry->name); });
  CHECK(motions.size() >= 18);
  require_on_the_rows(motions);
}

TEST_CASE("every tabulated motion made anew goes through its rows", "[truth][slow]") {
  require_on_the_rows(tabulated_motions(1000));
}

// ---- kept from run to run ---------------------------------------------------------------------------------

namespace {

const std::vector<double> tenths{0.1, 0.2, 0.3, 0.4};

Known swing(const Reference& by, const std::vector<double>& inputs = {0.7, 1, 9.81},
            const std::vector<double>& times = tenths) {
  return by.motion("03_05_swing", inputs, times);
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& file : fs::directory_iterator(folder)) files.push_back(file.path());
  return files;
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A cache with the one motion in it.
struct Kept {
  ScratchFolder folder;
  Reference reference{tables, folder.path()};
  Known made = swing(reference);
  fs::path file = files_in(folder.path()).at(0);
  std::string text = text_of(file);

  /// What is read when the file has this text.
  std::vector<double> read(const std::string& changed) const {
    folder.file(file.filename().string(), changed);
    return swing(reference).value;
  }
};

}  // namespace

TEST_CASE("a motion read back is the motion made, in every bit", "[truth]") {
  const Kept kept;
  const Known again = swing(Reference(tables, kept.folder.path()));
  CHECK(again.value == kept.made.value);
  CHECK(again.value == swing(known()).value);
  CHECK(again.error == kept.made.error);
  CHECK(again.source == kept.made.source);
  int ticks = 0;
  swing(kept.reference.watched([&] { ++ticks; }));
  CHECK(ticks == 0);  // nothing was made
  swing(known().watched([&] { ++ticks; }));
  CHECK(ticks > 0);
}

TEST_CASE("a kept motion that is damaged anywhere is made again", "[truth]") {
  const Kept kept;
  for (std::size_t length = 0; length < kept.text.size(); length += 7) {
    INFO("cut after " << length << " of " << kept.text.size());
    CHECK(kept.read(kept.text.substr(0, length)) == kept.made.value);
  }
  for (std::size_t at = 0; at < kept.text.size(); at += 5) {
    std::string changed = kept.text;
    changed[at] = changed[at] == '7' ? '3' : '7';
    INFO("another character at " << at << ":\n" << changed);
    CHECK(kept.read(changed) == kept.made.value);
  }
  CHECK(kept.read(kept.text + "1\n") == kept.made.value);
  CHECK(kept.read(kept.text) == kept.made.value);
}

TEST_CASE("a motion of other inputs, times or makers is kept apart", "[truth]") {
  const Kept kept;
  const auto count = [&] { return files_in(kept.folder.path()).size(); };
  CHECK(count() == 1);
  swing(kept.reference, {0.7000000000000001, 1, 9.81});
  CHECK(count() == 2);
  swing(kept.reference, {0.7, 1, 9.81}, {0.1, 0.2, 0.3, 0.4000000000000001});
  CHECK(count() == 3);
  swing(kept.reference, {0.7, 1, 9.81}, {0.1, 0.2, 0.3});
  CHECK(count() == 4);
  swing(kept.reference);
  CHECK(count() == 4);

  const std::string print(truth::fingerprint_of_makers);
  const std::size_t at = kept.text.find(print);
  REQUIRE(print.size() == 64);
  REQUIRE(at != std::string::npos);
  std::string foreign = kept.text;
  foreign[at] = foreign[at] == '0' ? '1' : '0';
  CHECK(kept.read(foreign) == kept.made.value);
  CHECK(text_of(kept.file) == kept.text);
}

TEST_CASE("a cache that cannot be written is done without", "[truth]") {
  const ScratchFolder folder;
  const fs::path no_folder = folder.file("a file", "");
  CHECK(swing(Reference(tables, no_folder)).value == swing(known()).value);
}

// ---- watched ----------------------------------------------------------------------------------------------

TEST_CASE("what a watch throws ends the making of a motion, and nothing is kept", "[truth]") {
  const ScratchFolder folder;
  const Reference reference(tables, folder.path());
  struct Enough {};
  for (int last : {1, 3}) {
    int ticks = 0;
    const auto ending_with = [&](const auto& exception) {
      ticks = 0;
      return reference.watched([&ticks, last, exception] {
        if (++ticks == last) throw exception;
      });
    };
    CHECK_THROWS_AS(swing(ending_with(Enough{})), Enough);
    CHECK(ticks == last);
    CHECK_THROWS_AS(swing(ending_with(OutOfTime("over"))), OutOfTime);
    CHECK_THROWS_AS(swing(ending_with(std::logic_error("over"))), std::logic_error);
  }
  CHECK(files_in(folder.path()).empty());
}

TEST_CASE("a long integration is watched on its way", "[truth]") {
  int ticks = 0;
  const std::vector<double> top{1, 0.25, 0.125, 0.0625, 9.81, 0.25, 0.5, 0.75, 0.5, 0.25, 31};
  known().watched([&] { ++ticks; }).motion("03_33_axis", top, std::vector{2.0});
  CHECK(ticks > 10);
}
