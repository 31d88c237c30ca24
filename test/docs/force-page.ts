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
    'Limits of time of `restrictForce` are rounded to the stages of a step: the force is asked there whether it acts. What it gives, F (until - from), is therefore',
    'off by at most F dt, one step of it, with `yoshida4` by two and with `yoshida6` and `positionVerlet` by one and a half; torques and fuel are decided at the start',
    'of the step. `dormandPrince` and `gaussRadau` take sub-steps at the jump and are off by less than a tenth of a step, but may report E_STEP there.',
    '',
    'A force restricted to a region has no potential, because energy changes at its border: `energy(world)` does not count it even',
    'within; by group and time it does. Forces in axes of the body, such as `wing`, `thrust` and `rocketEngines`, and `polygonBuoyancy`, are of first order in',
    'the step with every integrator, because all its stages see the orientation of the start of the step: halve the step and the error halves.',
    'Rigid bodies evaluate forces in each sub-step.',
    '',
    '`magnus`, `lift` and `magneticField` do no work, but with steps or sub-steps of h the schemes change the speed of what they turn by Ω rad/s, with θ = Ω h:',
    "Euler's, and so rigid bodies and `wisdomHolman`, make it √(1 + θ²) times as large in each, about e^(Ω² h t/2); `velocityVerlet`, `midpoint` and `heun`",
    '√(1 + θ⁴/4) times, and `positionVerlet` about 1 + θ⁴/4 times; `rungeKutta4` makes it √(1 - θ⁶/72 + θ⁸/576) times as large, and `implicitEuler` 1/√(1 + θ²)',
    'times. A warning tells the rate where that is more than 1 % in a minute, and more than drag takes; `leapfrog`, `driftKickDrift`, `yoshida4` and `yoshida6` are',
    'warned of whatever the step. Only `boris` keeps the speed, that of charges in a magnetic field.',
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
