// How soft the spring of a joint is in a sub-step (softness.ts), from its frequency and how it is solved.
import { get } from '../../memory/columns';
import { poseOf } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { softenSpring } from '../../solver/2d/softness';
import { JointTable, REVOLUTE, WELD } from './joint-table';
import { JointWork } from './joint-work';

// What is solved with its tree is at most as stiff as at this multiple of the rate of sub-steps, so that its matrix has digits: it then
// gives way under its weight by g/(8π rate)², a quarter of a micrometre at 240 Hz.
const MOST_IN_TREE: f64 = 4;

// Springs that are solved one after another do not know in a sub-step what those behind them do to their bodies. Of n at a body, each as
// stiff as at f of the rate of sub-steps, the fastest motion has at most √n times its frequency; semi-implicit Euler gains energy where
// n (2π f)² > 4. Where there are others they are at most as stiff as at 3, which leaves room for their damping.
const MOST_TOGETHER: f64 = 3 / (4 * 9.869604401089358);

// Sets the softness of a spring with the inverse mass k of its bodies, 1/kg, that is solved with its tree.
export function softenInTree(t: JointTable, work: JointWork, k: f64, h: f64): void {
  softenTo(t, work, k, h, MOST_IN_TREE);
}

// The same for one that is solved by itself.
export function softenAlone(t: JointTable, work: JointWork, k: f64, h: f64): void {
  softenTo(t, work, k, h, mostAlone(work));
}

// The greatest frequency of a spring that is solved by itself, as a part of the rate of sub-steps.
export function mostAlone(work: JointWork): f64 {
  return sqrt<f64>(MOST_TOGETHER / <f64>work.springs);
}

function softenTo(t: JointTable, work: JointWork, k: f64, h: f64, most: f64): void {
  const hertz = <f64>get(t.hertz, work.id);
  const rate = rateOf(t, work, k);
  softenSpring(min<f64>(rate * hertz, most / h), rate * <f64>get(t.dampingRatio, work.id), h);
}

// A spring along a line has the stiffness m ω² and the damping 2ζ m ω for the reduced mass m of its bodies, wherever it is tied to
// them. The mass 1/k that it moves depends on that and on how they lie: on it, this times ω and ζ are the same stiffness and damping.
function rateOf(t: JointTable, work: JointWork, k: f64): f64 {
  if (work.kind == REVOLUTE || work.kind == WELD) return 1;
  const rigid = changetype<RigidTable>(t.rigid);
  const inverseMass = <f64>poseOf(rigid, work.rowA).inverseMass + <f64>poseOf(rigid, work.rowB).inverseMass;
  return inverseMass > 0 ? sqrt<f64>(k / inverseMass) : 1;
}
