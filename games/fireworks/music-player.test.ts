import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { MusicPlayer } from './music-player.ts';

/** Sources that play, and where in the music they began, s. */
const playing = new Map<object, number>();
const page = Object.assign(new EventTarget(), { hidden: false });

class Part {
  readonly context = { destination: {}, state: 'running' };
  readonly gain = { value: 0 };
  connect(next: unknown) {
    return next;
  }
  disconnect() {}
}

class Source extends Part {
  start(_: number, from: number) {
    playing.set(this, from);
  }
  stop() {
    playing.delete(this);
  }
}

class Context {
  currentTime = 0;
  async decodeAudioData() {
    return { duration: 60, sampleRate: 100, getChannelData: () => new Float32Array(6000) };
  }
  async resume() {}
  async close() {}
}

beforeEach(() => {
  playing.clear();
  vi.stubGlobal('document', page);
  vi.stubGlobal('AudioContext', Context);
  vi.stubGlobal('GainNode', Part);
  vi.stubGlobal('AudioBufferSourceNode', Source);
});
afterEach(() => vi.unstubAllGlobals());

function hide(hidden: boolean) {
  page.hidden = hidden;
  page.dispatchEvent(new Event('visibilitychange'));
}

it('music stops with the page that is hidden, which draws no frames, and goes on with the next step', async () => {
  const player = new MusicPlayer();
  await player.load(new File([], 'song.ogg'));
  player.start();
  player.follow(1, true);
  expect([...playing.values()]).toEqual([1]);
  hide(true);
  expect(playing.size).toBe(0);
  // The game is paused when the player comes back.
  hide(false);
  for (let frame = 0; frame < 3; frame++) player.follow(1, true);
  expect(playing.size).toBe(0);
  player.follow(1.1, true);
  expect([...playing.values()]).toEqual([1.1]);
  player.destroy();
});
