#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <set>
#include <thread>

#include "chapters/random.hpp"
#include "extras/sweep/merge.hpp"
#include "report/verify/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/program.hpp"
#include "tests/properties.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity::sweep;
using namespace program;
namespace fs = std::filesystem;

namespace {

// Chunks of a few milliseconds, so that there are many of them.
const std::string small =
    " 3.5 --model 'one angle' --algorithm 'velocity Verlet' --over a=10deg..170deg:200 --over step=5ms..1:200 "
    "--looks 4 --chunk-time 3ms";
// More chunks than shards, threads and ranks.
const std::string many =
    " 3.5 --model 'one angle' --algorithm 'velocity Verlet' --over a=10deg..170deg:520 --over step=5ms..1:520 "
    "--looks 4 --chunk-time 0.5ms";

std::string quoted(const fs::path& path) { return "'" + path.string() + "'"; }

/// Makes a plan in a folder, by the program.
void plan(const fs::path& folder, const std::string& asked = small) {
  const Ran ran = run("sweep plan " + quoted(folder) + asked);
  INFO(ran.output);
  REQUIRE(ran.status == 0);
}

/// All files of a folder by name.
std::map<std::string, std::string> files_in(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& file : fs::directory_iterator(folder))
    files[file.path().filename()] = text_of(file.path());
  return files;
}

/// A copy of a plan, with nothing done.
fs::path copy_of_plan(const fs::path& folder, const fs::path& to) {
  fs::create_directories(to);
  fs::copy_file(plan_file(folder), plan_file(to));
  return to;
}

std::size_t chunks_in(const fs::path& folder) {
  std::size_t count = 0;
  for (const auto& file : fs::directory_iterator(folder / "chunks"))
    count += file.path().extension() == ".txt";
  return count;
}

/// The time at which each chunk was made.
std::map<std::string, fs::file_time_type> chunk_times(const fs::path& folder) {
  std::map<std::string, fs::file_time_type> times;
  for (const auto& file : fs::directory_iterator(folder / "chunks"))
    if (file.path().extension() == ".txt") times[file.path().filename()] = file.last_write_time();
  return times;
}

/// Starts the program and kills it after this time. Returns whether it had not ended before.
bool killed_after(std::chrono::duration<double> time, std::vector<std::string> arguments) {
  const pid_t child = fork();
  if (child == 0) {
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, 1), dup2(nowhere, 2);
    std::vector<char*> words{const_cast<char*>("oddity")};
    for (std::string& argument : arguments) words.push_back(argument.data());
    words.push_back(nullptr);
    execv(ODDITY_PROGRAM, words.data());
    _exit(127);
  }
  std::this_thread::sleep_for(time);
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status);
}

Ended disc(int x, int y) {
  return {std::hypot(x - 300, y - 220) < 171.3 ? "inside" : "outside", 1.0 * x, 1.0 * y};
}

}  // namespace

TEST_CASE("a map is quartered where neighbours end differently", "[sweep]") {
  const Cells cells{10, 20, 521, 419};
  const Tile all = all_looked_at(cells, disc), few = quartered(cells, disc);
  REQUIRE(all.ended.size() == 512 * 400);
  long looked = 0;
  for (int y = cells.first_y; y <= cells.last_y; ++y)
    for (int x = cells.first_x; x <= cells.last_x; ++x) {
      const std::size_t place = few.place(x, y);
      looked += few.looked[place];
      if (few.ended[place].as != all.ended[place].as) FAIL("at " << x << ", " << y);
      if (few.looked[place])
        CHECK(few.ended[place].error == x);
      else
        CHECK(std::isnan(few.ended[place].error));
    }
  CHECK(looked < 512 * 400 / 20);
  CHECK(few.checked > 100);
}

TEST_CASE("checked cells find islands, which are then divided closely", "[sweep]") {
  // Stripes that miss all corners of the map.
  const Look stripes = [](int x, int) { return Ended{x / 40 % 3 == 1 ? "stripe" : "sea"}; };
  const Cells cells{0, 0, 255, 255};
  REQUIRE(stripes(0, 0).as == stripes(255, 255).as);
  const Tile few = quartered(cells, stripes), all = all_looked_at(cells, stripes);
  CHECK(few.otherwise > 0);
  long wrong = 0;
  for (std::size_t i = 0; i < all.ended.size(); ++i) wrong += few.ended[i].as != all.ended[i].as;
  CHECK(wrong < 256 * 256 / 100);
}

