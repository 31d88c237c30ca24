/** Bits of a row's flags in the table of rigid bodies: kernels/solver/2d/body.ts. */
export const ASLEEP = 8;
export const COLLIDES = 32;
export const WAKES = 128;
export const PART = 1024;
export const TO_SLEEP = 1048576;
