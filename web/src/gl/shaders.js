// SPDX-License-Identifier: MIT

const head = `precision highp float;
precision highp int;
precision highp usampler2D;
`;

/** Points live in textures, one texel per vertex; a view mixes two of them. */
const points = `
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform highp sampler2D beforePoints;
uniform highp sampler2D fromPoints;
uniform highp sampler2D toPoints;
uniform float mixing;
ivec2 texel(uint i) { return ivec2(int(i & 2047u), int(i >> 11u)); }
vec3 pointOf(uint vertex) {
  ivec2 at = texel(vertex);
  vec3 from = texelFetch(fromPoints, at, 0).xyz;
  return mixing == 0.0 ? from : mix(from, texelFetch(toPoints, at, 0).xyz, mixing);
}
`;

export const cellsVertex = `${head}${points}
in uvec2 corner;  // vertex; 8 cell + edges
uniform highp sampler2D fromMiddles;
uniform highp sampler2D toMiddles;
uniform float shrink;
uniform usampler2D cells;  // byte before, byte after, visibility, unused
uniform sampler2D colours;
uniform float progress;    // 0: values before, 1: values after
uniform bool lowerIsBetter;
uniform vec3 fadedColour;
uniform vec3 plainColour;
uniform bool hasValues;
uniform bool planar;
out vec3 viewPoint;
out vec3 weights;
flat out vec3 colour;
flat out uint edges;
flat out int cell;
flat out int look;         // 1: value, 2: faded, 3: undefined

void main() {
  uint number = corner.y >> 3u;
  uvec4 data = texelFetch(cells, texel(number), 0);
  cell = int(number);
  edges = corner.y & 7u;
  look = int(data.b);
  int k = gl_VertexID % 3;
  weights = vec3(k == 0, k == 1, k == 2);
  if (data.b == 0u) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  vec3 point = pointOf(corner.x);
  if (shrink < 1.0) {
    ivec2 at = texel(number);
    vec3 middle = mix(texelFetch(fromMiddles, at, 0).xyz, texelFetch(toMiddles, at, 0).xyz, mixing);
    point = mix(middle, point, shrink);
  }
  vec4 seen = modelViewMatrix * vec4(point, 1.0);
  viewPoint = seen.xyz;
  gl_Position = projectionMatrix * seen;

  uint nearest = progress < 0.5 ? data.r : data.g;
  float value = data.r == 255u || data.g == 255u ? float(nearest) : mix(float(data.r), float(data.g), progress);
  float good = value / 254.0;
  if (lowerIsBetter) good = 1.0 - good;
  colour = hasValues ? texelFetch(colours, ivec2(int(good * 255.0 + 0.5), 0), 0).rgb : plainColour;
  if (look == 1 && hasValues && nearest == 255u) look = 3;
  if (look == 2) colour = fadedColour;
  // Cells that lie on each other in a plane: the worst on top, or those turned over would be hidden.
  if (planar && look != 2) gl_Position.z -= look == 3 ? 3e-4 : 2e-4 * (1.0 - good);
}`;

export const cellsFragment = `${head}
in vec3 viewPoint;
in vec3 weights;
flat in vec3 colour;
flat in uint edges;
flat in int cell;
flat in int look;
uniform float shading;
uniform bool showEdges;
uniform float pixelRatio;
uniform vec3 edgeColour;
uniform vec3 undefinedColour;
uniform vec3 undefinedStripe;
uniform int hovered;
out vec4 fragment;

void main() {
  vec3 base = colour;
  if (look == 3) {
    float stripe = mod(gl_FragCoord.x + gl_FragCoord.y, 8.0 * pixelRatio) / pixelRatio;
    base = stripe < 2.5 ? undefinedStripe : undefinedColour;
  }
  vec3 normal = cross(dFdx(viewPoint), dFdy(viewPoint));
  float size = length(normal);
  vec3 light = normalize(vec3(-0.25, 0.45, 1.0));
  float lit = size > 0.0 ? abs(dot(normal / size, light)) : 1.0;
  base *= mix(1.0, 0.6 + 0.42 * lit, shading);
  if (cell == hovered) base = mix(base, vec3(1.0), 0.3);

  if (showEdges) {
    vec3 slope = sqrt(dFdx(weights) * dFdx(weights) + dFdy(weights) * dFdy(weights));
    vec3 steep = max(slope, vec3(1e-9));
    vec3 away = weights / steep;
    bvec3 real = bvec3(edges & 1u, edges & 2u, edges & 4u);
    away = mix(vec3(1e9), away, real);
    float nearest = min(away.x, min(away.y, away.z)) / pixelRatio;
    float line = 1.0 - smoothstep(0.35, 1.15, nearest);
    // Where cells are hardly larger than the lines, lines would hide the colours.
    float height = 1.0 / (max(steep.x, max(steep.y, steep.z)) * pixelRatio);
    float strength = clamp((height - 2.0) / 9.0, 0.0, 1.0) * (look == 2 ? 0.28 : 0.8);
    base = mix(base, edgeColour, line * strength);
  }
  fragment = vec4(base, 1.0);
}`;

