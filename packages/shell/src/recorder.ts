import type { FilmOverlay } from './film-overlay.ts';
import { download, fileName, screenshotPng } from './screenshot.ts';
import { startVideo, type VideoRecording } from './video-recording.ts';

/** Takes screenshots and records videos of a game, and offers them as downloads. */
export class Recorder {
  readonly #title: string;
  readonly #onChange: () => void;
  readonly #overlay: FilmOverlay;
  #recording: VideoRecording | undefined;

  /**
   * @param onChange called when a recording starts or ends
   * @param overlay paints what lies over the picture into videos; a screenshot is the bare picture
   */
  constructor(title: string, onChange: () => void, overlay: FilmOverlay) {
    this.#title = title;
    this.#onChange = onChange;
    this.#overlay = overlay;
  }

  get isRecording(): boolean {
    return this.#recording !== undefined;
  }

  /** Saves the content of a canvas; call it right after drawing. @param time simulated, s */
  async saveScreenshot(canvas: HTMLCanvasElement, time: number): Promise<void> {
    download(await screenshotPng(canvas), fileName(this.#title, time, 'png'));
  }

  /**
   * Starts or ends a recording. @param time simulated, s @throws Error with a sentence where the browser cannot record
   */
  toggleVideo(canvas: HTMLCanvasElement, time: number): void {
    if (this.#recording !== undefined) {
      this.#recording.stop();
      return;
    }
    const end = (blob: Blob, extension: string) => {
      this.#recording = undefined;
      this.#onChange();
      download(blob, fileName(this.#title, time, extension));
    };
    this.#recording = startVideo(canvas, end, { overlay: this.#overlay });
    this.#onChange();
  }

  /** Ends a recording in progress, and saves it. */
  stop(): void {
    this.#recording?.stop();
  }

  /** Adds a drawn frame to the recording in progress. */
  captureFrame(canvas: HTMLCanvasElement): void {
    this.#recording?.captureFrame(canvas);
  }
}
