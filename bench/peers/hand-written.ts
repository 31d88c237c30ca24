// The loop that a user writes without a framework: typed arrays, gravity, quadratic drag, a box. Quantities that are
// columns in our world are constants here, walls clamp the position, the previous pose is not stored, and nothing is
// checked. It does less work than ours; the motion is similar but not equal.
import type { Particles, SceneRun } from '@principia/scenes';
import type { Column } from './columns.ts';
import { type Constants, handWrittenStep } from './hand-written-loops.ts';
import { type ParticleColumns, particleColumns } from './particles-columns.ts';
import type { Peer } from './peer.ts';
import { firstBodies, warmStep } from './warm-up.ts';

export async function handWritten(run: SceneRun): Promise<Peer> {
  const columns = firstBodies(particleColumns(run as Particles));
  const constants = constantsOf(columns);
  const { precision, dimensions } = run.world;
  return {
    name: 'hand-written loop',
    step: await warmStep(columns, (some) => handWrittenStep(precision, dimensions, some, constants)),
    positions: (axis) => columns[axis],
    differs: true,
  };
}

function constantsOf({ dt, gravity, side, wall, mass, drag, radius }: ParticleColumns): Constants {
  const r = mean(radius);
  return { dt, gravity, drag: mean(drag) / mean(mass), low: r, high: side - r, restitution: wall };
}

function mean(column: Column): number {
  let sum = 0;
  for (let i = 0; i < column.length; i++) sum += column[i];
  return sum / column.length;
}
