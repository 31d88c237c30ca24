/** Worlds of three dimensions warn of what only those of two have, and of spins that turn nothing. */
import {
  createPhysicsWorld,
  magnus,
  type PhysicsWorldOptions,
  particleContacts,
  spawn,
  step,
  uniformGravity,
} from '@principia/physics';
import { expect, it } from 'vitest';

function warningsOf(options: PhysicsWorldOptions, body: Parameters<typeof spawn>[1]): string[] {
  const warnings: string[] = [];
  const onWarning = ({ message, hint }: { message: string; hint: string }) => warnings.push(`${message} ${hint}`);
  const world = createPhysicsWorld({ dimensions: 3, preset: particleContacts, capacity: 10, onWarning, ...options });
  spawn(world, body);
  for (let i = 0; i < 3; i++) step(world, 0.01);
  return warnings;
}

it('a segment as a wall, an angle, and a spin without an orientation in three dimensions', () => {
  expect(warningsOf({}, { segmentWall: { ax: -9, bx: 9 } })).toEqual([expect.stringMatching(/SegmentWall.*planeWall/)]);
  expect(warningsOf({}, { position: {}, rotation: 1 })).toEqual([expect.stringMatching(/Rotation.*orientation/)]);
  const spinning = { position: {}, velocity: {}, mass: 1, inertia: 1, angularVelocity: { z: 1 } };
  expect(warningsOf({}, spinning)).toEqual([expect.stringMatching(/body 1.*no Orientation.*orientation/)]);
});

it('is silent where they are meant', () => {
  const flat = { dimensions: 2 } as const;
  expect(warningsOf(flat, { segmentWall: { ax: -9, bx: 9 } })).toEqual([]);
  expect(warningsOf(flat, { position: {}, rotation: 1, angularVelocity: 1, mass: 1, inertia: 1 })).toEqual([]);
  const spinning = { position: {}, velocity: { x: 1 }, mass: 1, inertia: 1, angularVelocity: { z: 1 } };
  expect(warningsOf({}, { ...spinning, orientation: {} })).toEqual([]);
  expect(warningsOf({ forces: [uniformGravity()] }, { ...spinning, collider: 0.1 })).toEqual([]);
  expect(warningsOf({ forces: [magnus({ density: 1.2 })] }, { ...spinning, collider: 0.1 })).toEqual([]);
});

it('the hint about walls names the system that was taken out', () => {
  const warnings: string[] = [];
  const onWarning = ({ hint }: { hint: string }) => warnings.push(hint);
  const world = createPhysicsWorld({ preset: particleContacts, capacity: 10, onWarning });
  spawn(world, { segmentWall: { ax: -9, bx: 9 } });
  world.phases.walls.splice(0, 1);
  step(world, 0.01);
  expect(warnings).toEqual([expect.stringMatching(/Put "segment walls" back.*replaceBoxWalls/)]);
});
