/** Calls `frame` for every picture the display shows, and stands still while the page is hidden. */
export interface Loop {
  stop(): void;
}

/**
 * @param frame gets the seconds since the last call; zero in the first one, and after the page was hidden
 * @param onError gets what `frame` throws; the loop goes on
 */
export function startLoop(frame: (seconds: number) => void, onError: (error: unknown) => void): Loop {
  // In a cell: a variable that functions keep would be a new number on the heap with every frame.
  const last = new Float64Array([Number.NaN]);
  let request = 0;
  const tick = (now: number) => {
    request = requestAnimationFrame(tick);
    // Browsers give the start of the frame, which may be a little before the time the last one was asked for.
    const seconds = Number.isNaN(last[0]) ? 0 : Math.max(0, (now - last[0]) / 1000);
    last[0] = now;
    try {
      frame(seconds);
    } catch (error) {
      onError(error);
    }
  };
  // The display's clock goes on while the page is hidden: that time must not be caught up with.
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
