/** Weight of the latest frame in the moving means. */
const WEIGHT = 0.1;

/** Moving means of milliseconds per frame, per step, and per submission of the world to the renderer. */
export class FrameTimes {
  frame = 0;
  step = 0;
  draw = 0;

  add(name: 'frame' | 'step' | 'draw', milliseconds: number): void {
    this[name] += WEIGHT * (milliseconds - this[name]);
  }
}
