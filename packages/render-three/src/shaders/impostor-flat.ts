/** GLSL of the shapes without a surface: an outline of the body's silhouette, and a soft spot of light. */
import { SHAPES } from '@principia/render-core';

export function flatVertexShader(declarations: string): string {
  return /* glsl */ `
#include <common>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
${declarations}
void main() {
  pullImpostor();
  placeImpostor();
  gl_Position = impostorVisible ? projectionMatrix * impostorCorner : vec4(2.0, 2.0, 2.0, 1.0);
  #include <logdepthbuf_vertex>
}
`;
}

/** Writes premultiplied colour: alpha is what is hidden behind an outline, and zero where light is added. */
export function flatFragmentShader(declarations: string): string {
  return /* glsl */ `
#include <common>
#include <logdepthbuf_pars_fragment>
${declarations}
void main() {
  #include <logdepthbuf_fragment>
  vec3 origin, direction;
  impostorRay(origin, direction);
  vec3 toRay = origin - vSphere.xyz;
  float offset = length(toRay - dot(toRay, direction) * direction) / vSphere.w;
  if (offset > 1.0) discard;
  vec4 color = linearToOutputTexel(vBodyColor);
  if (vBodyShape == ${SHAPES.glow}u) {
    float fall = 1.0 - offset;
    gl_FragColor = vec4(color.rgb * color.a * fall * fall, 0.0);
  } else {
    float width = max(0.12, 1.5 * fwidth(offset));
    float alpha = coverageOf(1.0 - offset) * coverageOf(offset - 1.0 + width) * color.a;
    gl_FragColor = vec4(color.rgb * alpha, alpha);
  }
}
`;
}
