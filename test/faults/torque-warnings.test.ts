/** Torques that turn nothing, and drags that a step cannot follow, are named. */
import { COMPONENTS, defineLaw, linearDrag, mutualGravity, spawn, step, vec3, wisdomHolman } from '@principia/physics';
import { expect, it } from 'vitest';
import { warnedWorld } from '../support/warned-world.ts';

it('asks the same of every law with a torque, of the bodies that it acts on', () => {
  const twist = defineLaw({
    name: 'twist',
    reads: { charge: COMPONENTS.Charge },
    torque: ({ charge }) => vec3(0, 0, charge),
  });
  const warned = (init: object) => {
    const { world, messages } = warnedWorld({ forces: [twist()] });
    spawn(world, { position: {}, velocity: {}, mass: 1, charge: 1, rotation: 0, ...init });
    step(world, 0.01);
    return messages();
  };
  expect(warned({ inertia: 1 })).toBe('"twist" does not turn body 1, because it has Inertia and no AngularVelocity.');
  expect(warned({ angularVelocity: 0 })).toBe(
    '"twist" does not turn body 1, because it has AngularVelocity and no Inertia.',
  );
  expect(warned({ inertia: 1, angularVelocity: 0 })).toBe('');
  expect(warned({})).toBe('');
  const { world, messages } = warnedWorld({ forces: [twist()] });
  spawn(world, { position: {}, velocity: {}, mass: 1, inertia: 1 });
  step(world, 0.01);
  expect(messages()).toBe('');
});

it('names a drag that is too strong for the one kick of wisdomHolman', () => {
  const warned = (coefficient: number) => {
    const { world, messages } = warnedWorld({
      integrator: wisdomHolman({ G: 1 }),
      forces: [mutualGravity({ G: 1 }), linearDrag()],
    });
    spawn(world, { position: {}, velocity: {}, mass: 1 });
    spawn(world, { position: { x: 1 }, velocity: { y: 1 }, mass: 1e-3, linearDrag: coefficient });
    step(world, 0.1);
    return messages();
  };
  expect(warned(0.03)).toBe(
    'the drag of body 2 takes more of its speed in a step than it has, and throws it back faster.',
  );
  expect(warned(0.01)).toBe('');
});
