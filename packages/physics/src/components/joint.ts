import { PhysicsError } from '../errors/physics-error.ts';
import { bodyId, bodyIdOrWorld, defineComponent, real, u32 } from './define.ts';

/** Kinds of joints, by the number in `Joint.kind`: that of kernels/joints/2d/joint-table.ts. */
export const JOINT_KINDS = [
  'revolute',
  'distance',
  'weld',
  'prismatic',
  'wheel',
  'motor',
  'pulley',
  'gear',
  'filter',
] as const;

const LENGTH = { bounds: { min: -1e12, max: 1e12 } };
const ANGLE = { bounds: { min: -1e9, max: 1e9 } };

/**
 * A joint between two rigid bodies, made by `createJoint`. The entity that has it is the joint, and goes when one of its
 * bodies goes. Limits, springs and motors may be changed at any time. The free coordinate of a joint is the angle of b from
 * a, the distance along its axis, or the distance of its anchors.
 */
export const Joint = defineComponent({
  fields: {
    /** 0 revolute, 1 distance, 2 weld, 3 prismatic, 4 wheel, 5 motor, 6 pulley, 7 gear, 8 filter. */
    kind: u32('', { bounds: { max: JOINT_KINDS.length - 1 } }),
    /** The bodies it joins, by id; a is 0 where b is joined to the world. */
    a: bodyIdOrWorld('aGeneration', true),
    b: bodyId('bGeneration', true),
    /** Which life of those ids is meant; filled in by the engine. */
    aGeneration: u32(''),
    bGeneration: u32(''),
    /** The anchors in the frames of a, or of the world, and of b. */
    ax: real('m', LENGTH),
    ay: real('m', LENGTH),
    bx: real('m', LENGTH),
    by: real('m', LENGTH),
    /** Angle of b from a at which the joint's angle is 0. */
    angle: real('rad', ANGLE),
    /** Direction of the axis of a prismatic or wheel joint in the frame of a; of a gear joint, in that of the world. */
    axis: real('rad', ANGLE),
    /** Length of a distance joint; of a pulley, length of the rope: that at a and `ratio` times that at b. */
    length: real('m', { bounds: { min: 0, max: 1e12 } }),
    /** Of a pulley: where the rope leaves the wheels, in the world. */
    pulleyAx: real('m', LENGTH),
    pulleyAy: real('m', LENGTH),
    pulleyBx: real('m', LENGTH),
    pulleyBy: real('m', LENGTH),
    /** Of a pulley: metres of rope at a for one at b. Of a gear: radians, or metres, of b for a radian of a. */
    ratio: real('', { initial: 1, bounds: { min: -1e6, max: 1e6 } }),
    /** 1 where a gear joint moves b along `axis` rather than turning it. */
    isRack: u32('', { bounds: { max: 1 } }),
    /** 1 where `lower` and `upper` bound the free coordinate, m or rad. */
    hasLimits: u32('', { bounds: { max: 1 } }),
    lower: real('', LENGTH),
    upper: real('', LENGTH),
    /** Frequency of the spring along the free coordinate; 0 for none. */
    hertz: real('Hz', { bounds: { min: 0, max: 1e6 } }),
    /** Damping ratio of the spring: 1 is critical. */
    dampingRatio: real('', { initial: 1, bounds: { min: 0, max: 1000 } }),
    /** Largest force of the spring of a distance joint, and of a motor joint. */
    maxForce: real('N', { initial: 1e30, bounds: { min: 0, max: 1e30 } }),
    /** Largest force with which the spring of a distance joint pushes; with 0 it is an elastic cord, which only pulls. */
    maxCompression: real('N', { initial: 1e30, bounds: { min: 0, max: 1e30 } }),
    /** Speed that the motor keeps, m/s or rad/s. */
    motorSpeed: real('', { bounds: { min: -1e9, max: 1e9 } }),
    /** Largest force, N, or torque, N m, of the motor; 0 for none. */
    maxMotor: real('', { bounds: { min: 0, max: 1e30 } }),
    /** Force at which it breaks, N; 0 for never. */
    breakForce: real('N', { bounds: { min: 0, max: 1e30 } }),
    /** Torque at which it breaks, N m; 0 for never. */
    breakTorque: real('N m', { bounds: { min: 0, max: 1e30 } }),
    /** 1 where the two bodies collide with each other. */
    collide: u32('', { bounds: { max: 1 } }),
    /** 1 once the solver knows the joint; filled in by the engine. */
    started: u32('', { bounds: { max: 1 } }),
  },
  complete({ a, b, lower, upper }, entity) {
    const details = { entity, field: 'joint.b', value: b, hint: 'Give the ids of two different bodies as a and b.' };
    if (b === 0) throw new PhysicsError('E_RANGE', 'joint needs a body b.', details);
    if (a === b) throw new PhysicsError('E_RANGE', `joint joins body ${a} to itself.`, details);
    if (lower <= upper) return;
    throw new PhysicsError('E_RANGE', `joint.lower is ${lower}, above joint.upper, which is ${upper}.`, {
      entity,
      field: 'joint.lower',
      value: lower,
      hint: 'Swap the two limits.',
    });
  },
});
