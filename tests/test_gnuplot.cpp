#include <sys/resource.h>

#include <csignal>
#include <fstream>

#include "report/charts/gnuplot.hpp"
#include "tests/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

std::string sine(const fs::path& into) {
  return "set terminal svg\n" + set_output(into) + "plot sin(x)\nunset output\n";
}

/// A program of our own in place of gnuplot.
Plotter plotter(const ScratchFolder& scratch, const std::string& script) {
  const fs::path program = scratch.file("plotter", "#!/bin/sh\n" + script + "\n");
  fs::permissions(program, fs::perms::owner_all);
  return {program.string(), 300ms};
}

/// What the drawing of a picture complains of. Its folder holds what it held before: an older picture.
std::string refused(const ScratchFolder& scratch, const Plotter& by, const std::string& script = "") {
  const fs::path folder = scratch.path() / "pictures";
  fs::create_directories(folder);
  std::ofstream(folder / "sine.svg") << "an older picture";
  const std::string words = complaint([&] {
    draw({{folder / "sine.svg", [&](const fs::path& into) { return script.empty() ? sine(into) : script; }}},
         by);
  });
  CHECK(fs::file_size(folder / "sine.svg") == std::string("an older picture").size());
  CHECK(std::distance(fs::directory_iterator(folder), fs::directory_iterator()) == 1);
  return words;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("pictures are drawn whole", "[gnuplot]") {
  const ScratchFolder scratch;
  draw({{scratch.path() / "new" / "a.svg", sine}, {scratch.path() / "b.svg", sine}});
  CHECK(fs::file_size(scratch.path() / "new" / "a.svg") > 1000);
  CHECK(std::distance(fs::directory_iterator(scratch.path()), fs::directory_iterator()) == 2);
}

TEST_CASE("a plotter that is missing, fails, dies, hangs or does nothing is reported", "[gnuplot]") {
  const ScratchFolder scratch;
  CHECK(has(refused(scratch, {"/no/such/gnuplot", 1s}), "/no/such/gnuplot: No such file or directory"));
  CHECK(has(refused(scratch, plotter(scratch, "echo some words >&2; exit 3")),
            "ended with status 3: some words"));
  CHECK(has(refused(scratch, plotter(scratch, "kill -9 $$")), "ended with signal 9"));
  CHECK(has(refused(scratch, plotter(scratch, "exec sleep 100")), "ended with no answer within 0.3 s"));
  CHECK(has(refused(scratch, plotter(scratch, "exit 0")), "it came out unfinished"));
  CHECK(has(refused(scratch, gnuplot_plotter(), "plot nonsense\n"), "undefined variable: nonsense"));
}

TEST_CASE("a plotter that does not read its script breaks no pipe", "[gnuplot]") {
  const ScratchFolder scratch;
  const std::string long_script(1'000'000, '\n');
  CHECK(has(refused(scratch, plotter(scratch, "exit 4"), long_script), "ended with status 4"));
}

TEST_CASE("a picture that a full disk cuts off is not kept", "[gnuplot]") {
  const ScratchFolder scratch;
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);  // which gnuplot inherits
  const rlimit small{2000, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string words = refused(scratch, gnuplot_plotter());
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  CHECK(has(words, "sine.svg: it came out unfinished"));
}
