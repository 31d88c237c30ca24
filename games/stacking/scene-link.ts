/** A build as text for a link: its numbers, compressed, in URL-safe base64. */
import { destroyWorld } from '@principia/physics';
import { initialValues, packText, unpackText } from '@principia/shell';
import type { SavedScene } from './saved-scene.ts';
import { settings } from './settings.ts';
import { createSim } from './sim.ts';
import { WORDS } from './words.ts';

/** Bodies of a link at most: links of more than some thousand characters are cut off by programs that carry them. */
export const MAX_BODIES = 250;
const VERSION = '1.';

/** The text of a scene. @throws Error with a sentence where there are too many bodies */
export async function writeScene(scene: SavedScene): Promise<string> {
  const { length } = scene.bodies;
  if (length > MAX_BODIES) throw new Error(WORDS.tooMany(MAX_BODIES, length));
  return VERSION + (await packText(JSON.stringify(scene)));
}

/** @throws Error with a sentence that says what is wrong with the text */
export async function readScene(text: string): Promise<SavedScene> {
  if (!text.startsWith(VERSION)) throw broken(WORDS.broken.version);
  const scene = await unpacked(text);
  try {
    // Only a world knows whether it takes all shapes, bodies and joints.
    destroyWorld(createSim({ values: initialValues(settings), seed: 1, scene }).world);
  } catch {
    throw broken(WORDS.broken.impossible);
  }
  return scene;
}

async function unpacked(text: string): Promise<SavedScene> {
  try {
    return checked(JSON.parse(await unpackText(text.slice(VERSION.length))));
  } catch {
    throw broken(WORDS.broken.incomplete);
  }
}

/** @throws Error where a value is not a list of finite numbers, or refers to what is not there */
function checked({ shapes, bodies: list, joints }: SavedScene): SavedScene {
  const areNumbers = (rows: readonly (readonly number[])[]) => rows.every((row) => row.every(Number.isFinite));
  if (![shapes, list, joints].every(areNumbers) || list.length > MAX_BODIES) throw new Error('not a scene');
  const isPlace = (index: number, least: number, count: number) => index >= least && index < count;
  if (!list.every(([shape]) => isPlace(shape, 0, shapes.length))) throw new Error('no such shape');
  if (!joints.every(([a, b]) => isPlace(a, -1, list.length) && isPlace(b, 0, list.length)))
    throw new Error('no such body');
  return { shapes, bodies: list, joints };
}

function broken(why: string): Error {
  return new Error(WORDS.broken.sentence(why));
}
