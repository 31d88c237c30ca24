/** A longer pause between two frames, s, is none of the game's: the machine had no time for it, or slept. */
const LONGEST_FRAME = 1;

/** Calls `frame` for every frame of the display, and stops while the page is hidden. */
export interface Loop {
  stop(): void;
}

/**
 * @param frame receives the seconds since the last call, one at most; zero in the first call and after the page was hidden
 * @param onError receives an error thrown by `frame`; the loop continues
 */
export function startLoop(frame: (seconds: number) => void, onError: (error: unknown) => void): Loop {
  // A typed array, because a captured variable would allocate a number on the heap in every frame.
  const last = new Float64Array([Number.NaN]);
  let request = 0;
  const tick = (now: number) => {
    request = requestAnimationFrame(tick);
    // Browsers pass the start time of the frame, which may be slightly before the time of the last request.
    const seconds = Number.isNaN(last[0]) ? 0 : Math.min(LONGEST_FRAME, Math.max(0, (now - last[0]) / 1000));
    last[0] = now;
    try {
      frame(seconds);
    } catch (error) {
      onError(error);
    }
  };
  // The clock goes on while the page is hidden; the loop must not catch up with that time.
  const forget = () => {
    last[0] = Number.NaN;
  };
  document.addEventListener('visibilitychange', forget);
  request = requestAnimationFrame(tick);
  return {
    stop() {
      cancelAnimationFrame(request);
      document.removeEventListener('visibilitychange', forget);
    },
  };
}
