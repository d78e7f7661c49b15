// MuJoCo 2.2: positions are a step late.
//
// After mj_step, xpos is where the bodies were before the step; qpos is where they are. mj_kinematics
// brings xpos up to date.
//   g++ -std=c++20 mujoco_positions_a_step_late.cpp -lmujoco && ./a.out

#include <mujoco/mujoco.h>

#include <cstdio>
#include <memory>
#include <string>

int main() {
  const std::string xml =
      "<mujoco><option gravity='0 0 0' timestep='0.01'/><worldbody><body><freejoint/>"
      "<geom size='1'/></body></worldbody></mujoco>";
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "a", static_cast<int>(xml.size()));
  xml.copy(static_cast<char*>(files->filedata[0]), xml.size());
  mjModel* const m = mj_loadXML("a", files.get(), nullptr, 0);
  mjData* const d = mj_makeData(m);
  d->qvel[0] = 1;
  mj_step(m, d);
  std::printf("after a step of 0.01 s at 1 m/s: qpos %g m, xpos %g m\n", d->qpos[0], d->xpos[3]);
  mj_kinematics(m, d);
  std::printf("after mj_kinematics: xpos %g m\n", d->xpos[3]);
}
