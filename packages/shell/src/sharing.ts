import type { Banner } from './banner.ts';
import { Clip } from './clip.ts';
import type { ClipControl } from './clip-button.ts';
import { type ClipCard, canShareFile, createClipCard } from './clip-card.ts';
import { hasCoarsePointer } from './coarse-pointer.ts';
import { copyLink, shareText } from './copy-link.ts';
import type { Failures } from './failures.ts';
import { createFilmOverlay } from './film-overlay.ts';
import { Recorder } from './recorder.ts';
import { download } from './screenshot.ts';
import { words } from './words.ts';

/** The picture on display, just drawn. */
export interface Picture {
  readonly canvas: HTMLCanvasElement;
  /** Simulated, s. */
  readonly time: number;
}

export interface SharingOptions {
  readonly title: string;
  /** Receives the card with a finished clip, and holds what lies over the picture. */
  readonly root: HTMLElement;
  readonly banner: Banner;
  readonly failures: Failures;
  /** Draws the picture; undefined while there is no view. */
  readonly picture: () => Picture | undefined;
  /** The address of the present game. */
  readonly link: () => string;
  /** Called when a recording starts, counts down or ends. */
  readonly onChange: () => void;
  /** Called when a clip starts: it shows play, so a paused game goes on. */
  readonly onClip: () => void;
  /** Length of a clip, s; default 8. */
  readonly clipSeconds?: number;
}

/** What a player takes away from a game: screenshots, videos, clips, results and links. */
export class Sharing implements ClipControl {
  readonly #options: SharingOptions;
  readonly #recorder: Recorder;
  readonly #clip: Clip;
  /** Made with the first clip. */
  #card: ClipCard | undefined;

  constructor(options: SharingOptions) {
    const { title, root, banner, onChange } = options;
    const overlay = createFilmOverlay(root, title);
    this.#options = options;
    this.#recorder = new Recorder(title, onChange, overlay);
    this.#clip = new Clip({
      title,
      onChange,
      overlay,
      onReady: (file) => this.#offer(file),
      onFailure: (sentence) => banner.show(sentence, 'note'),
      ...(options.clipSeconds === undefined ? {} : { seconds: options.clipSeconds }),
    });
  }

  get isRecording(): boolean {
    return this.#recorder.isRecording;
  }

  get secondsLeft(): number | undefined {
    return this.#clip.secondsLeft;
  }

  get seconds(): number {
    return this.#clip.seconds;
  }

  /** Adds a drawn frame to the recordings in progress. */
  captureFrame(canvas: HTMLCanvasElement): void {
    this.#recorder.captureFrame(canvas);
    this.#clip.captureFrame(canvas);
  }

  saveScreenshot(): void {
    this.#attempt(({ canvas, time }) => this.#recorder.saveScreenshot(canvas, time));
  }

  toggleVideo(): void {
    this.#attempt(({ canvas, time }) => this.#recorder.toggleVideo(canvas, time));
  }

  /** Starts a clip of the seconds that follow, or gives up the one in progress. */
  toggle(): void {
    if (this.#clip.cancel()) return;
    this.#attempt(({ canvas, time }) => {
      this.#clip.start(canvas, time);
      this.#options.onClip();
    });
  }

  /** Gives up a clip whose picture goes away. @param sentence for a player who has not been told why */
  dropClip(sentence = ''): void {
    if (this.#clip.cancel() && sentence !== '') this.#options.banner.show(sentence, 'note');
  }

  /** Gives a clip up and saves a video: nothing is drawn any more. */
  destroy(): void {
    this.#clip.cancel();
    this.#recorder.stop();
  }

  /** Shares a result, or without one copies the link to this game. */
  async share(result?: string): Promise<void> {
    const link = this.#options.link();
    const said = await (result === undefined
      ? copyLink(link, words().thisGame)
      : shareText(result, link, hasCoarsePointer()));
    if (said !== '') this.#options.banner.show(said, 'note');
  }

  #offer(file: File): void {
    const { root, title, banner } = this.#options;
    const say = (text: string) => banner.show(text, 'note');
    if (canShareFile(file)) {
      this.#card ??= createClipCard(root, title, say);
      this.#card.show(file);
    } else {
      download(file, file.name);
      say(words().clipSaved(file.name));
    }
  }

  /** Runs an action on the picture; the browser may refuse it. */
  #attempt(action: (picture: Picture) => unknown): void {
    const { picture, failures } = this.#options;
    failures.attempt(() => {
      const present = picture();
      return present && action(present);
    });
  }
}
