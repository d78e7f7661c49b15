// Writes the results of all scenes and of the site's example, without times, for replay.mjs: write_trials
// TABLES FILE

#include <vector>

#include "chapters/contents.hpp"
#include "reference/files.hpp"
#include "report/site/example.hpp"
#include "report/study/run.hpp"

int main(int, char** argv) {
  using namespace oddity;
  std::vector<Task> scenes;
  for (const Entry& entry : registry())
    if (entry.exercise.scene) scenes.emplace_back(entry);
  scenes.emplace_back(example());
  write_whole(argv[2], to_json(run(scenes, Reference(argv[1]), false)));
}
