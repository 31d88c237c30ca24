/** Draws arrays of `count` numbers uniform in [low, high); the same seed gives the same arrays in the same order. */
export function seededUniforms(seed: number, count: number): (low: number, high: number) => Float64Array {
  const random = createRandom(seed);
  return (low, high) => {
    const values = new Float64Array(count);
    for (let i = 0; i < count; i++) values[i] = low + (high - low) * random();
    return values;
  };
}

function createRandom(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}
