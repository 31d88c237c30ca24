/** Energy errors of the integrators over a thousand orbits, for the picture in docs/integrators.md. */
import { PANELS } from './energy-panels.mjs';

const ORBITS = 1000;
/** All schemes do the same work: as many force evaluations an orbit. Those that choose their steps take what they want. */
const EVALUATIONS = 400;
/** Points of a line, evenly on a logarithmic axis. */
const POINTS = 46;

/**
 * @typedef {{ key: string, name: string, beside: boolean, points: [orbits: number, error: number][] }} Line
 * @typedef {{ title: string, note: string, lines: Line[] }} Chart
 * @param {any} physics the package
 * @returns {Chart[]}
 */
export function energyErrors(physics) {
  return PANELS.map(({ title, note, problem, schemes, beside }) => {
    process.stderr.write(`${title}: ${[...beside, ...schemes].join(', ')}\n`);
    const line = (/** @type {string} */ key, /** @type {boolean} */ isBeside) => {
      const record = physics.INTEGRATORS[key];
      return { key, name: record.name, beside: isBeside, points: measure(physics, record, problem) };
    };
    return { title, note, lines: [...beside.map((key) => line(key, true)), ...schemes.map((key) => line(key, false))] };
  });
}

/**
 * Largest relative energy error up to each point.
 * @param {any} physics
 * @param {any} record
 * @param {import('./energy-panels.mjs').Panel['problem']} problem
 * @returns {[number, number][]}
 */
function measure(physics, record, problem) {
  const { energy, step } = physics;
  const world = problem.build(physics, record.create());
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
