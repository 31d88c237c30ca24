import { defineComponent, real, u32 } from './define.ts';

/** The volume with which a body floats: read by `buoyancy`, `polygonBuoyancy`, `immersedDrag` and `addedMass`. */
export const Hull = defineComponent({
  scalar: 'volume',
  fields: {
    /** Volume when fully immersed, m³. By default a metre of the shape with which the body is spawned, or 1 m³. */
    volume: real('m³', { initial: 1, bounds: { min: 0, max: 1e38 } }),
    /**
     * Half the height from bottom to top, m. By default half the height of the upright shape with which the body is spawned;
     * zero means the collider's radius.
     */
    halfHeight: real('m', { bounds: { min: 0, max: 1e12 } }),
    /**
     * 0 is a sphere, 1 an upright box, 2 or more a polygon registered with `polygonBuoyancy` under this number:
     * `immersedDrag` and `addedMass` take it for an upright box.
     */
    shape: u32('', { bounds: { max: 1000 } }),
  },
});
