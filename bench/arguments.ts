import { existsSync, statSync } from 'node:fs';
import { dirname, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { INTEGRATORS, type IntegratorName, type Precision } from '@principia/physics';
import { findScene, SCENES, type Scene, type SceneParameter } from '@principia/scenes';
import { LAW_COUNTS, type Variant } from './particles-variants.ts';
import { peersOf } from './peers/all.ts';
import { countsBetween } from './scaling.ts';

/** The options of the command line. */
export type Request = { readonly kind: 'help' } | { readonly kind: 'list' } | RunRequest;

export interface RunRequest {
  readonly kind: 'run';
  readonly scene: Scene;
  readonly count: number;
  /** Number of steps; the first `warmup` of them are not timed. */
  readonly steps: number;
  readonly warmup: number;
  readonly dimensions: 2 | 3;
  readonly precision: Precision;
  readonly seed: number;
  /** Undefined selects the scene's default. */
  readonly integrator: IntegratorName | undefined;
  /** Options of the scene `particles`. */
  readonly variant: Variant;
  readonly peers: boolean;
  /** Further counts at which a step is timed; undefined for none. */
  readonly scaling: readonly number[] | undefined;
  readonly json: string | undefined;
  readonly html: string | undefined;
  /** The scene parameters that were given. */
  readonly parameters: Readonly<Record<string, number>>;
}

/** An invalid command line; the message is one sentence for the user. */
export class ArgumentError extends Error {}

const OPTIONS = {
  count: { type: 'string' },
  steps: { type: 'string' },
  warmup: { type: 'string' },
  dimensions: { type: 'string' },
  precision: { type: 'string' },
  seed: { type: 'string' },
  integrator: { type: 'string' },
  resting: { type: 'boolean' },
  laws: { type: 'string' },
  peers: { type: 'boolean' },
  scaling: { type: 'string' },
  json: { type: 'string' },
  html: { type: 'string' },
  list: { type: 'boolean' },
  help: { type: 'boolean' },
} as const;

/** Parameters of scenes, as options: relativeError is --relative-error. Those that are options of the bench stay its own. */
const PARAMETERS = new Map(
  SCENES.flatMap(({ parameters }) => Object.keys(parameters))
    .filter((name) => !(name in OPTIONS))
    .map((name) => [name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`), name]),
);

const MAX_STEPS = 1_000_000;
const optionNames = Object.keys(OPTIONS).map((name) => `--${name}`);
const integratorNames = Object.keys(INTEGRATORS) as IntegratorName[];
const sceneNames = SCENES.map(({ name }) => name);

/**
 * Reads the command line and looks whether everything it names is there, so that nothing is measured in vain.
 * @throws ArgumentError
 */
export function readArguments(args: readonly string[]): Request {
  const { values, positionals } = parse(args);
  if (values.help) return { kind: 'help' };
  if (values.list) return { kind: 'list' };
  const scene = sceneOf(positionals);
  const { count } = scene.parameters;
  const steps = wholeNumber('steps', values.steps, 200, 1, MAX_STEPS);
  const warmup = wholeNumber('warmup', values.warmup, Math.min(20, Math.floor(steps / 5)), 0, steps - 1);
  const peers = values.peers ?? false;
  if (peers && steps - warmup < peersOf(scene.name).length) {
    const least = peersOf(scene.name).length;
    throw new ArgumentError(`--peers needs at least ${least} timed steps here, and ${steps - warmup} are left.`);
  }
  return {
    kind: 'run',
    scene,
    count: wholeNumber('count', values.count, count.initial, count.min, count.max),
    steps,
    warmup,
    dimensions: choice('dimensions', values.dimensions ?? '2', ['2', '3']) === '2' ? 2 : 3,
    precision: choice('precision', values.precision ?? scene.precision, ['f32', 'f64']),
    seed: wholeNumber('seed', values.seed, 1, 0, Number.MAX_SAFE_INTEGER),
    integrator: values.integrator === undefined ? undefined : choice('integrator', values.integrator, integratorNames),
    variant: variantOf(scene, values.resting, values.laws),
    peers,
    scaling: scalingOf(scene, values.scaling),
    json: outputFile('json', values.json),
    html: outputFile('html', values.html),
    parameters: { ...awakeForPeers(scene, peers), ...parametersOf(scene, values as Record<string, unknown>) },
  };
}

function parse(args: readonly string[]) {
  try {
    const more = Object.fromEntries([...PARAMETERS.keys()].map((option) => [option, { type: 'string' as const }]));
    const { values, positionals } = parseArgs({
      args: [...args],
      options: { ...more, ...OPTIONS },
      allowPositionals: true,
    });
    return { values, positionals };
  } catch (error) {
    const problem = (error as Error).message.split(/[.\n]/)[0] as string;
    throw new ArgumentError(`${problem}: the options are ${optionNames.join(', ')}.`);
  }
}

function sceneOf(positionals: readonly string[]): Scene {
  const [name, ...more] = positionals;
  const list = sceneNames.join(', ');
  if (name === undefined) throw new ArgumentError(`Name the scene to measure: ${list}.`);
  if (more.length > 0) throw new ArgumentError(`Only one scene can be measured at a time, one of ${list}.`);
  const scene = findScene(name);
  if (scene === undefined) throw new ArgumentError(`There is no scene "${name}": the scenes are ${list}.`);
  return scene;
}

/** Rigid bodies are compared with other engines while nothing sleeps. */
const awakeForPeers = (scene: Scene, peers: boolean) =>
  peers && 'sleeping' in scene.parameters ? { sleeping: 0 } : {};

/** Only `particles` has variants. */
function variantOf(scene: Scene, resting = false, laws: string | undefined): Variant {
  if (scene.name !== 'particles' && (resting || laws !== undefined)) {
    throw new ArgumentError(`Only the scene particles has --${resting ? 'resting' : 'laws'}.`);
  }
  const count = choice('laws', laws ?? '2', LAW_COUNTS.map(String));
  return { resting, laws: Number(count) as Variant['laws'] };
}

/** The scene parameters that were given, checked against their ranges. */
function parametersOf(scene: Scene, values: Readonly<Record<string, unknown>>): Record<string, number> {
  const given: Record<string, number> = {};
  for (const [option, name] of PARAMETERS) {
    const text = values[option];
    if (typeof text !== 'string') continue;
    const parameter = (scene.parameters as Record<string, SceneParameter | undefined>)[name];
    if (parameter === undefined) throw new ArgumentError(`The scene ${scene.name} has no --${option}.`);
    const { min, max, integer = false } = parameter;
    const value = text.trim() === '' ? Number.NaN : Number(text);
    if (!(value >= min && value <= max) || (integer && !Number.isInteger(value))) {
      const kind = integer ? 'a whole number' : 'a number';
      throw new ArgumentError(`--${option} must be ${kind} from ${min} to ${max}, not "${text}".`);
    }
    given[name] = value;
  }
  return given;
}

function wholeNumber(option: string, text: string | undefined, initial: number, min: number, max: number): number {
  const value = text === undefined ? initial : /^\d+(e\d+)?$/.test(text) ? Number(text) : Number.NaN;
  if (value >= min && value <= max) return value;
  throw new ArgumentError(`--${option} must be a whole number from ${min} to ${max}, not "${text ?? value}".`);
}

/** The counts of FROM-TO. */
function scalingOf({ parameters: { count } }: Scene, text: string | undefined): number[] | undefined {
  if (text === undefined) return undefined;
  const [from, to, ...more] = text.split('-').map((part) => (/^\d+(e\d+)?$/.test(part) ? Number(part) : Number.NaN));
  if (from >= Math.max(2, count.min) && to > from && to <= count.max && more.length === 0)
    return countsBetween(from, to);
  throw new ArgumentError(
    `--scaling must be two counts such as ${Math.max(2, count.min)}-${count.max}, within these, not "${text}".`,
  );
}

function choice<const T extends string>(option: string, value: string, choices: readonly T[]): T {
  if ((choices as readonly string[]).includes(value)) return value as T;
  throw new ArgumentError(`--${option} must be ${choices.join(' or ')}, not "${value}".`);
}

function outputFile(option: string, file: string | undefined): string | undefined {
  if (file === undefined) return undefined;
  const path = resolve(file);
  const isFolder = existsSync(path) && statSync(path).isDirectory();
  if (file === '' || isFolder || !existsSync(dirname(path))) {
    throw new ArgumentError(`--${option} must be a file in a folder that exists, not "${file}".`);
  }
  return path;
}

/** The output of `--list`. */
export function sceneList(): string {
  const width = Math.max(...sceneNames.map((name) => name.length)) + 2;
  return SCENES.map(({ name, description }) => `${name.padEnd(width)}${description}`).join('\n');
}

/** The output of `--help`. */
export function helpText(): string {
  return `Measures a scene headlessly: npm run bench -- <scene> [options]

Scenes
${sceneList().replace(/^/gm, '  ')}

Options
  --count N           how many bodies, springs or particles (the scene's own default)
  --steps N           steps in all (200); the state after them is what the hash is of
  --warmup N          the first N of them are not timed (20, or a fifth of the steps)
  --dimensions 2|3    (2)
  --precision f32|f64 type of every column (the scene's own)
  --seed S            equal seeds give equal states (1)
  --integrator NAME   the scheme, such as rungeKutta4 (the scene's own)
  --resting           particles only: all of them on the floor, where every step presses them on it
  --laws 2|3|5|8      particles only: how many laws of force act on each (2)
  --peers             measure other ways to do the same work, step by step in turn with ours
  --scaling FROM-TO   measure at counts from 1e4 to 1e6, say, too: how the cost grows
  --json FILE         write the result as JSON
  --html FILE         write a report that opens in any browser, offline
  --list              list the scenes
  --help              this text

The scene's own parameters are options too, such as --relative-error 0.01 of nbody-tree.`;
}
