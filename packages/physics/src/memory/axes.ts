/** The axis names of a world by its dimensions; they are keys of columns and addresses. */
export const AXES = { 2: ['x', 'y'], 3: ['x', 'y', 'z'] } as const;

/** The component that stores the orientation of a body, by dimensions. */
export const ANGLES = { 2: 'Rotation', 3: 'Orientation' } as const;
