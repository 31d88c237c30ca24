// The same four systems in the usual style of bitECS: a query per system, and a loop over its entity ids with typed
// arrays indexed by id. Forces are summed in a column, because drag needs the velocity before gravity changed it.
import type { Particles, SceneRun } from '@principia/scenes';
import { addComponents, addEntity, createWorld } from 'bitecs';
import { type Column, particleColumns } from './particles-columns.ts';
import type { Peer } from './peer.ts';
import { systems2d } from './query-idiom-2d.ts';
import { systems3d } from './query-idiom-3d.ts';

export function queryIdiom(run: SceneRun): Peer {
  const state = makeState(run);
  const systems = run.world.dimensions === 2 ? systems2d(state) : systems3d(state);
  return {
    name: 'bitECS query idiom',
    step() {
      for (const system of systems) system();
    },
    positions: (axis) => state.Position[axis].subarray(1),
  };
}

export type QueryState = ReturnType<typeof makeState>;

function makeState(run: SceneRun) {
  const { count, dt, gravity, side, wall, ...from } = particleColumns(run as Particles);
  // Entity ids start at 1.
  const column = (values?: Column): Column => {
    const made = run.world.precision === 'f32' ? new Float32Array(count + 1) : new Float64Array(count + 1);
    if (values !== undefined) made.set(values, 1);
    return made;
  };
  const Position = { x: column(from.x), y: column(from.y), z: column(from.z) };
  const Velocity = { x: column(from.vx), y: column(from.vy), z: column(from.vz) };
  const Start = { x: column(), y: column(), z: column() };
  const Force = { x: column(), y: column(), z: column() };
  const Mass = column(from.mass);
  const Drag = column(from.drag);
  const Radius = column(from.radius);
  const world = createWorld();
  for (let i = 0; i < count; i++) {
    addComponents(world, addEntity(world), [Position, Velocity, Force, Mass, Drag, Radius]);
  }
  return { world, dt, gravity, side, wall, Position, Velocity, Start, Force, Mass, Drag, Radius };
}
