// Damped springs between two bodies, in ascending id: springs share bodies, so the order of sums matters.
import { columns, get, put } from '../memory/columns';

// The record of a world's springs; src/forces/support/spring-table.ts writes the addresses and reads the counts.
@unmanaged
export class SpringTable {
  a: usize;
  b: usize;
  aGeneration: usize;
  bGeneration: usize;
  stiffness: usize;
  damping: usize;
  length: usize;
  tensionOnly: usize;
  generations: usize;
  // Ids of all springs, ascending.
  ids: usize;
  // The active springs, those with two living ends: id, and the rows of both ends.
  links: usize;
  // Ids of springs that lost an end.
  dangling: usize;
  count: i32;
  active: i32;
  danglingCount: i32;
  rows: i32;
  // Largest stiffness over reduced mass, 1/s^2, and damping over reduced mass, 1/s.
  maxStiffness: f64;
  maxDamping: f64;
}

// @ts-ignore: decorator
@inline function word(column: usize, row: u32): u32 {
  return load<u32>(column + ((<usize>row) << 2));
}

// @ts-ignore: decorator
@inline function isAlive(members: usize, body: u32, generations: usize, generation: u32, position: u32): bool {
  return (word(members, body) & position) != 0 && word(generations, body) == generation;
}

// Separates the springs with two living ends from those that lost an end, and finds the stiffest. A spring without
// ends (a = b = 0), or with ends overwritten by invalid values, is skipped.
//
// The loop reads the records through locals, because the compiler must assume that stores change them.
export function scanSprings(table: usize, position: u32): void {
  const t = changetype<SpringTable>(table);
  const c = columns();
  const count = t.count;
  const rows = <u32>t.rows;
  const ids = t.ids;
  const firsts = t.a;
  const seconds = t.b;
  const firstGenerations = t.aGeneration;
  const secondGenerations = t.bGeneration;
  const generations = t.generations;
  const members = c.members;
  const masses = c.mass;
  const stiffnesses = t.stiffness;
  const dampings = t.damping;
  const links = t.links;
  let active = 0;
  let dangling = 0;
  let maxStiffness: f64 = 0;
  let maxDamping: f64 = 0;
  for (let i = 0; i < count; i++) {
    const spring = word(ids, i);
    const a = word(firsts, spring);
    const b = word(seconds, spring);
    if (a == 0 || b == 0 || a == b || a >= rows || b >= rows) continue;
    if (
      !isAlive(members, a, generations, word(firstGenerations, spring), position) ||
      !isAlive(members, b, generations, word(secondGenerations, spring), position)
    ) {
      store<u32>(t.dangling + ((<usize>dangling) << 2), spring);
      dangling++;
      continue;
    }
    const link = links + <usize>active * 12;
    store<u32>(link, spring);
    store<u32>(link, a, 4);
    store<u32>(link, b, 8);
    active++;
    const massA = <f64>get(masses, a);
    const massB = <f64>get(masses, b);
    const stiffness = <f64>get(stiffnesses, spring);
    const damping = <f64>get(dampings, spring);
    // 1/m_a + 1/m_b as a fraction, so that only a new maximum takes a division. A body without mass is an anchor.
    const above = massA > 0 && massB > 0 ? massA + massB : massA > 0 || massB > 0 ? 1 : 0;
    const below = (massA > 0 ? massA : 1) * (massB > 0 ? massB : 1);
    if (stiffness * above > maxStiffness * below) maxStiffness = (stiffness * above) / below;
    if (damping * above > maxDamping * below) maxDamping = (damping * above) / below;
  }
  t.active = active;
  t.danglingCount = dangling;
  t.maxStiffness = maxStiffness;
  t.maxDamping = maxDamping;
}

// Tension at a distance d that grows at `rate`. A slack tension-only spring exerts none, and a taut one never pushes.
// @ts-ignore: decorator
@inline function tension(t: SpringTable, spring: u32, d: real, rate: real): real {
  const extension = d - get(t.length, spring);
  const force = get(t.stiffness, spring) * extension + get(t.damping, spring) * rate;
  if (word(t.tensionOnly, spring) == 0) return force;
  return extension > 0 && force > 0 ? force : 0;
}

// Coincident ends have no direction; the x axis is used instead.
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
    const force = tension(t, load<u32>(link), d, vx * nx + vy * ny);
    put(fx, a, get(fx, a) + force * nx);
    put(fy, a, get(fy, a) + force * ny);
    put(fx, b, get(fx, b) - force * nx);
    put(fy, b, get(fy, b) - force * ny);
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
    const force = tension(t, load<u32>(link), d, vx * nx + vy * ny + vz * nz);
    put(fx, a, get(fx, a) + force * nx);
    put(fy, a, get(fy, a) + force * ny);
    put(fz, a, get(fz, a) + force * nz);
    put(fx, b, get(fx, b) - force * nx);
    put(fy, b, get(fy, b) - force * ny);
    put(fz, b, get(fz, b) - force * nz);
  }
}

// Minimum stiffness of a rod, N/m; a constraint holds the length of a rod.
const RIGID: f64 = 1e29;

// Sum of k (d - L)^2 / 2, J; slack tension-only springs have none, and rods do not stretch.
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
    if (stiffness >= RIGID || (extension < 0 && word(t.tensionOnly, spring) != 0)) continue;
    sum += 0.5 * stiffness * extension * extension;
  }
  return sum;
}
