import { defineComponent, normaliseFields, real } from './define.ts';

const NEWTONS = { bounds: { min: -1e38, max: 1e38 } };
const DIRECTION = { bounds: { min: -1e12, max: 1e12 } };

/** A steady force on the body, N, in world axes or its own: write the columns to steer. See `thrust`. */
export const Thrust = defineComponent({
  fields: { x: real('N', NEWTONS), y: real('N', NEWTONS), z: real('N', { ...NEWTONS, spatial: true }) },
});

/** An engine of given power along the way the body goes. See `motors`. */
export const Motor = defineComponent({
  scalar: 'power',
  fields: {
    /** Power P, W; negative brakes. */
    power: real('W', { bounds: { min: -1e38, max: 1e38 } }),
    /** Most force it can give, N: P/v grows without bound towards rest. */
    maxForce: real('N', { initial: 1000, bounds: { above: 0, max: 1e38 } }),
  },
});

/** A rocket engine that burns part of its body's mass. See `rocketEngines`. */
export const Engine = defineComponent({
  fields: {
    /** Speed v_e at which the exhaust leaves, m/s. */
    exhaustSpeed: real('m/s', { bounds: { min: 0, max: 299_792_458 } }),
    /** Mass burnt per time at full throttle, kg/s. */
    burnRate: real('kg/s', { bounds: { min: 0, max: 1e38 } }),
    /** Fuel left, kg: part of the body's Mass. */
    fuel: real('kg', { bounds: { min: 0, max: 1e38 } }),
    /** 0 off, 1 full. */
    throttle: real('', { initial: 1, bounds: { min: 0, max: 1 } }),
    /** Where it pushes: a unit vector, in the body's frame or the world's. Given vectors are normalised. */
    x: real('', DIRECTION),
    y: real('', { ...DIRECTION, initial: 1 }),
    z: real('', { ...DIRECTION, spatial: true }),
    /** Thrust of the last step, N, written by the engine: what a flame shows. */
    thrustX: real('N'),
    thrustY: real('N'),
    thrustZ: real('N'),
  },
  complete(values, entity) {
    normaliseFields(values, ['x', 'y', 'z'], 'engine', 'Give x, y and z of the push, such as { y: 1 }.', entity);
  },
});
