// Camera, light and picture of one run. Draws only when something has changed.

import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

import type { Blocks } from "./blocks";
import { Shading } from "./shade";
import { Problem } from "./source";

type Camera = THREE.OrthographicCamera | THREE.PerspectiveCamera;

/** Where a camera stands, to be taken over by another. */
export interface Standpoint {
  position: THREE.Vector3;
  target: THREE.Vector3;
  zoom: number;
}

/** With more faces than this, shadows would take longer than the picture itself; the second where the processor draws. */
const SHADED = [1_500_000, 150_000] as const;

/** Where the processor draws more faces than this, pictures of a camera that moves have neither shadows nor edges. */
const QUICK = 20_000;
/** A camera that has not moved for so long stands, ms. */
const STANDS = 220;

export type Side = "default" | "x" | "y" | "z";

export class Stage {
  readonly canvas: HTMLCanvasElement;
  readonly scene = new THREE.Scene();
  readonly renderer: THREE.WebGLRenderer;
  camera: Camera;
  controls: OrbitControls;
  onMove: ((from: Standpoint) => void) | null = null;
  onDrawn: (() => void) | null = null;
  /** Called before a picture is drawn, with its scale. */
  onDraw: ((metresPerPixel: number, quick: boolean) => void) | null = null;
  private standing = 0;
  private moving = false;
  /** What stands in the light, if shadows are wanted. */
  shadowed: Blocks | null = null;
  readonly shading: Shading;
  /** Whether the processor draws, for want of graphics. */
  readonly software: boolean;
  private readonly light = new THREE.DirectionalLight(0xffffff, 1.5);
  private readonly sky = new THREE.HemisphereLight(0xffffff, 0xd0d0d0, 1.35);
  private due = false;
  /** Which way is up in space. */
  up: "y" | "z" = "z";
  private following = false;
  private readonly axes = new THREE.Group();
  private box = new THREE.Box3(new THREE.Vector3(-1, -1, -1), new THREE.Vector3(1, 1, 1));

  constructor(
    readonly host: HTMLElement,
    public dimension: 2 | 3,
  ) {
    if (!document.createElement("canvas").getContext("webgl2")) {
      throw new Problem(
        "This browser does not support WebGL 2.",
        "Switch on its hardware acceleration or try another browser. Without it, riprap shot RUN draws blocks in space and riprap plot RUN blocks those of the plane.",
      );
    }
    // Smooth edges cost a processor more than all else.
    const software = drawnBySoftware();
    this.software = software;
    // Kept after drawing, since saved pictures are read from the canvas.
    this.renderer = new THREE.WebGLRenderer({ antialias: !software, preserveDrawingBuffer: true });
    this.renderer.localClippingEnabled = true;
    this.renderer.setPixelRatio(software ? 1 : Math.min(window.devicePixelRatio, 2));
    this.canvas = this.renderer.domElement;
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("aria-label", "the blocks");
    host.append(this.canvas);
    this.shading = new Shading(this.renderer, software);
    // The sun stands still beside the model, and much light comes from everywhere: shades tell faces apart, colours stay readable.
    this.scene.add(this.sky, this.light, this.axes);
    this.camera = this.makeCamera();
    this.controls = this.makeControls();
    new ResizeObserver(() => this.resize()).observe(host);
    this.resize();
  }

  set background(colour: string) {
    this.scene.background = new THREE.Color(colour);
    this.redraw();
  }

  /** Between the plane and space. */
  setDimension(dimension: 2 | 3, up: "y" | "z"): void {
    if (dimension === this.dimension && up === this.up) return;
    this.dimension = dimension;
    this.up = up;
    this.controls.dispose();
    this.camera = this.makeCamera();
    this.controls = this.makeControls();
    this.resize();
  }

  private makeCamera(): Camera {
    if (this.dimension === 2) return new THREE.OrthographicCamera(-1, 1, 1, -1, 0.1, 1000);
    const camera = new THREE.PerspectiveCamera(32, 1, 0.01, 1000);
    camera.up.set(0, this.up === "y" ? 1 : 0, this.up === "y" ? 0 : 1);
    return camera;
  }

  private makeControls(): OrbitControls {
    const controls = new OrbitControls(this.camera, this.canvas);
    controls.zoomToCursor = true;
    controls.screenSpacePanning = true;
    if (this.dimension === 2) {
      controls.enableRotate = false;
      controls.mouseButtons = { LEFT: THREE.MOUSE.PAN, MIDDLE: THREE.MOUSE.DOLLY, RIGHT: THREE.MOUSE.PAN };
      controls.touches = { ONE: THREE.TOUCH.PAN, TWO: THREE.TOUCH.DOLLY_PAN };
    }
    controls.addEventListener("change", () => {
      this.moves();
      this.redraw();
      if (!this.following) this.onMove?.(this.standpoint());
    });
    return controls;
  }

  /** Someone turns the model: it follows at once, and gets its shadows when it stands. */
  private moves(): void {
    const { shadowed } = this;
    if (!this.software || this.following || !shadowed || shadowed.visibleFaces <= QUICK) return;
    this.moving = true;
    clearTimeout(this.standing);
    this.standing = window.setTimeout(() => {
      this.moving = false;
      this.redraw();
    }, STANDS);
  }

  /** The camera stands from now on: the next picture is whole. */
  stand(): void {
    clearTimeout(this.standing);
    this.moving = false;
  }

  standpoint(): Standpoint {
    return {
      position: this.camera.position.clone(),
      target: this.controls.target.clone(),
      zoom: this.camera.zoom,
    };
  }

