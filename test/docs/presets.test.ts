import { readFileSync } from 'node:fs';
import { boxWalls, createPhysicsWorld, type Preset, spawn, step } from '@principia/physics';
import { expect, test } from 'vitest';
import * as indexOfPresets from '../../packages/physics/src/presets/particle-contacts.ts';
import * as rigidPreset from '../../packages/physics/src/presets/rigid-bodies.ts';
import * as standardPreset from '../../packages/physics/src/presets/standard.ts';
import { withMarkedPart } from './marked-table.ts';
import { PRESETS, presetsTable } from './presets-table.ts';

const page = readFileSync('docs/presets.md', 'utf8');

test('docs/presets.md lists what presets run; `npx vitest run test/docs/presets.test.ts -u` writes it', async () => {
  await expect(withMarkedPart(page, presetsTable())).toMatchFileSnapshot('../../docs/presets.md');
});

test('every preset of the package is listed', () => {
  expect(Object.values(PRESETS)).toEqual([
    ...Object.values(standardPreset),
    ...Object.values(indexOfPresets),
    ...Object.values(rigidPreset),
  ]);
});

/** How fast a body falls, upwards, after it met something that lies at the origin. */
function speedAfter(preset: Preset, walls: boolean, obstacle: Parameters<typeof spawn>[1]): number {
  const world = createPhysicsWorld({ preset, walls: walls ? [boxWalls({ min: { y: -0.5 } })] : [] });
  spawn(world, obstacle);
  const collider = { radius: 0.5, restitution: 1 };
  const ball = spawn(world, { position: { y: 0.6 }, velocity: { y: -10 }, mass: 1, collider });
  for (let i = 0; i < 10; i++) step(world, 0.01);
  return world.components.Velocity.y[ball] as number;
}

const OBSTACLES = {
  Collider: { position: { y: -0.5 }, collider: { radius: 0.5, restitution: 1 } },
  SegmentWall: { segmentWall: { ax: -1, bx: 1, restitution: 1 } },
  PlaneWall: { planeWall: { restitution: 1 } },
};

test.each(Object.entries(OBSTACLES))(
  'standard ignores %s between bodies, and particleContacts does not',
  (_, obstacle) => {
    expect(speedAfter(PRESETS.standard as Preset, false, obstacle)).toBe(-10);
    expect(speedAfter(PRESETS.particleContacts as Preset, false, obstacle)).toBeCloseTo(10, 9);
  },
);

test('boxWalls turn a body back in every preset, and rigidBodies knows all walls', () => {
  for (const preset of [PRESETS.standard, PRESETS.particleContacts]) {
    expect(speedAfter(preset as Preset, true, { position: { x: 50 } })).toBeCloseTo(10, 9);
  }
  const { rigidBodies } = PRESETS;
  for (const [name, obstacle] of Object.entries({ boxWalls: { position: { x: 50 } }, ...OBSTACLES })) {
    expect(speedAfter(rigidBodies as Preset, name === 'boxWalls', obstacle), name).toBeGreaterThan(9);
  }
});
