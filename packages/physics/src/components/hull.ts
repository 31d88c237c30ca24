import { defineComponent, real, u32 } from './define.ts';

/** What a body displaces when a fluid covers it: read by `buoyancy`, `immersedDrag` and `addedMass`. */
export const Hull = defineComponent({
  scalar: 'volume',
  fields: {
    /** Volume when wholly immersed, m³. */
    volume: real('m³', { initial: 1, bounds: { min: 0, max: 1e38 } }),
    /** Half the height from keel to top, m; zero takes the collider's radius. */
    halfHeight: real('m', { bounds: { min: 0, max: 1e12 } }),
    /** 0 a sphere, 1 an upright box, 2 and up a polygon that `polygonBuoyancy` was given under this number. */
    shape: u32('', { bounds: { max: 1000 } }),
  },
});
