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