TEST_CASE("axes go evenly or by a factor, and end at the given values", "[sweep]") {
  const Axis even{"a", "rad", -1, 2, 7}, factor{"step", "s", 1e-3, 10, 5, true};
  CHECK(even.at(0) == -1);
  CHECK(even.at(2) == 0);
  CHECK(even.at(6) == 2);
  CHECK(factor.at(0) == 1e-3);
  CHECK(std::abs(factor.at(2) - 0.1) < 1e-15);
  CHECK(factor.at(4) == 10);
}

TEST_CASE("a sweep is the same, byte for byte, however it is shared", "[sweep]") {
  const ScratchFolder scratch;
  const fs::path one = scratch.path() / "one";
  plan(one, many);
  REQUIRE(run("sweep run --threads 1 " + quoted(one)).status == 0);
  const auto chunks = files_in(one / "chunks");
  REQUIRE(chunks.size() > 64);
  const fs::path csv = scratch.path() / "one.csv";
  REQUIRE(run("sweep merge " + quoted(one) + " --out " + quoted(csv)).status == 0);
  const std::string cells = text_of(csv);
  CHECK(std::count(cells.begin(), cells.end(), '\n') == 520 * 520 + 1);

  SECTION("by threads") {
    for (int threads : {2, 7, 64}) {
      const fs::path other = copy_of_plan(one, scratch.path() / std::to_string(threads));
      REQUIRE(run("sweep run --threads " + std::to_string(threads) + " " + quoted(other)).status == 0);
      CHECK(files_in(other / "chunks") == chunks);
    }
  }
  SECTION("by machines that share nothing") {
    for (int shards : {2, 7, 64}) {
      std::string folders;
      for (int shard = 1; shard <= shards; ++shard) {
        const std::string share = std::to_string(shard) + "/" + std::to_string(shards);
        const fs::path other = copy_of_plan(one, scratch.path() / share);
        REQUIRE(run("sweep run --threads 1 --shard " + share + " " + quoted(other)).status == 0);
        CHECK(chunks_in(other) < chunks.size());
        folders += " " + quoted(other);
      }
      const fs::path out = scratch.path() / (std::to_string(shards) + ".csv");
      const Ran merged = run("sweep merge" + folders + " --out " + quoted(out));
      INFO(merged.output);
      REQUIRE(merged.status == 0);
      CHECK(text_of(out) == cells);
    }
  }
  SECTION("by ranks of MPI, if available") {
    if (shell("command -v mpirun").status == 0 &&
        fs::exists(fs::path(ODDITY_PROGRAM).parent_path() / "liboddity_mpi.so")) {
      for (int ranks : {2, 7, 64}) {
        const fs::path other = copy_of_plan(one, scratch.path() / std::to_string(ranks));
        const Ran ran =
            shell("OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun --oversubscribe -n " +
                  std::to_string(ranks) + " $oddity sweep run " + quoted(other));
        INFO(ran.output);
        REQUIRE(ran.status == 0);
        CHECK(files_in(other / "chunks") == chunks);
        CHECK(says(ran, "all " + std::to_string(chunks.size()) + " chunks are there"));
      }
    }
  }
  SECTION("merged twice") {
    const fs::path again = scratch.path() / "again.csv";
    REQUIRE(run("sweep merge " + quoted(one) + " --out " + quoted(again)).status == 0);
    CHECK(text_of(again) == cells);
    const Ran h5 = run("sweep merge " + quoted(one));
    if (h5.status == 0) {
      const std::string first = text_of(one / "map.h5");
      REQUIRE(run("sweep merge " + quoted(one)).status == 0);
      CHECK(text_of(one / "map.h5") == first);
    } else {
      CHECK(says(h5, "built without HDF5"));
    }
  }
}

