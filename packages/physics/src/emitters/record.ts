// The layout of an emitter's record in the world's memory, kernels/emitters/record.ts.
export { BURST_BYTES, EMITTER_BYTES, EmitterNumber as N, EmitterWord as W } from '../memory/layouts.gen.ts';

/** The maximum number of colour ramps of an emitter, and of stops of a ramp. */
export const MAX_RAMPS = 8;
export const MAX_STOPS = 4;