/** The number of the cell plus one, in four bytes. */
export const numbersFragment = `${head}
flat in int cell;
out vec4 fragment;
void main() {
  uint n = uint(cell + 1);
  fragment = vec4(n & 255u, (n >> 8u) & 255u, (n >> 16u) & 255u, n >> 24u) / 255.0;
}`;

/**
 * Lines between two vertices, several pixels wide; or arrows along the move of one vertex.
 * Six corners per line, nine per arrow.
 */
export const linesVertex = `${head}${points}
in uvec2 ends;
uniform bool arrows;
uniform float arrowScale;
uniform vec2 viewport;     // in pixels
uniform float width;       // in pixels
uniform float lift;        // towards the eye, in depth
const vec2 shaft[6] = vec2[6](vec2(0, -1), vec2(1, -1), vec2(1, 1), vec2(0, -1), vec2(1, 1), vec2(0, 1));
void main() {
  vec3 a, b;
  if (arrows) {
    a = texelFetch(beforePoints, texel(ends.x), 0).xyz;
    b = a + arrowScale * (pointOf(ends.x) - a);
  } else {
    a = pointOf(ends.x);
    b = pointOf(ends.y);
  }
  vec4 p = projectionMatrix * modelViewMatrix * vec4(a, 1.0);
  vec4 q = projectionMatrix * modelViewMatrix * vec4(b, 1.0);
  vec2 along = (q.xy - p.xy) * 0.5 * viewport;
  float size = length(along);
  vec2 direction = size > 1e-6 ? along / size : vec2(1.0, 0.0);
  vec2 across = vec2(-direction.y, direction.x);
  int k = gl_VertexID;
  vec2 offset;             // in pixels from p
  float place;
  if (arrows) {
    float tip = min(0.5 * size, 4.5 * width);
    if (k < 6) {
      place = shaft[k].x;
      offset = direction * place * (size - tip) + across * shaft[k].y * 0.5 * width;
    } else {
      place = 1.0;
      float side = k == 6 ? -1.0 : k == 7 ? 1.0 : 0.0;
      offset = direction * (size - (k == 8 ? 0.0 : tip)) + across * side * 0.45 * tip;
    }
  } else {
    place = shaft[k].x;
    // A little longer than the edge, so that bends have no gaps.
    offset = direction * (place * size + (2.0 * place - 1.0) * 0.4 * width) + across * shaft[k].y * 0.5 * width;
  }
  vec2 at = p.xy + offset * 2.0 / viewport;
  gl_Position = vec4(at, mix(p.z, q.z, place) - lift, 1.0);
}`;

export const plainFragment = `${head}
uniform vec3 colour;
out vec4 fragment;
void main() { fragment = vec4(colour, 1.0); }`;

export const marksVertex = `${head}${points}
in uvec2 mark;             // vertex, hold
uniform float pixelRatio;
uniform float lift;
flat out uint hold;
void main() {
  hold = mark.y;
  vec4 at = projectionMatrix * modelViewMatrix * vec4(pointOf(mark.x), 1.0);
  gl_Position = vec4(at.xy, at.z - lift, 1.0);
  gl_PointSize = 9.0 * pixelRatio;
}`;

/** Fixed: square. Sliding: disk on a curve, ring on a surface. Tied: diamond. Held: triangle. */
export const marksFragment = `${head}
flat in uint hold;
uniform vec3 holdColours[6];
uniform vec3 rim;
out vec4 fragment;
void main() {
  vec2 p = 2.0 * gl_PointCoord - 1.0;
  float d;
  if (hold == 1u) d = max(abs(p.x), abs(p.y)) + 0.2;
  else if (hold == 4u) d = abs(p.x) + abs(p.y);
  else if (hold == 5u) d = max(p.y + 0.25, abs(p.x) * 1.2 - p.y * 0.6 - 0.1) + 0.25;
  else d = length(p) + 0.05;
  if (d > 1.0) discard;
  vec3 inside = hold == 3u && d < 0.45 ? rim : holdColours[hold];
  fragment = vec4(d > 0.78 ? rim : inside, 1.0);
}`;
