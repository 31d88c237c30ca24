// How long bodies have been still, and which forces wake what sleeps.
//
// Still is what is slow, does not get faster, and stays where it is:
//
//   v <= V      v - (least v while still) <= V/10      |u| <= c V      u' = (v - u)/(T/2)      c = 3/5, or 1/10
//
// V: sleepSpeed    T: sleepTime. The mean velocity u tells what rests and trembles from what drifts, or swings and is about to turn
// back: with an acceleration A that lasts for T it becomes more than A T/2 before or after. Heaps creep, and friction holds them
// in the end: c = 3/5 where anything touches. Nothing brakes what only joints hold: c = 1/10. The mean starts from 0 where a body
// begins to be still, so that what goes at a steady speed sleeps below c V/(1 - e⁻²): 0.69 V and 0.116 V.
//
// What sleeps wakes when forces change so that it would gain more than V/10 in T. Nothing at all holds what neither touches
// nor is joined to something that does not move: it sleeps where V and forces are a thousandth of what others may have, so
// that what drifts goes on, and wakes by as little.
import { get } from '../../memory/columns';
import { LOCKED, SLEEPLESS, TO_SLEEP, flagsOf, poseOf, stateOf, word } from './body';
import { inverseMassX, inverseMassY, openAxes } from './motion-locks';
import { pathOf } from './paths';
import { RigidTable } from './rigid-table';
import { Sleeper, sleeperOf } from './sleeper';

// Where gravity is weak a block that begins to tip, or a ball at the top of its flight, is slow for longer than it takes to fall
// asleep, but gets faster. It may lose more, as piles do that settle.
const GAIN: real = 0.1;

// The largest mean velocity, in parts of the speed that counts as still, of what touches anything, and of what does not.
const CREEP: real = 0.6;
const SWING: real = 0.1;

// What nothing holds may have this part of the speed that counts as still.
const FREE: real = 0.001;

// Bits of what holds an island: locks along both axes, or something that does not move, by contacts or joints; and whether there are contacts in it.
export const HELD: i32 = 1;
export const TOUCHES: i32 = 2;

// Whether any body has been still for long enough.
export function countStill(t: RigidTable): bool {
  const dt = <real>t.dt;
  const limit = <real>t.sleepSpeed;
  const gain = GAIN * limit;
  let any = false;
  for (let i = 0; i < t.awakeCount; i++) {
    const row = word(t.awake, i);
    const sleeper = sleeperOf(t, row);
    const speed = speedOf(t, row);
    if (sleeper.stillFor == 0) startStill(sleeper, speed);
    else if (speed < sleeper.slowest) sleeper.slowest = speed;
    const still = (flagsOf(t, row) & SLEEPLESS) == 0 && speed <= limit && speed - sleeper.slowest <= gain;
    const mean = still ? meanSpeed(t, row, sleeper) : <real>Infinity;
    sleeper.stillFor = mean <= CREEP * limit ? sleeper.stillFor + dt : 0;
    sleeper.steadyFor = mean <= SWING * limit ? sleeper.steadyFor + dt : 0;
    sleeper.freeFor = still && speed <= FREE * limit ? sleeper.freeFor + (isFree(t, row) ? dt : <real>0.5 * dt) : 0;
    sleeper.island = row;
    sleeper.holds = (flagsOf(t, row) & LOCKED) != 0 && openAxes(t, row) == 0 ? HELD : 0;
    if (<f64>sleeper.stillFor >= t.sleepTime || (flagsOf(t, row) & TO_SLEEP) != 0) any = true;
  }
  return any;
}

function startStill(sleeper: Sleeper, speed: real): void {
  sleeper.slowest = speed;
  sleeper.meanX = 0;
  sleeper.meanY = 0;
  sleeper.meanW = 0;
}

// For how long the island of a body has rested, of its first body.
export function restsFor(first: Sleeper): real {
  if ((first.holds & HELD) == 0) return min<real>(first.stillFor, first.freeFor);
  return (first.holds & TOUCHES) != 0 ? first.stillFor : min<real>(first.stillFor, first.steadyFor);
}

// The larger of the speed of the fastest point and half the rate at which the body was displaced, m/s.
function speedOf(t: RigidTable, row: i32): real {
  const state = stateOf(t, row);
  const extent = poseOf(t, row).extent;
  const speed = sqrt<real>(state.vx * state.vx + state.vy * state.vy) + abs<real>(state.w) * extent;
  return max<real>(speed, (<real>0.5 * pathOf(t, row)) / <real>t.dt);
}

// The speed of the fastest point in the mean velocity of late, m/s, with what the body moved in this step.
function meanSpeed(t: RigidTable, row: i32, sleeper: Sleeper): real {
  const state = stateOf(t, row);
  const share = <real>min<f64>(1, (2 * t.dt) / t.sleepTime);
  const rate = share / <real>t.dt;
  sleeper.meanX += rate * state.dx - share * sleeper.meanX;
  sleeper.meanY += rate * state.dy - share * sleeper.meanY;
  sleeper.meanW += rate * state.turned - share * sleeper.meanW;
  const speed = sqrt<real>(sleeper.meanX * sleeper.meanX + sleeper.meanY * sleeper.meanY);
  return speed + abs<real>(sleeper.meanW) * poseOf(t, row).extent;
}

// Whether a body would hardly move if nothing held it. Along what is locked forces do not count.
function isFree(t: RigidTable, row: i32): bool {
  const x = get(t.forceX, row) * inverseMassX(t, row);
  const y = get(t.forceY, row) * inverseMassY(t, row);
  return sqrt<real>(x * x + y * y) + turnOf(t, row, torqueOn(t, row)) <= freeAcceleration(t);
}

// The acceleration of the outermost point by a torque, m/s².
// @ts-ignore: decorator
@inline function turnOf(t: RigidTable, row: i32, torque: real): real {
  const pose = poseOf(t, row);
  return abs<real>(torque) * pose.inverseInertia * pose.extent;
}

// @ts-ignore: decorator
@inline function torqueOn(t: RigidTable, row: i32): real {
  return t.torqueZ == 0 ? <real>0 : get(t.torqueZ, row);
}

// The changes of acceleration, m/s², that wake what is held, and what nothing holds: what would be no longer still after T.
// @ts-ignore: decorator
@inline export function heldAcceleration(t: RigidTable): real {
  return GAIN * <real>(t.sleepSpeed / t.sleepTime);
}

// @ts-ignore: decorator
@inline export function freeAcceleration(t: RigidTable): real {
  return FREE * <real>(t.sleepSpeed / t.sleepTime);
}

// Keeps the forces on a body that falls asleep.
export function noteForces(t: RigidTable, row: i32, sleeper: Sleeper): void {
  sleeper.fx = get(t.forceX, row);
  sleeper.fy = get(t.forceY, row);
  sleeper.torque = torqueOn(t, row);
}

// Whether the forces on a sleeping body are others than when it fell asleep, so that it wakes.
export function haveForcesChanged(t: RigidTable, row: i32): bool {
  const sleeper = sleeperOf(t, row);
  // There is no drag any more on what was put to sleep while it moved.
  if (sleeper.isStopped != 0) {
    sleeper.isStopped = 0;
    noteForces(t, row, sleeper);
    return false;
  }
  const x = (get(t.forceX, row) - sleeper.fx) * inverseMassX(t, row);
  const y = (get(t.forceY, row) - sleeper.fy) * inverseMassY(t, row);
  const turn = turnOf(t, row, torqueOn(t, row) - sleeper.torque);
  return sqrt<real>(x * x + y * y) + turn > sleeper.wakingAcceleration;
}
