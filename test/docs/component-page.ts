/** The page docs/components.md, made from the records of the components, the comments beside them, and the laws. */
import { readdirSync, readFileSync } from 'node:fs';
import { COMPONENT_NAMES, COMPONENTS, type ComponentName, type FieldSpec } from '@principia/physics';
import { LAW_RECORDS, makeLaw } from '../support/law-records.ts';

const source = 'packages/physics/src/components';
const texts = readdirSync(source)
  .filter((name) => name.endsWith('.ts'))
  .map((name) => readFileSync(`${source}/${name}`, 'utf8'));

/** A component that more laws than this read does not get their names. */
const MAX_LAWS_NAMED = 12;

/** What reads a component besides the laws. The test checks that every name in backticks exists. */
export const OTHER_READERS: Partial<Record<ComponentName, string>> = {
  Position: 'everything',
  Velocity: 'every integrator, walls, contacts, `energy`, `momentum`',
  Mass: 'every integrator, walls, contacts, `xpbd`, `energy`, `momentum`, `totalMass`',
  Inertia:
    'the integration of rotation, the preset `rigidBodies`, contacts and wall entities (friction turns a body), `explode`, `energy`',
  InertiaTensor: 'the integration of rotation in 3D, `applyImpulse`, `angularMomentum`, `energy`',
  Rotation: 'the integration of rotation in 2D, renderers',
  Orientation: 'the integration of rotation in 3D, renderers',
  AngularVelocity: 'the integration of rotation, contacts and wall entities, `angularMomentum`, `energy`',
  Collider:
    'the preset `rigidBodies`, `boxWalls`, `segmentWalls`, `planeWalls`, `collideBodies`, `mergeOnContact`, `bodyAt`, renderers',
  Appearance: 'renderers, `bodyAt`',
  Joint: 'the preset `rigidBodies`',
  Spring: 'the force `springs`, `xpbd`, `breakSprings`, `maxStrain`, `rmsStrain`',
  SegmentWall: '`segmentWalls`, in the preset `particleContacts`; the preset `rigidBodies`',
  PlaneWall: '`planeWalls`, in the preset `particleContacts`; the preset `rigidBodies`',
  Attachment: 'the preset `rigidBodies`, queries, `bodyOf`, `partsOf`',
  Kinematic: 'the preset `rigidBodies`',
  MotionLocks: 'the preset `rigidBodies`',
  NeverSleep: 'the preset `rigidBodies`',
  Attractor: 'the force `attractors`',
  TestParticle: '`mutualGravity`, `mutualCoulomb`',
  Quarantined: 'nothing: `query` it, or read `world.faults`',
};

export function componentPage(): string {
  return [
    '# The components',
    '',
    '<!-- Made by `npx vitest run test/docs/components.test.ts -u` from the records and comments in the source. -->',
    '',
    'All components of a world, with units, defaults, bounds, and what reads them. A component is a set of columns.',
    '`spawn(world, { mass: 2, velocity: { x: 3 } })` and',
    '`addComponent(world, id, set(world.components.Mass, { value: 2 }))` set fields; a field that is left out gets its',
    'default. `spawn` writes the name with a small first letter. Some components can be given as a bare number, which',
    'sets the field that is named. A value outside its bounds is refused with a `PhysicsError`. A value written straight',
    'into a column is not checked there: the step caps speeds, and quarantines a body that is not finite or out of range.',
    'Write straight into a column only for bodies that have the component, and give it to the others with `addComponent`.',
    'Of a body without it, the values of `Collider`, `GravityScale` and `MotionLocks` have no effect, nor do those of',
    'entities that are made with their component, such as `Attractor`, walls, springs and joints. Coefficients of forces,',
    'such as `LinearDrag`, and `Mass` and `Inertia` act all the same, but are not part of `stateHash` nor checked while no',
    'body has the component.',
    'Fields marked *3D* must be 0 in a world of two dimensions. Renderers read columns too: see [drawing](drawing.md).',
    'Components of your own: `defineComponent`, see [adding a force](adding-a-force.md#with-a-component-of-your-own).',
    'Of the observers of bitECS, `onSet` gets the values; `onAdd` reads defaults, or zeros within a step, and `onRemove` reads columns',
    'that may be zero already: read what you need of a body, such as where an explosion is to be, before you despawn it.',
    '',
    '| component | fields | meaning |',
    '|---|---|---|',
    ...COMPONENT_NAMES.map(row),
    '',
    ...COMPONENT_NAMES.flatMap(section),
  ].join('\n');
}