TEST_CASE("a sweep that is killed repeatedly loses only the chunks under way", "[sweep]") {
  const ScratchFolder scratch;
  const fs::path whole = scratch.path() / "whole", killed = scratch.path() / "killed";
  plan(whole);
  const auto begin = std::chrono::steady_clock::now();
  REQUIRE(run("sweep run --threads 1 " + quoted(whole)).status == 0);
  std::chrono::duration<double> takes = std::chrono::steady_clock::now() - begin;
  const auto chunks = files_in(whole / "chunks");

  const int most = oddity::in_environment("ODDITY_KILLS", 25);
  oddity::Random random(11);
  int kills = 0, kills_of_resumed = 0;
  std::map<std::string, fs::file_time_type> before;
  for (int time = 0; kills < most && time < 10 * most; ++time) {
    if (before.empty() || before.size() == chunks.size()) {
      fs::remove_all(killed);
      copy_of_plan(whole, killed);
      fs::create_directories(killed / "chunks");
      before.clear();
    }
    const bool was_killed =
        killed_after(takes * random.between(0, 1), {"sweep", "run", "--threads", "1", killed});
    kills += was_killed;
    kills_of_resumed += was_killed && !before.empty();
    const auto after = chunk_times(killed);
    // The machine may be busier or less busy than before.
    if (!was_killed) takes *= 0.8;
    if (was_killed && after.size() == before.size()) takes *= 1.25;
    for (const auto& [name, made] : before) CHECK(after.at(name) == made);
    for (const auto& [name, text] : files_in(killed / "chunks"))
      if (name.ends_with(".txt")) CHECK(text == chunks.at(name));
    CHECK(files_in(killed / "chunks").size() <= after.size() + 1);  // and the one being written
    before = after;
  }
  CHECK(kills == most);
  CHECK(kills_of_resumed > 0);
  REQUIRE(run("sweep run " + quoted(killed)).status == 0);
  for (const auto& [name, text] : chunks) CHECK(text_of(killed / "chunks" / name) == text);
  CHECK(run("sweep merge " + quoted(killed) + " --out " + quoted(scratch.path() / "k.csv")).status == 0);
}

TEST_CASE("merge refuses missing, duplicate, damaged and foreign chunks", "[sweep]") {
  const ScratchFolder scratch;
  const fs::path one = scratch.path() / "one", out = scratch.path() / "out.csv";
  plan(one);
  REQUIRE(run("sweep run " + quoted(one)).status == 0);
  const auto merge = [&](const std::string& folders) {
    return run("sweep merge " + folders + " --out " + quoted(out));
  };
  const fs::path second = one / "chunks/000001.txt";
  const std::string text = text_of(second);

  fs::remove(second);
  const Ran hole = merge(quoted(one));
  CHECK(hole.status == 2);
  CHECK(says(hole, "chunk 1 is missing"));
  CHECK_FALSE(fs::exists(out));

  std::string damaged = text;
  damaged[text.size() / 2] ^= 1;
  std::ofstream(second, std::ios::binary) << damaged;
  CHECK(says(merge(quoted(one)), "000001.txt is damaged"));
  REQUIRE(run("sweep run " + quoted(one)).status == 0);
  CHECK(text_of(second) == text);

  const fs::path other = copy_of_plan(one, scratch.path() / "other");
  fs::create_directories(other / "chunks");
  fs::copy_file(second, other / "chunks/000001.txt");
  const Ran twice = merge(quoted(one) + " " + quoted(other));
  CHECK(twice.status == 2);
  CHECK(says(twice, "chunk 1 is there twice"));

  const fs::path foreign = scratch.path() / "foreign";
  plan(foreign, small + " --horizon 9");
  REQUIRE(run("sweep run " + quoted(foreign)).status == 0);
  fs::remove(second);
  fs::copy_file(foreign / "chunks/000001.txt", second);
  CHECK(says(merge(quoted(one)), "is of another sweep"));
  fs::remove(second);
  std::ofstream(second, std::ios::binary) << text;
  std::ofstream(one / "chunks/999999.txt") << "nothing of ours\n";
  CHECK(says(merge(quoted(one)), "999999.txt is no chunk of this sweep"));
}

TEST_CASE("a plan belongs to its program, tables and question", "[sweep]") {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "sweep";
  plan(folder);
  std::string text = text_of(plan_file(folder));
  const auto at = text.find("\"horizon\": 10");
  REQUIRE(at != std::string::npos);
  text.replace(at, 13, "\"horizon\": 11");
  std::ofstream(plan_file(folder), std::ios::binary) << text;
  const Ran changed = run("sweep run " + quoted(folder));
  CHECK(changed.status == 2);
  CHECK(says(changed, "another question"));
  std::ofstream(plan_file(folder)) << "{}";
  CHECK(says(run("sweep run " + quoted(folder)), "is no plan of a sweep"));
  CHECK(says(run("sweep status " + quoted(scratch.path() / "none")), "there is no plan"));
}

