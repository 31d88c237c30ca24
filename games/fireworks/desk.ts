/** The player's choices and the show in the making: they outlive worlds and pictures. */
import { SHELL_NAMES, STAR_COLORS } from '@principia/scenes';
import { DEMO_SHOW } from './demo-show.ts';
import { readShow, writeShow } from './show.ts';
import { ShowEditor } from './show-editor.ts';
import { type Cue, type FireworksGame, SURPRISE, SWARM, THROWN } from './sim.ts';
import { Sound } from './sound.ts';

type Place = { readonly x: number; readonly y: number; readonly z: number };

/** The finger that keys and gamepads press with. */
export const KEYS = -1;

export class Desk {
  /** Number of the chosen kind and colour, or `SURPRISE`. */
  kind = SURPRISE;
  color = SURPRISE;
  /** Clicks go into the show as well. */
  isEditing = false;
  readonly editor: ShowEditor;
  readonly sound: Sound;
  /** What is played when a night begins. */
  readonly opening: readonly Cue[];
  readonly isDemo: boolean;
  /** Grows with every choice. */
  version = 0;
  #say: ((sentence: string) => void) | undefined;
  #unsaid: string | undefined;

  /** @param hash of the address: `#show=…` is a show that somebody shared */
  constructor(hash: string) {
    let shared: readonly Cue[] = [];
    const [, text] = /^#show=(.*)$/s.exec(hash) ?? [];
    try {
      if (text !== undefined) shared = readShow(text);
    } catch (error) {
      this.#unsaid = `${(error as Error).message} Meanwhile the game plays its own.`;
    }
    this.editor = new ShowEditor(shared);
    this.isDemo = shared.length === 0;
    this.opening = this.isDemo ? DEMO_SHOW : shared;
    this.sound = new Sound((sentence) => this.say(sentence));
  }

  /** Sentences for the player go there from now on. */
  listen(say: (sentence: string) => void): void {
    this.#say = say;
    if (this.#unsaid !== undefined) say(this.#unsaid);
    this.#unsaid = undefined;
  }

  say(sentence: string): void {
    if (this.#say === undefined) this.#unsaid = sentence;
    else this.#say(sentence);
  }

  choose(kind: number, color: number): void {
    this.kind = kind;
    this.color = color;
    this.version++;
  }

  /** The next kind or colour; behind the last comes the surprise. */
  next(what: 'kind' | 'color'): void {
    const count = what === 'kind' ? SHELL_NAMES.length : STAR_COLORS.length;
    this[what] = this[what] + 1 < count ? this[what] + 1 : SURPRISE;
    this.version++;
  }

  edit(on = !this.isEditing): void {
    this.isEditing = on;
    this.version++;
  }

  hold(sim: FireworksGame, finger: number): void {
    sim.press({ do: 'hold', finger });
  }

  /** A shell goes up; while a show is being made it becomes part of it. */
  fire(sim: FireworksGame, finger: number, { x, y, z }: Place): void {
    let { kind, color } = this;
    const power = sim.powerOf(finger, kind);
    // A swarm that was not held for a second is none.
    if (this.isEditing && (kind !== SWARM || power > 0)) {
      // A show has no surprises: what goes up now goes up every time.
      if (kind === SURPRISE) kind = Math.floor(THROWN * Math.random());
      if (color === SURPRISE) color = Math.floor(STAR_COLORS.length * Math.random());
      if (!this.editor.add({ x, y, z, kind, color, power })) {
        this.say(`A show has at most ${this.editor.cues.length} shells: take one out first.`);
      }
    }
    sim.press({ do: 'fire', finger, x, y, z, kind, color });
  }

  /** Plays the show from its beginning, or ends it. */
  play(sim: FireworksGame): void {
    if (sim.isShowing && !sim.isDemo) sim.press({ do: 'stop' });
    else sim.press({ do: 'play', cues: this.editor.cues });
  }

  /** Puts the show into the address, and into the clipboard where that is allowed. */
  async share(): Promise<void> {
    const link = new URL(location.href);
    link.hash = `show=${writeShow(this.editor.cues)}`;
    history.replaceState(null, '', link);
    try {
      await navigator.clipboard.writeText(link.href);
      this.say('The link to your show is copied; it is in the address bar as well.');
    } catch {
      this.say('The link to your show is in the address bar: copy it from there.');
    }
  }
}
