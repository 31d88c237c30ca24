// JPL planetary ephemeris DE421 (Folkner, Williams, Boggs: IPN Progress Report 42-178, 2009), public domain.
//
// Barycentric, axes of the ICRF (Earth's mean equator and equinox of J2000), km and km/s, time TDB. Mars to Pluto are
// the barycentres of planets with their moons, and GM is that of the whole.

/** A body at the epoch. */
export interface EpochState {
  /** G times its mass, km³/s². */
  readonly gm: number;
  /** Mean radius, km. */
  readonly radius: number;
  /** km. */
  readonly position: readonly [number, number, number];
  /** km/s. */
  readonly velocity: readonly [number, number, number];
}

/** Julian date of the states: noon of 1 January 2000. */
export const EPOCH = 2451545;

/** Speed of light, km/s. */
export const SPEED_OF_LIGHT = 299792.458;

/** Astronomical unit of the ephemeris, km. */
export const ASTRONOMICAL_UNIT = 149597870.6996262;

/** Inclination of the ecliptic to the equator, 84381.448″: its cosine and sine. */
export const OBLIQUITY = { cos: 0.9174820620691818, sin: 0.3977771559319137 };

/** The bodies, by distance from the Sun; the Moon follows the Earth. */
export const STATES = {
  sun: {
    gm: 132712440040.9446,
    radius: 695700,
    position: [-1067598.6811, -395988.8329, -138071.0363],
    velocity: [0.009312569289, -0.01170150765, -0.005251247671],
  },
  mercury: {
    gm: 22032.09000000011,
    radius: 2439.7,
    position: [-20529325.1378, -60323955.48, -30130845.7553],
    velocity: [37.004304387814, -8.541376231973, -8.398373333422],
  },
  venus: {
    gm: 324858.59200000117,
    radius: 6051.8,
    position: [-108524092.7435, -7318517.5117, 3548115.8744],
    velocity: [1.391218587983, -32.029519942558, -14.497086715497],
  },
  earth: {
    gm: 398600.43623333966,
    radius: 6371,
    position: [-27566632.311, 132361428.5383, 57418647.3837],
    velocity: [-29.784947502523, -5.029753792208, -2.180645082525],
  },
  moon: {
    gm: 4902.800076227743,
    radius: 1737.4,
    position: [-27858240.6964, 132094711.7053, 57342544.8965],
    velocity: [-29.141416115694, -5.695841478366, -2.48197078679],
  },
  mars: {
    gm: 42828.37521400019,
    radius: 3389.5,
    position: [206980541.971, -186369.8356, -5667233.1044],
    velocity: [1.171985013152, 23.906708192941, 10.933920650325],
  },
  jupiter: {
    gm: 126712764.8000003,
    radius: 69911,
    position: [597499986.0228, 408990381.9074, 160756218.9656],
    velocity: [-7.900525062283, 10.171796549817, 4.552467367493],
  },
  saturn: {
    gm: 37940585.20000016,
    radius: 58232,
    position: [957317526.1406, 923319670.953, 340162788.9958],
    velocity: [-7.422709426027, 6.097474824543, 2.837682292941],
  },
  uranus: {
    gm: 5794548.600000031,
    radius: 25362,
    position: [2157907516.5188, -1871306812.9279, -850106410.6385],
    velocity: [4.646335882393, 4.251153497545, 1.796171746466],
  },
  neptune: {
    gm: 6836535.000000017,
    radius: 24622,
    position: [2513979090.5353, -3438170415.3282, -1469851221.0963],
    velocity: [4.475215434163, 2.877104165007, 1.066200621271],
  },
  pluto: {
    gm: 977.0000000000057,
    radius: 1188.3,
    position: [-1478399422.324, -4185975816.4338, -860878354.0688],
    velocity: [5.253463454466, -1.964080096506, -2.195770813713],
  },
} as const satisfies Record<string, EpochState>;

/** The name of a body of the solar system. */
export type BodyName = keyof typeof STATES;

/** All bodies, by distance from the Sun. */
export const BODY_NAMES = Object.keys(STATES) as BodyName[];
