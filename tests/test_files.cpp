#include <sys/resource.h>
#include <sys/stat.h>

#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <fstream>

#include "reference/csv.hpp"
#include "reference/files.hpp"
#include "report/study/engines.hpp"
#include "report/study/results.hpp"
#include "report/study/run_program.hpp"
#include "report/verify/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/program.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;
namespace fs = std::filesystem;

namespace {

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

}  // namespace

TEST_CASE("a file that cannot be written completely stays as it was, and nothing is left next to it",
          "[files]") {
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

TEST_CASE("only a file can be overwritten", "[files]") {
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

TEST_CASE("a table may have Windows line ends, and no control characters", "[files]") {
  const ScratchFolder scratch;
  CHECK(read_csv(scratch.file("a.csv", "x,y\r\n1,2\r\n")).rows.at(0).number(1) == 2);
  const auto refused = complaint([&] { read_csv(scratch.file("b.csv", "x,y\n1,\x1b[31m\n")); });
  CHECK(refused.find("b.csv:2: not a line of CSV: it holds a control character") != std::string::npos);
  CHECK(complaint([&] { read_csv(scratch.path()); }).find("cannot read") == 0);
}

TEST_CASE("only a regular file of limited size is read, without waiting", "[files]") {
  const ScratchFolder scratch;
  const fs::path pipe = scratch.path() / "pipe", large = scratch.file("large", ""),
                 link = scratch.path() / "link";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  fs::resize_file(large, most_read + 1);  // a hole
  CHECK(read_whole(scratch.file("text", "two\nlines")) == "two\nlines");
  CHECK(complaint([&] { read_whole(scratch.path()); }).ends_with(": it is a folder"));
  CHECK(complaint([&] { read_whole(scratch.path() / "none"); }).ends_with(": No such file or directory"));
  CHECK(complaint([&] { read_whole(pipe); }).ends_with(": it is not a regular file"));
  CHECK(complaint([&] { read_whole("/dev/zero"); }).ends_with(": it is not a regular file"));
  CHECK(complaint([&] {
          read_whole(large);
        }).ends_with(": it is larger than 200 MB, and no file of this kind is"));
  for (const fs::path& wrong : {pipe, fs::path("/dev/zero"), large}) {
    CHECK(complaint([&] { read_csv(wrong); }).find("cannot read " + wrong.string()) == 0);
    CHECK(complaint([&] { read_results(wrong); }).find("cannot read " + wrong.string()) == 0);
    CHECK(complaint([&] { read_engines(wrong); }).find("cannot read " + wrong.string()) == 0);
    CHECK_FALSE(read_sealed(wrong));
  }
  write_sealed(scratch.path() / "kept", "one line\n");
  CHECK(read_sealed(scratch.path() / "kept") == "one line\n");
  fs::create_symlink("kept", link);
  CHECK_FALSE(read_sealed(link));
}

TEST_CASE("nothing is written through an existing link or file", "[files]") {
  const ScratchFolder scratch, other;
  const fs::path victim = other.file("victim", "before"), file = scratch.path() / "file";
  fs::create_symlink(victim, scratch.path() / "file.part");
  fs::create_symlink(victim, file);
  write_whole(file, "whole");
  CHECK(text_of(victim) == "before");
  CHECK(fs::is_regular_file(fs::symlink_status(file)));
  CHECK(text_of(file) == "whole");
  CHECK(fs::status(file).permissions() == fs::status(victim).permissions());  // by the umask
  fs::remove(file);
  fs::create_symlink(other.path() / "none", file);
  require_writable(file);
  write_whole(file, "whole");
  CHECK_FALSE(fs::exists(other.path() / "none"));
  REQUIRE(mkfifo((scratch.path() / "other.part").c_str(), 0600) == 0);
  write_whole(scratch.path() / "other", "nobody reads the pipe");
  REQUIRE(mkfifo((scratch.path() / "pipe").c_str(), 0600) == 0);
  CHECK(
      complaint([&] { write_whole(scratch.path() / "pipe", "x"); }).ends_with(": it is not a regular file"));
}

TEST_CASE("a link in a file's path is followed if root or we made it, and no other user's", "[files]") {
  const ScratchFolder scratch;
  fs::create_directory(scratch.path() / "real");
  fs::create_symlink("real", scratch.path() / "link");
  write_whole(scratch.path() / "link/deeper/file", "whole");
  CHECK(text_of(scratch.path() / "real/deeper/file") == "whole");
  if (lchown((scratch.path() / "link").c_str(), 12345, 12345) != 0) return;  // only root can
  CHECK(complaint([&] {
          write_whole(scratch.path() / "link/file", "x");
        }).ends_with(": link is another user's link: name the folder itself"));
  CHECK(complaint([&] { require_writable_folder(scratch.path() / "link/charts"); }) != "nothing");
  CHECK_FALSE(fs::exists(scratch.path() / "real/file"));
}

TEST_CASE("leftovers of killed runs are removed when they are a day old and ours", "[files]") {
  const ScratchFolder scratch;
  const fs::path old = scratch.file(".oddity-0123456789abcdef.part", ""),
                 fresh = scratch.file(".oddity-0123456789abcdee.part", ""),
                 named = scratch.file(".oddity-mine.part", "");
  for (const fs::path& file : {old, named})
    fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(25));
  write_whole(scratch.path() / "file", "whole");
  CHECK_FALSE(fs::exists(old));
  CHECK(fs::exists(fresh));
  CHECK(fs::exists(named));
}

TEST_CASE("a folder for kept files belongs to its user alone, or nothing is kept", "[files]") {
  const ScratchFolder scratch;
  const fs::path kept = scratch.path() / "cache/oddity";
  const auto refused = [&] { return complaint([&] { require_private(kept, "motions"); }); };
  const mode_t before = umask(0);
  CHECK(refused() == "nothing");
  umask(before);
  CHECK(fs::status(kept).permissions() == fs::perms::owner_all);
  fs::permissions(kept, fs::perms::others_write, fs::perm_options::add);
  CHECK(refused().find(kept.string() + " can be written by others: ") != std::string::npos);
  fs::permissions(kept, fs::perms::owner_all);
  fs::create_symlink("elsewhere", kept / "motions");
  CHECK(refused().find("/motions is a link: ") != std::string::npos);
  fs::remove(kept / "motions");
  fs::create_directory(kept / "motions");
  CHECK(refused() == "nothing");
  write_sealed(kept / "motions/one", "line\n");
  CHECK(read_sealed(kept / "motions/one") == "line\n");
  if (geteuid() == 0) {
    REQUIRE(chown((kept / "motions/one").c_str(), 12345, 12345) == 0);
    CHECK_FALSE(read_sealed(kept / "motions/one"));
    CHECK(read_sealed(kept / "motions/one", Whose::anybodys) == "line\n");
    REQUIRE(chown((kept / "motions").c_str(), 12345, 12345) == 0);
    CHECK(refused().find("/motions is another user's: ") != std::string::npos);
    REQUIRE(chown(kept.c_str(), 12345, 12345) == 0);
    fs::permissions(kept, fs::perms::none);
    CHECK(refused().find("/oddity is another user's: ") != std::string::npos);
  }
  fs::remove_all(kept);
  fs::create_symlink(scratch.path(), kept);
  CHECK(refused().find("/oddity is a link or no folder: ") != std::string::npos);
  fs::remove(kept);
  CHECK(complaint([] { require_private("/proc/none/oddity", "motions"); }) == "nothing");  // nothing is there
}

TEST_CASE("a folder with files of others is used on request", "[files]") {
  const ScratchFolder scratch;
  const fs::path ours = scratch.path() / "ours", others = scratch.path() / "others";
  take_folder(ours, false);
  write_whole(ours / "README.md", "a report");
  take_folder(ours, false);
  scratch.file("others/README.md", "somebody's");
  CHECK(
      complaint([&] { take_folder(others, false); }) ==
      others.string() +
          " holds files that are not of oddity, such as README.md: name a new folder, or write over them by --overwrite");
  CHECK(files_in(others) == 1);
  take_folder(others, true);
  take_folder(others, false);
  scratch.file("marked/.oddity", "somebody's too");
  scratch.file("marked/index.html", "");
  CHECK(complaint([&] { take_folder(scratch.path() / "marked", false); }) != "nothing");
}

TEST_CASE("programs are found on PATH, and not in the current folder", "[files]") {
  CHECK(program_on_path("sh").starts_with('/'));
  CHECK(program_on_path("./sh") == "./sh");
  const ScratchFolder scratch;
  for (const char* name : {"env", "coqc"})
    fs::permissions(scratch.file(name, "#!/bin/sh\ntouch canary\n"), fs::perms::owner_all);
  const std::string there = scratch.path().string();
  const auto ran =
      program::shell("cd " + there + " && PATH=.::./:$PATH $oddity prove 7.1 --out " + there + "/proofs");
  INFO(ran.output);
  CHECK(fs::exists(scratch.path() / "proofs"));
  CHECK_FALSE(fs::exists(scratch.path() / "canary"));
}
