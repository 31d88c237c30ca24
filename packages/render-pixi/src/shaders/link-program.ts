import { NO_LINK } from '../link-list.ts';
import { GLSL_LINE_FRAGMENT, GLSL_LINE_VERTEX, WGSL_LINE } from './line.ts';
import type { PullProgram } from './pull-program.ts';

/** Draws lines between the centres of bodies: texels `2 i` and `2 i + 1` of the pairs are the ids of link `i`, or `NO_LINK`. */
export const LINK_PROGRAM: PullProgram = {
  name: 'principia-links',
  textures: {
    uPairs: 'whole',
    uLineColors: 'whole',
    uX: 'real',
    uY: 'real',
    uPreviousX: 'real',
    uPreviousY: 'real',
  },
  uniforms: { uLineColor: 'vec4<f32>', uThickness: 'f32', uAlpha: 'f32' },
  glsl: {
    vertex: `${GLSL_LINE_VERTEX}
vec2 centre(int id) {
  vec2 from = vec2(real(uPreviousX, id), real(uPreviousY, id));
  return mix(from, vec2(real(uX, id), real(uY, id)), uAlpha);
}

void main() {
  int i = gl_VertexID >> 2;
  if (whole(uPairs, 2 * i) == ${NO_LINK}u) {
    gl_Position = NOWHERE;
    return;
  }
  float width = uThickness * pixelRatio();
  uint bytes = whole(uLineColors, i);
  drawLine(centre(int(whole(uPairs, 2 * i))), centre(int(whole(uPairs, 2 * i + 1))), width);
  vColor = thinned(tinted(bytes == 0u ? uLineColor : rgba(bytes)), width);
}
`,
    fragment: GLSL_LINE_FRAGMENT,
  },
  wgsl: `${WGSL_LINE}
fn centre(id: i32) -> vec2<f32> {
  let start = vec2<f32>(real(uPreviousX, id), real(uPreviousY, id));
  return mix(start, vec2<f32>(real(uX, id), real(uY, id)), own.uAlpha);
}

@vertex
fn mainVertex(@builtin(vertex_index) vertex: u32) -> Varyings {
  let index = i32(vertex);
  let i = index >> 2u;
  if (whole(uPairs, 2 * i) == ${NO_LINK}u) {
    var out: Varyings;
    out.position = NOWHERE;
    return out;
  }
  let bytes = whole(uLineColors, i);
  let color = tinted(select(rgba(bytes), own.uLineColor, bytes == 0u));
  let a = centre(i32(whole(uPairs, 2 * i)));
  let b = centre(i32(whole(uPairs, 2 * i + 1)));
  return drawLine(a, b, own.uThickness * pixelRatio(), index, color);
}
`,
};
