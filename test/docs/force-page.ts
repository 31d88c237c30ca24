/** The page docs/forces.md, made from the records the laws return, and the headers and declarations of their files. */
import { readdirSync, readFileSync } from 'node:fs';
import { type Force, formulasOf } from '@principia/physics';
import { LAW_RECORDS, makeLaw } from '../support/law-records.ts';
import { type LawCall, lawCall, marked, optionTypes } from './law-options.ts';

const source = 'packages/physics/src';
const folders = ['forces', 'n-body', 'soft-bodies'];

/** What makes forces of forces, or forces of your own. */
const NOT_LAWS = [
  'defineForce',
  'restrictForce',
  'restrictedLaw',
  'centralForce',
  'fieldForce',
  'createMutualForce',
  'replaceForce',
];

interface Law {
  readonly makers: readonly string[];
  readonly file: string;
  readonly header: string;
}

/** Every file of the folder that makes forces, with the functions that do. */
export function lawFiles(): Law[] {
  return folders
    .flatMap((folder) => readdirSync(`${source}/${folder}`).map((name) => `${folder}/${name}`))
    .filter((name) => name.endsWith('.ts') && !name.endsWith('.test.ts'))
    .map((file) => ({ file, text: readFileSync(`${source}/${file}`, 'utf8') }))
    .map(({ file, text }) => ({ file, header: headerOf(text), makers: makersIn(text) }))
    .filter(({ makers }) => makers.length > 0);
}

function makersIn(text: string): string[] {
  const found = [...text.matchAll(/^export function (\w+)\(.*\): (?:\w*Force|PointerPull) \{$/gm)];
  return found.map(([, name]) => name).filter((name) => !NOT_LAWS.includes(name));
}

/** The comment a file begins with. */
function headerOf(text: string): string {
  const lines = text.split('\n');
  const end = lines.findIndex((line) => !line.startsWith('//'));
  return lines
    .slice(0, end)
    .map((line) => line.replace(/^\/\/ ?/, ''))
    .join('\n');
}

export function forcePage(): string {
  const laws = lawFiles();
  const order = LAW_RECORDS.map(({ maker }) => maker);
  const place = ({ makers }: Law) => Math.min(...makers.map((name) => order.indexOf(name)));
  const sorted = laws.toSorted((a, b) => place(a) - place(b));
  const rows = sorted.flatMap(({ makers, file }) => makers.map((maker) => row(maker, file)));
  return [
    '# The forces',
    '',
    '<!-- Made by `npx vitest run test/docs/forces.test.ts -u` from the records, headers and declarations in the source. -->',
    '',
    'All force laws of the package, with formulas, units, validity and cost. A function makes the record of a law, and',
    '`world.forces` lists the records of a world. *Energy* marks',
    'those with a potential, with which `energy(world)` closes. Those marked *last* answer the forces listed before them.',
    'Formulas are typeset from the expressions that are compiled. Any force can be kept to some bodies, places or times by',
    '`restrictForce(force, { group, region, from, until })`, where `group` is a component that the bodies have, by its name or one that you defined; one of your own is [an expression](adding-a-force.md). Winds that change are made by `gusts` and `correlatedGusts`; blows by',
    '`applyImpulse` and `explode`.',
    '',
    'A force restricted to a region has no potential, because energy changes at its border: `energy(world)` does not count it even',
    'within; by group and time it does. Forces in axes of the body, such as `wing`, `thrust` and `rocketEngines`, and `polygonBuoyancy`, are of first order in',
    'the step with every integrator, because all its stages see the orientation of the start of the step: halve the step and the error halves.',
    'Rigid bodies evaluate forces in each sub-step. `magnus`, `lift` and `magneticField` do no work, but schemes of first order, and so rigid bodies,',
    'make what they turn by Ω rad/s faster as e^(Ω² h t/2), with steps or sub-steps of h; a warning tells the rate.',
    '',
    'Each section begins with the call and what it takes; a question mark marks what may be left out. A *vector* is `{ x, y, z }`, of which omitted axes are',
    'zero. One *over time* is a vector, or a function of the time in seconds that returns one.',
    '',
    '| function | law | components it reads | |',
    '|---|---|---|---|',
    ...rows,
    '',
    ...sorted.flatMap(section),
  ].join('\n');
}

function example(maker: string): Force {
  const record = LAW_RECORDS.find((candidate) => candidate.maker === maker);
  if (record === undefined) throw new Error(`${maker} makes a force: give it a line in test/support/law-records.ts.`);
  return makeLaw(record);
}

function row(maker: string, file: string): string {
  const { equation, reads, potential } = example(maker);
  const marks = [
    ...(typeof potential === 'function' ? ['energy'] : []),
    ...(/list it last/i.test(readFileSync(`${source}/${file}`, 'utf8')) ? ['last'] : []),
  ];
  const law = equation.replaceAll('|', '∣');
  return `| [\`${maker}\`](#${anchor(maker)}) | ${law} | ${reads.join(', ')} | ${marks.join(', ')} |`;
}

function section({ makers, file, header }: Law): string[] {
  const parts = makers.flatMap((maker) => [
    '',
    `## ${maker}`,
    '',
    `*${example(maker).name}*`,
    '',
    ...callAndOptions(callOf(maker, file)),
    ...formulas(maker),
  ]);
  return [...parts.slice(1), '```text', header, '```', '', `[${file.replace(/^.*\//, '')}](../${source}/${file})`, ''];
}

const types = optionTypes(folders.map((folder) => `${source}/${folder}`));

/** How a function is called that makes forces. */
export function callOf(maker: string, file: string): LawCall {
  return lawCall(maker, `${source}/${file}`, types);
}

function callAndOptions({ call, options }: LawCall): string[] {
  const rows = options.map((option) => {
    const cells = [`\`${marked(option)}\``, typeName(option.type), option.meaning];
    return `| ${cells.map((cell) => cell.replaceAll('|', '\\|')).join(' | ')} |`;
  });
  const table = rows.length === 0 ? [] : ['| option | type | |', '|---|---|---|', ...rows, ''];
  return ['```ts', call, '```', '', ...table];
}

function typeName(type: string): string {
  if (type === 'number' || type === 'string') return type;
  if (type === 'VectorInput') return 'vector';
  if (type === 'VectorOverTime' || type === 'Wind') return 'vector over time';
  return `\`${type}\``;
}

/** Longer formulas are better read in the header. */
const LONGEST_FORMULA = 260;

/** What the law computes, typeset from its expressions. */
function formulas(maker: string): string[] {
  const { law } = example(maker);
  const lines = law === undefined ? [] : formulasOf(law, 'latex');
  if (lines.length === 0 || lines.some((line) => line.length > LONGEST_FORMULA)) return [];
  return lines.flatMap((line) => ['```math', line, '```', '']);
}

function anchor(maker: string): string {
  return maker.toLowerCase();
}
