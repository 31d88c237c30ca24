/** The axes of a world by its dimensions: names that key columns and addresses alike. */
export const AXES = { 2: ['x', 'y'], 3: ['x', 'y', 'z'] } as const;
