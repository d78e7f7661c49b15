// The walk of CONTRIBUTING.md, with the two files of its page: from a table to make to a green exercise, and
// how an exercise of one's own is shown.

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "tests/catch.hpp"
#include "tests/scratch_folder.hpp"

namespace fs = std::filesystem;

namespace {

struct Ran {
  int status;
  std::string output;
};

Ran run(const std::string& command) {
  std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  Ran ran{-1, ""};
  std::array<char, 4096> buffer{};
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe))
    ran.output.append(buffer.data(), n);
  const int status = pclose(pipe);
  ran.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
  return ran;
}

bool says(const Ran& ran, const std::string& text) { return ran.output.find(text) != std::string::npos; }

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The tables and records, without what is of 4.1, should somebody have taken the walk.
void copy_tables(const fs::path& folder) {
  const fs::path source = fs::path(ODDITY_SOURCE) / "reference";
  for (const auto& entry : fs::recursive_directory_iterator(source)) {
    if (entry.path().extension() != ".csv" || entry.path().stem() == "04_01_spring") continue;
    const fs::path copy = folder / fs::relative(entry.path(), source);
    fs::create_directories(copy.parent_path());
    std::ifstream in(entry.path());
    std::ofstream out(copy);
    for (std::string line; std::getline(in, line);)
      if (!line.starts_with("4.1,") && !line.starts_with("4.1-")) out << line << "\n";
  }
}

}  // namespace

TEST_CASE("the walk of CONTRIBUTING.md ends green", "[walk]") {
  const ScratchFolder scratch;
  copy_tables(scratch.path());
  const std::string folder = scratch.path().string();
  const auto oddity = [&](const std::string& words) {
    return run(std::string(ODDITY_WALK) + " --reference " + folder + " " + words);
  };
  const auto rows = [&](const std::string& file) { return text_of(scratch.path() / file); };

  const Ran before = oddity("solve 4.1");
  CHECK(before.status == 2);
  CHECK(says(before, "04_01_spring makes it"));
  const Ran made = run(std::string(ODDITY_WALK_MAKER) + " " + folder + " 04_01_spring");
  INFO(made.output);
  REQUIRE(made.status == 0);

  CHECK(says(oddity("list"), "4.1  Mass on a spring (scene) (own)\n"));
  CHECK(oddity("solve 4.1 c=41").status == 0);

  const std::string others = rows("approved/verdicts.csv");
  const Ran red = oddity("verify '[4.1]'");
  CHECK(red.status == 1);
  CHECK(says(red, "\n+ 4.1-period,confirmed\n"));
  CHECK(says(red, "\n+ 4.1,mass on a spring,Runge-Kutta 4,"));
  CHECK_FALSE(says(red, "raised"));
  CHECK(rows("approved/verdicts.csv") == others);

  const Ran approved = oddity("verify --approve '[4.1]'");
  INFO(approved.output);
  CHECK(approved.status == 0);
  CHECK(says(approved, "\n+ 4.1-period,confirmed\n"));
  CHECK(says(approved, "Look at the differences"));
  const std::string now = rows("approved/verdicts.csv");
  const auto added = now.find("4.1-period,confirmed\n");
  REQUIRE(added != std::string::npos);
  CHECK(now.find("\n5.1-") > added);
  CHECK(std::string(now).erase(added, std::string("4.1-period,confirmed\n").size()) == others);

  const Ran green = oddity("verify '[4.1]'");
  CHECK(green.status == 0);
  CHECK_FALSE(says(green, "+ 4.1"));
  CHECK(says(oddity("verify --approve '[4.1]'"), "every row was on record already"));
  CHECK(oddity("verify '[own]'").status == 0);
  CHECK(says(oddity("choose 4.1 --criterion energy --error 0.01 --horizon 1"), "Take "));
  const Ran page = oddity("verify '[4.1]' -r markdown");
  CHECK(says(page, "0 exercises and 1 of one's own, 1 claim"));
  CHECK(says(page, "4.1 Mass on a spring (own)"));
  CHECK_FALSE(says(page, "The solutions have no exercises in this chapter"));
}
