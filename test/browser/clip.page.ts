/** The page of `clip.test.ts`: a canvas that changes, a tone, and the shell's part that makes clips of them. */
import { connectToSpeakers } from '@principia/shell';
import { createBanner } from '../../packages/shell/src/banner.ts';
import { createClipButton } from '../../packages/shell/src/clip-button.ts';
import { Failures } from '../../packages/shell/src/failures.ts';
import { Sharing } from '../../packages/shell/src/sharing.ts';
import { addStyles } from '../../packages/shell/src/styles.ts';

const SECONDS = 3;

addStyles();
const root = document.createElement('div');
root.className = 'game';
document.body.append(root);
const canvas = document.createElement('canvas');
canvas.width = 1601;
canvas.height = 800;
const pen = canvas.getContext('2d') as CanvasRenderingContext2D;
const banner = createBanner(root);
let resumed = 0;
const sharing: Sharing = new Sharing({
  title: 'Black hole',
  root,
  banner,
  failures: new Failures(banner, () => {}),
  picture: () => ({ canvas, time: 12.34 }),
  link: () => location.href,
  onChange: () => button.update(),
  onClip: () => {
    resumed++;
  },
  clipSeconds: SECONDS,
});
const button = createClipButton(sharing);
root.append(button.button);
let frame = 0;
const draw = () => {
  requestAnimationFrame(draw);
  frame++;
  pen.fillStyle = `hsl(${(7 * frame) % 360} 90% 50%)`;
  pen.fillRect(0, 0, canvas.width, canvas.height);
  sharing.captureFrame(canvas);
};
draw();

/** Plays tones of as many audio contexts. */
function hum(count: number): void {
  for (let i = 0; i < count; i++) {
    const context = new AudioContext();
    const tone = new OscillatorNode(context, { frequency: 300 + 200 * i });
    connectToSpeakers(tone);
    tone.start();
  }
}

/** What a browser finds in a video. */
async function inspect(data: string, type: string) {
  const video = document.createElement('video');
  video.muted = true;
  video.src = `data:${type};base64,${data}`;
  await new Promise((done, fail) => {
    video.onloadeddata = done;
    video.onerror = () => fail(new Error(video.error?.message));
  });
  // A video that was recorded piece by piece knows its length once its end was sought.
  if (!Number.isFinite(video.duration)) {
    video.currentTime = 1e6;
    await new Promise((done) => {
      video.onseeked = done;
    });
  }
  const heard = await new AudioContext()
    .decodeAudioData(Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0)).buffer)
    .then((sound) => sound.getChannelData(0).reduce((most, value) => Math.max(most, value), 0))
    .catch(() => 0);
  return { width: video.videoWidth, height: video.videoHeight, seconds: video.duration, loudness: heard };
}

const lab = {
  SECONDS,
  hum,
  inspect,
  sharing,
  text: () => banner.text,
  resumed: () => resumed,
};

declare global {
  var clipLab: typeof lab;
}
globalThis.clipLab = lab;
