// MuJoCo 2.2: a motion that diverges starts again.
//
// Where a motion diverges, mj_step resets the world to its start and goes on from there at time zero. The
// only signs are a line in MUJOCO_LOG.TXT and d->warning. Here a spring is too stiff for the step.
//   g++ -std=c++20 mujoco_starts_again.cpp -lmujoco && ./a.out

#include <mujoco/mujoco.h>

#include <cstdio>
#include <memory>
#include <string>

int main() {
  const std::string xml =
      "<mujoco><option timestep='0.01'/><worldbody><body><joint type='slide' stiffness='50000' springref='0.1'/>"
      "<inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/></body></worldbody></mujoco>";
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "a", static_cast<int>(xml.size()));
  xml.copy(static_cast<char*>(files->filedata[0]), xml.size());
  mjModel* const m = mj_loadXML("a", files.get(), nullptr, 0);
  mjData* const d = mj_makeData(m);
  for (int i = 1; i <= 60; ++i) {
    mj_step(m, d);
    if (i % 3 == 0) std::printf("step %2d: time %.2f s, at %.3g m\n", i, d->time, d->qpos[0]);
  }
}
