// The layout of an emitter's record in the world's memory, kernels/emitters/record.ts.
export { BURST_BYTES, EMITTER_BYTES, EmitterNumber as N, EmitterWord as W } from '../memory/layouts.gen.ts';

/** Colour ramps an emitter can choose from, and stops of a ramp. */
export const MAX_RAMPS = 8;
export const MAX_STOPS = 4;
