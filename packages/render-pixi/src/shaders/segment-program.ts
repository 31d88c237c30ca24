import { GLSL_LINE_FRAGMENT, GLSL_LINE_VERTEX, WGSL_LINE } from './line.ts';
import type { PullProgram } from './pull-program.ts';

/** Draws the segments of a list: one texel (x1, y1, x2, y2), metres, for each. */
export const SEGMENT_PROGRAM: PullProgram = {
  name: 'principia-segments',
  textures: { uSegments: 'real', uLineColors: 'whole' },
  uniforms: { uLineColor: 'vec4<f32>', uThickness: 'f32' },
  glsl: {
    vertex: `${GLSL_LINE_VERTEX}
void main() {
  int i = gl_VertexID >> 2;
  vec4 ends = texelFetch(uSegments, texel(i), 0);
  float width = uThickness * pixelRatio();
  uint bytes = whole(uLineColors, i);
  drawLine(ends.xy, ends.zw, width);
  vColor = thinned(tinted(bytes == 0u ? uLineColor : rgba(bytes)), width);
}
`,
    fragment: GLSL_LINE_FRAGMENT,
  },
  wgsl: `${WGSL_LINE}
@vertex
fn mainVertex(@builtin(vertex_index) vertex: u32) -> Varyings {
  let index = i32(vertex);
  let ends = textureLoad(uSegments, texel(index >> 2u), 0);
  let bytes = whole(uLineColors, index >> 2u);
  let color = tinted(select(rgba(bytes), own.uLineColor, bytes == 0u));
  return drawLine(ends.xy, ends.zw, own.uThickness * pixelRatio(), index, color);
}
`,
};
