/**
 * Air that the player blows at the cloth: where the mouse is while a key is held, and, while a button is on, where fingers or the
 * mouse press, which then neither drag nor cut. A ring shows each place.
 */
import { placeOnCanvas } from '@principia/render-core';
import { element, listenToKeys } from '@principia/shell';
import { JETS } from './air-jet.ts';
import { WORDS } from './words.ts';

type Place = { readonly x: number; readonly y: number };

export interface BlowOptions {
  /** Whether the pointer belongs to the view, which the space bar moves. */
  isSpaceHeld(): boolean;
  /** Where a key blows before a mouse was over the canvas, CSS pixels. */
  middle(): Place;
  /** A jet blows at this place on the canvas, CSS pixels. @param jet index of it, below `JETS` */
  blow(jet: number, place: Place): void;
  stop(jet: number): void;
}

export interface BlowButton {
  readonly isBlowing: boolean;
  /** Ends all jets, as if pointers and key had been released. */
  release(): void;
  destroy(): void;
}

/** Stands for the key among the ids of pointers, which are not negative. */
const KEY = -1;

/** @param row of buttons that gets this one */
export function createBlowButton(
  parent: HTMLElement,
  row: HTMLElement,
  canvas: HTMLCanvasElement,
  options: BlowOptions,
): BlowButton {
  const attributes = { type: 'button', 'aria-pressed': 'false', 'aria-keyshortcuts': 'A', title: WORDS.blowHint };
  const button = element('button', 'cloth-button', attributes, WORDS.blow);
  row.append(button);
  const jets = createJets(parent, options);
  let isOn = false;
  let mouse: Place | undefined;
  button.addEventListener('click', () => {
    isOn = !isOn;
    button.setAttribute('aria-pressed', String(isOn));
    jets.endAll();
  });
  const placeOf = (event: PointerEvent): Place => placeOnCanvas(canvas, event);
  const down = (event: PointerEvent) => {
    if (!isOn || event.target !== canvas || event.button !== 0 || options.isSpaceHeld()) return;
    // The canvas would take it for a drag or a cut.
    event.stopPropagation();
    if (jets.begin(event.pointerId, placeOf(event))) canvas.setPointerCapture(event.pointerId);
  };
  const move = (event: PointerEvent) => {
    const place = placeOf(event);
    jets.move(event.pointerId, place);
    if (event.pointerType !== 'mouse') return;
    mouse = place;
    jets.move(KEY, place);
  };
  const up = ({ pointerId }: PointerEvent) => jets.end(pointerId);
  const stopKeys = listenToKeys({ a: () => jets.begin(KEY, mouse ?? options.middle()) }, { a: () => jets.end(KEY) });
  const listening = new AbortController();
  const capture = { capture: true, signal: listening.signal };
  parent.addEventListener('pointerdown', down, capture);
  parent.addEventListener('pointermove', move, capture);
  parent.addEventListener('pointerup', up, capture);
  parent.addEventListener('pointercancel', up, capture);
  return {
    get isBlowing() {
      return jets.isBlowing;
    },
    release: jets.endAll,
    destroy() {
      jets.destroy();
      stopKeys();
      listening.abort();
      button.remove();
    },
  };
}

/** The jets, which pointers and the key take; where all are taken, one more pointer gets none. */
function createJets(parent: HTMLElement, { blow, stop }: BlowOptions) {
  const rings = Array.from({ length: JETS }, () => element('i', 'cloth-ring', { 'aria-hidden': 'true', hidden: '' }));
  parent.append(...rings);
  const holders: (number | undefined)[] = rings.map(() => undefined);
  const show = (jet: number, place: Place) => {
    rings[jet].style.translate = `${place.x}px ${place.y}px`;
    rings[jet].hidden = false;
    blow(jet, place);
  };
  const free = (jet: number) => {
    if (holders[jet] === undefined) return;
    holders[jet] = undefined;
    rings[jet].hidden = true;
    stop(jet);
  };
  const endAll = () => {
    for (const jet of rings.keys()) free(jet);
  };
  return {
    get isBlowing() {
      return holders.some((holder) => holder !== undefined);
    },
    /** @returns whether a jet was left */
    begin(holder: number, place: Place): boolean {
      const jet = holders.indexOf(undefined);
      if (jet < 0) return false;
      holders[jet] = holder;
      show(jet, place);
      return true;
    },
    move(holder: number, place: Place) {
      const jet = holders.indexOf(holder);
      if (jet >= 0) show(jet, place);
    },
    end: (holder: number) => free(holders.indexOf(holder)),
    endAll,
    destroy() {
      endAll();
      for (const ring of rings) ring.remove();
    },
  };
}
