// Damped springs between two bodies, one after the other in ascending id: bodies share springs, so order is meaning.
import { columns, get, put } from '../memory/columns';

// What the springs of a world need; src/forces/support/spring-table.ts writes the addresses and reads the counts.
@unmanaged
export class SpringTable {
  a: usize;
  b: usize;
  aLife: usize;
  bLife: usize;
  stiffness: usize;
  damping: usize;
  length: usize;
  cord: usize;
  generations: usize;
  // Ids of all springs, ascending.
  ids: usize;
  // Per spring with two living ends: its id, and the rows of its ends.
  links: usize;
  // Ids of springs that lost an end.
  lost: usize;
  count: i32;
  active: i32;
  lostCount: i32;
  rows: i32;
  // Largest stiffness over reduced mass, 1/s^2, and damping over reduced mass, 1/s.
  stiffest: f64;
  mostDamped: f64;
}

// @ts-ignore: decorator
@inline function word(column: usize, row: u32): u32 {
  return load<u32>(column + ((<usize>row) << 2));
}

// @ts-ignore: decorator
@inline function lives(members: usize, body: u32, generations: usize, life: u32, position: u32): bool {
  return (word(members, body) & position) != 0 && word(generations, body) == life;
}

// Sorts the springs into those with two living ends and those that lost one, and finds the stiffest. A spring that was
// never given ends (a = b = 0), or whose ends somebody overwrote with nonsense, joins nothing.
export function scanSprings(table: usize, position: u32): void {
  const t = changetype<SpringTable>(table);
  const c = columns();
  let active = 0;
  let lost = 0;
  let stiffest: f64 = 0;
  let mostDamped: f64 = 0;
  for (let i = 0; i < t.count; i++) {
    const spring = word(t.ids, i);
    const a = word(t.a, spring);
    const b = word(t.b, spring);
    if (a == 0 || b == 0 || a == b || a >= <u32>t.rows || b >= <u32>t.rows) continue;
    if (
      !lives(c.members, a, t.generations, word(t.aLife, spring), position) ||
      !lives(c.members, b, t.generations, word(t.bLife, spring), position)
    ) {
      store<u32>(t.lost + ((<usize>lost) << 2), spring);
      lost++;
      continue;
    }
    const link = t.links + <usize>active * 12;
    store<u32>(link, spring);
    store<u32>(link, a, 4);
    store<u32>(link, b, 8);
    active++;
    const inverse = inverseMass(get(c.mass, a)) + inverseMass(get(c.mass, b));
    stiffest = max<f64>(stiffest, <f64>get(t.stiffness, spring) * inverse);
    mostDamped = max<f64>(mostDamped, <f64>get(t.damping, spring) * inverse);
  }
  t.active = active;
  t.lostCount = lost;
  t.stiffest = stiffest;
  t.mostDamped = mostDamped;
}

// @ts-ignore: decorator
@inline function inverseMass(mass: real): f64 {
  return mass > 0 ? 1 / <f64>mass : 0;
}

// Pull between the ends for a distance d that grows at `rate`; a slack cord pulls nothing, a taut one never pushes.
// @ts-ignore: decorator
@inline function tension(t: SpringTable, spring: u32, d: real, rate: real): real {
  const extension = d - get(t.length, spring);
  const pull = get(t.stiffness, spring) * extension + get(t.damping, spring) * rate;
  if (word(t.cord, spring) == 0) return pull;
  return extension > 0 && pull > 0 ? pull : 0;
}

// Ends in one place have no direction between them: x is taken.
export function springForces2d(table: usize, fx: usize, fy: usize): void {
  const t = changetype<SpringTable>(table);
  const c = columns();
  for (let i = 0; i < t.active; i++) {
    const link = t.links + <usize>i * 12;
    const a = load<u32>(link, 4);
    const b = load<u32>(link, 8);
    const x = get(c.positionX, b) - get(c.positionX, a);
    const y = get(c.positionY, b) - get(c.positionY, a);
    const d = sqrt<real>(x * x + y * y);
    const nx: real = d > 0 ? x / d : 1;
    const ny: real = d > 0 ? y / d : 0;
    const vx = get(c.velocityX, b) - get(c.velocityX, a);
    const vy = get(c.velocityY, b) - get(c.velocityY, a);
    const pull = tension(t, load<u32>(link), d, vx * nx + vy * ny);
    put(fx, a, get(fx, a) + pull * nx);
    put(fy, a, get(fy, a) + pull * ny);
    put(fx, b, get(fx, b) - pull * nx);
    put(fy, b, get(fy, b) - pull * ny);
  }
}

export function springForces3d(table: usize, fx: usize, fy: usize, fz: usize): void {
  const t = changetype<SpringTable>(table);
  const c = columns();
  for (let i = 0; i < t.active; i++) {
    const link = t.links + <usize>i * 12;
    const a = load<u32>(link, 4);
    const b = load<u32>(link, 8);
    const x = get(c.positionX, b) - get(c.positionX, a);
    const y = get(c.positionY, b) - get(c.positionY, a);
    const z = get(c.positionZ, b) - get(c.positionZ, a);
    const d = sqrt<real>(x * x + y * y + z * z);
    const nx: real = d > 0 ? x / d : 1;
    const ny: real = d > 0 ? y / d : 0;
    const nz: real = d > 0 ? z / d : 0;
    const vx = get(c.velocityX, b) - get(c.velocityX, a);
    const vy = get(c.velocityY, b) - get(c.velocityY, a);
    const vz = get(c.velocityZ, b) - get(c.velocityZ, a);
    const pull = tension(t, load<u32>(link), d, vx * nx + vy * ny + vz * nz);
    put(fx, a, get(fx, a) + pull * nx);
    put(fy, a, get(fy, a) + pull * ny);
    put(fz, a, get(fz, a) + pull * nz);
    put(fx, b, get(fx, b) - pull * nx);
    put(fy, b, get(fy, b) - pull * ny);
    put(fz, b, get(fz, b) - pull * nz);
  }
}

// A stiffness from here on is a rod's, whose length is held by a constraint.
const RIGID: f64 = 1e29;

// Sum of k (d - L)^2 / 2, J; slack cords hold none, and rods do not stretch.
export function springPotential(table: usize): f64 {
  const t = changetype<SpringTable>(table);
  const c = columns();
  let sum: f64 = 0;
  for (let i = 0; i < t.active; i++) {
    const link = t.links + <usize>i * 12;
    const spring = load<u32>(link);
    const a = load<u32>(link, 4);
    const b = load<u32>(link, 8);
    const x = <f64>get(c.positionX, b) - <f64>get(c.positionX, a);
    const y = <f64>get(c.positionY, b) - <f64>get(c.positionY, a);
    const z = <f64>get(c.positionZ, b) - <f64>get(c.positionZ, a);
    const extension = sqrt<f64>(x * x + y * y + z * z) - <f64>get(t.length, spring);
    const stiffness = <f64>get(t.stiffness, spring);
    if (stiffness >= RIGID || (extension < 0 && word(t.cord, spring) != 0)) continue;
    sum += 0.5 * stiffness * extension * extension;
  }
  return sum;
}
