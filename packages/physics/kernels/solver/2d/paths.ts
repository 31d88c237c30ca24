// How far bodies moved in a step.
import { poseOf, stateOf, word } from './body';
import { RigidTable } from './rigid-table';

// How far any point of a body moved at most in this step, m.
// @ts-ignore: decorator
@inline export function pathOf(t: RigidTable, row: i32): real {
  const state = stateOf(t, row);
  return sqrt<real>(state.dx * state.dx + state.dy * state.dy) + abs<real>(state.turned) * poseOf(t, row).extent;
}

// The longest path of all bodies, m.
export function longestPath(t: RigidTable): real {
  let longest: real = 0;
  for (let i = 0; i < t.awakeCount; i++) longest = max<real>(longest, pathOf(t, word(t.awake, i)));
  return longest;
}
