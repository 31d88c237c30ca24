// Wind on a cloth, triangle by triangle.
//
//   F = ρ A |u| (c_n (u·n) n + c_t (u - (u·n) n)) / 2        a third on each corner
//
//   u  wind minus the triangle's mean velocity, m/s    A, n  area, m², and unit normal
//   ρ  density of the air, kg/m³                       c_n, c_t  normal and tangential coefficients
//
// A plate normal to the stream has c_n near 2 (Hoerner, Fluid-Dynamic Drag, 1965); parallel to it only friction
// remains, c_t near 0.01. Every triangle is in the free stream, without shielding by others. The force also damps a
// sheet that moves in still air. 3D only. Explicit: stable while ρ c_n A |u| dt is below the mass of the triangle.
// Cost: two square roots per triangle.
//
// No wind acts on what is torn: a triangle of `cloth.triangles` that lost a spring along its row or its column, and one
// of another list that had springs along two sides or more when the force first acted, and now has fewer than two.

import { PhysicsError } from '../errors/physics-error.ts';
import { checkKeys, checkNumber } from '../errors/validate.ts';
import { VELOCITY_BOUNDS } from '../forces/support/bounds.ts';
import { shownVector, timeVector, type VectorOverTime } from '../laws/time-vector.ts';
import { forceMemory, type TakeBytes } from '../memory/force-memory.ts';
import { SHEET_IN_WIND_BYTES, SheetInWindNumber, SheetInWindWord } from '../memory/layouts.gen.ts';
import { type MemoryRecord, recordAt } from '../memory/record.ts';
import type { Force, PhysicsWorld } from '../world/types.ts';
import { type Faces, facesOf, stateOfFaces } from './faces.ts';
import { softBodyKernels } from './kernels.ts';
import { dropTornFaces } from './threads.ts';

/** Options of `clothWind`. */
export interface ClothWindOptions {
  /** Entity ids of the corners of the triangles, three each: `cloth.triangles`. Give that list itself, no copy of it. */
  readonly triangles: ArrayLike<number>;
  /** Velocity of the air, m/s, steady or as a function of time; default still air. */
  readonly velocity?: VectorOverTime;
  /** kg/m³; default 1.2. */
  readonly density?: number;
  /** c_n; default 2. */
  readonly normal?: number;
  /** c_t; default 0.01. */
  readonly tangential?: number;
}

/**
 * Wind on a cloth, triangle by triangle: F = ρ A |u| (c_n (u·n) n + c_t (u - (u·n) n))/2, N, with the wind u past the
 * triangle. 3D only.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN; in a step of a 2D world E_RANGE
 */
export function clothWind(options: ClothWindOptions): Force {
  checkKeys(options, 'clothWind', ['triangles', 'velocity', 'density', 'normal', 'tangential']);
  const density = checkNumber(options.density ?? 1.2, 'clothWind.density', { min: 0, max: 1e6 });
  const normal = checkNumber(options.normal ?? 2, 'clothWind.normal', { min: 0, max: 100 });
  const tangential = checkNumber(options.tangential ?? 0.01, 'clothWind.tangential', { min: 0, max: 100 });
  const wind = timeVector(options.velocity ?? {}, 'clothWind.velocity', 'velocity', VELOCITY_BOUNDS);
  const faces = facesOf(options.triangles, 3, 'clothWind.triangles', true);
  const sheet = forceMemory((world, take) => writeSheet(world, take, faces.of(world), [density, normal, tangential]));
  return {
    name: 'wind on cloth',
    equation: 'F = ρ A |u| (c_n (u·n) n + c_t (u - (u·n) n)) / 2',
    parameters: {
      density: { unit: 'kg/m³', value: density },
      normal: { unit: '', value: normal },
      tangential: { unit: '', value: tangential },
      ...shownVector('velocity', 'm/s', wind.steady),
    },
    reads: ['Position', 'Velocity'],
    memory: stateOfFaces(faces, 3, true),
    local: false,
    readsOfOthers: [],
    prepare(world) {
      if (world.dimensions === 2) {
        throw new PhysicsError(
          'E_RANGE',
          'clothWind needs a 3D world, but this world is 2D. Create the world with dimensions: 3.',
          { field: 'dimensions' },
        );
      }
      sheet.of(world);
      dropTornFaces(world, faces.of(world));
    },
    releaseMemory(world) {
      sheet.release(world);
      faces.release(world);
    },
    accumulate(world, _first, _last, time) {
      const { at, numbers } = sheet.of(world);
      const { x, y, z } = wind.at(world, time);
      numbers[SheetInWindNumber.windX] = x;
      numbers[SheetInWindNumber.windY] = y;
      numbers[SheetInWindNumber.windZ] = z;
      softBodyKernels(world).addWindForces(at);
    },
  };
}

function writeSheet(
  world: PhysicsWorld,
  take: TakeBytes,
  { at, count, sections }: Faces,
  coefficients: readonly number[],
): MemoryRecord {
  const sheet = recordAt(world.memory, take(SHEET_IN_WIND_BYTES, 'wind on cloth'), SHEET_IN_WIND_BYTES);
  const { x, y, z } = world.scratch.at.force;
  sheet.words.set([at, count, sections, world.internal.generations.byteOffset], SheetInWindWord.faces);
  sheet.words.set([x, y, z], SheetInWindWord.forceX);
  sheet.numbers.set(coefficients, SheetInWindNumber.density);
  return sheet;
}