TEST_CASE("a map that no machine could hold is refused at once", "[sweep]") {
  const ScratchFolder scratch;
  const Ran ran = run("sweep plan " + quoted(scratch.path()) +
                      " 3.5 --over a=1deg..179deg:1000000 --over L=0.1..1:1000000");
  INFO(ran.output);
  CHECK(ran.status == 2);
  CHECK(says(ran, "a map of 1e+12 cells is too large"));
  CHECK(fs::is_empty(scratch.path()));
}

TEST_CASE("a thousand million cells are planned and estimated", "[sweep]") {
  const ScratchFolder scratch;
  const Ran ran =
      run("sweep plan " + quoted(scratch.path()) +
          " 3.5 --model 'one angle' --algorithm 'Runge-Kutta 4' --over a=1deg..179deg:31623 --over "
          "step=1ms..2.5:31623 --looks 4");
  INFO(ran.output);
  CHECK(ran.status == 0);
  CHECK(says(ran, "1,000,014,129 cells in"));
  CHECK(says(ran, "on one thread"));
}

TEST_CASE("no cell of a small map is guessed", "[sweep]") {
  const ScratchFolder scratch;
  const fs::path small_one = scratch.path() / "small", large = scratch.path() / "large";
  const auto merged = [&](const fs::path& folder, const std::string& cells) {
    plan(folder,
         " 3.5 --model 'one angle' --algorithm 'velocity Verlet' --setting 1 --looks 4 --over a=0.1..3:" +
             cells);
    REQUIRE(run("sweep run " + quoted(folder)).status == 0);
    return run("sweep merge " + quoted(folder) + " --out " + quoted(folder / "map.csv"));
  };
  CHECK(says(merged(small_one, "4096"), "4,096 cells, all of them looked at"));
  CHECK(says(merged(large, "4097"), " of them looked at; "));

  Map map;
  map.ended.resize(5000);
  map.looked.assign(5000, 0);
  CHECK(summary(map).ends_with("looked at; none of the others was checked"));
  map.checked = 3;
  CHECK(summary(map).ends_with("none of 3 checked between them ended otherwise"));
}

TEST_CASE("a fixed step is no longer than the time between two looks, and shortening it is reported",
          "[sweep]") {
  const ScratchFolder scratch;
  const auto planned = [&](const std::string& asked) {
    const Ran ran = run("sweep plan " + quoted(scratch.path()) + " 3.5 --model 'one angle' " + asked);
    INFO(ran.output);
    CHECK((ran.status == 0 || ran.status == 2));
    return ran;
  };
  const std::string fixed = "--algorithm 'Runge-Kutta 4' ";
  const Ran axis = planned(fixed + "a=1 --over step=5ms..1s:8");
  CHECK(axis.status == 2);
  CHECK(says(axis,
             "the axis step goes up to 1 s, and a step is no longer than the 0.0167 s between two looks"));
  CHECK(says(axis, "--looks 10"));
  const Ran setting = planned(fixed + "--over a=1..2:8 --setting 1s");
  CHECK(setting.status == 2);
  CHECK(says(setting, "--setting is 1 s"));
  CHECK(planned(fixed + "--over a=1..2:8 --setting 11s --looks 1").status == 2);
  CHECK_FALSE(fs::exists(plan_file(scratch.path())));

  const Ran as_advised = planned(fixed + "a=1 --over step=5ms..1s:8 --looks 10");
  CHECK(as_advised.status == 0);
  CHECK(says(as_advised, "a whole number of them fills the 1 s between looks: by up to 29 %"));
  const Ran whole = planned(fixed + "--over a=1..2:8 --setting 0.5 --looks 10");
  CHECK(whole.status == 0);
  CHECK_FALSE(says(whole, "shortened"));
  const Ran tolerance = planned("--algorithm 'Dormand-Prince 5(4)' --over tolerance=1e-9..1:8 a=1");
  CHECK(tolerance.status == 0);
  CHECK_FALSE(says(tolerance, "shortened"));
}

TEST_CASE("a step in another variable than time may be longer than the time between two looks", "[sweep]") {
  const ScratchFolder scratch;
  const Ran ran = run("sweep plan " + quoted(scratch.path()) +
                      " 3.31 --model 'time stretched by the speed' --algorithm 'Runge-Kutta 4' --over "
                      "step=1ms..1:10 --horizon 1");
  INFO(ran.output);
  CHECK(ran.status == 0);
}

