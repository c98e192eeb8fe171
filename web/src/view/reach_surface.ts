/** Where a handle may be moved: the surface of the intersection of all limits, drawn as the part of each limit's surface that
 *  lies within all others. */
import {
  BackSide,
  Color,
  GLSL3,
  InstancedBufferGeometry,
  Mesh,
  NormalBlending,
  ShaderMaterial,
  SphereGeometry,
  Vector3,
  Vector4,
} from 'three';
import type { Limit } from '../handles/reach';
import type { Space } from './space';
import type { Theme } from './theme';

/** Most limits drawn: the smallest ones bound the region. */
const MOST_LIMITS = 16;

const VERTEX = /* glsl */ `
uniform vec4 balls[${MOST_LIMITS}];
uniform vec3 counts[${MOST_LIMITS}];
flat out int own;
out vec3 place;
out vec3 seen;
out vec3 outward;
void main() {
  own = gl_InstanceID;
  vec4 ball = balls[gl_InstanceID];
  // Of the unit sphere; an axis that does not count is stretched far beyond what is seen.
  vec3 counted = counts[gl_InstanceID] * position;
  vec3 across = counted / max(length(counted), 1e-6);
  place = ball.xyz + ball.w * across + 10.0 * (position - counted);
  vec4 inView = modelViewMatrix * vec4(place, 1.0);
  seen = inView.xyz;
  outward = normalMatrix * across;
  gl_Position = projectionMatrix * inView;
}`;

const FRAGMENT = /* glsl */ `
uniform vec4 balls[${MOST_LIMITS}];
uniform vec3 counts[${MOST_LIMITS}];
uniform int count;
uniform vec3 tint;
flat in int own;
in vec3 place;
in vec3 seen;
in vec3 outward;
out vec4 colour;
void main() {
  float rim = 1.0;
  for (int i = 0; i < count; i++) {
    if (i == own) continue;
    float inside = balls[i].w - length(counts[i] * (place - balls[i].xyz));
    if (inside < 0.0) discard;
    // Highlights the edge where two surfaces intersect.
    rim = min(rim, inside / max(fwidth(inside), 1e-6) / 1.5);
  }
  float grazing = 1.0 - abs(dot(normalize(outward), normalize(seen)));
  colour = vec4(tint, mix(0.75, 0.08 + 0.3 * pow(grazing, 3.0), clamp(rim, 0.0, 1.0)));
}`;

export class ReachSurface {
  readonly object: Mesh<InstancedBufferGeometry, ShaderMaterial>;

  constructor() {
    const sphere = new SphereGeometry(1, 64, 40);
    const geometry = new InstancedBufferGeometry();
    geometry.index = sphere.index;
    geometry.setAttribute('position', sphere.getAttribute('position'));
    const material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      transparent: true,
      blending: NormalBlending,
      depthWrite: false,
      // Back faces only: the front would cover the net.
      side: BackSide,
      uniforms: {
        balls: { value: Array.from({ length: MOST_LIMITS }, () => new Vector4()) },
        counts: { value: Array.from({ length: MOST_LIMITS }, () => new Vector3()) },
        count: { value: 0 },
        tint: { value: new Color() },
      },
    });
    this.object = new Mesh(geometry, material);
    this.object.frustumCulled = false;
    this.object.renderOrder = 3;
    this.object.visible = false;
  }

  update(limits: readonly Limit[] | null, space: Space): void {
    this.object.visible = limits !== null;
    if (limits === null) return;
    const drawn = [...limits].sort((a, b) => a.radius - b.radius).slice(0, MOST_LIMITS);
    const { balls, counts, count } = this.object.material.uniforms;
    const place = new Vector3();
    drawn.forEach(({ centre, radius, counts: axes }, i) => {
      space.toScene(place, centre);
      balls!.value[i].set(place.x, place.y, place.z, radius * space.scale);
      counts!.value[i].set(axes[0], axes[space.axisY], axes[space.axisZ]);
    });
    count!.value = drawn.length;
    this.object.geometry.instanceCount = drawn.length;
  }

  setTheme({ accent }: Theme): void {
    this.object.material.uniforms.tint!.value.setRGB(...accent);
  }

  dispose(): void {
    this.object.geometry.dispose();
    this.object.material.dispose();
  }
}
