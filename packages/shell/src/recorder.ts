import { type Film, startFilm } from './film.ts';
import { download, fileName, picturePng } from './print.ts';

/** Takes pictures and films of a game and hands them to the player. */
export class Recorder {
  readonly #title: string;
  readonly #onChange: () => void;
  #film: Film | undefined;

  /** @param onChange a film began or ended */
  constructor(title: string, onChange: () => void) {
    this.#title = title;
    this.#onChange = onChange;
  }

  get filming(): boolean {
    return this.#film !== undefined;
  }

  /** Stores what a canvas shows; call it right after it was drawn. @param time simulated, s */
  async picture(canvas: HTMLCanvasElement, time: number): Promise<void> {
    download(await picturePng(canvas), fileName(this.#title, time, 'png'));
  }

  /** Begins a film, or ends it. @param time simulated, s @throws Error with a sentence where the browser cannot */
  toggleFilm(canvas: HTMLCanvasElement, time: number): void {
    if (this.#film !== undefined) {
      this.#film.stop();
      return;
    }
    this.#film = startFilm(canvas, (blob, ending) => {
      this.#film = undefined;
      this.#onChange();
      download(blob, fileName(this.#title, time, ending));
    });
    this.#onChange();
  }

  /** A picture was drawn. */
  take(canvas: HTMLCanvasElement): void {
    this.#film?.take(canvas);
  }
}
