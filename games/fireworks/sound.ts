/** Synthesised sound, delayed by the travel time to the listener. */
import type { EventRing, FireworksEvent } from '@principia/scenes';
import { burstVoice, crackleVoice, launchVoice, type Mixer, openMixer } from './voices.ts';
import { WORDS } from './words.ts';

/** Speed of sound in air of 20 °C, m/s. */
export const SPEED_OF_SOUND = 343;
/** Position of the listener, m. */
const LISTENER = { x: 0, y: 2, z: 140 };
/** Largest number of simultaneous voices; more cannot be distinguished by ear. */
const MAX_VOICES = 28;

/** Seconds from an event to its sound. */
export function soundDelay({ x, y, z }: { readonly x: number; readonly y: number; readonly z: number }): number {
  return Math.hypot(x - LISTENER.x, y - LISTENER.y, z - LISTENER.z) / SPEED_OF_SOUND;
}

/** `waiting` for the first gesture, `on`, or `blocked` permanently. */
export type SoundState = 'waiting' | 'on' | 'blocked';

export class Sound {
  state: SoundState = 'waiting';
  /** Number of sounds so far, and the delay of the last one, s. */
  soundCount = 0;
  lastDelay = 0;
  #mixer: Mixer | undefined;
  #isOn = true;
  #news: EventRing | undefined;
  #playedCount = 0;
  readonly #showMessage: (sentence: string) => void;

  /** @param showMessage receives a sentence when sound is unavailable */
  constructor(showMessage: (sentence: string) => void) {
    this.#showMessage = showMessage;
  }

  /** Enables sound; browsers allow it after the first gesture. */
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

  /** Plays the sounds of new events. */
  playNew(news: EventRing): void {
    if (news !== this.#news) this.#playedCount = 0;
    this.#news = news;
    // Events during silence are skipped.
    const first = Math.max(this.#playedCount, news.count - MAX_VOICES);
    this.#playedCount = news.count;
    if (this.state !== 'on' || !this.#isOn || this.#mixer === undefined) return;
    for (let i = first; i < news.count; i++) this.#make(this.#mixer, news.at(i));
  }

  #make(mixer: Mixer, news: FireworksEvent): void {
    if (mixer.voices >= MAX_VOICES) return;
    const delay = soundDelay(news);
    const at = mixer.context.currentTime + delay;
    const pan = Math.max(-1, Math.min(1, news.x / 60));
    if (news.type === 'launch') launchVoice(mixer, at, pan);
    else if (news.type === 'burst') burstVoice(mixer, at, pan, news.power);
    else crackleVoice(mixer, at, pan);
    this.soundCount++;
    this.lastDelay = delay;
  }

  #block(): void {
    if (this.state === 'blocked') return;
    this.state = 'blocked';
    this.#mixer = undefined;
    this.#showMessage(WORDS.noSound);
  }
}
