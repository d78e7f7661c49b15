// A chunk of a sweep, after its seal and its head.
#include "extras/sweep/chunks.hpp"

#include "extras/fuzz/fuzz.hpp"
#include "reference/files.hpp"

namespace {

oddity::sweep::Plan small_plan() {
  oddity::sweep::Asked asked;
  asked.model = "one angle";
  asked.algorithm = "velocity Verlet";
  asked.axes = {{"a", "rad", 0, 1, 7}, {"L", "m", 1, 2, 5}};
  return {asked, {0, 1}, {1}, "fingerprint"};
}

}  // namespace

void fuzz::read(std::string_view input) {
  static const oddity::sweep::Plan plan = small_plan();
  const std::string text =
      plan.fingerprint + "\nchunk 0\n" + std::string(input) + (input.ends_with('\n') ? "" : "\n");
  const auto chunk = file("sweep/chunks/000000.txt", text + oddity::checksum(text) + "\n");
  const auto tiles = kept(chunk.parent_path().parent_path(), plan, 0);
  for (const oddity::sweep::Tile& tile : tiles.value())
    require(tile.ended.size() == 35 && tile.looked.size() == 35);
}
