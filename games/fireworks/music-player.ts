/** Plays a music file beside the simulation: it pauses with it, and catches up where it went ahead or stayed behind. */

import { connectToSpeakers } from '@principia/shell';
import { WORDS } from './words.ts';

/** Largest difference between music and show that is left uncorrected, s. */
const MAX_DRIFT = 0.12;
/** Frames without a step after which the game counts as paused. */
const PAUSED_FRAMES = 12;

/** One channel of a music file. */
export interface Music {
  readonly samples: Float32Array;
  /** Samples per second. */
  readonly rate: number;
}

export class MusicPlayer {
  #context: AudioContext | undefined;
  #buffer: AudioBuffer | undefined;
  #source: AudioBufferSourceNode | undefined;
  #gain: GainNode | undefined;
  /** Where every piece of music goes. */
  #out: GainNode | undefined;
  /** Time of the audio context at which the music would have begun, s. */
  #origin = 0;
  /** Time of the show at the last frame, s, and the frames since it moved. */
  #shown = -1;
  #still = 0;
  readonly #end = new AbortController();

  constructor() {
    document.addEventListener('visibilitychange', () => document.hidden && this.#pause(), { signal: this.#end.signal });
  }

  /** @throws Error with a sentence where the browser cannot play the file */
  async load(file: File): Promise<Music> {
    try {
      this.#context ??= new AudioContext();
      this.#buffer = await this.#context.decodeAudioData(await file.arrayBuffer());
    } catch {
      throw new Error(WORDS.noMusic(file.name));
    }
    return { samples: this.#buffer.getChannelData(0), rate: this.#buffer.sampleRate };
  }

  get hasEnded(): boolean {
    return this.#buffer !== undefined && this.#shown > this.#buffer.duration;
  }

  start(): void {
    this.#shown = -1;
    this.#still = 0;
    this.#playFrom(0);
  }

  /** @param time of the show, s @param isOn whether the player wants sound */
  follow(time: number, isOn: boolean): void {
    const context = this.#context;
    if (context === undefined || this.#gain === undefined) return;
    this.#gain.gain.value = isOn ? 0.8 : 0;
    this.#still = time === this.#shown ? this.#still + 1 : 0;
    this.#shown = time;
    if (this.#still > PAUSED_FRAMES) {
      this.#stopSource();
      return;
    }
    const drift = context.currentTime - this.#origin - time;
    if (this.#source === undefined || Math.abs(drift) > MAX_DRIFT) this.#playFrom(time);
  }

  stop(): void {
    this.#stopSource();
    this.#buffer = undefined;
  }

  destroy(): void {
    this.#end.abort();
    this.stop();
    void this.#context?.close().catch(() => {});
  }

  /** A hidden page pauses the game and draws no frame that would tell. The next step goes on with the music. */
  #pause(): void {
    this.#still = PAUSED_FRAMES;
    this.#stopSource();
  }

  #playFrom(time: number): void {
    const context = this.#context;
    if (context === undefined || this.#buffer === undefined) return;
    this.#stopSource();
    if (time >= this.#buffer.duration) return;
    void context.resume().catch(() => {});
    this.#gain = new GainNode(context, { gain: 0.8 });
    this.#source = new AudioBufferSourceNode(context, { buffer: this.#buffer });
    if (this.#out === undefined) {
      this.#out = new GainNode(context);
      connectToSpeakers(this.#out);
    }
    this.#source.connect(this.#gain).connect(this.#out);
    this.#source.start(0, time);
    this.#origin = context.currentTime - time;
  }

  #stopSource(): void {
    this.#source?.stop();
    this.#source?.disconnect();
    this.#source = undefined;
  }
}
