// Every conservative force of the package has a potential that matches it.
import { constantTorque, type Force, step } from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { lawForce } from '../../packages/physics/src/dynamics/define-law.ts';
import type { LawForce } from '../../packages/physics/src/dynamics/sum-of-laws.ts';
import { gradientOf } from '../../packages/physics/src/laws/differentiate.ts';
import { constant } from '../../packages/physics/src/laws/expression.ts';
import { structureOf } from '../../packages/physics/src/laws/structure.ts';
import { LAW_CASES, type LawWorld, lawWorld } from '../support/law-records.ts';
import { forceOn, slope } from '../support/laws.ts';

/** Positions of the first body, m: inside and outside of radius 1, in and out of the fluid. */
const MOVES = [
  { x: 0, y: 0, z: 0 },
  { x: -0.5, y: 0.4, z: 0.3 },
  { x: 0.9, y: -0.35, z: 0.5 },
];

/** Their energy is that of fuel, batteries or muscles, which a world does not model. */
const DRIVEN = ['thrust', 'rocketEngines'];

const axesOf = ({ world }: LawWorld) => (world.dimensions === 2 ? (['x', 'y'] as const) : (['x', 'y', 'z'] as const));

function moveBy({ world, subject }: LawWorld, by: { x: number; y: number; z: number }, sign: 1 | -1 = 1): void {
  for (const axis of ['x', 'y', 'z'] as const) {
    if (axis !== 'z' || world.dimensions === 3) world.components.Position[axis][subject] += sign * by[axis];
  }
}

/** Extrapolated from two steps: the error is of fourth order, 10⁻¹² of the energy, as is the rounding. */
function gradient({ world }: LawWorld, eid: number): Record<'x' | 'y' | 'z', number> {
  const [wide, narrow] = [2e-4, 1e-4].map((h) => slope(world, eid, h));
  const at = (axis: 'x' | 'y' | 'z') => (4 * narrow[axis] - wide[axis]) / 3;
  return { x: at('x'), y: at('y'), z: at('z') };
}

/** The same for the rotation of the body. */
function torqueOf({ world, force, subject }: LawWorld): number {
  const { angle } = world.components.Rotation;
  const at = (turn: number) => {
    angle[subject] += turn;
    const energy = force.potential?.(world) ?? Number.NaN;
    angle[subject] -= turn;
    return energy;
  };
  const along = (h: number) => (at(-h) - at(h)) / (2 * h);
  return (4 * along(1e-4) - along(2e-4)) / 3;
}

describe.each(LAW_CASES)('$name', ({ record, dimensions }) => {
  const built = () => lawWorld(record, dimensions, { still: true });

  if (built().force.potential !== undefined) {
    test('the force is minus the gradient of the potential', () => {
      const stage = built();
      const { world, force, subject, moving } = stage;
      for (const by of MOVES) {
        moveBy(stage, by);
        const size = 1 + Math.abs(force.potential?.(world) ?? Number.NaN);
        for (const eid of moving) {
          const pull = forceOn(world, eid);
          const fall = gradient(stage, eid);
          for (const axis of axesOf(stage)) expect(Math.abs(fall[axis] - pull[axis])).toBeLessThan(1e-9 * size);
        }
        if (force.appliesTorque === true) {
          expect(Math.abs(torqueOf(stage) - forceOn(world, subject).torque)).toBeLessThan(1e-9 * size);
        }
        moveBy(stage, by, -1);
      }
    });
    test('the force is the derivative of its expression', () => {
      const { law } = built().force;
      if (law?.potential === undefined) return;
      const derived = () => lawWorld(record, dimensions, { still: true, wrap: derivedLaw });
      for (const by of MOVES) {
        const [stated, found] = [built(), derived()];
        for (const stage of [stated, found]) moveBy(stage, by);
        for (const eid of stated.moving) {
          const [a, b] = [forceOn(stated.world, eid), forceOn(found.world, eid)];
          // The bound is tens of roundings of terms that may cancel.
          const within = 1e-12 * (1 + Math.hypot(a.x, a.y, a.z));
          expect(Math.hypot(a.x - b.x, a.y - b.y, a.z - b.z)).toBeLessThan(within);
        }
      }
    });
    return;
  }

  test('it has no potential, because the force is not conservative', () => {
    expect(DRIVEN.includes(record.maker) || needsNone(built(), () => built())).toBe(true);
  });
});

/** The law whose force is derived from the potential of the given law. */
function derivedLaw(force: Force): Force {
  const { law, sources, ...rest } = force as LawForce;
  const parts = { force: gradientOf(law.potential as NonNullable<typeof law.potential>, constant(-1)) };
  const { acceleration: _a, torque: _t, potential: _p, ...others } = law;
  return lawForce({ ...others, ...parts, structure: structureOf(law.parameters, parts) }, sources, rest);
}

/** Tests whether a law has no effect at rest, depends on velocity or time, or does work on a closed loop. */
function needsNone(stage: LawWorld, again: () => LawWorld): boolean {
  const { world, subject } = stage;
  const rests = MOVES.map((by) => {
    moveBy(stage, by);
    const { x, y, z } = forceOn(world, subject);
    moveBy(stage, by, -1);
    return Math.hypot(x, y, z);
  });
  if (rests.every((size) => size === 0)) return true;
  const here = forceOn(world, subject);
  const differs = (other: typeof here) => Math.hypot(other.x - here.x, other.y - here.y, other.z - here.z) > 1e-9;
  if (differs(forceOn(world, subject, 0.7))) return true;
  const moves = again();
  moves.world.components.Velocity.x[subject] = 0.6;
  if (differs(forceOn(moves.world, subject))) return true;
  const later = again();
  step(later.world, 1e-12);
  return differs(forceOn(later.world, subject)) || curl(again()) > 1e-6;
}

function curl(stage: LawWorld): number {
  const { world, subject } = stage;
  const h = 1e-5;
  const change = (force: 'x' | 'y' | 'z', along: 'x' | 'y' | 'z') => {
    const column = world.components.Position[along];
    const at = column[subject];
    column[subject] = at + h;
    const above = forceOn(world, subject)[force];
    column[subject] = at - h;
    const below = forceOn(world, subject)[force];
    column[subject] = at;
    return (above - below) / (2 * h);
  };
  if (world.dimensions === 2) return Math.abs(change('y', 'x') - change('x', 'y'));
  return Math.hypot(
    change('z', 'y') - change('y', 'z'),
    change('x', 'z') - change('z', 'x'),
    change('y', 'x') - change('x', 'y'),
  );
}

test('a constant torque has no potential: it would change with each revolution', () => {
  expect(constantTorque({ z: 1 }).potential).toBeUndefined();
});
