import { connectToSpeakers } from './sound-outputs.ts';

/** A sound with an exponential decay. */
export interface SoundShape {
  /** Frequency at the start, Hz: of the tone, or of the band of noise. */
  readonly frequency: number;
  /** Frequency at the end, Hz; default the same. */
  readonly to?: number;
  /** 0 to 1. */
  readonly loudness: number;
  /** Time until it has faded to a thousandth, s. */
  readonly seconds: number;
  /** −1 left to 1 right; default 0. */
  readonly pan?: number;
  /** Wave form of the tone; default `sine`. */
  readonly wave?: OscillatorType;
}

/** Sounds at a time; more cannot be told apart. */
const MAX_VOICES = 14;
const GESTURES = ['pointerdown', 'keydown', 'touchend'] as const;

/**
 * Short sounds, synthesised: a tone that glides, and filtered noise, 14 at a time at most. Nothing is heard before the first gesture on
 * the page, on a hidden page, in a preview, and where Web Audio is missing or blocked.
 */
export class Synth {
  /** Number of sounds played so far. */
  count = 0;
  #isOn = true;
  #isBlocked = false;
  #voices = 0;
  #context: AudioContext | undefined;
  #out: AudioNode | undefined;
  #noise: AudioBuffer | undefined;
  readonly #stop = new AbortController();

  /** Browsers allow sound after the first gesture on the page, for which this listens. */
  constructor() {
    const { signal } = this.#stop;
    for (const type of GESTURES) globalThis.addEventListener(type, () => this.#open(), { capture: true, signal });
    document.addEventListener('visibilitychange', () => this.#follow(), { signal });
  }

  /** Whether sounds are heard. */
  get isAudible(): boolean {
    return this.#isOn && this.#context?.state === 'running';
  }

  /** Turns all sounds on or off; they are on at first. */
  set(on: boolean): void {
    if (on === this.#isOn) return;
    this.#isOn = on;
    this.#follow();
  }

  /** Plays a tone. */
  tone({ frequency, to = frequency, wave = 'sine', ...shape }: SoundShape): void {
    const context = this.#free();
    if (context === undefined) return;
    const source = new OscillatorNode(context, { type: wave, frequency });
    source.frequency.exponentialRampToValueAtTime(Math.max(1, to), context.currentTime + shape.seconds);
    this.#play(context, source, [], shape);
  }

  /** Plays noise about a frequency. */
  noise({ frequency, to = frequency, ...shape }: SoundShape): void {
    const context = this.#free();
    if (context === undefined) return;
    this.#noise ??= whiteNoise(context);
    const source = new AudioBufferSourceNode(context, { buffer: this.#noise, loop: true });
    const filter = new BiquadFilterNode(context, { type: 'bandpass', frequency, Q: 0.8 });
    filter.frequency.exponentialRampToValueAtTime(Math.max(1, to), context.currentTime + shape.seconds);
    this.#play(context, source, [filter], shape);
  }

  /** Ends all sounds for good. */
  destroy(): void {
    this.#stop.abort();
    this.#isBlocked = true;
    void this.#context?.close().catch(() => {});
  }

  #open(): void {
    if (this.#isBlocked) return;
    try {
      this.#context ??= new AudioContext();
      this.#out ??= this.#connect(this.#context);
      this.#follow();
    } catch {
      this.#isBlocked = true;
    }
  }

  #connect(context: AudioContext): AudioNode {
    const limiter = new DynamicsCompressorNode(context, { threshold: -16, ratio: 10, attack: 0.002, release: 0.15 });
    connectToSpeakers(limiter);
    return limiter;
  }

  /** Nobody hears a hidden page. */
  #follow(): void {
    const context = this.#context;
    if (context === undefined) return;
    const isWanted = this.#isOn && !document.hidden;
    void (isWanted ? context.resume() : context.suspend()).catch(() => {
      this.#isBlocked = true;
    });
  }

  #free(): AudioContext | undefined {
    return this.isAudible && this.#voices < MAX_VOICES ? this.#context : undefined;
  }

  #play(
    context: AudioContext,
    source: AudioScheduledSourceNode,
    filters: readonly AudioNode[],
    { loudness, seconds, pan = 0 }: Omit<SoundShape, 'frequency'>,
  ): void {
    const now = context.currentTime;
    const gain = new GainNode(context, { gain: 0 });
    gain.gain.setValueAtTime(0.0001, now);
    gain.gain.exponentialRampToValueAtTime(Math.max(0.001, loudness), now + 0.004);
    gain.gain.exponentialRampToValueAtTime(0.001 * Math.max(0.001, loudness), now + seconds);
    const chain = [...filters, gain, new StereoPannerNode(context, { pan: Math.max(-1, Math.min(1, pan)) })];
    let last: AudioNode = source;
    for (const node of chain) last = last.connect(node);
    last.connect(this.#out as AudioNode);
    this.#voices++;
    this.count++;
    source.onended = () => {
      this.#voices--;
      for (const node of [source, ...chain]) node.disconnect();
    };
    source.start(now);
    source.stop(now + seconds);
  }
}

function whiteNoise(context: AudioContext): AudioBuffer {
  const buffer = context.createBuffer(1, context.sampleRate, context.sampleRate);
  const samples = buffer.getChannelData(0);
  for (let i = 0; i < samples.length; i++) samples[i] = 2 * Math.random() - 1;
  return buffer;
}
