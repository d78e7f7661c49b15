// MuJoCo 2.2: friction depends on the direction.
//
// By default the friction cone is a pyramid: a box that slides along the diagonal of its contact's axes goes
// 41 % farther than one along an axis. cone="elliptic" fixes it.
//   g++ -std=c++20 mujoco_friction_has_directions.cpp -lmujoco && ./a.out

#include <mujoco/mujoco.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

int main() {
  for (const std::string cone : {"pyramidal", "elliptic"})
    for (const double degrees : {0., 45.}) {
      const std::string xml =
          "<mujoco><option cone='" + cone +
          "'/><worldbody><geom type='plane' size='9 9 1' friction='0.3'/>"
          "<body pos='0 0 0.1'><freejoint/><geom type='box' size='0.3 0.2 0.1' friction='0.3'/></body></worldbody></mujoco>";
      const auto files = std::make_unique<mjVFS>();
      mj_defaultVFS(files.get());
      mj_makeEmptyFileVFS(files.get(), "a", static_cast<int>(xml.size()));
      xml.copy(static_cast<char*>(files->filedata[0]), xml.size());
      mjModel* const m = mj_loadXML("a", files.get(), nullptr, 0);
      mjData* const d = mj_makeData(m);
      d->qvel[0] = 2 * std::cos(degrees * mjPI / 180), d->qvel[1] = 2 * std::sin(degrees * mjPI / 180);
      for (int i = 0; i < 1000; ++i) mj_step(m, d);
      std::printf("%-9s at %2.0f degrees: stops after %.3f m; by Coulomb after %.3f m\n", cone.c_str(),
                  degrees, std::hypot(d->qpos[0], d->qpos[1]), 2 * 2 / (2 * 0.3 * 9.81));
    }
}
