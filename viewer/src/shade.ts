// Shadows of the sun and ambient occlusion: how much light comes to a place, found at a part of the size of the picture and smoothed.
//
// The blocks are drawn twice more, for their depths alone: from the sun, when they have moved, and from the camera. A pass over the
// picture takes from these the share of the sky that near faces hide (after McGuire and others, The Alchemy screen-space ambient
// obscurance algorithm, 2011) and whether something stands before the sun (Williams, Casting curved shadows on curved surfaces, 1978,
// with several comparisons to a point). What is drawn over the blocks has no part in it.

import * as THREE from "three";
import { FullScreenQuad } from "three/addons/postprocessing/Pass.js";

/** Points of the picture to a point of the passes, along a side. */
const COARSE = 2;
/** The same where the processor draws. */
const COARSE_IN_SOFTWARE = 3;
/** Points along a side of the picture from the sun. */
const SUN_POINTS = 2048;
const SUN_POINTS_IN_SOFTWARE = 1024;

const VERTEX = "varying vec2 place; void main() { place = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }";

/** Red: share of the sky that is seen; green: of the sun; blue and alpha: depth. */
const LIGHT = `
  uniform sampler2D depth;
  uniform sampler2D sun;
  uniform mat4 back;
  uniform mat4 toSun;
  uniform vec2 points;
  uniform vec2 clip;
  uniform float reach;
  uniform float scale;
  uniform float lift;
  uniform float sunPoint;
  uniform float bias;
  varying vec2 place;

  vec3 at(vec2 uv) {
    vec4 p = back * vec4(2.0 * uv - 1.0, 2.0 * texture2D(depth, uv).r - 1.0, 1.0);
    return p.xyz / p.w;
  }

  void main() {
    if (texture2D(depth, place).r >= 1.0) {
      gl_FragColor = vec4(1.0);
      return;
    }
    vec2 one = 1.0 / points;
    vec3 p = at(place);
    // Of the neighbours on either side, the one on the same face is nearer in depth.
    vec3 l = p - at(place - vec2(one.x, 0.0));
    vec3 r = at(place + vec2(one.x, 0.0)) - p;
    vec3 d = p - at(place - vec2(0.0, one.y));
    vec3 u = at(place + vec2(0.0, one.y)) - p;
    vec3 n = normalize(cross(abs(l.z) < abs(r.z) ? l : r, abs(d.z) < abs(u.z) ? d : u));
    // Sixteen turns of the samples in a square of four points, which is what the smoothing covers.
    vec2 cell = mod(floor(gl_FragCoord.xy), 4.0);
    float turn = 6.2832 * fract(0.0625 * (cell.x + 4.0 * cell.y) * 7.0);
    float far = clamp(reach * scale / max(-p.z, 1e-9), 2.0, 48.0);
    float hidden = 0.0;
    for (int i = 0; i < SAMPLES; i++) {
      float share = (float(i) + 0.5) / float(SAMPLES);
      float angle = turn + 2.399963 * float(i);
      vec3 v = at(place + far * share * one * vec2(cos(angle), sin(angle))) - p;
      float long2 = dot(v, v);
      float near = max(0.0, 1.0 - long2 / (reach * reach));
      hidden += near * max(0.0, dot(v, n) * inversesqrt(long2 + 1e-12 * reach * reach) - 0.12);
    }
    float sky = clamp(1.0 - 2.1 * hidden / float(SAMPLES), 0.0, 1.0);
    vec4 s = toSun * vec4(p + lift * n, 1.0);
    vec3 q = 0.5 * s.xyz / s.w + 0.5;
    float lit = 0.0;
    for (int i = 0; i < 6; i++) {
      float angle = turn + 1.0472 * float(i);
      vec2 off = sunPoint * (i < 3 ? 0.8 : 1.9) * vec2(cos(angle), sin(angle));
      lit += step(q.z - bias, texture2D(sun, q.xy + off).r);
    }
    float z = clamp((-p.z - clip.x) / (clip.y - clip.x), 0.0, 1.0) * 255.0;
    gl_FragColor = vec4(sky, lit / 6.0, floor(z) / 255.0, fract(z));
  }
`;

