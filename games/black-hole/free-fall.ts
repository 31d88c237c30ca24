/**
 * Height above a horizon of a point that falls from `height`, as a part of the fall of one from `highest` has passed. Free
 * fall from rest far away, towards −GM/(r − r_s): (r − r_s)^(3/2) decreases uniformly (Paczyński and Wiita 1980; Landau and
 * Lifshitz, Mechanics, section 15).
 */
export function heightAfter(height: number, highest: number, part: number): number {
  const left = height ** 1.5 - part * highest ** 1.5;
  return left <= 0 ? 0 : left ** (2 / 3);
}
