import { createRandom } from '@principia/physics';

/** Draws arrays of `count` uniform numbers in [low, high); equal seeds give equal sequences of arrays. */
export function seededUniforms(seed: number, count: number): (low: number, high: number) => Float64Array {
  const random = createRandom(seed);
  return (low, high) => {
    const values = new Float64Array(count);
    for (let i = 0; i < count; i++) values[i] = random.uniform(low, high);
    return values;
  };
}
