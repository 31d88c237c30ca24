// Rebounds from wall entities under forces that depend on position or velocity: see impact-list.ts.
//
// Bodies that met walls twice in a step or came to rest keep what the kernel gave them.
import { MAX_SPEED } from '../components/velocity.ts';
import { ContactTableWord as Word } from '../memory/layouts.gen.ts';
import type { PhysicsWorld } from '../world/types.ts';
import {
  AFTER,
  FRICTION,
  goOn,
  HEIGHT,
  type ImpactWay,
  listedImpacts,
  NORMAL,
  numbersOf,
  RESTITUTION,
  START,
  wordOf,
} from './impact-list.ts';

/** Takes the steps of the bodies that rebounded from walls again. */
export function retakeRebounds(world: PhysicsWorld, dt: number): void {
  const way = listedImpacts(world, dt);
  if (way === undefined) return;
  const count = way.words[Word.impactCount];
  for (let k = 0; k < count; k++) {
    const row = wordOf(way, k, 0);
    const at = numbersOf(way, k);
    if (way.reals[at + RESTITUTION] >= 0 && isOnly(way, k, row, count) && bounce(world, way, row, at, dt)) {
      accept(way, row);
    }
  }
}

/** Whether a row has no other entry. Those of one vector follow each other. */
function isOnly(way: ImpactWay, k: number, row: number, count: number): boolean {
  return !isFoundFrom(way, k, row, count, -1) && !isFoundFrom(way, k, row, count, 1);
}

function isFoundFrom(way: ImpactWay, k: number, row: number, count: number, by: 1 | -1): boolean {
  const vector = Math.floor(row / way.lanes);
  for (let n = k + by; n >= 0 && n < count; n += by) {
    const other = wordOf(way, n, 0);
    if (other === row) return true;
    if (Math.floor(other / way.lanes) !== vector) return false;
  }
  return false;
}

/** Takes a body from the start of the step to the wall, and from there to its end. Returns whether that has a sense. */
function bounce(world: PhysicsWorld, way: ImpactWay, row: number, at: number, dt: number): boolean {
  const { reals, loop } = way;
  begin(way, row, at);
  let time = dt - reals[at + AFTER];
  goOn(world, way, row, 0, time);
  const reached = speedInto(way, row, at);
  time += heightOf(way, row, at) / reached;
  if (!(reached > 0 && time >= 0 && time <= dt)) return false;
  begin(way, row, at);
  goOn(world, way, row, 0, time);
  const speed = speedInto(way, row, at);
  const height = heightOf(way, row, at);
  if (!(speed > 0)) return false;
  const change = (1 + reals[at + RESTITUTION]) * speed;
  for (let i = 0; i < loop.position.length; i++) {
    const n = reals[at + NORMAL + i];
    loop.position[i][row] -= height * n;
    loop.velocity[i][row] += change * n + reals[at + FRICTION + i];
  }
  goOn(world, way, row, time, dt - time);
  return heightOf(way, row, at) >= 0;
}

/** Sets a body to the start of the step. */
function begin({ loop, previous, reals }: ImpactWay, row: number, at: number): void {
  for (let i = 0; i < previous.length; i++) {
    loop.position[i][row] = previous[i][row];
    loop.velocity[i][row] = reals[at + START + i];
  }
}

/** Height of a body above the place where it touches the wall. */
function heightOf({ loop, reals }: ImpactWay, row: number, at: number): number {
  let height = -reals[at + HEIGHT];
  for (let i = 0; i < loop.position.length; i++) height += loop.position[i][row] * reals[at + NORMAL + i];
  return height;
}

function speedInto({ loop, reals }: ImpactWay, row: number, at: number): number {
  let speed = 0;
  for (let i = 0; i < loop.velocity.length; i++) speed -= loop.velocity[i][row] * reals[at + NORMAL + i];
  return speed;
}

/** Takes the state at the end of the step over. */
function accept({ loop, position, velocity, start }: ImpactWay, row: number): void {
  for (let i = 0; i < position.length; i++) if (!(Math.abs(loop.velocity[i][row]) <= MAX_SPEED)) return;
  for (let i = 0; i < position.length; i++) {
    const v = loop.velocity[i][row];
    // What follows takes the change since the start of the step for the acceleration.
    start[i][row] += v - velocity[i][row];
    position[i][row] = loop.position[i][row];
    velocity[i][row] = v;
  }
}
