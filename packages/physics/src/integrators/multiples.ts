// Lengths that a scheme hands on in every step, made once for each length of the step: a number that is worked out and
// handed to a function becomes garbage each time.

/**
 * Multiples of the step, as a function of it that remembers its last answer. In a list that holds something else as
 * well, reading a number makes no garbage: that is the undefined at the end.
 */
export function multiplesOf(factors: readonly number[]): (dt: number) => readonly number[] {
  let known = Number.NaN;
  let list: readonly (number | undefined)[] = [];
  return (dt) => {
    if (dt !== known) {
      known = dt;
      list = [...factors.map((factor) => factor * dt), undefined];
    }
    return list as readonly number[];
  };
}
