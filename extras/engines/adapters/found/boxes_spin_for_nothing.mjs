// Jolt 1.1, Rapier 0.21: all friction acts in the middle.
//
// A box that slides at 2 m/s and spins at 10 rad/s comes to rest as soon as one that only slides. It turns as
// far as one that only spins. All friction acts in the middle of the contact area, plus a moment. With
// friction at its four corners it would go more than half as far again.
//   node found/boxes_spin_for_nothing.mjs

const zero = [0, 0, 0];
const world = (speed, spin) => ({
  gravity: [0, 0, -9.81], floor: [0, 0, 1], friction: 0.3, restitution: 0, joints: [], springs: [],
  bodies: [{ mass: 1, inertia: [0.0135, 0.0301, 0.0433], shape: { kind: 'box', half: [0.3, 0.2, 0.02] },
    start: { position: [0, 0, 0.02], orientation: [1, 0, 0, 0], velocity: [speed, 0, 0],
      spin: [0, 0, spin] } }],
});

for (const [engine, variant] of [['jolt', 'nothing left out'], ['rapier', '16 substeps']]) {
  const { make } = await import(`../${engine}.mjs`);
  for (const [speed, spin] of [[2, 0], [2, 10], [0, 10]]) {
    const simulation = make(world(speed, spin), variant, 1 / 960);
    let turned = 0;
    for (let step = 0; step < 2 * 960; ++step) {
      simulation.step(1 / 960);
      turned += simulation.state(0).spin[2] / 960;
    }
    const { position } = simulation.state(0);
    console.log(`${engine}: from ${speed} m/s and ${spin} rad/s it goes ${position[0].toFixed(3)} m and ` +
      `turns by ${(turned * 180 / Math.PI).toFixed(0)} degrees`);
  }
}