/** The mean over the sixteen turns, of what lies at the same depth. */
const SMOOTH = `
  uniform sampler2D light;
  uniform vec2 points;
  uniform float near;
  varying vec2 place;
  float depthOf(vec4 c) { return c.b + c.a / 255.0; }
  void main() {
    vec4 own = texture2D(light, place);
    float z = depthOf(own);
    vec3 sum = vec3(own.rg, 1.0);
    for (int y = -2; y < 2; y++) {
      for (int x = -2; x < 2; x++) {
        vec4 c = texture2D(light, place + vec2(float(x) + 0.5, float(y) + 0.5) / points);
        float w = step(abs(depthOf(c) - z), near);
        sum += w * vec3(c.rg, 1.0);
      }
    }
    gl_FragColor = vec4(sum.xy / sum.z, 0.0, 1.0);
  }
`;

const white = new THREE.DataTexture(new Uint8Array([255, 255, 255, 255]), 1, 1);
white.needsUpdate = true;

/** What the materials of the blocks take from here. */
export interface Lit {
  light: THREE.IUniform<THREE.Texture>;
  points: THREE.IUniform<THREE.Vector2>;
}

/** Lets a material be lit by what the passes found, and by a lamp at the eye, which no shadow takes away. */
export function litBy(material: THREE.MeshLambertMaterial, lit: Lit): void {
  material.onBeforeCompile = (shader) => {
    shader.uniforms.shadeLight = lit.light;
    shader.uniforms.shadePoints = lit.points;
    shader.fragmentShader = shader.fragmentShader
      .replace("void main() {", "uniform sampler2D shadeLight;\nuniform vec2 shadePoints;\nvoid main() {")
      .replace(
        "#include <aomap_fragment>",
        `vec2 shade = texture2D(shadeLight, gl_FragCoord.xy / shadePoints).rg;
        reflectedLight.directDiffuse *= shade.g;
        reflectedLight.indirectDiffuse += 0.7 * abs(dot(normal, normalize(vViewPosition))) * BRDF_Lambert(diffuseColor.rgb);
        reflectedLight.indirectDiffuse *= shade.r;
        reflectedLight.directDiffuse *= 0.5 + 0.5 * shade.r;`,
      );
  };
}

/** The passes. */
export class Shading {
  readonly lit: Lit = { light: { value: white }, points: { value: new THREE.Vector2(1, 1) } };
  private readonly depth: THREE.WebGLRenderTarget;
  private readonly found: THREE.WebGLRenderTarget;
  private readonly smooth: THREE.WebGLRenderTarget;
  private readonly sun: THREE.WebGLRenderTarget;
  private readonly sunCamera = new THREE.OrthographicCamera();
  private readonly own = new THREE.PerspectiveCamera();
  private readonly find: FullScreenQuad;
  private readonly mean: FullScreenQuad;
  private stale = true;

  constructor(
    private readonly renderer: THREE.WebGLRenderer,
    private readonly software: boolean,
  ) {
    const depthTarget = (side: number) => {
      const target = new THREE.WebGLRenderTarget(side, side, { minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter });
      target.depthTexture = new THREE.DepthTexture(side, side, THREE.UnsignedIntType);
      return target;
    };
    this.depth = depthTarget(4);
    this.sun = depthTarget(software ? SUN_POINTS_IN_SOFTWARE : SUN_POINTS);
    this.found = new THREE.WebGLRenderTarget(4, 4, { minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter, depthBuffer: false });
    this.smooth = new THREE.WebGLRenderTarget(4, 4, { depthBuffer: false });
    const pass = (fragmentShader: string, names: string[], defines: Record<string, number> = {}) => {
      const uniforms = Object.fromEntries(names.map((name) => [name, { value: null as unknown }]));
      return new FullScreenQuad(new THREE.ShaderMaterial({ vertexShader: VERTEX, fragmentShader, uniforms, defines, depthTest: false, depthWrite: false, blending: THREE.NoBlending }));
    };
    this.find = pass(LIGHT, ["depth", "sun", "back", "toSun", "points", "clip", "reach", "scale", "lift", "sunPoint", "bias"], { SAMPLES: software ? 9 : 14 });
    this.mean = pass(SMOOTH, ["light", "points", "near"]);
  }

