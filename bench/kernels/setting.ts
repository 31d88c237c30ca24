// What all bodies share.
export let low: real = 0;
export let high: real = 0;
export let gravity: real = 0;
export let restitution: real = 0;
export let maxPosition: real = 0;
export let maxSpeed: real = 0;
export let dt: real = 0;

export function configure(
  lowest: real,
  highest: real,
  downwards: real,
  bounciness: real,
  positionLimit: real,
  speedLimit: real,
  step: real,
): void {
  low = lowest;
  high = highest;
  gravity = downwards;
  restitution = bounciness;
  maxPosition = positionLimit;
  maxSpeed = speedLimit;
  dt = step;
}
