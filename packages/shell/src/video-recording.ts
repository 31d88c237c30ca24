import type { FilmOverlay } from './film-overlay.ts';
import { canvasLike, drawOverBackground } from './screenshot.ts';
import { words } from './words.ts';

/** A video recording in progress. */
export interface VideoRecording {
  /** Copies the content of a canvas into the video; call it after every frame. */
  captureFrame(source: HTMLCanvasElement): void;
  /** Ends the recording. */
  stop(): void;
  /** Ends the recording and discards it. */
  discard(): void;
}

export interface VideoOptions {
  /** Longest recording, s. Default 300: the video is held in memory, so a forgotten recording must end. */
  readonly maxSeconds?: number;
  /** Longer side of the video, pixels; default that of the canvas. */
  readonly maxSide?: number;
  /** Default 12e6. */
  readonly bitsPerSecond?: number;
  /** Most frames a second; default every frame that is drawn. */
  readonly maxRate?: number;
  /** Called when the encoder has its first picture, from which on the video counts. */
  readonly onStart?: () => void;
  /** Default none: a silent video. */
  readonly sound?: MediaStreamTrack;
  /** Paints what lies over the picture. Default nothing. */
  readonly overlay?: FilmOverlay;
}

/** Formats, the one that most programs play first, each without and with sound. */
const FORMATS = [
  ['video/mp4;codecs=avc1.640028', 'video/mp4;codecs=avc1.640028,mp4a.40.2'],
  ['video/mp4;codecs=avc1.42E01F', 'video/mp4;codecs=avc1.42E01F,mp4a.40.2'],
  ['video/mp4;codecs=avc1.640028', 'video/mp4;codecs=avc1.640028,opus'],
  ['video/webm;codecs=vp9', 'video/webm;codecs=vp9,opus'],
  ['video/webm;codecs=vp8', 'video/webm;codecs=vp8,opus'],
  ['video/webm', 'video/webm'],
  ['video/mp4', 'video/mp4'],
] as const;
const MAX_SECONDS = 300;
/** Milliseconds from the last picture to the end, because an encoder drops what it has not yet encoded. */
const ENCODER_LAG = 300;
const BITS_PER_SECOND = 12e6;

/** Receives a video and its file extension. */
type OnEnd = (video: Blob, extension: string) => void;

/**
 * Starts recording a canvas.
 * @param onEnd receives the video and its file extension
 * @throws Error with a sentence where the browser cannot record
 */
export function startVideo(
  source: HTMLCanvasElement,
  onEnd: OnEnd,
  {
    maxSeconds = MAX_SECONDS,
    maxSide,
    bitsPerSecond = BITS_PER_SECOND,
    maxRate = 1000,
    onStart,
    sound,
    overlay,
  }: VideoOptions = {},
): VideoRecording {
  const copy = canvasLike(source, maxSide);
  const format = formatOf(copy, sound !== undefined);
  drawOverBackground(source, copy, overlay);
  const stream = copy.captureStream();
  if (sound !== undefined) stream.addTrack(sound);
  const recorder = new MediaRecorder(stream, { mimeType: format, videoBitsPerSecond: bitsPerSecond });
  const pieces: Blob[] = [];
  let isWanted = true;
  let last = performance.now();
  let timer: ReturnType<typeof setTimeout> | undefined;
  const begin = () => {
    if (isComplete) return;
    clearTimeout(timer);
    timer = setTimeout(() => stop(), maxSeconds * 1000);
  };
  let isComplete = false;
  const end = () => {
    clearTimeout(timer);
    if (recorder.state !== 'inactive') recorder.stop();
  };
  const stop = () => {
    if (isComplete) return;
    isComplete = true;
    clearTimeout(timer);
    timer = setTimeout(end, ENCODER_LAG);
  };
  recorder.onstart = () => {
    begin();
    onStart?.();
  };
  recorder.ondataavailable = ({ data }) => {
    if (data.size > 0) pieces.push(data);
  };
  recorder.onstop = () => {
    clearTimeout(timer);
    release(stream);
    if (isWanted) deliver(pieces, format, onEnd);
  };
  recorder.start(1000);
  begin();
  return {
    captureFrame(from) {
      const now = performance.now();
      // Displays are not exact: a frame that is due within a fifth of the interval counts.
      if (isComplete || now - last < 800 / maxRate) return;
      last = now;
      drawOverBackground(from, copy, overlay);
    },
    stop,
    discard() {
      isWanted = false;
      end();
      // The recorder says later that it has stopped.
      release(stream);
    },
  };
}

function deliver(pieces: readonly Blob[], format: string, onEnd: OnEnd): void {
  // The bare type: share sheets do not know codecs.
  const [type] = format.split(';');
  onEnd(new Blob([...pieces], { type }), type === 'video/mp4' ? 'mp4' : 'webm');
}

function release(stream: MediaStream): void {
  for (const track of stream.getTracks()) track.stop();
}

function formatOf(canvas: HTMLCanvasElement, hasSound: boolean): string {
  const canRecord = typeof MediaRecorder === 'function' && typeof canvas.captureStream === 'function';
  const names = FORMATS.map(([silent, heard]) => (hasSound ? heard : silent));
  const format = canRecord ? names.find((each) => MediaRecorder.isTypeSupported(each)) : undefined;
  if (format === undefined) throw new Error(words().cannotRecord);
  return format;
}
