#include <sys/resource.h>

#include <array>
#include <csignal>
#include <fstream>

#include "reference/csv.hpp"
#include "reference/files.hpp"
#include "tests/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;
namespace fs = std::filesystem;

namespace {

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

}  // namespace

TEST_CASE("a file that cannot be written whole is as it was, and nothing is left beside it", "[files]") {
  const ScratchFolder scratch;
  const fs::path file = scratch.file("results", "before");
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{1000, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string refused = complaint([&] { write_whole(file, std::string(100'000, 'x')); });
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  CHECK(refused.find("cannot write " + file.string() + ": ") == 0);
  CHECK(text_of(file) == "before");
  CHECK(files_in(scratch.path()) == 1);
}

TEST_CASE("what is no file is not written over", "[files]") {
  const ScratchFolder scratch;
  CHECK(complaint([&] { write_whole(scratch.path(), "x"); }).find("it is a folder") != std::string::npos);
  CHECK(complaint([&] { write_whole("/dev/full", "x"); }).find("not a regular file") != std::string::npos);
  CHECK(fs::is_character_file("/dev/full"));
}

TEST_CASE("a place where nothing can be written is named before the run", "[files]") {
  const ScratchFolder scratch;
  const fs::path file = scratch.file("file", "x");
  fs::create_symlink("loop", scratch.path() / "loop");
  for (const fs::path& wrong : {file / "results.json", scratch.path() / "loop" / "results.json",
                                scratch.path() / std::string(300, 'n')}) {
    CHECK(complaint([&] { require_writable(wrong); }).find("cannot ") == 0);
    CHECK(complaint([&] { require_writable_folder(wrong); }).find("cannot ") == 0);
  }
  require_writable_folder(scratch.path() / "new");
  CHECK(files_in(scratch.path() / "new") == 0);
}

TEST_CASE("a table may end its lines as Windows does, and holds no control characters", "[files]") {
  const ScratchFolder scratch;
  CHECK(read_csv(scratch.file("a.csv", "x,y\r\n1,2\r\n")).rows.at(0).number(1) == 2);
  const auto refused = complaint([&] { read_csv(scratch.file("b.csv", "x,y\n1,\x1b[31m\n")); });
  CHECK(refused.find("b.csv:2: not a line of CSV: it holds a control character") != std::string::npos);
  CHECK(complaint([&] { read_csv(scratch.path()); }).find("cannot read") == 0);
}