  /** The blocks have moved, or are cut elsewhere. */
  moved(): void {
    this.stale = true;
  }

  /** No shadows: everything is lit. */
  clear(): void {
    this.lit.light.value = white;
  }

  /** Finds the light on the blocks as a camera sees them. `way`: to the sun; `size`: of a usual block, m. */
  draw(solid: THREE.Object3D, camera: THREE.PerspectiveCamera, sphere: THREE.Sphere, way: THREE.Vector3, size: number): void {
    const { renderer, own, lit } = this;
    const whole = renderer.getDrawingBufferSize(lit.points.value);
    const coarse = this.software ? COARSE_IN_SOFTWARE : COARSE;
    const [wide, high] = [Math.ceil(whole.x / coarse), Math.ceil(whole.y / coarse)];
    for (const target of [this.depth, this.found, this.smooth]) if (target.width !== wide || target.height !== high) target.setSize(wide, high);
    if (this.stale) this.fromSun(solid, sphere, way);
    this.stale = false;
    // Depths as fine as they can be: from the nearest to the farthest place of the model.
    own.copy(camera);
    const away = camera.position.distanceTo(sphere.center);
    own.far = away + 1.01 * sphere.radius;
    own.near = Math.max(camera.near, away - 1.01 * sphere.radius, 1e-4 * own.far);
    own.updateProjectionMatrix();
    own.updateMatrixWorld();
    const before = { color: renderer.getClearColor(new THREE.Color()), alpha: renderer.getClearAlpha() };
    renderer.setRenderTarget(this.depth);
    renderer.render(solid, own);
    const toSun = new THREE.Matrix4().multiplyMatrices(this.sunCamera.projectionMatrix, this.sunCamera.matrixWorldInverse).multiply(own.matrixWorld);
    const point = (2 * sphere.radius) / this.sun.width;
    const points = new THREE.Vector2(wide, high);
    set(this.find, {
      depth: this.depth.depthTexture,
      sun: this.sun.depthTexture,
      back: own.projectionMatrixInverse,
      toSun,
      points,
      clip: new THREE.Vector2(own.near, own.far),
      // Of large blocks the hollows between them, of small ones those that many of them leave.
      reach: Math.min(Math.max(0.9 * size, 0.02 * sphere.radius), 0.25 * sphere.radius),
      scale: (0.5 * high) / Math.tan(THREE.MathUtils.degToRad(own.fov / 2)),
      lift: 1.6 * point,
      sunPoint: 1 / this.sun.width,
      bias: (0.6 * point) / (2 * sphere.radius),
    });
    renderer.setRenderTarget(this.found);
    this.find.render(renderer);
    set(this.mean, { light: this.found.texture, points, near: 0.02 });
    renderer.setRenderTarget(this.smooth);
    this.mean.render(renderer);
    renderer.setRenderTarget(null);
    renderer.setClearColor(before.color, before.alpha);
    lit.light.value = this.smooth.texture;
  }

  private fromSun(solid: THREE.Object3D, sphere: THREE.Sphere, way: THREE.Vector3): void {
    const { sunCamera, renderer } = this;
    const r = sphere.radius;
    Object.assign(sunCamera, { left: -r, right: r, top: r, bottom: -r, near: 0, far: 2 * r });
    sunCamera.position.copy(sphere.center).addScaledVector(way.clone().normalize(), r);
    sunCamera.up.set(0, 0, 1);
    sunCamera.lookAt(sphere.center);
    sunCamera.updateProjectionMatrix();
    sunCamera.updateMatrixWorld();
    renderer.setRenderTarget(this.sun);
    renderer.render(solid, sunCamera);
  }
}

function set(quad: FullScreenQuad, values: Record<string, unknown>): void {
  const { uniforms } = quad.material as THREE.ShaderMaterial;
  for (const [name, value] of Object.entries(values)) uniforms[name]!.value = value;
}
