import type { Result } from './result.ts';
import { growthOf } from './scaling.ts';

/** The result as lines for a terminal. */
export function resultTable(result: Result): string {
  const { msPerStep, create } = result;
  const rows: [string, string][] = [
    ['step', `${ms(msPerStep.median)} median, ${ms(msPerStep.min)} least, ${ms(msPerStep.p99)} 99th percentile`],
    ['per body', `${result.nsPerBodyStep.toFixed(2)} ns a step`],
    [
      'creation',
      `${ms(create.ms)}, ${mega(create.bytes)}${create.peers.map((peer) => against(create, peer)).join('')}`,
    ],
    ['garbage', `${result.garbageBytesPerStep} bytes a step`],
    [
      'energy drift',
      (result.energyDrift === null ? 'no energy to speak of' : drift(result.energyDrift)) +
        (result.energyNote === null ? '' : `: ${result.energyNote}`),
    ],
    ...forceError(result),
    ...stretch(result),
    ...reference(result),
    ['hash', result.hash],
  ];
  return [
    title(result),
    '',
    ...aligned(rows),
    '',
    ...profileLines(result),
    ...peerLines(result),
    ...scalingLines(result),
  ].join('\n');
}

/** A line for approximated forces. */
function forceError({ rmsForceError }: Result): [string, string][] {
  return rmsForceError === null ? [] : [['force error', `${rmsForceError.toExponential(2)} RMS, relative`]];
}

/** A line for the stretch of inextensible threads. */
function stretch({ stretch }: Result): [string, string][] {
  if (stretch === null) return [];
  return [['stretch', `${percent(stretch.worst)} worst, ${percent(stretch.rms)} RMS`]];
}

/** Lines for the comparison with a reference. */
function reference({ reference }: Result): [string, string][] {
  if (reference === null) return [];
  const { name, timeRatio, worstKm, errorKm } = reference;
  const rows = Object.entries(errorKm).map(([body, at]): [string, string] => [
    `  ${body}`,
    Object.entries(at)
      .map(([label, distance]) => `${label} ${distance.toPrecision(3)} km`)
      .join(', '),
  ]);
  return [
    [`against ${name}`, `${timeRatio.toPrecision(2)}x its time, at most ${worstKm.toFixed(0)} km apart`],
    ...rows,
  ];
}

function percent(share: number): string {
  return `${(100 * share).toPrecision(2)} %`;
}

function title({ scene, count, dimensions, precision, steps, warmup, seed, variant }: Result): string {
  const timed = warmup > 0 ? `${steps} steps, ${warmup} of them warm-up` : `${steps} steps`;
  const resting = variant.resting ? ', resting on the floor' : '';
  const laws = variant.laws > 2 ? `, ${variant.laws} laws` : '';
  return `${scene}: ${count.toLocaleString('en')} in ${dimensions}D, ${precision}, ${timed}, seed ${seed}${resting}${laws}`;
}

function aligned(rows: readonly (readonly [string, string])[]): string[] {
  const width = Math.max(...rows.map(([name]) => name.length)) + 2;
  return rows.map(([name, text]) => `  ${name.padEnd(width)}${text}`);
}

function against(ours: { ms: number; bytes: number }, peer: { name: string; ms: number; bytes: number }): string {
  const [time, room] = [ours.ms / peer.ms, ours.bytes / peer.bytes];
  return ` (${time.toFixed(2)}x the time and ${room.toFixed(2)}x the memory of ${peer.name})`;
}

function profileLines({ profile }: Result): string[] {
  const busy = Object.entries(profile).filter(([, time]) => time > 0);
  const total = busy.reduce((sum, [, time]) => sum + time, 0);
  if (total === 0) return [];
  const rows = busy.map(([phase, time]): [string, string] => {
    const share = time / total;
    return [
      phase,
      `${ms(time).padStart(11)} ${`${(100 * share).toFixed(0)} %`.padStart(6)}  ${'█'.repeat(Math.round(30 * share))}`,
    ];
  });
  return ['  phases', ...aligned(rows).map((line) => `  ${line}`)];
}

function scalingLines({ scaling }: Result): string[] {
  if (scaling.length === 0) return [];
  const rows = scaling.map(({ count, msPerStep, rmsForceError }): [string, string] => [
    count.toLocaleString('en'),
    `${ms(msPerStep).padStart(11)}${rmsForceError === null ? '' : `  force error ${rmsForceError.toExponential(1)}`}`,
  ]);
  const lines = aligned(rows).map((line) => `  ${line}`);
  return [`  cost by count: it grows as N^${growthOf(scaling).toFixed(2)}`, ...lines];
}

function peerLines({ peers, msPerStep }: Result): string[] {
  if (peers.length === 0) return [];
  const rows: [string, string][] = [
    ['this framework', ms(msPerStep.median).padStart(11)],
    ...peers.map((peer): [string, string] => [
      peer.name,
      `${ms(peer.msPerStep).padStart(11)}  ${peer.ratio.toFixed(2)}x our time`,
    ]),
  ];
  return ['', '  beside us, in turns', ...aligned(rows).map((line) => `  ${line}`)];
}

/** Milliseconds with a suitable number of digits. */
export function ms(time: number): string {
  const digits = time >= 100 ? 0 : time >= 1 ? 2 : 4;
  return `${time.toFixed(digits)} ms`;
}

export function mega(bytes: number): string {
  return Number.isFinite(bytes) ? `${(bytes / 2 ** 20).toFixed(1)} MiB` : 'memory unknown without --expose-gc';
}

function drift(value: number): string {
  return `${value.toExponential(2)} of the total`;
}
