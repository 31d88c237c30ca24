import { canvasLike, drawOverBackground } from './screenshot.ts';

/** A video recording in progress. */
export interface VideoRecording {
  /** Copies the content of a canvas into the video; call it after every frame. */
  captureFrame(source: HTMLCanvasElement): void;
  /** Ends the recording. */
  stop(): void;
}

/** Video formats, the most widely supported first. */
const FORMATS = ['video/mp4;codecs=avc1.640028', 'video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm'];
/** Longest recording, s. The video is held in memory, so a forgotten recording must end. */
const MAX_SECONDS = 300;
const BITS_PER_SECOND = 12e6;

/**
 * Starts recording a canvas.
 * @param onEnd receives the video and its file extension
 * @throws Error with a sentence where the browser cannot record
 */
export function startVideo(source: HTMLCanvasElement, onEnd: (video: Blob, extension: string) => void): VideoRecording {
  const copy = canvasLike(source);
  const format = formatOf(copy);
  drawOverBackground(source, copy);
  const recorder = new MediaRecorder(copy.captureStream(), { mimeType: format, videoBitsPerSecond: BITS_PER_SECOND });
  const pieces: Blob[] = [];
  const timer = setTimeout(() => stop(), MAX_SECONDS * 1000);
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
    captureFrame: (from) => drawOverBackground(from, copy),
    stop,
  };
}

function formatOf(canvas: HTMLCanvasElement): string {
  const canRecord = typeof MediaRecorder === 'function' && typeof canvas.captureStream === 'function';
  const format = canRecord ? FORMATS.find((each) => MediaRecorder.isTypeSupported(each)) : undefined;
  if (format === undefined)
    throw new Error('This browser cannot record video. Use the screen recorder of your system.');
  return format;
}
