/** Addresses of a moment: the step that the run has reached, the camera, and the plots. */
import { FIRST_PLOT } from '@principia/shell';
import { presentRun, presentView, recordTrails } from './on-display.ts';
import { writeShownPlots } from './shown-plots.ts';
import { WORDS } from './words.ts';

/** Steps taken at once, so that the page stays alive, and in all. */
const CHUNK = 200;
const MAX_STEPS = 200_000;

/** A step and a camera, as the address names them. */
export interface Moment {
  readonly step: number;
  readonly camera: readonly number[] | undefined;
  /** One sentence for each part that was rejected. */
  readonly problems: readonly string[];
}

/** What follows the # in links: the reader's own code, where that runs. */
let code = '';

/** Lets links carry the code that runs, as `codeHash` writes it. */
export function carryCode(hash: string): void {
  code = hash;
}

/** The part of an address that names its moment, empty if none does: opening takes it out. */
export function momentOf(query: URLSearchParams): string {
  const own = [...query].filter(([name]) => name === 'step' || name === 'camera');
  return new URLSearchParams(own).toString().replaceAll('%2C', ',');
}

/** Numbers of a camera: centre and height of the window, or the places of the camera and of what it looks at. */
const CAMERA_NUMBERS = { 2: 3, 3: 6 } as const;
/** Largest of these numbers, m. */
const FARTHEST = 1e15;

/** Takes the moment out of a query. */
export function takeMoment(query: URLSearchParams, dimensions: 2 | 3): Moment {
  const [stepText, cameraText] = [query.get('step'), query.get('camera')];
  for (const name of ['step', 'camera']) query.delete(name);
  const problems: string[] = [];
  let step = Number(stepText ?? 0);
  if (!(Number.isInteger(step) && step >= 0 && step <= MAX_STEPS)) {
    problems.push(WORDS.address.step(MAX_STEPS, stepText ?? ''));
    step = 0;
  }
  const camera = cameraText?.split(',').map(Number);
  const isRight = camera === undefined || isCamera(camera, dimensions);
  if (!isRight) problems.push(WORDS.address.camera(CAMERA_NUMBERS[dimensions], cameraText ?? ''));
  return { step, camera: isRight ? camera : undefined, problems };
}

function isCamera(numbers: readonly number[], dimensions: 2 | 3): boolean {
  const isNear =
    numbers.length === CAMERA_NUMBERS[dimensions] && numbers.every((number) => Math.abs(number) < FARTHEST);
  // A camera looks at another place than its own, and a window has a height.
  const looks = dimensions === 3 ? [0, 1, 2].some((i) => numbers[i] !== numbers[i + 3]) : numbers[2] > 0;
  return isNear && looks;
}

/** Goes to a moment of the run on display, and stops there. */
export async function goTo({ step, camera }: Moment): Promise<void> {
  if (camera !== undefined) presentView()?.setCamera?.(camera);
  if (step === 0) return;
  __game.pause();
  // Trails get the poses that frames would have shown.
  const stepsPerFrame = Math.max(1, Math.round(1 / (60 * (presentRun()?.dt ?? 1))));
  const start = __game.state().tick;
  let pause = start + CHUNK;
  for (let tick = start; tick < step; tick += stepsPerFrame) {
    __game.step(Math.min(stepsPerFrame, step - tick));
    recordTrails();
    if (tick < pause) continue;
    pause += CHUNK;
    await new Promise((done) => setTimeout(done));
  }
}

/** Whether links can name the step that the run has reached: opening one takes all steps before. */
export const isNameable = (): boolean => __game.state().tick <= MAX_STEPS;

/** The address of what is on display now, from the start of the run where its step is too late to be named. */
export function momentAddress(): string {
  const address = new URL(location.href);
  const { tick, plot = FIRST_PLOT } = __game.state();
  if (isNameable()) address.searchParams.set('step', String(tick));
  else address.searchParams.delete('step');
  if (code !== '') address.hash = code;
  if (plot === FIRST_PLOT) address.searchParams.delete('plot');
  else address.searchParams.set('plot', plot);
  writeShownPlots(address.searchParams);
  const camera = presentView()?.camera?.();
  if (camera !== undefined)
    address.searchParams.set('camera', camera.map((value) => Number(value.toPrecision(6))).join());
  return address.href.replaceAll('%2C', ',');
}
