/** Addresses of a moment: the step that the run has reached, and the camera. */
import { presentView } from './on-display.ts';
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

/** Takes the moment out of a query. */
export function takeMoment(query: URLSearchParams): Moment {
  const [stepText, cameraText] = [query.get('step'), query.get('camera')];
  for (const name of ['step', 'camera']) query.delete(name);
  const problems: string[] = [];
  let step = Number(stepText ?? 0);
  if (!(Number.isInteger(step) && step >= 0 && step <= MAX_STEPS)) {
    problems.push(WORDS.address.step(MAX_STEPS, stepText ?? ''));
    step = 0;
  }
  const camera = cameraText?.split(',').map(Number);
  const isCamera = camera === undefined || (camera.length >= 3 && camera.every(Number.isFinite));
  if (!isCamera) problems.push(WORDS.address.camera(cameraText ?? ''));
  return { step, camera: isCamera ? camera : undefined, problems };
}

/** Goes to a moment of the run on display, and stops there. */
export async function goTo({ step, camera }: Moment): Promise<void> {
  if (camera !== undefined) presentView()?.setCamera?.(camera);
  if (step === 0) return;
  __game.pause();
  for (let left = step - __game.state().tick; left > 0; left -= CHUNK) {
    __game.step(Math.min(CHUNK, left));
    await new Promise((done) => setTimeout(done));
  }
}

/** The address of what is on display now. */
export function momentAddress(): string {
  const address = new URL(location.href);
  address.searchParams.set('step', String(__game.state().tick));
  const camera = presentView()?.camera?.();
  if (camera !== undefined)
    address.searchParams.set('camera', camera.map((value) => Number(value.toPrecision(6))).join());
  return address.href.replaceAll('%2C', ',');
}