  /** Takes the place of another camera. */
  follow(from: Standpoint): void {
    this.following = true;
    this.camera.position.copy(from.position);
    this.controls.target.copy(from.target);
    this.camera.zoom = from.zoom;
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.following = false;
    this.redraw();
  }

  /** Looks at all of a box from a side. */
  look(box: THREE.Box3, side: Side = "default"): void {
    if (!box.isEmpty()) this.box = box.clone();
    const centre = this.box.getCenter(new THREE.Vector3());
    const size = this.box.getSize(new THREE.Vector3());
    this.controls.target.copy(centre);
    this.camera.zoom = 1;
    if (this.camera instanceof THREE.OrthographicCamera) {
      this.camera.position.set(centre.x, centre.y, centre.z + 100);
      this.frameOrthographic(size);
    } else {
      // Looking along `up` itself the camera would not know what is right and left.
      const standing = { default: [-0.55, 0.62, 1], x: [1, 0, 0], y: [0, 1, 0.001], z: [0, 0, 1] } as const;
      const lying = { default: [-0.55, -1, 0.62], x: [1, 0, 0], y: [0, -1, 0], z: [0, -0.001, 1] } as const;
      const ways = this.up === "y" ? standing : lying;
      const radius = Math.max(1e-9, 0.5 * size.length());
      const half = THREE.MathUtils.degToRad(this.camera.fov / 2);
      const narrow = Math.min(half, Math.atan(Math.tan(half) * this.camera.aspect));
      const away = new THREE.Vector3(...ways[side]).normalize().multiplyScalar((1.02 * radius) / Math.sin(narrow));
      this.camera.position.copy(centre).add(away);
      this.camera.near = radius / 200;
      this.camera.far = radius * 200;
    }
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.stand();
    this.redraw();
  }

  private frameOrthographic(size: THREE.Vector3): void {
    const camera = this.camera as THREE.OrthographicCamera;
    const { clientWidth: w, clientHeight: h } = this.host;
    const aspect = w > 0 && h > 0 ? w / h : 1;
    const half = 0.53 * Math.max(size.y, size.x / aspect, 1e-9);
    camera.left = -half * aspect;
    camera.right = half * aspect;
    camera.top = half;
    camera.bottom = -half;
  }

  private resize(): void {
    const { clientWidth: w, clientHeight: h } = this.host;
    if (w === 0 || h === 0) return;
    this.renderer.setSize(w, h, false);
    if (this.camera instanceof THREE.PerspectiveCamera) this.camera.aspect = w / h;
    else this.frameOrthographic(this.box.getSize(new THREE.Vector3()));
    this.camera.updateProjectionMatrix();
    // Drawn at once: a cleared canvas would flicker.
    this.draw();
  }

  /** Asks for a picture at the next chance. */
  redraw(): void {
    if (this.due) return;
    this.due = true;
    requestAnimationFrame(() => {
      if (this.due) this.draw();
    });
  }

  /** Draws now. */
  draw(): void {
    this.due = false;
    // To the left of and above the eye as it stands at first.
    const sun = this.up === "y" ? new THREE.Vector3(-1.0, 1.5, 0.5) : new THREE.Vector3(-1.0, -0.5, 1.5);
    this.light.position.copy(sun);
    this.sky.position.set(0, this.up === "y" ? 1 : 0, this.up === "y" ? 0 : 1);
    this.onDraw?.(this.metresPerPixel(), this.moving);
    const { shadowed, camera } = this;
    if (shadowed?.isSolid && !this.moving && !this.tooMany(shadowed) && camera instanceof THREE.PerspectiveCamera) {
      this.shading.draw(shadowed.solid, camera, shadowed.sphere, sun, shadowed.size);
    } else this.shading.clear();
    this.renderer.render(this.scene, this.camera);
    this.onDrawn?.();
  }

  /** Whether blocks have too many faces to be shown in light and shadow. */
  tooMany(blocks: Blocks): boolean {
    return blocks.visibleFaces > SHADED[this.software ? 1 : 0];
  }

  /** A ray through a place of the canvas. */
  ray(clientX: number, clientY: number): THREE.Raycaster {
    const rect = this.canvas.getBoundingClientRect();
    const at = new THREE.Vector2(
      (2 * (clientX - rect.left)) / rect.width - 1,
      1 - (2 * (clientY - rect.top)) / rect.height,
    );
    const ray = new THREE.Raycaster();
    ray.setFromCamera(at, this.camera);
    return ray;
  }

  /** Where a place is on the screen. */
  onScreen(place: THREE.Vector3): [number, number] {
    const rect = this.canvas.getBoundingClientRect();
    const at = place.clone().project(this.camera);
    return [rect.left + (0.5 + 0.5 * at.x) * rect.width, rect.top + (0.5 - 0.5 * at.y) * rect.height];
  }

  /** Directions of the axes on the screen: right and up parts. */
  triad(): [number, number][] {
    const inverse = this.camera.quaternion.clone().invert();
    return [0, 1, 2].map((k) => {
      const v = new THREE.Vector3().setComponent(k, 1).applyQuaternion(inverse);
      return [v.x, v.y];
    });
  }

  /** Metres per pixel at the target. */
  metresPerPixel(): number {
    const h = Math.max(1, this.host.clientHeight);
    if (this.camera instanceof THREE.OrthographicCamera) {
      return (this.camera.top - this.camera.bottom) / this.camera.zoom / h;
    }
    const away = this.camera.position.distanceTo(this.controls.target);
    return (2 * away * Math.tan(THREE.MathUtils.degToRad(this.camera.fov / 2))) / h;
  }
}

/** Whether WebGL runs on the processor, for want of graphics. */
function drawnBySoftware(): boolean {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (!gl) return false;
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  const name = String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}
