import { Presets, SingleBar } from 'cli-progress';

/** Shows the progress of a task. */
export interface Progress {
  update(done: number): void;
  end(): void;
}

/** A bar on a terminal; elsewhere a line for every quarter, which keeps logs short. */
export function startProgress(what: string, total: number, stream: NodeJS.WriteStream = process.stderr): Progress {
  return stream.isTTY ? terminalBar(what, total, stream) : plainLines(what, total, stream);
}

function terminalBar(what: string, total: number, stream: NodeJS.WriteStream): Progress {
  const format = `${what.padEnd(10)} {bar} {percentage} %  {value}/{total}  {eta_formatted} left`;
  const bar = new SingleBar({ format, stream, hideCursor: true, clearOnComplete: true }, Presets.shades_classic);
  bar.start(total, 0);
  return { update: (done) => bar.update(done), end: () => bar.stop() };
}

function plainLines(what: string, total: number, stream: NodeJS.WriteStream): Progress {
  let quarters = 0;
  return {
    update(done) {
      const reached = Math.floor((4 * done) / total);
      if (reached <= quarters) return;
      quarters = reached;
      stream.write(`${what} ${25 * quarters} %\n`);
    },
    end() {},
  };
}
