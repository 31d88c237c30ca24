import { spawnSync } from 'node:child_process';
import { expect, test } from 'vitest';

test.each(['frame-cost', 'leaks', 'open-time', 'site', 'start-time'])(
  '%s refuses options it does not know, and lists its own',
  (name) => {
    const { status, stdout, stderr } = spawnSync(process.execPath, [`scripts/${name}.mjs`, '--colour', 'red'], {
      encoding: 'utf8',
    });
    expect(status).toBe(2);
    expect(stdout).toBe('');
    expect(stderr).toMatch(/^Unknown option '--colour'\. The options are --\w+(, --\w+)+\.\n$/);
  },
);

test.each([
  ['soak', ['--operations', 'abc'], '--operations must be a whole number from 0, not "abc".'],
  ['soak', ['--operations', '0', '--steps', '5000'], '--steps must be 0 or at least 20000'],
  ['leaks', ['--minutes', 'abc'], '--minutes must be a number from 0.01, not "abc".'],
  ['leaks', ['--game', 'chess'], 'There is no game "chess": they are '],
])('%s %j measures nothing, and says why', (name, args, sentence) => {
  const { status, stdout, stderr } = spawnSync(process.execPath, [`scripts/${name}.mjs`, ...args], {
    encoding: 'utf8',
  });
  expect([status, stdout]).toEqual([2, '']);
  expect(stderr).toContain(sentence);
});
