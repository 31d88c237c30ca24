import type { FilmOverlay } from './film-overlay.ts';
import { fileName } from './screenshot.ts';
import { openSoundTrack, type SoundTrack } from './sound-outputs.ts';
import { startVideo, type VideoRecording } from './video-recording.ts';
import { words } from './words.ts';

/** Length of a clip, s: long enough for one good moment, and small enough for every messenger. */
export const CLIP_SECONDS = 8;
/** Longer side of a clip, pixels, its bits per second, with which eight seconds take some 8 MB, and frames a second. */
const CLIP_QUALITY = { maxSide: 1280, bitsPerSecond: 8e6, maxRate: 30 } as const;
/** Milliseconds between two changes of the countdown. */
const COUNT_INTERVAL = 250;

export interface ClipOptions {
  /** Title of the game, for the name of the file. */
  readonly title: string;
  /** Called when a clip starts, counts down or ends. */
  readonly onChange: () => void;
  /** Receives the clip when it is complete. */
  readonly onReady: (file: File) => void;
  /** Receives a sentence when there is no clip in the end. */
  readonly onFailure: (sentence: string) => void;
  /** Length of the clip, s; default 8. */
  readonly seconds?: number;
  /** Paints what lies over the picture. */
  readonly overlay: FilmOverlay;
}

/** A short video of the play that follows, with the sound that the page plays. */
export class Clip {
  readonly seconds: number;
  readonly #options: ClipOptions;
  #recording: VideoRecording | undefined;
  #sound: SoundTrack | undefined;
  #count: ReturnType<typeof setInterval> | undefined;
  #end = 0;

  constructor(options: ClipOptions) {
    this.#options = options;
    this.seconds = options.seconds ?? CLIP_SECONDS;
  }

  /** Seconds until the clip is complete; undefined while none is recorded. */
  get secondsLeft(): number | undefined {
    if (this.#recording === undefined) return undefined;
    return Math.min(this.seconds, Math.max(0, (this.#end - performance.now()) / 1000));
  }

  /** Starts a clip of a canvas. @param time simulated, s @throws Error with a sentence where the browser cannot record */
  start(canvas: HTMLCanvasElement, time: number): void {
    if (this.#recording !== undefined) return;
    this.#sound = openSoundTrack();
    try {
      this.#recording = startVideo(canvas, (video, extension) => this.#finish(video, time, extension), {
        ...CLIP_QUALITY,
        maxSeconds: this.seconds,
        overlay: this.#options.overlay,
        onStart: () => this.#countFromNow(),
        ...(this.#sound === undefined ? {} : { sound: this.#sound.track }),
      });
    } catch (error) {
      this.#release();
      throw error;
    }
    this.#countFromNow();
    this.#count = setInterval(this.#options.onChange, COUNT_INTERVAL);
    this.#options.onChange();
  }

  /** Adds a drawn frame to the clip in progress. */
  captureFrame(canvas: HTMLCanvasElement): void {
    this.#recording?.captureFrame(canvas);
  }

  /** Gives up the clip in progress. @returns whether there was one */
  cancel(): boolean {
    if (this.#recording === undefined) return false;
    this.#recording.discard();
    this.#release();
    this.#options.onChange();
    return true;
  }

  #countFromNow(): void {
    this.#end = performance.now() + 1000 * this.seconds;
  }

  #finish(video: Blob, time: number, extension: string): void {
    this.#release();
    this.#options.onChange();
    if (video.size > 0) {
      this.#options.onReady(new File([video], fileName(this.#options.title, time, extension), { type: video.type }));
    } else this.#options.onFailure(words().clipEmpty);
  }

  #release(): void {
    clearInterval(this.#count);
    this.#sound?.stop();
    this.#sound = undefined;
    this.#recording = undefined;
  }
}
