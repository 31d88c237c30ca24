// Loops of joints that are closed exactly: structures that stand, and linkages that move.
import {
  box,
  createJoint,
  destroyWorld,
  distance,
  energy,
  jointForce,
  type PhysicsWorld,
  revolute,
  softStep,
  spawn,
  step,
  wheel,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { addBar, DT, G, type Point, rigidWorld, run } from '../../../../test/support/rigid-world.ts';

/** A truss of equilateral triangles on a hinge and a roller, with a load at the middle of its lower edge. */
function addTruss(world: PhysicsWorld, bays: number, barMass: number, load: number) {
  const nodes: Point[] = [];
  for (let i = 0; i <= bays; i++) nodes.push([i, 0]);
  for (let i = 0; i < bays; i++) nodes.push([i + 0.5, Math.sqrt(0.75)]);
  const held = nodes.map((): number[] => []);
  const hinges = new Map<string, number>();
  const join = (from: number, to: number) => {
    const bar = addBar(world, nodes[from], nodes[to], barMass);
    for (const k of [from, to]) {
      const anchor = { x: nodes[k][0], y: nodes[k][1] };
      if (held[k].length > 0)
        hinges.set(`${from}-${to} at ${k}`, createJoint(world, revolute({ a: held[k][0], b: bar, anchor })));
      held[k].push(bar);
    }
  };
  for (let i = 0; i < bays; i++) {
    join(i, bays + 1 + i);
    join(bays + 1 + i, i + 1);
    if (i > 0) join(bays + i, bays + 1 + i);
    join(i, i + 1);
  }
  createJoint(world, revolute({ b: held[0][0], anchor: { x: 0, y: 0 } }));
  createJoint(world, wheel({ b: held[bays][0], anchor: { x: bays, y: 0 }, axis: { x: 1, y: 0 } }));
  const middle = bays / 2;
  const collider = { shape: box(1, 1), density: load, mask: 0 };
  const weight = spawn(world, { position: { x: middle, y: -1 }, rotation: 0, collider });
  createJoint(world, revolute({ a: held[middle][0], b: weight, anchor: { x: middle, y: 0 } }));
  return { weight, hinges };
}

describe.each(['f32', 'f64'] as const)('mechanisms in %s', (precision) => {
  test.each([4, 8, 14])('the bars of a truss of %i bays bear what the method of sections says', (bays) => {
    const world = rigidWorld({ precision, integrator: softStep({ sleepTime: 0 }) });
    const load = 100;
    const { weight, hinges } = addTruss(world, bays, 0.1, load);
    run(world, 3);
    const { y } = world.components.Position;
    // Half of the load on each support: what its moment about a node is, the opposite chord bears at the height of a triangle.
    const middle = bays / 2;
    const height = Math.sqrt(0.75);
    const weightOfBars = 0.1 * G * (4 * bays - 1);
    const chord = (at: number) => (load * G * at) / 2 / height;
    const within = (force: number, at: number) => {
      expect(Math.abs(force / chord(at) - 1)).toBeLessThan(weightOfBars / (load * G) + 1e-3);
    };
    within(jointForce(world, hinges.get(`${middle - 1}-${middle} at ${middle}`) as number), middle - 0.5);
    within(
      jointForce(world, hinges.get(`${bays + middle}-${bays + middle + 1} at ${bays + middle}`) as number),
      middle,
    );
    // A truss is a rigid body.
    expect(Math.abs(y[weight] + 1)).toBeLessThan(0.005);
    destroyWorld(world);
  });

  test.each([1, 10, 100, 1000])('a free ring of six bars of 1 : %i keeps its energy', (ratio) => {
    const world = rigidWorld({ precision, forces: [], integrator: softStep({ sleepTime: 0 }) });
    const corner = (i: number): Point => [Math.cos((i * Math.PI) / 3), 0.9 * Math.sin((i * Math.PI) / 3)];
    const bars = [0, 1, 2, 3, 4, 5].map((i) =>
      addBar(world, corner(i), corner(i + 1), i % 2 === 0 ? ratio : 1, { velocity: { x: (i % 3) - 1, y: i % 2 } }),
    );
    for (let i = 0; i < 6; i++) {
      const [x, y] = corner(i + 1);
      createJoint(world, revolute({ a: bars[i], b: bars[(i + 1) % 6], anchor: { x, y } }));
    }
    // The first step takes out what the joints forbid.
    step(world, DT);
    const start = energy(world).total;
    run(world, 30);
    // A symplectic step of the length h errs by (h ω)², and bars turn by 6 rad/s here; where they stretch to a line, the rounding of
    // f32 costs some energy.
    expect(energy(world).total / start - 1).toBeLessThan(6e-4);
    expect(energy(world).total / start - 1).toBeGreaterThan(precision === 'f64' ? -6e-4 : -0.02);
    destroyWorld(world);
  });

  test.each([1, 0.1, 0.01])('a triangle of rods bears 100 kg at nodes of %f kg', (mass) => {
    const world = rigidWorld({ precision });
    const node = (x: number, y: number, mass: number) =>
      spawn(world, { position: { x, y }, rotation: 0, mass, collider: { radius: 0.1, mask: 0 } });
    const [a, b, c] = [node(0, 0, mass), node(1, 0, mass), node(0.5, -0.8, 100)];
    for (const [p, q] of [
      [a, b],
      [b, c],
      [c, a],
    ])
      createJoint(world, distance({ a: p, b: q }));
    createJoint(world, distance({ b: a, anchorA: { x: 0, y: 1 } }));
    createJoint(world, distance({ b, anchorA: { x: 1, y: 1 } }));
    run(world, 10);
    // Joints to what does not move give way by 1e-4 of what a node does in a sub-step, h F/m, and close by 77 of it a second.
    const most = 0.001 + (1e-4 * 100 * G) / (mass * 240) / 77;
    expect(Math.abs(world.components.Position.y[c] + 0.8)).toBeLessThan(most);
    destroyWorld(world);
  });

  test("Peaucellier's linkage draws a straight line", () => {
    const world = rigidWorld({ precision });
    const [long, short, crank] = [2, 0.8, 0.7];
    // The crank turns about (crank, 0), so that its pin C is on a circle through the origin O. A and B are `long` from O and `short`
    // from C and from D: D is the inverse of C, |OC| |OD| = long² - short², and so on a straight line.
    const c: Point = [2 * crank, 0];
    const d: Point = [(long * long - short * short) / (2 * crank), 0];
    const middle = (c[0] + d[0]) / 2;
    const up = Math.sqrt(short * short - ((d[0] - c[0]) / 2) ** 2);
    const [a, b]: Point[] = [
      [middle, up],
      [middle, -up],
    ];
    const o: Point = [0, 0];
    const p: Point = [crank, 0];
    const [oa, ob, pc, ac, bc, ad, bd] = [
      [o, a],
      [o, b],
      [p, c],
      [a, c],
      [b, c],
      [a, d],
      [b, d],
    ].map(([from, to]) => addBar(world, from, to, 1));
    const hinge = (a: number, b: number, [x, y]: Point) => createJoint(world, revolute({ a, b, anchor: { x, y } }));
    for (const bar of [oa, ob]) createJoint(world, revolute({ b: bar, anchor: { x: 0, y: 0 } }));
    const motor = createJoint(world, revolute({ b: pc, anchor: { x: crank, y: 0 }, motor: { speed: 0.5, max: 1000 } }));
    for (const bar of [ac, bc]) hinge(pc, bar, c);
    for (const bar of [ac, ad]) hinge(oa, bar, a);
    for (const bar of [bc, bd]) hinge(ob, bar, b);
    hinge(ad, bd, d);
    const { Position, Rotation, Joint } = world.components;
    let [most, highest] = [0, 0];
    for (let i = 0; i < 600; i++) {
      // Up and down.
      const angle = Rotation.angle[pc];
      if (Math.abs(angle) > 0.8) Joint.motorSpeed[motor] = -Math.sign(angle) * 0.5;
      step(world, DT);
      // D is where the bar from A ends.
      const turn = Rotation.angle[ad];
      most = Math.max(most, Math.abs(Position.x[ad] + (short / 2) * Math.cos(turn) - d[0]));
      highest = Math.max(highest, Position.y[ad] + (short / 2) * Math.sin(turn));
    }
    expect(highest).toBeGreaterThan(1);
    expect(most).toBeLessThan(1e-3);
    destroyWorld(world);
  });
});
