/** Reads the map of a world's first bytes, `kernels/memory/low-memory-map.ts`, and checks that what goes there fits. */
import { existsSync, readFileSync } from 'node:fs';

const MAP = 'memory/low-memory-map.ts';

/** Bytes at the start of the memory that nothing may use. */
const GUARD = 64;

/** Vectors are aligned to this many bytes. */
const ALIGNMENT = 16;

/**
 * @typedef {{ start: number, end: number }} Room addresses in a world's memory
 * @typedef {Map<string, Room>} LowMemoryMap by name; the last one, where columns begin, has no end
 * @param {string} folder the folder of the kernels
 * @returns {LowMemoryMap}
 */
export function readLowMemoryMap(folder) {
  if (!existsSync(`${folder}/${MAP}`)) throw new Error(`${folder}/${MAP} is missing: it says where constants go.`);
  const text = readFileSync(`${folder}/${MAP}`, 'utf8');
  const ranges = [...text.matchAll(/^export const (\w+): usize = (\d+);$/gm)].map(([, name, start]) => ({
    name,
    start: Number(start),
  }));
  let lowest = GUARD;
  for (const { name, start } of ranges) {
    if (start >= lowest && start % ALIGNMENT === 0) lowest = start + ALIGNMENT;
    else throw wrong(`${name} is ${start}, but must be a multiple of ${ALIGNMENT} and at least ${lowest}`);
  }
  if (ranges.at(-1)?.name !== 'FIRST_COLUMN') throw wrong('FIRST_COLUMN must be the last range');
  const ends = ranges.map((_, i) => ranges[i + 1]?.start ?? Number.POSITIVE_INFINITY);
  return new Map(ranges.map(({ name, start }, i) => [name, { start, end: ends[i] }]));
}

/**
 * The range of that name, after a check that it holds so many bytes.
 * @param {LowMemoryMap} map
 * @param {string} name
 * @param {number} bytes
 * @param {string} what what goes there
 * @returns {Room}
 */
export function roomFor(map, name, bytes, what) {
  const room = map.get(name);
  if (room === undefined) throw wrong(`${what} has no range: add ${name}`);
  if (room.end - room.start >= bytes) return room;
  throw wrong(`${what} takes ${bytes} bytes, but ${name} reaches from ${room.start} to ${room.end}: make it longer`);
}

/**
 * The name of the range for the constants of a module: PARTICLE_CONTACTS_CONSTANTS for particle-contacts.
 * @param {string} module
 */
export const constantsOf = (module) => `${module.replaceAll('-', '_').toUpperCase()}_CONSTANTS`;

/** @param {string} fault */
const wrong = (fault) => new Error(`kernels/${MAP}: ${fault}.`);
