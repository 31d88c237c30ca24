import { describe, expect, it } from 'vitest';
import { manifestOf, packageNames } from '../../scripts/lib/packages.mjs';
import { read } from './sources.ts';

const repository = 'https://github.com/principia-physics/principia';
const { version } = JSON.parse(read('package.json'));

it('there are packages', () => expect(packageNames.length).toBeGreaterThan(4));

describe.each(packageNames)('the manifest of %s', (name) => {
  const manifest = manifestOf(name);

  it('has the version of the project, and asks for that of its siblings', () => {
    expect(manifest.version).toBe(version);
    const wanted: Record<string, string> = { ...manifest.dependencies, ...manifest.peerDependencies };
    const siblings = Object.entries(wanted).filter(([other]) => other.startsWith('@principia/'));
    expect(siblings.filter(([, range]) => range !== version)).toEqual([]);
  });

  it('says what the package is and where it comes from', () => {
    expect(manifest).toMatchObject({
      name: `@principia/${name}`,
      license: 'MIT',
      homepage: `${repository}/tree/main/packages/${name}#readme`,
      bugs: `${repository}/issues`,
      repository: { type: 'git', url: `git+${repository}.git`, directory: `packages/${name}` },
      publishConfig: { access: 'public' },
    });
    expect(manifest.description.length).toBeGreaterThan(20);
    expect(manifest.keywords.length).toBeGreaterThan(3);
  });

  it('lets bundlers drop what is not used, and exports itself', () => {
    expect(manifest.sideEffects).toBe(false);
    expect(manifest.files).toEqual(name === 'physics' ? ['dist', 'docs'] : ['dist']);
    expect(manifest.exports['./package.json']).toBe('./package.json');
  });

  it('leaves the choice of a renderer’s library to the user', () => {
    expect(Object.keys(manifest.dependencies)).not.toContain('pixi.js');
    expect(Object.keys(manifest.dependencies)).not.toContain('three');
  });
});
