/** What is heard: all of it synthesised, and as late as sound takes to the audience. */
import type { NewsRing, SkyNews } from '@principia/scenes';
import { burstVoice, crackleVoice, launchVoice, type Mixer, openMixer } from './voices.ts';

/** Speed of sound in air of 20 °C, m/s. */
export const SPEED_OF_SOUND = 343;
/** Where the audience stands, m. */
const EAR = { x: 0, y: 2, z: 140 };
/** Voices at once; a crowd of more is not heard apart. */
const MOST_VOICES = 28;

/** Seconds from what happens to its sound. */
export function soundDelay({ x, y, z }: { readonly x: number; readonly y: number; readonly z: number }): number {
  return Math.hypot(x - EAR.x, y - EAR.y, z - EAR.z) / SPEED_OF_SOUND;
}

/** `waiting` for the first gesture, `on`, or `blocked` for good. */
export type SoundState = 'waiting' | 'on' | 'blocked';

export class Sound {
  state: SoundState = 'waiting';
  /** Sounds made so far, and how late the last one was, s. */
  heard = 0;
  lastDelay = 0;
  #mixer: Mixer | undefined;
  #isOn = true;
  #news: NewsRing | undefined;
  #told = 0;
  readonly #say: (sentence: string) => void;

  /** @param say gets a sentence when there is no sound */
  constructor(say: (sentence: string) => void) {
    this.#say = say;
  }

  /** Browsers allow sound once somebody has touched the page. */
  unlock(): void {
    if (this.state === 'blocked' || !this.#isOn) return;
    try {
      this.#mixer ??= openMixer();
      if (this.#mixer.context.state === 'suspended') void this.#mixer.context.resume().catch(() => this.#block());
      this.state = 'on';
    } catch {
      this.#block();
    }
  }

  set(on: boolean): void {
    this.#isOn = on;
    if (this.#mixer !== undefined) this.#mixer.master.gain.value = on ? 1 : 0;
  }

  /** Makes the sounds of what is new. */
  hear(news: NewsRing): void {
    if (news !== this.#news) this.#told = 0;
    this.#news = news;
    // What nobody could hear then is not made up for.
    const first = Math.max(this.#told, news.count - MOST_VOICES);
    this.#told = news.count;
    if (this.state !== 'on' || !this.#isOn || this.#mixer === undefined) return;
    for (let i = first; i < news.count; i++) this.#make(this.#mixer, news.at(i));
  }

  #make(mixer: Mixer, news: SkyNews): void {
    if (mixer.voices >= MOST_VOICES) return;
    const delay = soundDelay(news);
    const at = mixer.context.currentTime + delay;
    const pan = Math.max(-1, Math.min(1, news.x / 60));
    if (news.what === 'launch') launchVoice(mixer, at, pan);
    else if (news.what === 'burst') burstVoice(mixer, at, pan, news.power);
    else crackleVoice(mixer, at, pan);
    this.heard++;
    this.lastDelay = delay;
  }

  #block(): void {
    if (this.state === 'blocked') return;
    this.state = 'blocked';
    this.#mixer = undefined;
    this.#say('This browser gives no sound, as Web Audio is missing or blocked; the fireworks go on in silence.');
  }
}
