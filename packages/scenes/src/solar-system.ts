// The solar system as it was at noon of 1 January 2000, from JPL's ephemeris: Sun, planets, Moon and Pluto attract each
// other, and asteroids that weigh next to nothing circle between Mars and Jupiter. Kilometres, seconds, and GM (km³/s²)
// for masses, so that G = 1. After 50 years the planets are within 20 km of the ephemeris, the Moon within 800 km.
import { cos, createRandom, gaussRadau, leapfrog, sin, spawnMany } from '@principia/physics';
import { countOf, defineScene, type SceneRun } from './scene.ts';
import { buildSolarSystem, type SolarSystem } from './solar-system/build.ts';
import { againstGaussRadau, DAY, errorsOf } from './solar-system/errors.ts';
import { ASTRONOMICAL_UNIT, STATES } from './solar-system/states.ts';

/** The run of a solar system, with the ids of its bodies. */
export type SolarSystemRun = SceneRun & SolarSystem;

/** GM of an asteroid, km³/s²: a few kilometres of rock. */
const ASTEROID = 1e-6;

/** Sun, planets, Moon and Pluto from JPL’s states of 2000, and asteroids. */
export const solarSystem = defineScene({
  name: 'solar-system',
  description: 'Sun, planets, Moon and Pluto from JPL’s states of 2000, and asteroids',
  precision: 'f64',
  parameters: {
    count: countOf('bodies in all, those beyond Sun, planets, Moon and Pluto asteroids', 11, 511, 11),
    moon: { about: '1 for Earth and Moon, 0 for one body in their place', unit: '', initial: 1, min: 0, max: 1 },
    relativity: { about: '1 for the post-Newtonian term of the Sun', unit: '', initial: 1, min: 0, max: 1 },
  },
  build({ dimensions, precision, seed, integrator, progress, parameters }): SolarSystemRun {
    const { moon, relativity } = parameters;
    const others = parameters.count - (moon > 0 ? 11 : 10);
    // The fifteenth order is below the rounding of f32.
    const scheme = integrator ?? (precision === 'f64' ? gaussRadau() : leapfrog);
    const system = buildSolarSystem({
      dimensions,
      precision,
      seed,
      others,
      moon: moon > 0,
      relativity: relativity > 0,
      integrator: scheme,
    });
    if (others > 0) spawnMany(system.world, others, asteroids(others, seed), progress);
    const run = { ...system, dt: DAY, errorKm: () => errorsOf(scheme) };
    return scheme.name === gaussRadau().name ? run : { ...run, reference: () => againstGaussRadau(scheme) };
  },
});

/** Circular orbits in the ecliptic, 2.1 to 3.3 astronomical units from the Sun. */
function asteroids(count: number, seed: number) {
  const random = createRandom(seed, 2);
  const axis = () => new Float64Array(count);
  const position = { x: axis(), y: axis() };
  const velocity = { x: axis(), y: axis() };
  for (let i = 0; i < count; i++) {
    const radius = random.uniform(2.1, 3.3) * ASTRONOMICAL_UNIT;
    const angle = random.uniform(0, 2 * Math.PI);
    const speed = Math.sqrt(STATES.sun.gm / radius);
    const [along, across] = [cos(angle), sin(angle)];
    position.x[i] = radius * along;
    position.y[i] = radius * across;
    velocity.x[i] = -speed * across;
    velocity.y[i] = speed * along;
  }
  return { position, velocity, mass: ASTEROID };
}
