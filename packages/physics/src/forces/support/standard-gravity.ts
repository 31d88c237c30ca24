/** Standard acceleration of free fall, m/s². */
export const STANDARD_GRAVITY = 9.80665;
