/** The hull and the water about it. SI units. */

export const GRAVITY = 9.81;
/** Of sea water, kg/m³. */
export const DENSITY = 1025;
/** Volume of the hull, m³; half its height, m; its drag, kg/m; force of the propeller, N. */
export const HULL = { volume: 60, halfHeight: 2.2, length: 15, drag: 12_000, thrust: 300_000 } as const;
