/** The tables of docs/presets.md: the systems that each preset puts into each phase of a new world. */
import * as physics from '@principia/physics';
import { createPhysicsWorld, PHASES, type Preset, type System } from '@principia/physics';
import { integrate } from '../../packages/physics/src/dynamics/integrate.ts';
import { integrateRotation } from '../../packages/physics/src/dynamics/integrate-rotation.ts';
import { breakJoints } from '../../packages/physics/src/joints/create-joint.ts';
import { dispatchFaultEvents } from '../../packages/physics/src/world/event-handlers.ts';

export const PRESETS: Readonly<Record<string, Preset>> = {
  standard: physics.standard,
  particleContacts: physics.particleContacts,
  rigidBodies: physics.rigidBodies,
};

/** Systems by the names under which the sources export them. */
const NAMED: Readonly<Record<string, unknown>> = {
  ...physics,
  integrate,
  integrateRotation,
  dispatchFaultEvents,
  breakJoints,
};

function nameOf(system: System): string {
  const found = Object.entries(NAMED).find(([, value]) => value === system);
  if (found === undefined) throw new Error(`test/docs/presets-table.ts has no name for the system ${system.name}.`);
  return `\`${found[0]}\``;
}

export function presetsTable(): string {
  const names = Object.keys(PRESETS);
  const worlds = names.map((name) => createPhysicsWorld({ preset: PRESETS[name] as Preset, capacity: 10 }));
  const cells = (phase: (typeof PHASES)[number]) => worlds.map(({ phases }) => phases[phase].map(nameOf).join(', '));
  return [
    `| phase | ${names.map((name) => `\`${name}\``).join(' | ')} |`,
    `|---|${'---|'.repeat(names.length)}`,
    ...PHASES.map((phase) => `| \`${phase}\` | ${cells(phase).join(' | ')} |`),
  ].join('\n');
}
