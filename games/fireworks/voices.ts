/** The sounds of fireworks, synthesised from oscillators and noise. */
import { connectToSpeakers } from '@principia/shell';

/** The output chain of all voices. */
export interface Mixer {
  readonly context: AudioContext;
  readonly master: GainNode;
  readonly bus: AudioNode;
  readonly noise: AudioBuffer;
  /** Number of voices that sound or are scheduled. */
  voices: number;
}

/** @throws Error when the browser has no Web Audio or refuses it */
export function openMixer(): Mixer {
  const context = new AudioContext();
  const master = new GainNode(context, { gain: 1 });
  const limiter = new DynamicsCompressorNode(context, { threshold: -14, ratio: 12, attack: 0.002, release: 0.2 });
  const bus = new GainNode(context, { gain: 0.8 });
  // Two muffled echoes from the hills.
  const echo = new DelayNode(context, { delayTime: 0.83, maxDelayTime: 1 });
  const dull = new BiquadFilterNode(context, { type: 'lowpass', frequency: 420 });
  const again = new GainNode(context, { gain: 0.3 });
  bus.connect(limiter);
  bus.connect(echo).connect(dull).connect(again).connect(limiter);
  again.connect(echo);
  connectToSpeakers(limiter.connect(master));
  return { context, master, bus, noise: whiteNoise(context), voices: 0 };
}

function whiteNoise(context: AudioContext): AudioBuffer {
  const buffer = context.createBuffer(1, 2 * context.sampleRate, context.sampleRate);
  const samples = buffer.getChannelData(0);
  for (let i = 0; i < samples.length; i++) samples[i] = 2 * Math.random() - 1;
  return buffer;
}

/** Connects a source to the mixer and schedules it. Counts the voice until the source ends. */
function play(mixer: Mixer, source: AudioScheduledSourceNode, through: AudioNode[], at: number, length: number): void {
  let last: AudioNode = source;
  for (const node of [...through, mixer.bus]) last = last.connect(node);
  mixer.voices++;
  source.onended = () => {
    mixer.voices--;
    for (const node of [source, ...through]) node.disconnect();
  };
  source.start(at);
  source.stop(at + length);
}

function noiseOf({ context, noise }: Mixer): AudioBufferSourceNode {
  return new AudioBufferSourceNode(context, { buffer: noise, loop: true, loopStart: 0, loopEnd: 2 });
}

/** An envelope with exponential attack and decay to a thousandth. */
function decayEnvelope(context: AudioContext, at: number, loudness: number, attack: number, length: number): GainNode {
  const gain = new GainNode(context, { gain: 0 });
  gain.gain.setValueAtTime(0.0001, at);
  gain.gain.exponentialRampToValueAtTime(loudness, at + attack);
  gain.gain.exponentialRampToValueAtTime(0.001 * loudness, at + length);
  return gain;
}

/** A thump from the mortar and a whistle that rises and fades. */
export function launchVoice(mixer: Mixer, at: number, pan: number): void {
  const { context } = mixer;
  const thump = new OscillatorNode(context, { frequency: 90 });
  thump.frequency.setValueAtTime(90, at);
  thump.frequency.exponentialRampToValueAtTime(38, at + 0.18);
  play(mixer, thump, [decayEnvelope(context, at, 0.5, 0.004, 0.25), new StereoPannerNode(context, { pan })], at, 0.26);
  const length = 1 + 0.5 * Math.random();
  const top = 1500 + 900 * Math.random();
  const whistle = new OscillatorNode(context, { type: 'sine', frequency: 700 });
  whistle.frequency.setValueAtTime(0.45 * top, at + 0.1);
  whistle.frequency.exponentialRampToValueAtTime(top, at + 0.1 + 0.6 * length);
  whistle.frequency.exponentialRampToValueAtTime(0.8 * top, at + 0.1 + length);
  const gain = decayEnvelope(context, at + 0.1, 0.035, 0.25, length);
  play(mixer, whistle, [gain, new StereoPannerNode(context, { pan })], at + 0.1, length);
}

/** A low blow followed by a roar. */
export function burstVoice(mixer: Mixer, at: number, pan: number, power: number): void {
  const { context } = mixer;
  const loudness = 0.55 + 0.45 * power;
  const blow = new OscillatorNode(context, { frequency: 80 });
  blow.frequency.setValueAtTime(82 - 20 * power, at);
  blow.frequency.exponentialRampToValueAtTime(30, at + 0.35);
  play(
    mixer,
    blow,
    [decayEnvelope(context, at, loudness, 0.003, 0.6), new StereoPannerNode(context, { pan })],
    at,
    0.62,
  );
  const filter = new BiquadFilterNode(context, { type: 'lowpass', frequency: 1600, Q: 0.4 });
  filter.frequency.setValueAtTime(1900, at);
  filter.frequency.exponentialRampToValueAtTime(110, at + 1.1);
  const roar = [filter, decayEnvelope(context, at, 0.7 * loudness, 0.002, 1.3), new StereoPannerNode(context, { pan })];
  play(mixer, noiseOf(mixer), roar, at, 1.35);
}

/** A single snap. */
export function crackleVoice(mixer: Mixer, at: number, pan: number): void {
  const { context } = mixer;
  const frequency = 1800 + 3000 * Math.random();
  const filter = new BiquadFilterNode(context, { type: 'bandpass', frequency, Q: 1.2 });
  const snap = [filter, decayEnvelope(context, at, 0.16, 0.001, 0.06), new StereoPannerNode(context, { pan })];
  play(mixer, noiseOf(mixer), snap, at + 0.05 * Math.random(), 0.12);
}
