// Bounds shared by the parameters of many laws. 10³⁸ is close to the largest f32.
import { MAX_POSITION, POSITION_LIMITS } from '../../components/position.ts';
import { VELOCITY_LIMITS } from '../../components/velocity.ts';

export const ANY = { min: -1e38, max: 1e38 };
export const NOT_NEGATIVE = { min: 0, max: 1e38 };
export const POSITIVE = { above: 0, max: 1e38 };
export const POSITION_BOUNDS = POSITION_LIMITS;
export const LENGTH_BOUNDS = { above: 0, max: MAX_POSITION };
export const VELOCITY_BOUNDS = VELOCITY_LIMITS;
