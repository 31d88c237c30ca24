// Velocities of a shell's stars relative to the shell, for a maximum speed of 1 m/s. They form opposite pairs, so that
// a burst conserves momentum.
import { cos, type Random, sin, type Vector } from '@principia/physics';
import type { ShellKind } from './shells.ts';

const TWO_PI = 6.283185307179586;
/** Fronds of a palm. */
const FRONDS = 12;

/** @param dimensions in 2D the third axis is dropped, which shows the ball, ring or palm from the side */
export function formVelocities(kind: ShellKind, dimensions: 2 | 3, random: Random): Vector[] {
  const half = drawHalf(kind, random);
  const flat = ({ x, y, z }: Vector): Vector => ({ x, y, z: dimensions === 3 ? z : 0 });
  return half.map(flat).flatMap(({ x, y, z }) => [
    { x, y, z },
    { x: -x, y: -y, z: -z },
  ]);
}

function drawHalf({ form, stars, minSpeedShare }: ShellKind, random: Random): Vector[] {
  const count = stars / 2;
  const speed = () => random.uniform(minSpeedShare, 1);
  if (form === 'ball') return Array.from({ length: count }, () => random.onSphere(speed()));
  if (form === 'ring') return ringHalf(count, random, speed);
  return palmHalf(count, random, minSpeedShare);
}

/** Stars evenly spaced on a randomly tilted circle. */
function ringHalf(count: number, random: Random, speed: () => number): Vector[] {
  const normal = random.onSphere();
  const [u, w] = basis(normal);
  const start = random.uniform(0, TWO_PI);
  return Array.from({ length: count }, (_, i) => {
    const angle = start + (0.5 * TWO_PI * i) / count;
    return combine(u, cos(angle) * speed(), w, sin(angle) * speed());
  });
}

/** Every frond is a row of stars with nearly the same direction and increasing speed. */
function palmHalf(count: number, random: Random, slowest: number): Vector[] {
  const fronds = FRONDS / 2;
  const turn = random.uniform(0, TWO_PI);
  const directions = Array.from({ length: fronds }, (_, f) => {
    const angle = turn + (0.5 * TWO_PI * (f + random.uniform(-0.25, 0.25))) / fronds;
    const depth = random.uniform(-0.6, 0.6);
    const flat = Math.sqrt(1 - depth * depth);
    return { x: cos(angle) * flat, y: sin(angle) * flat, z: depth };
  });
  const each = Math.ceil(count / fronds);
  return Array.from({ length: count }, (_, i) => {
    const { x, y, z } = directions[i % fronds];
    const speed = slowest + ((1 - slowest) * (Math.floor(i / fronds) + 1)) / each;
    const off = random.onSphere(0.025);
    return { x: x * speed + off.x, y: y * speed + off.y, z: z * speed + off.z };
  });
}

/** Two unit vectors orthogonal to `n` and to each other. */
function basis(n: Vector): [Vector, Vector] {
  const u = Math.abs(n.z) > 0.9 ? unit({ x: 0, y: n.z, z: -n.y }) : unit({ x: n.y, y: -n.x, z: 0 });
  return [u, { x: n.y * u.z - n.z * u.y, y: n.z * u.x - n.x * u.z, z: n.x * u.y - n.y * u.x }];
}

function unit({ x, y, z }: Vector): Vector {
  const norm = Math.sqrt(x * x + y * y + z * z);
  return { x: x / norm, y: y / norm, z: z / norm };
}

function combine(u: Vector, a: number, w: Vector, b: number): Vector {
  return { x: u.x * a + w.x * b, y: u.y * a + w.y * b, z: u.z * a + w.z * b };
}
