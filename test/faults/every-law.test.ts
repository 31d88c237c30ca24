// Cases 16 to 22 for every law of the package: an invalid state or parameter affects only its own body.
import {
  COMPONENTS,
  type ComponentName,
  createPhysicsWorld,
  despawn,
  type Force,
  MAX_SPEED,
  PhysicsError,
  spawn,
  step,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { LAW_CASES, LAW_RECORDS, type LawRecord, type LawWorld, lawWorld, makeLaw } from '../support/law-records.ts';
import { bodyState, refusal } from '../support/worlds.ts';

/** The kinds of world: single precision in 3D, double precision in 2D. */
const precisionOf = (dimensions: 2 | 3) => (dimensions === 2 ? 'f64' : 'f32');

function expectFinite({ world, moving }: LawWorld): void {
  const { Position, Velocity } = world.components;
  for (const eid of moving) {
    for (const axis of world.dimensions === 2 ? (['x', 'y'] as const) : (['x', 'y', 'z'] as const)) {
      expect(Number.isFinite(Position[axis][eid])).toBe(true);
      expect(Math.abs(Velocity[axis][eid])).toBeLessThanOrEqual(MAX_SPEED);
    }
  }
}

/** Runs ten steps; a law that reports by an exception may throw. */
function runOn({ world }: LawWorld): void {
  for (let i = 0; i < 10; i++) {
    try {
      step(world, 1 / 60);
    } catch (error) {
      const causes = error instanceof AggregateError ? error.errors : [error];
      for (const cause of causes) expect(cause).toBeInstanceOf(PhysicsError);
      return;
    }
  }
}

/** Returns the real columns of the components that a law reads, as far as this world uses them. */
function columnsOf({ world, force }: LawWorld): Float64Array[] {
  return force.reads.flatMap((component) => {
    const columns = world.components[component as ComponentName] as unknown as Record<string, Float64Array>;
    return Object.entries(COMPONENTS[component as ComponentName].fields).flatMap(([field, spec]) =>
      spec.kind === 'real' && !(spec.spatial === true && world.dimensions === 2) ? [columns[field]] : [],
    );
  });
}

describe.each(LAW_CASES)('$name', ({ record, dimensions }) => {
  const precision = precisionOf(dimensions);
  const build = () => lawWorld(record, dimensions, { precision });

  it('16, 17 NaN, infinity and the largest number in a column that it reads affect only their body', () => {
    const count = columnsOf(build()).length;
    for (let i = 0; i < count; i++) {
      for (const bad of [Number.NaN, Infinity, precision === 'f64' ? 1e308 : 1e38, -1e30]) {
        const stage = build();
        const { world, force, subject, moving } = stage;
        columnsOf(stage)[i][subject] = bad;
        runOn(stage);
        expectFinite(stage);
        if (!force.local || record.maker === 'postNewtonian') continue;
        const control = build();
        runOn(control);
        // A local law reads only its own body.
        for (const eid of moving)
          if (eid !== subject) expect(bodyState(world, eid)).toBe(bodyState(control.world, eid));
      }
    }
  });

  it('16 NaN and infinity in a source of the field reach no other body', () => {
    const counts = Object.entries({ Mass: 'value', Charge: 'value', Attractor: 'mu', Velocity: 'x' } as const);
    for (const [component, field] of counts) {
      for (const bad of [Number.NaN, Infinity]) {
        const stage = build();
        const { world, moving } = stage;
        (world.components as unknown as Record<string, Record<string, Float64Array>>)[component][field][1] = bad;
        runOn(stage);
        expectFinite(stage);
        const ill = world.faults.faults.filter(
          ({ code, entity }) => code === 'E_NONFINITE' && moving.includes(entity ?? 0),
        );
        expect(ill, `${component}.${field} = ${bad}`).toEqual([]);
      }
    }
  });

  it('18, 19 at r = 0 and for coincident bodies: finite, reproducible, and equal for equal bodies', () => {
    const play = () => {
      const stage = build();
      const { Position, Velocity } = stage.world.components;
      for (const eid of stage.moving) {
        for (const axis of ['x', 'y', 'z'] as const) {
          Position[axis][eid] = 0;
          Velocity[axis][eid] = 0;
        }
      }
      runOn(stage);
      expectFinite(stage);
      expect(stage.world.faults.faults.filter(({ code }) => code === 'E_NONFINITE')).toEqual([]);
      return stage.moving.map((eid) => bodyState(stage.world, eid));
    };
    expect(play()).toEqual(play());
  });

  it('does not move a body without mass, in its centre or beside it', () => {
    const stage = build();
    const { world } = stage;
    const { maker } = record;
    const massless = [0, 1.5].map((x) => spawn(world, { position: { x }, velocity: {}, charge: 1 }));
    runOn(stage);
    const { Position, Velocity } = world.components;
    for (const [i, eid] of massless.entries()) {
      expect([Position.x[eid], Position.y[eid], Velocity.x[eid], Velocity.y[eid]], maker).toEqual([1.5 * i, 0, 0, 0]);
    }
    expectFinite(stage);
  });

  it('continues if the bodies that it acts on are removed', () => {
    const stage = build();
    const { world, subject } = stage;
    step(world, 1 / 60);
    despawn(world, subject);
    runOn({ ...stage, moving: stage.moving.slice(1) });
    expectFinite({ ...stage, moving: stage.moving.slice(1) });
  });

  it('22 with any parameter at 10¹⁵ the state stays finite, or an error is thrown', () => {
    for (const [at, options] of record.args.entries()) {
      if (typeof options !== 'object' || options === null) continue;
      for (const [key, value] of Object.entries(options)) {
        if (typeof value !== 'number' || key === 'central') continue;
        const args = record.args.map((arg, i) =>
          i === at ? { ...options, [key]: Math.sign(value || 1) * 1e15 } : arg,
        );
        const made = attempt(() => makeLaw(record, args));
        if (made instanceof PhysicsError) continue;
        const stage = lawWorld({ ...record, args }, dimensions, { precision });
        runOn(stage);
        expectFinite(stage);
      }
    }
  });
});

function attempt(make: () => Force): Force | PhysicsError {
  try {
    return make();
  } catch (error) {
    expect(error).toBeInstanceOf(PhysicsError);
    return error as PhysicsError;
  }
}

/** The first record of each function that takes arguments. */
const MAKERS = LAW_RECORDS.filter((record, i) => LAW_RECORDS.findIndex(({ maker }) => maker === record.maker) === i);

/** Returns the valid options of a function, from the hint of its error for an unknown option. */
function keysOf(record: LawRecord, at: number): string[] {
  const given = record.args[at];
  const args = record.args.map((arg, i) => (i === at ? { ...(given as object), colour: 1 } : arg));
  const { code, hint } = refusal(() => makeLaw(record, args));
  expect(code).toBe('E_UNKNOWN');
  return (hint ?? '').replace(/^Valid: |\.$/g, '').split(', ');
}

describe('arguments of laws', () => {
  it.each(MAKERS.filter(({ args }) => args.length > 0))('20, 21 $title refuses NaN in each argument', (record) => {
    for (const [at, given] of record.args.entries()) {
      const refused = (value: unknown) => {
        const args = record.args.map((arg, i) => (i === at ? value : arg));
        return refusal(() => makeLaw(record, args));
      };
      expect(refused(Number.NaN).message).toMatch(/must|needs/);
      expect(refused('strong').code).toMatch(/E_TYPE|E_RANGE/);
      if (typeof given !== 'object') continue;
      for (const key of keysOf(record, at)) {
        const { code, message } = refused({ ...(given as object), [key]: Number.NaN });
        expect(code, key).toMatch(/E_NONFINITE|E_TYPE|E_RANGE/);
        expect(message).toContain(key);
      }
    }
  });

  it('a refused law neither creates nor changes a world', () => {
    const { world, force } = lawWorld(LAW_RECORDS[0], 2);
    expect(() => world.forces.splice(0, 1, makeLaw(LAW_RECORDS[0], [{ y: Number.NaN }]))).toThrow(PhysicsError);
    expect(world.forces).toEqual([force]);
    expect(() => createPhysicsWorld({ forces: [makeLaw(LAW_RECORDS[0], [{ y: '9' }])] })).toThrow(PhysicsError);
  });
});
