// Cases 18, 19 and 22 for every law: a body in the centre of a field, bodies at one place, springs without length or far
// too stiff, bodies without mass. All must stay finite, spread to nobody, and be told of where they are wrong.
import {
  attractors,
  corneringGrip,
  createPhysicsWorld,
  enclosedMassGravity,
  type Force,
  fixedCharges,
  lennardJones,
  mutualCoulomb,
  mutualGravity,
  paczynskiWiita,
  powerLaw,
  spawn,
  springs,
  step,
  stringTension,
  uniformSphereGravity,
  vortex,
  yukawa,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { forceOn } from '../support/laws.ts';

const LAWS: [string, () => Force][] = [
  ['attractors', () => attractors()],
  ['corneringGrip', () => corneringGrip({ friction: 1 })],
  ['enclosedMassGravity', () => enclosedMassGravity({ radii: [0.5, 1], masses: [0.5, 1], gravitationalConstant: 1 })],
  ['fixedCharges', () => fixedCharges(1)],
  ['lennardJones', () => lennardJones({ depth: 1, diameter: 1 })],
  ['mutualCoulomb, direct', () => mutualCoulomb({ k: 1, method: 'direct' })],
  ['mutualCoulomb, tree', () => mutualCoulomb({ k: 1, method: 'tree' })],
  ['mutualGravity, direct', () => mutualGravity({ G: 1, method: 'direct' })],
  ['mutualGravity, tree', () => mutualGravity({ G: 1, method: 'tree' })],
  ['mutualGravity, 1/r', () => mutualGravity({ G: 1, law: 'inverse-distance' })],
  ['paczynskiWiita', () => paczynskiWiita({ mu: 1, horizon: 0.1 })],
  ...[-7, -2, -1, 0, 1, 3].map((exponent): [string, () => Force] => [
    `powerLaw of ${exponent}`,
    () => powerLaw({ strength: 1, exponent }),
  ]),
  ['stringTension', () => stringTension({ length: 1 })],
  ['uniformSphereGravity', () => uniformSphereGravity({ mu: 1, radius: 1 })],
  ['vortex', () => vortex({ strength: 1, radius: 1 })],
  ['yukawa', () => yukawa({ strength: 1, range: 1 })],
];

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  describe.each(LAWS)('%s', (_, law) => {
    it('18, 19 is finite in its centre and for coincident bodies, and does not move bodies without mass', () => {
      const world = createPhysicsWorld({ precision, capacity: 20, forces: [law()] });
      spawn(world, { position: {}, attractor: 1, charge: 1 });
      const body = { velocity: {}, mass: 1, charge: 1 };
      const inside = [0, 1, 2].map(() => spawn(world, { position: {}, ...body }));
      const outside = spawn(world, { position: { x: 3 }, ...body });
      const massless = spawn(world, { position: {}, velocity: {} });
      for (const eid of [...inside, outside]) {
        const { x, y } = forceOn(world, eid);
        expect(Number.isFinite(x) && Number.isFinite(y)).toBe(true);
      }
      for (let s = 0; s < 20; s++) step(world, 1 / 60);
      const { Position, Velocity } = world.components;
      for (const eid of [...inside, outside, massless]) {
        for (const column of [Position.x, Position.y, Velocity.x, Velocity.y]) {
          expect(Number.isFinite(column[eid])).toBe(true);
        }
      }
      expect([Position.x[massless], Velocity.x[massless]]).toEqual([0, 0]);
      // Bodies that differ only in their id move alike, in any direction.
      expect(new Set(inside.map((eid) => Position.x[eid])).size).toBe(1);
      // The state was finite in every step.
      expect(world.faults.faults.filter(({ code }) => code === 'E_NONFINITE')).toEqual([]);
    });
  });

  it('22 springs without length between coincident bodies exert no force, and too stiff ones are reported', () => {
    const world = createPhysicsWorld({ precision, capacity: 20, forces: [springs()] });
    const [a, b] = [0, 1].map(() => spawn(world, { position: { x: 1 }, velocity: {}, mass: 1 }));
    const spring = spawn(world, { spring: { a, b, length: 0, stiffness: 10 } });
    for (let s = 0; s < 20; s++) step(world, 1 / 60);
    expect([world.components.Position.x[a], world.components.Position.x[b]]).toEqual([1, 1]);
    expect(world.faults.faults).toEqual([]);
    world.components.Spring.stiffness[spring] = 1e15;
    world.components.Spring.length[spring] = 1;
    const codes = () => world.faults.faults.map(({ code }) => code);
    let thrown = '';
    try {
      for (let s = 0; s < 20; s++) step(world, 1 / 60);
    } catch (error) {
      thrown = (error as Error).message;
    }
    expect(`${thrown} ${codes().join(' ')}`).toMatch(/E_STIFF/);
    expect(Number.isFinite(world.components.Position.x[a])).toBe(true);
  });
});
