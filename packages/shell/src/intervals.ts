/** How often a game's page does what it does not do in every frame. */

/** Interval of updates of statistics and plot, s. */
export const STATS_INTERVAL = 0.2;
/** Shortest time between two new worlds while a slider is dragged, s. */
export const RESET_INTERVAL = 0.12;
export const SLOW_MOTION = 0.2;
