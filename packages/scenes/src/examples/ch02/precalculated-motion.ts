import { spawn, step, velocityVerlet } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS, type Point } from '../picture.ts';
import { positionOf } from '../support/read.ts';
import { GROUND, RADIUS, STAGE_VIEW, stageWorld } from '../support/stage.ts';

const DT = 1 / 60;
const SECONDS = 8;

/** A ball that is thrown across the stage. */
function throwBall(gravity: number, restitution: number) {
  const world = stageWorld(gravity, { integrator: velocityVerlet });
  const collider = { radius: RADIUS, restitution };
  return {
    world,
    ball: spawn(world, { position: { x: 30, y: 200 }, velocity: { x: 80, y: -150 }, mass: 1, collider }),
  };
}

/** The places of the ball after each step, computed before anything is shown. */
function recordPath(gravity: number, restitution: number): Point[] {
  const { world, ball } = throwBall(gravity, restitution);
  const path: Point[] = [positionOf(world, ball)];
  for (let i = 0; i < SECONDS / DT; i++) {
    step(world, DT);
    path.push(positionOf(world, ball));
  }
  return path;
}

export default defineExample({
  id: 'ch02-precalculated-motion',
  title: 'A film of a ball',
  chapter: 2,
  tags: ['animation', 'determinism', 'time'],
  about:
    'The white path was computed before the start, and the ring plays it back like a film. The ball is computed now, step by step, and follows it exactly. With a film one may also jump to any time: the small dots show the same flight one and two seconds later.',
  duration: SECONDS,
  ends: true,
  parameters: {
    gravity: { label: 'Gravity', unit: 'px/s²', initial: 360, min: 60, max: 900 },
    restitution: { label: 'Speed kept in a bounce', initial: 0.8, min: 0, max: 0.95 },
  },
  build({ gravity, restitution }) {
    const path = recordPath(gravity, restitution);
    const live = throwBall(gravity, restitution);
    const frame = (later: number) => path[Math.min(path.length - 1, Math.round((live.world.time + later) / DT))];
    return { ...live, dt: DT, path, frame };
  },
  picture: ({ path, frame }) => ({
    yDown: true,
    view: STAGE_VIEW,
    fills: [GROUND],
    curves: [{ points: path, now: () => frame(0), markRadius: 1.2 * RADIUS, label: 'film', color: COLORS.white }],
    dots: [1, 2].map((later) => ({ at: () => frame(later), color: COLORS.orange })),
  }),
  plots: (plot) => [
    plot(
      'Height, in the film and now',
      'height, px',
      { label: 'film', value: ({ frame }) => 480 - frame(0).y },
      { label: 'now', value: ({ world, ball }) => 480 - positionOf(world, ball).y },
    ),
  ],
  checks: ({ at, largest }) => [
    largest(
      SECONDS,
      'Largest distance of ball and film',
      { exact: 0, unit: 'px', absolute: 0 },
      ({ world, ball, frame }) => {
        const [{ x, y }, film] = [positionOf(world, ball), frame(0)];
        return Math.max(Math.abs(x - film.x), Math.abs(y - film.y));
      },
    ),
    at(
      0,
      'Pictures of the film, 60 a second and the first',
      { exact: 60 * SECONDS + 1, absolute: 0 },
      ({ path }) => path.length,
    ),
  ],
  tryThis: [
    'Drag the ball away while it flies: the film does not know of it, and plays on unchanged.',
    'Rewind: for the film that is only another number of a picture.',
  ],
});
