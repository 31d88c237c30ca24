// Wind on a sheet of triangles.
import { LANES, at } from '../memory/lanes';
import { computeWindForce, setWind, windState } from './wind-force';
import { CHUNK, addChunkForces, chunkAddress, readTriangles, triangles } from './faces';
import { addWindToStrip, isStripAlive } from './strips';
import { word } from '../xpbd/table';

// A sheet of `count` triangles, its strips, and the force columns; velocity and density of the air; normal and
// tangential drag coefficients. src/soft-bodies/cloth-wind.ts writes it.
@unmanaged
export class SheetInWind {
  faces: usize;
  count: i32;
  sections: usize;
  generations: usize;
  forceX: usize;
  forceY: usize;
  forceZ: usize;
  windX: f64;
  windY: f64;
  windZ: f64;
  density: f64;
  normal: f64;
  tangential: f64;
}

// Adds the wind forces. `sections` has two words per section of the faces: its first face, and whether it is a quad
// strip; behind the last, the number of faces. A triangle with a removed corner receives no force.
export function addWindForces(sheet: usize): void {
  const s = changetype<SheetInWind>(sheet);
  const faces = s.faces;
  const count = s.count;
  const sections = s.sections;
  const generations = s.generations;
  const fx = s.forceX;
  const fy = s.forceY;
  const fz = s.forceZ;
  setWind(s.windX, s.windY, s.windZ, s.density, s.normal, s.tangential);
  let first = 0;
  for (let section = 0; first < count; section++) {
    const last = <i32>word(sections, 2 * section + 2);
    const isStrip = word(sections, 2 * section + 1) != 0 && isStripAlive(faces, count, first, last, generations);
    if (isStrip) addWindToStrip(faces, count, first, last, fx, fy, fz);
    else addWindToEach(faces, count, first, last, generations, fx, fy, fz);
    first = last;
  }
}

function addWindToEach(
  faces: usize,
  count: i32,
  first: i32,
  last: i32,
  generations: usize,
  fx: usize,
  fy: usize,
  fz: usize,
): void {
  const t = triangles;
  const to = chunkAddress(faces, count);
  for (let chunk = first; chunk < last; chunk += CHUNK) {
    const end = min<i32>(chunk + CHUNK, last);
    let runs: u32 = 0;
    let address = to;
    for (let face = chunk, bit: u32 = 1; face < end; face += LANES, bit <<= 1) {
      if (readTriangles(faces, count, face, last, generations)) runs |= bit;
      computeWindForce(t.bx, t.by, t.bz, t.dx, t.dy, t.dz, t.vx, t.vy, t.vz);
      v128.store(address, windState.fx);
      v128.store(address + at(CHUNK), windState.fy);
      v128.store(address + at(2 * CHUNK), windState.fz);
      address += 16;
    }
    addChunkForces(faces, count, chunk, end, runs, fx, fy, fz);
  }
}
