/** The page docs/forces.md, made from the records the laws return and the headers of their files. */
import { readdirSync, readFileSync } from 'node:fs';
import type { Force } from '@principia/physics';
import * as physics from '@principia/physics';

const folder = 'packages/physics/src/forces';
const pool = { density: 1000, level: 0 };
const triangle = [
  { x: -1, y: -1 },
  { x: 1, y: -1 },
  { x: 0, y: 1 },
];

/** One record of each law, by the function that makes it. */
const EXAMPLES: Record<string, () => Force> = {
  uniformGravity: () => physics.uniformGravity(),
  attractors: () => physics.attractors(),
  uniformSphereGravity: () => physics.uniformSphereGravity({ mu: 1, radius: 1 }),
  enclosedMassGravity: () => physics.enclosedMassGravity({ radii: [1], masses: [1] }),
  paczynskiWiita: () => physics.paczynskiWiita({ mu: 1, horizon: 1 }),
  postNewtonian: () => physics.postNewtonian({ central: 1 }),
  powerLaw: () => physics.powerLaw({ strength: 1, exponent: 1 }),
  vortex: () => physics.vortex({ strength: 1, radius: 1 }),
  lennardJones: () => physics.lennardJones({ depth: 1, diameter: 1 }),
  yukawa: () => physics.yukawa({ strength: 1, range: 1 }),
  fixedCharges: () => physics.fixedCharges(),
  electricField: () => physics.electricField({}),
  magneticField: () => physics.magneticField({}),
  accelerationField: () => physics.accelerationField(() => {}, { potential: () => 0 }),
  forceField: () => physics.forceField(() => {}, { potential: () => 0 }),
  springs: () => physics.springs(),
  linearDrag: () => physics.linearDrag(),
  quadraticDrag: () => physics.quadraticDrag(),
  sphereDrag: () => physics.sphereDrag({ density: 1, viscosity: 1 }),
  turbulentDrag: () => physics.turbulentDrag({ deviation: 1, largest: 1 }),
  lift: () => physics.lift(),
  magnus: () => physics.magnus({ density: 1 }),
  upthrust: () => physics.upthrust(pool),
  polygonUpthrust: () => physics.polygonUpthrust(pool, { shape: 2, vertices: triangle }),
  immersedDrag: () => physics.immersedDrag(pool),
  addedMass: () => physics.addedMass(pool),
  thrust: () => physics.thrust(),
  motors: () => physics.motors(),
  rocketEngines: () => physics.rocketEngines(),
  periodicDrive: () => physics.periodicDrive({ angularFrequency: 1 }),
  randomDrive: () => physics.randomDrive({ spectralDensity: 1 }),
  pointerPull: () => physics.pointerPull(),
  constantTorque: () => physics.constantTorque({}),
  angularDrag: () => physics.angularDrag(),
  stringTension: () => physics.stringTension({ length: 1 }),
  bendGrip: () => physics.bendGrip({ friction: 1 }),
  planeSupport: () => physics.planeSupport(),
};

/** What makes forces of forces, or forces of your own. */
const NOT_LAWS = ['defineForce', 'limited', 'centralForce', 'fieldForce'];

interface Law {
  readonly makers: readonly string[];
  readonly file: string;
  readonly header: string;
}

/** Every file of the folder that makes forces, with the functions that do. */
export function lawFiles(): Law[] {
  return readdirSync(folder)
    .filter((name) => name.endsWith('.ts') && !name.endsWith('.test.ts'))
    .map((file) => ({ file, text: readFileSync(`${folder}/${file}`, 'utf8') }))
    .map(({ file, text }) => ({ file, header: headerOf(text), makers: makersIn(text) }))
    .filter(({ makers }) => makers.length > 0);
}

function makersIn(text: string): string[] {
  const found = [...text.matchAll(/^export function (\w+)\(.*\): (?:Force|PointerPull) \{$/gm)];
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
  const order = Object.keys(EXAMPLES);
  const place = ({ makers }: Law) => Math.min(...makers.map((name) => order.indexOf(name)));
  const sorted = laws.toSorted((a, b) => place(a) - place(b));
  const rows = sorted.flatMap(({ makers, file }) => makers.map((maker) => row(maker, file)));
  return [
    '# The forces',
    '',
    '<!-- Made by `npx vitest run test/docs/forces.test.ts -u` from the records and headers in the source. -->',
    '',
    'Every law of the package: a function makes its record, and `world.forces` lists the records of a world. *Energy* marks',
    'those with a potential, with which `energy(world)` closes. Those marked *last* answer the forces listed before them.',
    'Any of them can be kept to some bodies, places or times by `limited(force, { group, region, from, until })`; one of',
    'your own is [an object](adding-a-force.md). Winds that change are made by `gusts` and `correlatedGusts`; blows by',
    '`applyImpulse` and `explode`.',
    '',
    '| function | law | components it reads | |',
    '|---|---|---|---|',
    ...rows,
    '',
    ...sorted.flatMap(section),
  ].join('\n');
}

function example(maker: string): Force {
  const make = EXAMPLES[maker];
  if (make === undefined) throw new Error(`${maker} makes a force; give it an example in test/docs/force-page.ts.`);
  return make();
}

function row(maker: string, file: string): string {
  const { equation, reads, potential } = example(maker);
  const marks = [
    ...(typeof potential === 'function' ? ['energy'] : []),
    ...(/list it last/i.test(readFileSync(`${folder}/${file}`, 'utf8')) ? ['last'] : []),
  ];
  const law = equation.replaceAll('|', '∣');
  return `| [\`${maker}\`](#${anchor(maker)}) | ${law} | ${reads.join(', ')} | ${marks.join(', ')} |`;
}

function section({ makers, file, header }: Law): string[] {
  const parts = makers.flatMap((maker) => ['', `## ${maker}`, '', ...parametersOf(maker)]);
  return [...parts.slice(1), '```text', header, '```', '', `[${file}](../${folder}/${file})`, ''];
}

function parametersOf(maker: string): string[] {
  const { name, parameters = {} } = example(maker);
  const shown = Object.entries(parameters).map(([key, { unit }]) =>
    unit === '' ? `\`${key}\`` : `\`${key}\` (${unit})`,
  );
  return [`*${name}*${shown.length === 0 ? '' : `. Parameters: ${shown.join(', ')}`}`, ''];
}

function anchor(maker: string): string {
  return maker.toLowerCase();
}

/** Records that could be used on a world: what the test looks at besides the page. */
export function records(): [string, Force][] {
  return Object.keys(EXAMPLES).map((maker) => [maker, example(maker)]);
}
