/** How faces, lines and points are painted. Colours go to the screen as they are given. */
import { DoubleSide, GLSL3, RawShaderMaterial } from "three";

const PRECISION = "precision highp float;\nprecision highp int;\n";

/** Flat shading, edges of faces within the triangles, and hatching where the colour's fourth part is 0. */
export function faceMaterial(): RawShaderMaterial {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    side: DoubleSide,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
    uniforms: { wire: { value: 1 }, pixels: { value: 1 } },
    vertexShader: `${PRECISION}
uniform mat4 modelViewMatrix, projectionMatrix;
in vec3 position;
in vec4 edges, paint;
out vec3 vPlace, vEdges;
flat out vec4 vPaint;
void main() {
  vec4 place = modelViewMatrix * vec4(position, 1.0);
  vPlace = place.xyz;
  vEdges = edges.xyz;
  vPaint = paint;
  gl_Position = projectionMatrix * place;
}`,
    fragmentShader: `${PRECISION}
uniform float wire, pixels;
in vec3 vPlace, vEdges;
flat in vec4 vPaint;
out vec4 colour;
void main() {
  vec3 normal = normalize(cross(dFdx(vPlace), dFdy(vPlace)));
  float light = 0.62 + 0.38 * abs(dot(normal, normalize(vec3(0.35, 0.5, 0.8))));
  if (!gl_FrontFacing) light *= 0.72;
  vec3 lit = vPaint.rgb * light;
  if (vPaint.a < 0.5 && mod(gl_FragCoord.x + gl_FragCoord.y, 9.0 * pixels) < 3.5 * pixels) lit *= 0.45;
  vec3 width = fwidth(vEdges);
  vec3 away = vEdges / max(width, vec3(1e-6)) / pixels;
  // Where faces are but a few pixels wide, their edges would paint all of them.
  vec3 strong = (1.0 - smoothstep(0.6, 1.4, away)) * (1.0 - smoothstep(0.2, 0.6, width * pixels));
  float edge = max(max(strong.x, strong.y), strong.z) * wire * 0.45;
  colour = vec4(mix(lit, vec3(0.1), edge), 1.0);
}`,
  });
}

/** Lines a little in front of the faces they border. */
export function lineMaterial(rgb: readonly number[], over = false): RawShaderMaterial {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    depthTest: !over,
    depthWrite: !over,
    transparent: over,
    uniforms: { rgb: { value: rgb.map((part) => part / 255) } },
    vertexShader: `${PRECISION}
uniform mat4 modelViewMatrix, projectionMatrix;
in vec3 position;
void main() {
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  gl_Position.z -= 0.0004 * gl_Position.w;
}`,
    fragmentShader: `${PRECISION}
uniform vec3 rgb;
out vec4 colour;
void main() { colour = vec4(rgb, 1.0); }`,
  });
}

/** Round points of so many pixels, each of its own colour, with a dark rim. */
export function pointMaterial(size: number): RawShaderMaterial {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    uniforms: { size: { value: size }, pixels: { value: 1 } },
    vertexShader: `${PRECISION}
uniform mat4 modelViewMatrix, projectionMatrix;
uniform float size, pixels;
in vec3 position, paint;
out vec3 vPaint;
void main() {
  vPaint = paint;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  gl_Position.z -= 0.0008 * gl_Position.w;
  gl_PointSize = size * pixels;
}`,
    fragmentShader: `${PRECISION}
in vec3 vPaint;
out vec4 colour;
void main() {
  float away = length(gl_PointCoord - 0.5);
  if (away > 0.5) discard;
  colour = vec4(away > 0.36 ? vec3(0.08) : vPaint, 1.0);
}`,
  });
}

/** A veil over faces, seen through all that is in front. */
export function veilMaterial(rgb: readonly number[], strength: number): RawShaderMaterial {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    side: DoubleSide,
    depthTest: false,
    depthWrite: false,
    transparent: true,
    uniforms: { rgb: { value: rgb.map((part) => part / 255) }, strength: { value: strength } },
    vertexShader: `${PRECISION}
uniform mat4 modelViewMatrix, projectionMatrix;
in vec3 position;
void main() { gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`,
    fragmentShader: `${PRECISION}
uniform vec3 rgb;
uniform float strength;
out vec4 colour;
void main() { colour = vec4(rgb, strength); }`,
  });
}
