/** What both views share: cuts, air that the player blows, the sound of a tear, its film, and the player's picture. */
import { element, Synth, showHint, type ViewContext } from '@principia/shell';
import { blow, type JetAxis } from './air-jet.ts';
import { createBlowButton } from './blow-button.ts';
import type { ClothPrint } from './cloth-print.ts';
import { createPrintButtons } from './print-buttons.ts';
import type { Settings } from './settings.ts';
import { CLOTH, type ClothRun } from './sim.ts';
import { listenToSwipes } from './swipes.ts';
import { TearFilm } from './tear-film.ts';
import { WORDS } from './words.ts';

export interface Play {
  readonly film: TearFilm;
  /** Call it once a frame, before the picture is drawn. */
  update(seconds: number): void;
  /** Call it when the world was replaced. */
  refresh(): void;
  destroy(): void;
}

/** Slow motion sounds two octaves lower. */
const SLOW = 0.25;
const HALF_WIDTH = (CLOTH.columns * CLOTH.spacing) / 2;
/** The node in the middle of the cloth. */
const MIDDLE = (CLOTH.columns * (CLOTH.rows + 1)) / 2;
/** Time between two puffs of the sound of blowing, s. */
const PUFF = 0.2;

/**
 * @param place position of a node on the canvas, CSS pixels
 * @param axisUnder the line of sight through a place on the canvas, CSS pixels
 */
export function createPlay(
  context: ViewContext<Settings, ClothRun>,
  canvas: HTMLCanvasElement,
  print: ClothPrint,
  place: (node: number) => { x: number; y: number },
  axisUnder: (x: number, y: number) => JetAxis,
): Play {
  const { element: parent } = context;
  const synth = new Synth();
  const style = element('style', '', {}, STYLE);
  parent.append(style);
  const row = element('div', 'cloth-print');
  parent.append(row);
  const removeButtons = createPrintButtons(row, print, context.showMessage);
  const blowing = createBlowButton(parent, row, canvas, {
    isSpaceHeld: context.isSpaceHeld,
    middle: () => place(MIDDLE),
    blow: (jet, { x, y }) => blow(context.sim().world, jet, axisUnder(x, y)),
    stop: (jet) => blow(context.sim().world, jet, undefined),
  });
  const removeHint = showHint(parent, WORDS.hint);
  const stopSwipes = listenToSwipes(context, canvas, place);
  let film = new TearFilm(context.sim(), parent);
  let heard = context.sim().tears.endedCount;
  let sincePuff = 0;
  return {
    get film() {
      return film;
    },
    update(seconds) {
      synth.set(context.values().sound);
      const { tears } = context.sim();
      if (film.time === undefined) rip(synth, tears.endedCount - heard, tears.lastX, 1);
      heard = tears.endedCount;
      rip(synth, film.update(seconds), tears.lastX, SLOW);
      sincePuff += seconds;
      if (blowing.isBlowing && sincePuff > PUFF) {
        sincePuff = 0;
        synth.noise({ frequency: 500, to: 350, loudness: 0.12, seconds: 3 * PUFF });
      }
    },
    refresh() {
      // The jets of a new world do not blow.
      blowing.release();
      film.destroy();
      film = new TearFilm(context.sim(), parent);
      heard = context.sim().tears.endedCount;
    },
    destroy() {
      removeHint();
      stopSwipes();
      film.destroy();
      blowing.destroy();
      removeButtons();
      row.remove();
      style.remove();
      synth.destroy();
    },
  };
}

/** The sound of threads that end in a frame: the more, the louder and the deeper. @param speed of the time on display */
function rip(synth: Synth, threads: number, x: number, speed: number): void {
  if (threads <= 0) return;
  const loudness = Math.min(0.3, 0.04 + 0.03 * Math.sqrt(threads));
  const frequency = speed * (3600 / (1 + 0.12 * Math.sqrt(threads)));
  const pan = (0.8 * x) / HALF_WIDTH;
  synth.noise({
    frequency,
    to: 0.45 * frequency,
    loudness,
    seconds: (0.07 + 0.004 * Math.min(30, threads)) / speed,
    pan,
  });
}

const STYLE = `
@media (max-width: 759px), (max-height: 479px) { .game:has(.game-side:not([hidden])) .cloth-print { visibility: hidden } }
.cloth-print { position: absolute; left: max(16px, env(safe-area-inset-left)); bottom: max(16px, env(safe-area-inset-bottom));
  display: flex; gap: 8px }
.cloth-button { height: 40px; padding: 0 14px; border: 1px solid var(--line); border-radius: 12px; background: var(--card);
  color: var(--ink); font: 600 13px/1 inherit; font-family: inherit; cursor: pointer; touch-action: manipulation }
.cloth-button:hover { background: #2b3766 }
.cloth-button:focus-visible { outline: 2px solid var(--accent); outline-offset: 2px }
.cloth-button[aria-pressed=true] { background: var(--accent); border-color: transparent; color: #1c1503 }
.cloth-ring { position: absolute; left: -36px; top: -36px; width: 72px; height: 72px; box-sizing: border-box; border-radius: 50%;
  border: 2px solid #cfe0ff; box-shadow: 0 0 24px #cfe0ff80, inset 0 0 24px #cfe0ff59; pointer-events: none }
.cloth-ring[hidden] { display: none }
.cloth-again { position: absolute; left: 50%; bottom: max(72px, calc(env(safe-area-inset-bottom) + 72px)); translate: -50% 0;
  white-space: nowrap; background: var(--accent); border-color: transparent; color: #1c1503 }
.cloth-again:hover { background: #ffd38a }
@media (min-height: 480px) { .game-hint { bottom: 72px } }
/* The hint lies beside the buttons, of which there is one more while a picture is on. */
@media (max-height: 479px) { .game:has(.cloth-print) .game-hint { left: 248px; right: 12px }
  .game:has(.cloth-print > button:nth-of-type(2):not([hidden])) .game-hint { left: 372px } }
.cloth-film { position: absolute; left: 16px; right: 16px; bottom: 84px; margin: 0; text-align: center; pointer-events: none;
  font-weight: 600; text-shadow: 0 1px 3px #0d1226, 0 0 10px #0d1226 }
@media (pointer: coarse) { .cloth-button { height: 44px } }
`;
