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
canvas.style.cssText = 'position: fixed; left: 0; top: 0; width: 400px; height: 200px';
const pen = canvas.getContext('2d') as CanvasRenderingContext2D;
const banner = createBanner(root);
// What a game shows over its picture, a button among it, and something that only the page shows.
const gauges = document.createElement('div');
gauges.dataset.filmed = '';
gauges.innerHTML = `<style>.lab { position: fixed; width: 80px; height: 40px; top: 100px; background: #000; color: #fff; font: 700 20px/40px sans-serif }</style>
<div class="lab" style="left: 0">Level 7</div><div class="lab" style="left: 100px; visibility: hidden">Hidden</div><button class="lab" style="left: 200px">Press</button>`;
const panel = document.createElement('div');
panel.className = 'lab';
panel.style.left = '300px';
root.append(canvas, gauges, panel);
for (const each of [canvas, gauges, panel]) each.style.pointerEvents = 'none';
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
button.button.style.cssText = 'position: fixed; top: 300px';
root.append(button.button);
let frame = 0;
const draw = () => {
  requestAnimationFrame(draw);
  frame++;
  // Videos have a quarter as many points of colour as of brightness: letters on a vivid picture are tinted by it.
  pen.fillStyle = `hsl(${(7 * frame) % 360} 40% 45%)`;
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

/** Shares of black and of white points in boxes of 80 by 40 in a frame that shows 400 by 200, at these places. */
function tones(video: HTMLVideoElement, places: readonly (readonly [x: number, y: number])[]) {
  const frame = new OffscreenCanvas(400, 200);
  const context = frame.getContext('2d') as OffscreenCanvasRenderingContext2D;
  context.drawImage(video, 0, 0, 400, 200);
  return places.map(([x, y]) => {
    const { data } = context.getImageData(x, y, 80, 40);
    let [black, white] = [0, 0];
    for (let i = 0; i < data.length; i += 4) {
      const [least, most] = [Math.min(data[i], data[i + 1], data[i + 2]), Math.max(data[i], data[i + 1], data[i + 2])];
      if (most < 60) black++;
      if (least > 180) white++;
    }
    return { black: black / 3200, white: white / 3200 };
  });
}

/** Busy browsers say that a frame was sought before they have its picture: what is drawn of it is nothing, or black. */
async function pictureOf(video: HTMLVideoElement): Promise<void> {
  const context = new OffscreenCanvas(1, 1).getContext('2d') as OffscreenCanvasRenderingContext2D;
  for (let i = 0; i < 100; i++) {
    context.drawImage(video, 0, 0, 1, 1);
    const [red, green, blue] = context.getImageData(0, 0, 1, 1).data;
    if (Math.max(red, green, blue) > 20) return;
    await new Promise((done) => setTimeout(done, 50));
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
  // A frame in the middle: behind the last one, browsers show black.
  const { duration } = video;
  await new Promise((done) => {
    video.onseeked = done;
    video.currentTime = duration / 2;
  });
  await pictureOf(video);
  const [shown, hidden, button, unmarked, title] = tones(video, [
    [0, 100],
    [100, 100],
    [200, 100],
    [300, 100],
    [15, 10],
  ]);
  return {
    shown,
    hidden,
    button,
    unmarked,
    title,
    width: video.videoWidth,
    height: video.videoHeight,
    seconds: duration,
    loudness: heard,
  };
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
