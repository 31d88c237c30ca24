import { defineComponent, type FieldSpec, type FlagSpec, flag, real, u32 } from './define.ts';

/** What to do where bits of layers are refused. */
export const BITS_HINT = 'Bits are a number without a sign: write `~4 >>> 0` for all layers but 4.';

/**
 * Rules by which a coefficient of a contact follows from those of its bodies. `standard` is the geometric mean for friction,
 * and the larger value for restitution.
 */
export const COMBINE = { standard: 0, average: 1, min: 2, multiply: 3, max: 4 } as const;

/** Comments for editors: see `PositionFields`. */
export type ColliderFields = {
  /** Radius, or greatest distance of the surface of `shape` from the body's position, m; default 0.5. */
  radius: FieldSpec<'real'>;
  /** Ratio of separation to approach speed: 0 inelastic, 1 elastic; above 1, up to 10, adds energy; default 0. */
  restitution: FieldSpec<'real'>;
  /** Coulomb friction coefficient, static and kinetic; default 0. */
  friction: FieldSpec<'real'>;
  /** Index into the world's shape pool, which `spawn` and `setShape` write; 0 is the disc or ball of `radius`. */
  shape: FieldSpec<'u32'>;
  /** Torque that resists rolling, as a fraction of normal force times radius; default 0. Rigid bodies only. */
  rollingResistance: FieldSpec<'real'>;
  /** Speed of the surface along its tangent, m/s, as of a conveyor belt; default 0. Rigid bodies only. */
  tangentSpeed: FieldSpec<'real'>;
  /** Layers that the body is on, one bit each; default 1. */
  layers: FieldSpec<'u32'>;
  /** Layers that it collides with, one bit each: two bodies collide where each is on a layer of the other's mask. */
  mask: FieldSpec<'u32'>;
  /**
   * Rigid bodies of one group collide with each other always if it is positive, whatever their layers, and never if it is
   * negative. 0 is none.
   */
  group: FieldSpec<'real'>;
  /** 1 for a sensor: it touches nothing, and `sensorEvents` lists what begins and ends to overlap it. Rigid bodies only. */
  sensor: FlagSpec;
  /** 1 where only what comes down on the upper side of the shape, +y in its frame, is held. Rigid bodies only. */
  oneWay: FlagSpec;
  /** 1 for a body that passes through nothing, however fast both are. Rigid bodies only. */
  bullet: FlagSpec;
  /**
   * How friction and restitution of a contact follow from those of its two rigid bodies: a number of `COMBINE`. Of two
   * different rules the larger number holds.
   */
  frictionCombine: FieldSpec<'u32'>;
  restitutionCombine: FieldSpec<'u32'>;
};

/**
 * The shape by which a body meets others, about its position, and how its surface behaves: a disc (2D) or a ball (3D) of
 * `radius`, or in 2D a shape of the world's shape pool.
 */
export const Collider = defineComponent<{ readonly scalar: 'radius'; readonly fields: ColliderFields }>({
  scalar: 'radius',
  fields: {
    radius: real('m', {
      initial: 0.5,
      bounds: { min: 1e-9, max: 1e12 },
      hint: 'For a point without contacts, omit Collider.',
    }),
    restitution: real('', { initial: 0, bounds: { min: 0, max: 10 } }),
    friction: real('', { initial: 0, bounds: { min: 0, max: 100 } }),
    shape: u32('', {
      hint: 'Shapes such as box(1, 0.5) are given to `spawn` and `setShape`, which store their index here.',
    }),
    rollingResistance: real('', { bounds: { min: 0, max: 100 } }),
    tangentSpeed: real('m/s', { bounds: { min: -1e6, max: 1e6 } }),
    layers: u32('', { initial: 1, hint: BITS_HINT }),
    mask: u32('', { initial: 0xffffffff, hint: BITS_HINT }),
    group: real('', { bounds: { min: -8388608, max: 8388607, integer: true } }),
    sensor: flag(),
    oneWay: flag(),
    bullet: flag(),
    frictionCombine: u32('', { bounds: { max: COMBINE.max } }),
    restitutionCombine: u32('', { bounds: { max: COMBINE.max } }),
  },
});
