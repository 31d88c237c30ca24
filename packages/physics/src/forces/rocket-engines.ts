// Rocket engines: thrust from expelled mass, which reduces fuel and Mass.
//
//   F = v_e μ n,   dm/dt = -μ        Δv = v_e ln(m₀/m₁)  (Tsiolkovsky 1903)
//
//   v_e  exhaust speed, m/s    μ = burnRate × throttle, kg/s    n  direction of the thrust    m  mass, kg
//
// All quantities are in the component Engine. At the start of a step fuel and Mass decrease by the burnt mass; an
// engine whose fuel ends within the step burns the rest. The thrust is the constant force that gives the remaining
// mass v_e ln(m₀/m₁) in that step, so Δv is exact with every dt and every integrator
// but positionVerlet, which leaves out half of the first step. In `f32` it is exact but for the rounding of the velocity in each step: weak
// engines that burn for long take `f64`, because an ion engine that adds 30 µm/s a step at 32 m/s gains 1 % too much in 5 h at 60 Hz. Gravity is independent of the
// time of the mass loss within the step; a force not proportional to mass, such as drag, acts on the mass at the end
// of the step. Valid for exhaust far slower than light. A body that is fuel only would reach an infinite speed: it keeps a
// millionth of the mass that it has at the start of its last step. So there Δv depends on dt: 14 v_e where one step burns
// all, and 20 v_e where it burns for 8 s in steps of 1/60 s. Inertia stays what it is: where it matters that fuel is gone from
// it, write that column. Cost: one logarithm per firing engine and step, and the rotation of a vector per body.
import { Engine } from '../components/propulsion.ts';
import { defineLaw } from '../dynamics/define-law.ts';
import { checkKeys } from '../errors/validate.ts';
import { vec3 } from '../laws/expression.ts';
import { ENGINE_COLUMNS_BYTES, EngineColumnsWord as Word } from '../memory/layouts.gen.ts';
import { allocateRecord } from '../memory/record.ts';
import { namedResource } from '../memory/resource.ts';
import type { Force, PhysicsWorld } from '../world/types.ts';
import { forceKernels } from './support/force-kernels.ts';
import { checkFrame } from './support/frame.ts';

/** Options of `rocketEngines`. */
export interface RocketOptions {
  /** Whether engines push along axes of the world or, by default, of the body. */
  readonly frame?: 'world' | 'body';
}

const about = {
  name: 'rocket engines',
  formula: 'F = v_e μ n, dm/dt = -μ',
  source: 'Tsiolkovsky (1903).',
  reads: { engine: Engine },
  consumes: ['Mass', 'Engine'] as const,
  prepare: burn,
};

const ofWorld = /* @__PURE__ */ defineLaw({
  ...about,
  force: ({ engine: { thrustX, thrustY, thrustZ } }) => vec3(thrustX, thrustY, thrustZ),
});

const ofBody = /* @__PURE__ */ defineLaw({
  ...about,
  force: ({ engine: { thrustX, thrustY, thrustZ }, rotate }) => rotate(vec3(thrustX, thrustY, thrustZ)),
});

/**
 * Rocket engines: thrust F = v_e μ n, N, from mass that they expel, dm/dt = -μ, kg/s, by the component `engine`. Δv is
 * that of Tsiolkovsky.
 * @throws PhysicsError E_TYPE, E_RANGE, E_UNKNOWN
 */
export function rocketEngines(options: RocketOptions = {}): Force {
  checkKeys(options, 'rocketEngines', ['frame']);
  const frame = checkFrame(options.frame ?? 'body', 'rocketEngines.frame');
  return frame === 'body' ? ofBody() : ofWorld();
}

/** Burns the fuel of a step, and writes its thrust to the columns that the law reads. */
function burn(world: PhysicsWorld, dt: number): void {
  if (world.internal.counts.Engine === 0) return;
  forceKernels(world).burnFuel(engineColumns(world), dt, 0, world.lastId + 1);
}

const engineColumns = namedResource('engine columns', (world) => {
  const { at, words } = allocateRecord(world.internal.arena, ENGINE_COLUMNS_BYTES, 'rocket engines');
  const { fuel, fuelRemainder, massRemainder, burnRate, throttle, exhaustSpeed } = world.addresses.Engine;
  const { x, y, z, thrustX, thrustY, thrustZ } = world.addresses.Engine;
  words.set([fuel, fuelRemainder, massRemainder, burnRate, throttle, exhaustSpeed], Word.fuel);
  words.set([x, y, z, thrustX, thrustY, thrustZ], Word.x);
  return at;
});