function row(name: ComponentName): string {
  const fields = Object.keys(COMPONENTS[name].fields);
  const comment = commentOf(name);
  const [sentence] = /^(?:[23]D: )?.*?[.:;](?= |$)/.exec(comment) ?? [comment];
  return `| [\`${name}\`](#${name.toLowerCase()}) | ${fields.join(', ')} | ${escaped(sentence.replace(/[:;]$/, '.'))} |`;
}

function section(name: ComponentName): string[] {
  const { fields, ...spec } = COMPONENTS[name] as { fields: Record<string, FieldSpec>; scalar?: string };
  const rows = Object.entries(fields).map(([field, facts]) => fieldRow(name, field, facts));
  const table = ['| field | unit | default | bounds | |', '|---|---|---|---|---|', ...rows, ''];
  return [
    `## ${name}`,
    '',
    commentOf(name),
    ...(spec.scalar === undefined ? [] : [`A bare number sets \`${spec.scalar}\`.`]),
    '',
    ...(rows.length === 0 ? ['It has no fields: an entity has it or not.', ''] : table),
    `Read by: ${readersOf(name)}.`,
    '',
  ];
}

function fieldRow(name: ComponentName, field: string, facts: FieldSpec): string {
  const { unit, initial, infinite, spatial } = facts;
  const notes = [
    // A column of the table has the default.
    commentOf(name, field).replace(/; default -?[\d.]*\d/, ''),
    spatial === true ? '*3D*' : '',
    infinite === undefined ? '' : `\`Infinity\` is taken and stored as ${plain(infinite)}.`,
  ];
  const cells = [`\`${field}\``, unit, plain(initial), boundsOf(facts), escaped(notes.filter(Boolean).join(' '))];
  return `| ${cells.join(' | ')} |`;
}

function boundsOf({ kind, bounds }: FieldSpec): string {
  const { min = -Infinity, max = Infinity, above = -Infinity, integer } = bounds;
  const whole = integer ? 'whole number, ' : '';
  if (kind === 'u32' && max === 0xffffffff)
    return `${whole}${min === 0 ? 'up to 2³² − 1' : `${plain(min)} to 2³² − 1`}`;
  if (min === -Infinity && above === -Infinity && max === Infinity) return 'finite';
  if (min === -max) return `${whole}±${plain(max)}`;
  return `${whole}${above >= min ? `above ${plain(above)}, ` : ''}${plain(Math.max(min, above))} to ${plain(max)}`;
}

/** Large round numbers as powers of ten, such as 1e38; others as they are, such as 299792458. */
function plain(value: number): string {
  const power = value.toExponential().replace('e+', 'e');
  return Math.abs(value) >= 1e6 && power.length < 6 ? power : String(value).replace('e+', 'e');
}

function readersOf(name: ComponentName): string {
  const laws = LAW_RECORDS.filter((record) => makeLaw(record).reads.includes(name)).map(({ maker }) => maker);
  const makers = [...new Set(laws)];
  const named = makers.map((maker) => `[\`${maker}\`](forces.md#${maker.toLowerCase()})`).join(', ');
  const shown = makers.length > MAX_LAWS_NAMED ? 'many of [the laws](forces.md)' : named;
  return [OTHER_READERS[name] ?? '', shown].filter(Boolean).join('; ');
}

/** The comment before a component, or before one of its fields, as one line. */
function commentOf(name: ComponentName, field?: string): string {
  const comment = /\/\*\*((?:(?!\*\/)[\s\S])*)\*\/\s*$/;
  const text = texts.find((candidate) => candidate.includes(`export const ${name} = defineComponent`)) ?? '';
  const start = text.indexOf(`export const ${name} = defineComponent`);
  const body = bodyOf(text, name, start);
  const before =
    field === undefined ? text.slice(0, start) : body.slice(0, body.search(new RegExp(`^ +${field}: `, 'm')));
  const [, found = ''] = comment.exec(before) ?? [];
  return found.replaceAll(/\s*\n\s*\*\s?/g, ' ').trim();
}

/** The fields of a component with their comments: its type has them, where there is one. */
function bodyOf(text: string, name: ComponentName, start: number): string {
  const type = text.indexOf(`export type ${name}Fields = {`);
  return type < 0 ? text.slice(start, text.indexOf('\n});', start)) : text.slice(type, text.indexOf('\n};', type));
}

function escaped(text: string): string {
  return text.replaceAll('|', '∣');
}
