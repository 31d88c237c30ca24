/** Energy errors of the integrators over a thousand orbits of a planet, for the picture in docs/integrators.md. */

const ECCENTRICITY = 0.3;
const ORBITS = 1000;
/** All schemes do the same work: as many force evaluations an orbit. Those that choose their steps take what they want. */
const EVALUATIONS = 400;
/** Points of a line, evenly on a logarithmic axis. */
const POINTS = 46;

/** Left out: what is the same as another scheme in this problem, or follows it exactly. */
const LEFT_OUT = ['boris', 'wisdomHolman', 'leapfrog', 'midpoint', 'positionFirstEuler', 'positionVerlet'];

/**
 * @typedef {{ name: string, order: number, symplectic: boolean, points: [orbits: number, error: number][] }} Line
 * @param {any} physics the package
 * @returns {Line[]}
 */
export function energyErrors(physics) {
  return Object.entries(physics.INTEGRATORS)
    .filter(([key]) => !LEFT_OUT.includes(key))
    .map(([, record]) => {
      const { name, order, symplectic } = record;
      process.stderr.write(`${name}\n`);
      return { name, order, symplectic, points: measure(physics, record) };
    });
}

/**
 * Largest relative energy error up to each point.
 * @param {any} physics
 * @param {any} record
 * @returns {[number, number][]}
 */
function measure({ createPhysicsWorld, spawn, attractors, energy, step }, record) {
  const world = createPhysicsWorld({ capacity: 10, integrator: record.create(), forces: [attractors()] });
  spawn(world, { position: {}, attractor: 1 });
  const velocity = { y: Math.sqrt((1 + ECCENTRICITY) / (1 - ECCENTRICITY)) };
  spawn(world, { position: { x: 1 - ECCENTRICITY }, velocity, mass: 1 });
  const start = energy(world).total;
  const perStep = Number.parseInt(record.evaluations, 10);
  const steps = Math.round(EVALUATIONS / perStep);
  const marks = Array.from({ length: POINTS }, (_, i) => ORBITS ** (i / (POINTS - 1)));
  /** @type {[number, number][]} */
  const points = [];
  let worst = 0;
  let done = 0;
  for (const mark of marks) {
    for (; done < Math.round(mark * steps); done++) {
      step(world, (2 * Math.PI) / steps);
      worst = Math.max(worst, Math.abs(energy(world).total / start - 1));
    }
    points.push([mark, worst]);
  }
  return points;
}
