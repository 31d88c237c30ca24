// Where steps differ in length: what joints keep for the next step are impulses of a sub-step, as solver/2d/scale-impulses.ts.
import { word } from '../../solver/2d/body';
import { JointTable, impulsesOf } from './joint-table';

// Multiplies the impulses of all joints.
export function scaleJointImpulses(table: usize, factor: f64): void {
  const t = changetype<JointTable>(table);
  for (let i = 0; i < t.count; i++) {
    const impulses = impulsesOf(t, word(t.ids, i));
    impulses.lock0 *= factor;
    impulses.lock1 *= factor;
    impulses.lock2 *= factor;
    impulses.spring *= factor;
    impulses.motor *= factor;
    impulses.lower *= factor;
    impulses.upper *= factor;
  }
}
