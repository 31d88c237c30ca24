import { describe, expect, it } from 'vitest';
import { BODY_PROGRAM } from './body-program.ts';
import { LINK_PROGRAM } from './link-program.ts';
import { glslHeader, gpuLayout, wgslHeader } from './pull-program.ts';
import { SEGMENT_PROGRAM } from './segment-program.ts';
import { TRAIL_PROGRAM } from './trail-program.ts';

describe.each([BODY_PROGRAM, TRAIL_PROGRAM, SEGMENT_PROGRAM, LINK_PROGRAM])('$name', (program) => {
  it('keeps to the textures a vertex stage is sure of', () => {
    expect(Object.keys(program.textures).length).toBeLessThanOrEqual(16);
  });

  it('declares every texture and uniform for both languages, in the order of the layout', () => {
    const { vertex } = glslHeader(program);
    const wgsl = wgslHeader(program);
    const [, , own] = gpuLayout(program);
    for (const [i, [name, kind]] of Object.entries(program.textures).entries()) {
      expect(vertex).toContain(`sampler2D ${name};`);
      expect(wgsl).toContain(`@binding(${i + 1}) var ${name}: texture_2d<${kind === 'real' ? 'f32' : 'u32'}>;`);
      expect(own[i + 1].texture?.sampleType).toBe(kind === 'real' ? 'unfilterable-float' : 'uint');
    }
    for (const name of Object.keys(program.uniforms)) {
      expect(vertex).toMatch(new RegExp(`uniform \\w+ ${name};`));
      expect(wgsl).toContain(`  ${name}: `);
    }
  });

  it('uses high precision in both stages', () => {
    const { vertex, fragment } = glslHeader(program);
    for (const source of [vertex, fragment]) expect(source).toContain('precision highp float;');
  });

  it('orders its uniforms so that WGSL needs no padding', () => {
    const widths = Object.values(program.uniforms).map((type) =>
      type.startsWith('vec4') ? 4 : type === 'vec2<f32>' ? 2 : 1,
    );
    expect(widths).toEqual([...widths].sort((a, b) => b - a));
  });
});
