import { defineComponent, type FieldSpec, normaliseFields, real } from './define.ts';

const NEWTONS = { bounds: { min: -1e38, max: 1e38 } };
const DIRECTION = { bounds: { min: -1e12, max: 1e12 } };

/** Comments for editors: see `PositionFields`. */
export type ThrustFields = {
  /** Along x of the world or of the body, N; default 0. */
  x: FieldSpec<'real'>;
  /** Along y of the world or of the body, N; default 0. */
  y: FieldSpec<'real'>;
  /** Along z of the world or of the body, N; default 0. */
  z: FieldSpec<'real'>;
};

/** A constant force on the body, N, in axes of the world or of the body: write the columns to steer. See `thrust`. */
export const Thrust = defineComponent<{ readonly fields: ThrustFields }>({
  fields: { x: real('N', NEWTONS), y: real('N', NEWTONS), z: real('N', { ...NEWTONS, spatial: true }) },
});

/** An engine of constant power along the velocity. See `motors`. */
export const Motor = defineComponent({
  scalar: 'power',
  fields: {
    /** Power P, W; negative brakes. */
    power: real('W', { bounds: { min: -1e38, max: 1e38 } }),
    /** Maximum force, N, since P/v diverges at rest. */
    maxForce: real('N', { initial: 1000, bounds: { above: 0, max: 1e38 } }),
  },
});

/** A rocket engine, whose fuel is part of its body's mass. See `rocketEngines`. */
export const Engine = defineComponent({
  fields: {
    /** Exhaust speed v_e, m/s. */
    exhaustSpeed: real('m/s', { bounds: { min: 0, max: 299_792_458 } }),
    /** Mass flow at full throttle, kg/s. */
    burnRate: real('kg/s', { bounds: { min: 0, max: 1e38 } }),
    /** Remaining fuel, kg: included in the body's Mass. */
    fuel: real('kg', { bounds: { min: 0, max: 1e38 } }),
    /** Throttle: 0 off, 1 full. */
    throttle: real('', { initial: 1, bounds: { min: 0, max: 1 } }),
    /** Direction of the thrust: a unit vector, in axes of the body or the world. Given vectors are normalised. */
    x: real('', DIRECTION),
    y: real('', { ...DIRECTION, initial: 1 }),
    z: real('', { ...DIRECTION, spatial: true }),
    /** Thrust of the last step, N, written by the engine, for example to draw a flame. */
    thrustX: real('N'),
    thrustY: real('N'),
    thrustZ: real('N'),
    /** What the engine rounded fuel and Mass by in the last step, kg. */
    fuelRemainder: real('kg'),
    massRemainder: real('kg'),
  },
  complete(values, entity) {
    normaliseFields(
      values,
      ['x', 'y', 'z'],
      'engine',
      'Give x, y and z of the thrust direction, such as { y: 1 }.',
      entity,
    );
  },
});
