import { canvasLike, printCanvas } from './print.ts';

/** A recording under way. */
export interface Film {
  /** Takes up what a canvas shows; call it after every picture. */
  take(source: HTMLCanvasElement): void;
  /** Ends it. */
  stop(): void;
}

/** Formats, the most widely played first. */
const FORMATS = ['video/mp4;codecs=avc1.640028', 'video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm'];
/** A film that nobody stops stops by itself, s: it lies in memory. */
const LONGEST = 300;
const BITS_A_SECOND = 12e6;

/**
 * Begins to film a canvas.
 * @param onEnd gets the film and how its file name ends
 * @throws Error with a sentence where the browser cannot
 */
export function startFilm(source: HTMLCanvasElement, onEnd: (film: Blob, ending: string) => void): Film {
  const copy = canvasLike(source);
  const format = formatOf(copy);
  printCanvas(source, copy);
  const recorder = new MediaRecorder(copy.captureStream(), { mimeType: format, videoBitsPerSecond: BITS_A_SECOND });
  const pieces: Blob[] = [];
  const timer = setTimeout(() => stop(), LONGEST * 1000);
  const stop = () => {
    clearTimeout(timer);
    if (recorder.state !== 'inactive') recorder.stop();
  };
  recorder.ondataavailable = ({ data }) => {
    if (data.size > 0) pieces.push(data);
  };
  recorder.onstop = () => {
    for (const track of recorder.stream.getTracks()) track.stop();
    onEnd(new Blob(pieces, { type: format }), format.startsWith('video/mp4') ? 'mp4' : 'webm');
  };
  recorder.start(1000);
  return {
    take: (from) => printCanvas(from, copy),
    stop,
  };
}

function formatOf(canvas: HTMLCanvasElement): string {
  const canRecord = typeof MediaRecorder === 'function' && typeof canvas.captureStream === 'function';
  const format = canRecord ? FORMATS.find((each) => MediaRecorder.isTypeSupported(each)) : undefined;
  if (format === undefined)
    throw new Error('This browser cannot film the game: use the screen recorder of your system.');
  return format;
}
