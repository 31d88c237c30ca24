/** Jets of air that the player blows at the cloth. */
import { COMPONENTS, defineLaw, type PhysicsWorld, replaceForce, scalar, vector } from '@principia/physics';

/** Standard deviation of the jet's Gaussian profile of speed, m. */
const RADIUS = 0.3;
/** Speed of the air on the axis, m/s. A node weighs as much as the drag of air at 6.5 m/s. */
const SPEED = 30;
/** Number of jets: one for each of two fingers. */
export const JETS = 2;

/** A line through a point, m, along a unit vector. In 2D the direction is zero: the jet meets the plane from the front. */
export interface JetAxis {
  readonly through: { readonly x: number; readonly y: number; readonly z: number };
  readonly along: { readonly x: number; readonly y: number; readonly z: number };
}

/**
 * Drag by the air of the jet alone: `breeze` has the drag of air at rest, and linear drag of two winds is the sum of both.
 * On the axis the air flows along it; around the axis it also spreads outwards, as a jet does in front of a wall.
 */
const lawOf = (name: string) =>
  defineLaw({
    name,
    formula: 'F = k u exp(-ρ²/(2σ²)) (d + ρ/σ)',
    reads: { drag: COMPONENTS.LinearDrag },
    parameters: { speed: scalar('m/s', { min: 0 }), through: vector('m'), along: vector('') },
    force: ({ position, drag }, { speed, through, along }) => {
      const offset = position.sub(through);
      const across = offset.sub(along.mul(offset.dot(along)));
      const profile = across
        .lengthSquared()
        .div(-2 * RADIUS ** 2)
        .exp();
      return along.add(across.div(RADIUS)).mul(speed.mul(profile).mul(drag));
    },
  });

const NAMES = Array.from({ length: JETS }, (_, jet) => `air jet ${jet + 1}`);
const LAWS = NAMES.map(lawOf);

/**
 * Lets a jet blow along an axis, until the next call for it. A jet that does not blow is no force of the world: for some two
 * thousand nodes it would take a sixth of the step.
 * @param axis undefined stops it
 */
export function blow(world: PhysicsWorld, jet: number, axis: JetAxis | undefined): void {
  const { forces } = world;
  const index = forces.findIndex(({ name }) => name === NAMES[jet]);
  if (axis !== undefined) {
    const force = LAWS[jet]({ speed: SPEED, ...axis });
    if (index < 0) forces.push(force);
    else replaceForce(world, force);
  } else if (index >= 0) forces.splice(index, 1);
}
