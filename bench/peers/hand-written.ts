// The loop that a user would write by hand without a framework: typed arrays, gravity, quadratic drag, a box. What
// differs from body to body in our world is a constant here, the wall clamps the position, the pose before the step is
// not kept, and nothing is checked. It is less work than ours; the motion looks the same and is not the same.
import type { Particles, SceneRun } from '@principia/scenes';
import type { Column } from './columns';
import { type Constants, handWrittenStep } from './hand-written-loops';
import { type ParticleColumns, particleColumns } from './particles-columns';
import type { Peer } from './peer';

export function handWritten(run: SceneRun): Peer {
  const columns = particleColumns(run as Particles);
  return {
    name: 'hand-written loop',
    step: handWrittenStep(run.world.precision, run.world.dimensions, columns, constantsOf(columns)),
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
