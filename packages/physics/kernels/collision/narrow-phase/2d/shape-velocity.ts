// The velocity of the centre of a shape, which is in row `row`: of the parts of a body that turns each has its own.
import { BodyState, poseOf } from '../../../solver/2d/body';
import { RigidTable } from '../../../solver/2d/rigid-table';

// @ts-ignore: decorator
@inline export function velocityX(t: RigidTable, state: BodyState, body: i32, row: i32): real {
  return state.vx - state.w * (poseOf(t, row).y - poseOf(t, body).y);
}

// @ts-ignore: decorator
@inline export function velocityY(t: RigidTable, state: BodyState, body: i32, row: i32): real {
  return state.vy + state.w * (poseOf(t, row).x - poseOf(t, body).x);
}
