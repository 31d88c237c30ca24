// JPL planetary ephemeris DE421 (Folkner, Williams, Boggs: IPN Progress Report 42-178, 2009), public domain, at midnight of
// 1 January 2012, TDB.
//
// Axes and units as in states.ts. The source has places and velocities relative to the Sun; the origin here is the centre
// of mass of the listed bodies, at rest. The source has no Pluto: its state is that of states.ts, integrated for 12 years.
import type { BodyName, EpochState } from './states.ts';

/** Julian date of the states. */
export const EPOCH_2012 = 2455927.5;

export const STATES_2012: Readonly<Record<BodyName, Pick<EpochState, 'position' | 'velocity'>>> = {
  sun: {
    position: [-484975.4193, -182695.7846, -79345.8832],
    velocity: [0.007394386835, -0.007326187886, -0.003336128874],
  },
  mercury: {
    position: [-57219841.1681, -27969254.2805, -9040161.612],
    velocity: [12.171928846444, -36.052420509802, -20.519162992904],
  },
  venus: {
    position: [107877234.7716, 7035518.7319, -3688828.5122],
    velocity: [-1.810746002394, 31.709580422588, 14.381990420103],
  },
  earth: {
    position: [-25500645.5713, 132818634.6122, 57578805.8023],
    velocity: [-29.831359377556, -4.767550625242, -2.066490532444],
  },
  moon: {
    position: [-25102634.2238, 132849570.7909, 57629111.2442],
    velocity: [-29.918170159575, -3.867954536197, -1.711817858422],
  },
  mars: {
    position: [-178429156.1334, 154530595.3858, 75689316.8341],
    velocity: [-15.920767861718, -14.120915779271, -6.046672885346],
  },
  jupiter: {
    position: [561384506.9037, 452731788.3545, 180372978.4609],
    velocity: [-8.719623679018, 9.567628192435, 4.313234893293],
  },
  saturn: {
    position: [-1337929511.0269, -535713757.451, -163678040.7261],
    velocity: [3.189046939861, -8.213587709266, -3.529877405672],
  },
  uranus: {
    position: [2997209541.8719, 180593873.6464, 36703418.7093],
    velocity: [-0.45873068031, 5.933532806727, 2.605222182043],
  },
  neptune: {
    position: [3891680316.0854, -2033126458.7186, -929058757.1915],
    velocity: [2.670704600046, 4.417275583844, 1.741523824718],
  },
  pluto: {
    position: [590710969.2735, -4503685103.4714, -1583441395.7179],
    velocity: [5.495635102662, 0.244167521806, -1.579619147715],
  },
};
