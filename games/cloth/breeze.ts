/** A breeze whose gusts travel over the cloth, so that it ripples. */
import { COMPONENTS, defineLaw, scalar, vec3 } from '@principia/physics';

/**
 * Drag towards the velocity of the air, which blows away from the viewer and to the right. A gust is a wave of 4 m length
 * that passes in two seconds, and a shorter one across it.
 */
export const breeze = defineLaw({
  name: 'breeze',
  formula: 'F = -k (v - w(r, t))',
  reads: { drag: COMPONENTS.LinearDrag },
  parameters: { speed: scalar('m/s', { min: 0 }) },
  force: ({ position, velocity, time, drag }, { speed }) => {
    const gust = time.mul(3.1).sub(position.x.mul(1.6)).sin();
    const flutter = time.mul(5.3).add(position.y.mul(2.3)).sub(position.x.mul(0.7)).sin();
    const air = vec3(
      speed.mul(gust.mul(0.25).add(0.45)),
      speed.mul(flutter.mul(0.25)),
      speed.mul(gust.mul(0.5).add(flutter.mul(0.3)).add(0.35)).negate(),
    );
    return air.sub(velocity).mul(drag);
  },
});
