/** The axes of a world by its dimensions: names that key columns and addresses alike. */
export const AXES = { 2: ['x', 'y'], 3: ['x', 'y', 'z'] } as const;

/** The component that holds how far a body is turned, likewise. */
export const ANGLES = { 2: 'Rotation', 3: 'Orientation' } as const;