TEST_CASE("merge and draw refuse a missing folder and an unknown ending by name", "[sweep]") {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "sweep", nowhere = scratch.path() / "nowhere";
  plan(folder);
  REQUIRE(run("sweep run " + quoted(folder)).status == 0);
  for (const std::string verb : {"merge", "draw"}) {
    const Ran ran = run("sweep " + verb + " " + quoted(folder) + " " + quoted(nowhere));
    INFO(ran.output);
    CHECK(ran.status == 2);
    CHECK(says(ran, "there is no folder " + nowhere.string()));
  }
  const Ran drawn = run("sweep draw " + quoted(folder) + " --out " + quoted(folder / "map.png"));
  CHECK(drawn.status == 2);
  CHECK(says(drawn, "--out ends with .svg, and is "));
  CHECK_FALSE(fs::exists(folder / "map.png"));
}

TEST_CASE("each cell may show the choice there", "[sweep]") {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "table", csv = scratch.path() / "table.csv";
  plan(folder, " 3.5 --over a=2deg..40deg:3 --error 1deg --horizon 2 --every-cell");
  REQUIRE(run("sweep run " + quoted(folder)).status == 0);
  const Ran merged = run("sweep merge " + quoted(folder) + " --out " + quoted(csv));
  INFO(merged.output);
  REQUIRE(merged.status == 0);
  const std::string cells = text_of(csv);
  INFO(cells);
  CHECK(cells.find("a [rad],ended,error in needs,evaluations,looked at") == 0);
  CHECK(cells.find("closed form") != std::string::npos);
  const Ran drawn = run("sweep draw " + quoted(folder));
  CHECK(drawn.status == 0);
  CHECK(text_of(folder / "map.svg").find("what to choose") != std::string::npos);
}

TEST_CASE("frames as they come and kicks are of a plan, and any machine makes the same map of them",
          "[sweep]") {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "uneven", csv = scratch.path() / "uneven.csv";
  const auto cells_of = [&](const std::string& asked) {
    fs::remove_all(folder);
    plan(folder, asked);
    REQUIRE(run("sweep run " + quoted(folder)).status == 0);
    REQUIRE(run("sweep merge " + quoted(folder) + " --out " + quoted(csv)).status == 0);
    return text_of(csv);
  };
  const std::string chosen = " 3.5 --over a=20deg..40deg:3 --error 1deg --horizon 2 --every-cell";
  const std::string by_euler =
      " 3.5 --model 'one angle' --algorithm 'symplectic Euler' --over a=20deg..40deg:3 --setting 16ms --horizon 2";
  const std::string uneven = " --jitter 30% --drop 5%", kick = " --kick \"t=1s,theta'=+2\"";
  CHECK(cells_of(by_euler) != cells_of(by_euler + uneven));
  CHECK(cells_of(by_euler) != cells_of(by_euler + kick));
  CHECK(cells_of(by_euler + uneven) == cells_of(by_euler + uneven + " --frame-seed 1"));
  CHECK(cells_of(chosen).find("closed form") != std::string::npos);
  const std::string jolted = cells_of(chosen + uneven + kick);
  INFO(jolted);
  CHECK(jolted.find("closed form") == std::string::npos);
  CHECK(jolted.find("one angle, ") != std::string::npos);
  const std::string by_truth =  // which follows it so
      cells_of(
          " 3.5 --model 'one angle' --algorithm 'Fehlberg 7(8)' --over a=20deg..40deg:3 --setting 1e-13 --horizon 2" +
          kick);
  INFO(by_truth);
  CHECK(by_truth.find(",ok,") != std::string::npos);
  CHECK(by_truth.find(",ok,0,") == std::string::npos);
}

TEST_CASE("a small table of choices has many chunks, as a cell in chaos takes long", "[sweep]") {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "table";
  plan(folder, " 3.5 --over a=2deg..40deg:20 --over L=0.5..2:10 --error 1deg --horizon 1 --chunk-time 1ms");
  const Ran status = run("sweep status --csv " + quoted(folder));
  CHECK(std::ranges::count(status.output, '\n') > 12);
}

