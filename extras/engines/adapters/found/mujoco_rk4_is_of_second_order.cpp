// MuJoCo 2.2: RK4 is of second order in space.
//
// "RK4" has order 2 where bodies turn in space (free and ball joints), and order 4 with hinges. It averages
// the stages' spins and turns the body once by the mean, as if rotations commuted.
//   g++ -std=c++20 mujoco_rk4_is_of_second_order.cpp -lmujoco && ./a.out

#include <mujoco/mujoco.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

int main() {
  const std::string xml =
      "<mujoco><option gravity='0 0 0' integrator='RK4'/><worldbody><body><freejoint/>"
      "<inertial pos='0 0 0' mass='1' diaginertia='1 2 3'/></body></worldbody></mujoco>";
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "a", static_cast<int>(xml.size()));
  xml.copy(static_cast<char*>(files->filedata[0]), xml.size());
  mjModel* const m = mj_loadXML("a", files.get(), nullptr, 0);
  double before = 0, change = 0;
  for (int steps = 60; steps <= 3840; steps *= 2) {  // in one second
    mjData* const d = mj_makeData(m);
    d->qvel[3] = 1, d->qvel[4] = 10, d->qvel[5] = 1;
    m->opt.timestep = 1.0 / steps;
    for (int i = 0; i < steps; ++i) mj_step(m, d);
    const double was = change;
    change = d->qpos[4] - before, before = d->qpos[4];
    if (steps > 120)
      std::printf("%5d Hz: changes by %.1e, order %.2f\n", steps, change, std::log2(was / change));
  }
}
