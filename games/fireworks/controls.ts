/** The player's choices and the edited show, which persist across worlds and views. */
import { SHELL_NAMES, STAR_COLORS } from '@principia/scenes';
import { copyLink } from '@principia/shell';
import { DEMO_SHOW } from './demo-show.ts';
import { readShow, writeShow } from './show.ts';
import { ShowEditor } from './show-editor.ts';
import { type Cue, type FireworksGame, RANDOM, RANDOM_KINDS, SWARM } from './sim.ts';
import { Sound } from './sound.ts';
import { MAX_CHARACTERS, textPoints } from './text-points.ts';
import { WORDS } from './words.ts';

type SkyPoint = { readonly x: number; readonly y: number; readonly z: number };

/** Power of a shell that writes. */
const TEXT_POWER = 0.7;

/** Pointer id that stands for keyboard and gamepad. */
export const KEYBOARD_POINTER = -1;

export class PlayerControls {
  /** Index of the chosen kind and colour, or `RANDOM`. */
  kind = RANDOM;
  color = RANDOM;
  /** Whether clicks are also added to the show. */
  isEditing = false;
  /** What the next shells write into the sky; nothing if empty. */
  text = '';
  readonly editor: ShowEditor;
  readonly sound: Sound;
  /** The show that plays first. */
  readonly opening: readonly Cue[];
  readonly isDemo: boolean;
  /** Incremented by every choice. */
  version = 0;
  #messageHandler: ((sentence: string) => void) | undefined;
  #pendingMessage: string | undefined;

  /** @param hash of the URL: `#show=…` contains a shared show */
  constructor(hash: string) {
    let shared: readonly Cue[] = [];
    const [, text] = /^#show=(.*)$/s.exec(hash) ?? [];
    try {
      if (text !== undefined) shared = readShow(text);
    } catch (error) {
      this.#pendingMessage = WORDS.demoInstead((error as Error).message);
    }
    this.editor = new ShowEditor(shared);
    this.isDemo = shared.length === 0;
    this.opening = this.isDemo ? DEMO_SHOW : shared;
    this.sound = new Sound((sentence) => this.showMessage(sentence));
  }

  /** Sets the receiver of messages for the player, and delivers a pending one. */
  setMessageHandler(handler: (sentence: string) => void): void {
    this.#messageHandler = handler;
    if (this.#pendingMessage !== undefined) handler(this.#pendingMessage);
    this.#pendingMessage = undefined;
  }

  showMessage(sentence: string): void {
    if (this.#messageHandler === undefined) this.#pendingMessage = sentence;
    else this.#messageHandler(sentence);
  }

  choose(kind: number, color: number): void {
    this.kind = kind;
    this.color = color;
    this.version++;
  }

  /** Selects the next kind or colour; after the last one, random. */
  next(choice: 'kind' | 'color'): void {
    const count = choice === 'kind' ? SHELL_NAMES.length : STAR_COLORS.length;
    this[choice] = this[choice] + 1 < count ? this[choice] + 1 : RANDOM;
    this.version++;
  }

  /** Opens or closes the editor; a demo ends, so that the sky belongs to the show being made. */
  toggleEditing(sim: FireworksGame): void {
    this.isEditing = !this.isEditing;
    if (this.isEditing && sim.isDemo) sim.press({ do: 'stop' });
    this.version++;
  }

  startHold(sim: FireworksGame, finger: number): void {
    sim.press({ do: 'hold', finger });
  }

  /** Fires a shell and, in the editor, adds it to the show. */
  fire(sim: FireworksGame, finger: number, { x, y, z }: SkyPoint): void {
    if (this.text.trim() !== '') {
      sim.press({ do: 'forget', finger });
      this.write(sim, { x, y, z });
      return;
    }
    let { kind, color } = this;
    const power = sim.powerOf(finger, kind);
    // A swarm held for less than a second has no stars.
    if (this.isEditing && (kind !== SWARM || power > 0)) {
      // A show is deterministic: random choices are made now, not at each performance.
      if (kind === RANDOM) kind = Math.floor(RANDOM_KINDS * Math.random());
      if (color === RANDOM) color = Math.floor(STAR_COLORS.length * Math.random());
      if (!this.editor.add({ x, y, z, kind, color, power })) {
        this.showMessage(WORDS.tooMany(this.editor.cues.length));
      }
    }
    sim.press({ do: 'fire', finger, x, y, z, kind, color });
  }

  /** Launches a shell that writes the text. It is not added to a show, whose link has no room for it. */
  write(sim: FireworksGame, { x, y, z }: SkyPoint): void {
    const text = [...this.text.trim()].slice(0, MAX_CHARACTERS).join('');
    const points = textPoints(text);
    if (points.length > 0) sim.press({ do: 'write', points, x, y, z, color: this.color, power: TEXT_POWER });
    else this.showMessage(text === '' ? WORDS.noText : WORDS.noMark(text));
  }

  /** Plays the show from its beginning, or stops it. */
  play(sim: FireworksGame): void {
    if (sim.isShowing && !sim.isDemo) sim.press({ do: 'stop' });
    else sim.press({ do: 'play', cues: this.editor.cues });
  }

  /** Puts a show in the place of the edited one, which undo brings back, and plays it from its beginning. */
  load(sim: FireworksGame, cues: readonly Cue[]): void {
    this.editor.load(cues);
    sim.press({ do: 'play', cues: this.editor.cues });
  }

  /** Puts the show into the URL, and into the clipboard where that is allowed. */
  async share(): Promise<void> {
    const link = new URL(location.href);
    link.hash = `show=${writeShow(this.editor.cues)}`;
    history.replaceState(null, '', link);
    this.showMessage(await copyLink(link.href, WORDS.yourShow));
  }
}