TEST_CASE("impossible sweeps are refused with a suggestion", "[sweep]") {
  const ScratchFolder scratch;
  const auto refused = [&](const std::string& asked, const std::string& why) {
    const Ran ran = run("sweep plan " + quoted(scratch.path() / "no") + " " + asked);
    INFO(asked << "\n" << ran.output);
    CHECK(ran.status == 2);
    CHECK(says(ran, why));
    CHECK_FALSE(fs::exists(plan_file(scratch.path() / "no")));
  };
  const std::string method = " --model 'one angle' --algorithm 'Runge-Kutta 4'";
  refused("3.5" + method + " --over b=1..2:5 --setting 0.1", "no parameter 'b'");
  refused("3.5" + method + " --over a=1..2 --setting 0.1", "is not NAME=FROM..TO:COUNT");
  refused("3.5" + method + " --over a=1..2:1 --setting 0.1", "whole number from 2 to");
  refused("3.5" + method + " --over a=1..200deg:9 --setting 0.1", "out of its range: 0.001 to 3.14 rad");
  refused("3.5" + method + " --over a=1..2:5 --over a=1..2:5 --setting 0.1", "given twice");
  refused("3.5" + method + " --over a=2..1:5 --setting 0.1", "the axis a goes upward, and not from 2 to 1");
  refused("3.5" + method + " --over a=1..2:5", "needs a step");
  refused("3.5" + method + " --over tolerance=1e-9..1e-3:5", "has a step");
  refused("3.5 a=1" + method + " --over a=1..2:5 --setting 0.01", "both set a: ");
  refused("3.5" + method + " --over step=1ms..9ms:5 --setting 0.01", "both set the step: ");
  refused("3.5 --model 'one angle' --over a=1..2:5", "go together");
  refused("3.5 --model 'one angel' --algorithm 'Runge-Kutta 4' --over step=1ms..1:5", "has no method");
  refused("3.5 --over step=1ms..1:5", "has its own setting");
  refused("3.5 --over a=1..2:5 --error 1deg --looks 50", "--looks is of a method");
  refused("3.5 --over a=1..2:5 --looks 1", "--looks is of a method");
  refused("3.5 --over a=1..2:5 --setting 0.1", "is a method's: name it by --model and --algorithm");
  refused("2.3 --over a=1..2:5", "has no motion");
  refused("3.5" + method + " --over a=1..2:5 --setting 1ms --looks 5 --drop 1%", "--looks are evenly spaced");
  refused("3.5" + method + " --over a=1..2:5 --setting 1ms --kick t=1,b=2", "knows no 'b' here");
  CHECK(run("sweep").status == 2);
  CHECK(says(run("sweep"), "sweep needs one of its verbs: plan, run, status, merge, draw"));
  CHECK(says(run("sweep paln x"), "did you mean 'plan'?"));
  CHECK(says(run("sweep run --thread 2 x"), "'./oddity sweep run --help' shows more"));
}

TEST_CASE("a problem's file is swept like an exercise, and its plan needs no other file", "[sweep]") {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "springs", csv = scratch.path() / "springs.csv",
                 file = scratch.path() / "car.toml";
  const auto cells_by = [&](const std::string& method) {
    fs::remove_all(folder);
    fs::copy_file(fs::path(ODDITY_SOURCE) / "chapters/examples/problems/quarter_car.toml", file);
    plan(folder, " " + quoted(file) + method);
    fs::remove(file);  // the machine that runs it has no such file
    REQUIRE(run("sweep run " + quoted(folder)).status == 0);
    REQUIRE(run("sweep merge " + quoted(folder) + " --out " + quoted(csv)).status == 0);
    return text_of(csv);
  };
  const std::string axes = " --over k=10kN/m..60kN/m:3 --over c=1..4:2";
  const std::string chosen = cells_by(axes);
  INFO(chosen);
  CHECK(chosen.find("k [kN/m],c [kN s/m],ended,error in needs") == 0);
  CHECK(chosen.find("\n10,1,\"body and wheel, ") != std::string::npos);
  const std::string tried =
      cells_by(" --model 'body and wheel' --algorithm 'explicit Euler' --setting 0.01" + axes);
  INFO(tried);
  CHECK(tried.find(",inaccurate,") != std::string::npos);
  const Ran drawn = run("sweep draw " + quoted(folder));
  CHECK(drawn.status == 0);
  CHECK(text_of(folder / "map.svg").find("car.toml, body and wheel, explicit Euler") != std::string::npos);
}
