/** A dot on every joint: white for hinges, amber for motors, grey for welds; and a line to what hangs far below. */
import 'pixi.js/graphics';
import type { PhysicsWorld } from '@principia/physics';
import { query } from 'bitecs';
import { Container, Graphics } from 'pixi.js';

/** `Joint.kind` of a weld. */
const WELD = 2;
/** A body gets a line if its centre is farther from the joint than this; and the width of the line, m. */
const LINE = 1;
const LINE_WIDTH = 0.03;
const COLORS = { hinge: 0xffffff, motor: 0xffc15e, weld: 0x8fa0e0 } as const;

export interface JointMarks {
  readonly container: Container;
  update(alpha: number, pixelsPerMetre: number): void;
  destroy(): void;
}

export function createJointMarks(world: PhysicsWorld): JointMarks {
  const container = new Container();
  const marks: Graphics[] = [];
  const lines: Graphics[] = [];
  const { Joint, Position, Rotation } = world.components;
  const old = world.previous;
  return {
    container,
    update(alpha, pixelsPerMetre) {
      const joints = query(world, [Joint]);
      while (marks.length < joints.length) {
        const mark = new Graphics().circle(0, 0, 1).fill(0xffffff);
        marks.push(mark);
        const line = new Graphics().rect(0, -0.5, 1, 1).fill({ color: 0xffffff, alpha: 0.35 });
        lines.push(line);
        container.addChild(line, mark);
      }
      const size = Math.max(0.05, 3.5 / pixelsPerMetre);
      for (let i = 0; i < marks.length; i++) {
        marks[i].visible = i < joints.length;
        lines[i].visible = false;
        if (i >= joints.length) continue;
        const joint = joints[i];
        const b = Joint.b[joint];
        const angle = old.Rotation.angle[b] + (Rotation.angle[b] - old.Rotation.angle[b]) * alpha;
        const x = old.Position.x[b] + (Position.x[b] - old.Position.x[b]) * alpha;
        const y = old.Position.y[b] + (Position.y[b] - old.Position.y[b]) * alpha;
        const [c, s] = [Math.cos(angle), Math.sin(angle)];
        const [bx, by] = [Joint.bx[joint], Joint.by[joint]];
        // Pixi's y axis points down.
        marks[i].position.set(x + c * bx - s * by, -(y + s * bx + c * by));
        marks[i].scale.set(size);
        const length = Math.hypot(bx, by);
        if (length > LINE) {
          lines[i].visible = true;
          lines[i].position.copyFrom(marks[i].position);
          lines[i].rotation = Math.PI - angle - Math.atan2(by, bx);
          lines[i].scale.set(length, Math.max(LINE_WIDTH, 1 / pixelsPerMetre));
        }
        const kind = Joint.kind[joint] === WELD ? 'weld' : Joint.maxMotor[joint] > 0 ? 'motor' : 'hinge';
        // Pixi converts a tint whenever it is set, which allocates objects.
        if (marks[i].tint !== COLORS[kind]) marks[i].tint = COLORS[kind];
      }
    },
    destroy: () => container.destroy({ children: true, context: true }),
  };
}
