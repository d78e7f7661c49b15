// MuJoCo 2.2: a box that slides and spins rests on changing corners.
//
// A sliding box hops (mujoco_sliding_hops.mjs), and most of the time touches with fewer than its four
// corners, however short the step. A straight slide or a spin alone still follows Coulomb's law, since only
// the sum of the corners' loads matters there. A slide with spin does not: it is chance which corner carries
// the load.
//   g++ -std=c++20 mujoco_hops_share_the_load.cpp -lmujoco && ./a.out

#include <mujoco/mujoco.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

void slide(double speed, double spin, double step) {
  const std::string xml =
      "<mujoco><option cone='elliptic' impratio='10' tolerance='1e-12'/><default><geom friction='0.3'/></default>"
      "<worldbody><geom type='plane' size='9 9 1'/><body pos='0 0 0.02'><freejoint/>"
      "<geom type='box' size='0.3 0.2 0.02' mass='1'/></body></worldbody></mujoco>";
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "a", static_cast<int>(xml.size()));
  xml.copy(static_cast<char*>(files->filedata[0]), xml.size());
  mjModel* const m = mj_loadXML("a", files.get(), nullptr, 0);
  mjData* const d = mj_makeData(m);
  m->opt.timestep = step;
  d->qvel[0] = speed, d->qvel[1] = speed / 4, d->qvel[5] = spin;
  int all_four = 0, moving = 0;
  while (std::hypot(d->qvel[0], d->qvel[1], d->qvel[5]) > 0.01 && d->time < 2) {
    mj_step(m, d);
    ++moving;
    all_four += d->ncon == 4;
  }
  std::printf(
      "%g m/s, %2g rad/s, steps of %g ms: ends after %.3f m, %.3f m, %.3f rad; on four corners in %.1f %%\n",
      speed, spin, 1000 * step, d->qpos[0], d->qpos[1], 2 * std::atan2(d->qpos[6], d->qpos[3]),
      100. * all_four / moving);
}

int main() {
  for (const double step : {1e-3, 1e-4, 2e-5}) slide(2, 0, step), slide(0, 10, step), slide(2, 10, step);
  std::puts("Coulomb at four corners: 0.701 m, 0.175 m; 2.042 rad; together 1.067 m, 0.263 m, 3.072 rad");
}
