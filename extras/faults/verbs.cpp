#include "extras/faults/verbs.hpp"

#include <sys/stat.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "tests/scratch_folder.hpp"

namespace faults {

namespace fs = std::filesystem;

namespace {

/// An engine that dies at each request.
constexpr const char* dying_engine = R"(#!/bin/sh
[ "$1" = --about ] || kill -ABRT $$
echo '{"name": "Dying", "version": "1", "precision": "double",
       "variants": [{"name": "defaults", "says": "", "order": 1, "defaults": true}]}'
)";

/// A slow proof assistant that accepts everything: the test is about oddity's own files.
constexpr const char* believing_coqc = "#!/bin/sh\nsleep 0.05\necho Closed under the global context\n";

void write_program(const fs::path& file, const char* text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << text;
  fs::permissions(file, fs::perms::owner_all);
}

std::string replaced(std::string text, const std::string& old, const std::string& fresh) {
  if (const auto at = text.find(old); at != std::string::npos) text.replace(at, old.size(), fresh);
  return text;
}

void must(const Ended& ended) {
  if (ended.status != 0) throw std::runtime_error("cannot prepare: " + ended.output);
}

/// Keeps the times of writing, by which the program recognizes stale files.
void copy_as_it_is(const fs::path& from, const fs::path& to) {
  fs::create_directories(to.parent_path());
  must(run({{"/bin/cp", "-a", from.string(), to.string()}}));
}

}  // namespace

Installed::Installed(fs::path root) : root_(std::move(root)) {
  umask(022);  // the program runs nothing that others can write to
  copy_as_it_is(ODDITY_PROGRAM, root_ / "bin/oddity");
  copy_as_it_is(ODDITY_MAKER, root_ / "bin/make_reference");
  for (const char* room : {"tables", "approved"})
    copy_as_it_is(ODDITY_SOURCE "/reference/" + std::string(room), tables() / room);
  if (fs::exists(ODDITY_MODULE))
    for (const char* module : {"models.js", "own.js"})
      copy_as_it_is(fs::path(ODDITY_MODULE).replace_filename(module), root_ / "share/oddity" / module);
  write_program(root_ / "lib/oddity/engines/engine_dying", dying_engine);
  write_program(root_ / "tools/coqc", believing_coqc);
}

Command Installed::command(const Verb& verb, const fs::path& folder) const {
  Command command{{(root_ / "bin" / verb.program).string()}};
  for (const std::string& word : verb.words) command.words.push_back(replaced(word, "{}", folder.string()));
  command.environment["XDG_CACHE_HOME"] = (folder / "cache").string();
  const char* path = std::getenv("PATH");
  command.environment["PATH"] = (root_ / "tools").string() + ":" + (path ? path : "");
  return command;
}

Ended Installed::run(const std::vector<std::string>& words, const fs::path& folder) const {
  return faults::run(command({"", words}, folder));
}

void Installed::put_results(const fs::path& folder) const {
  const fs::path results = "cache/oddity/results.json", made = root_ / "made";
  if (!fs::exists(made)) {
    if (fs::exists(ODDITY_SOURCE "/build/results.json"))
      copy_as_it_is(ODDITY_SOURCE "/build/results.json", made / results);
    must(run({"report", "--out", (root_ / "report").string()}, made));
  }
  copy_as_it_is(made / results, folder / results);
}

std::vector<Verb> verbs(const Installed& program) {
  const auto with_results = [&](const fs::path& folder) { program.put_results(folder); };
  const auto with_records = [&](const fs::path& folder) {
    fs::copy(program.tables(), folder / "out", fs::copy_options::recursive);
    const fs::path verdicts = folder / "out/approved/verdicts.csv";
    const std::string text = text_of(verdicts);
    std::ofstream(verdicts) << replaced(text, "3.5-value,wrong", "3.5-value,confirmed");
  };
  const auto with_plan = [&](const fs::path& folder) {
    must(program.run({"sweep", "plan", (folder / "out").string(), "3.5", "--model", "one angle",
                      "--algorithm", "Runge-Kutta 4", "--over", "a=1deg..179deg:200", "--over",
                      "step=1ms..2.5s:200", "--looks", "4", "--chunk-time", "50ms"},
                     folder));
  };
  const auto with_chunks = [&, with_plan](const fs::path& folder) {
    with_plan(folder);
    must(program.run({"sweep", "run", (folder / "out").string()}, folder));
  };
  const auto with_tables = [](const fs::path& folder) { fs::create_directories(folder / "out"); };
  return {
      {.name = "report", .words = {"report", "--chapter", "9", "--out", "{}/out"}, .prepare = with_results},
      {.name = "site", .words = {"site", "--out", "{}/out"}, .prepare = with_results},
      {.name = "chart", .words = {"chart", "9.1", "--out", "{}/out"}, .timed = true},
      {.name = "stability", .words = {"stability", "3.5", "--out", "{}/out"}},
      {.name = "verify",
       .words = {"verify", "[9.1]", "--results", "{}/out/results.json", "-r", "junit", "-o",
                 "{}/out/junit.xml"},
       .timed = true},
      {.name = "verify --approve",
       .words = {"--reference", "{}/out", "verify", "[3.5]", "--approve"},
       .prepare = with_records},
      {.name = "choose",
       .words = {"choose", "3.9", "--digits", "14", "--horizon", "1"},
       .timed = true,
       .keeps = true},
      {.name = "sweep plan",  // so small that it is one chunk, however busy the machine is
       .words = {"sweep", "plan", "{}/out", "3.5", "--model", "one angle", "--algorithm", "Runge-Kutta 4",
                 "--over", "a=1deg..179deg:40", "--looks", "4", "--setting", "0.1"},
       .timed = true},
      {.name = "sweep run", .words = {"sweep", "run", "{}/out"}, .prepare = with_plan},
      {.name = "sweep merge",
       .words = {"sweep", "merge", "{}/out", "--out", "{}/out/map.csv"},
       .prepare = with_chunks},
      {.name = "sweep merge to HDF5", .words = {"sweep", "merge", "{}/out"}, .prepare = with_chunks},
      {.name = "sweep draw", .words = {"sweep", "draw", "{}/out"}, .prepare = with_chunks},
      {.name = "make_reference",
       .words = {"{}/out", "03_05_quarter_period"},
       .program = "make_reference",
       .prepare = with_tables},
      {.name = "new", .words = {"new", "20.1", "comet", "--topic", "space", "--in", "{}/out"}, .once = true},
      {.name = "engines", .words = {"engines", "free body", "--finest", "1"}},
      {.name = "prove", .words = {"prove", "5.1", "--out", "{}/out"}},
  };
}

Files files_in(const fs::path& folder) {
  Files all;
  if (!fs::exists(folder)) return all;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      all[entry.path().lexically_relative(folder).string()] = text_of(entry.path());
  return all;
}

}  // namespace faults
