// Principal stresses as crosses: of blocks, and of tetrahedra of deformable blocks where the run has their stresses.

import * as THREE from "three";
import type { Blocks } from "./blocks";
import { AHEAD, ARROWS, Instances, PRESSED, PULLED, type Shift } from "./marks";
import type { StressInfo } from "./run";
import type { Settings } from "./settings";
import type { Packet } from "./wire";

/** The longest cross of a tetrahedron as a share of its edge: it stays inside of most. */
const FINE = 0.5;

/** What is drawn, with the number of crosses beyond the longest. */
export type StressShown = StressInfo & { beyond: number };

export class StressMarks {
  readonly object = new THREE.Group();
  private readonly whole = new Crosses();
  private readonly fine = new Crosses();

  constructor() {
    this.object.add(this.whole.object, this.fine.object);
  }

  /**
   * Draws crosses of the blocks that are seen, of their tetrahedra where these have stresses of their own: behind a flat cut those that it goes
   * through, or nothing could be told apart. `moved` is the motion of blocks as it is, `thin` the largest thickness, m.
   */
  draw(stress: Packet<StressInfo> | null, blocks: Blocks, moved: Shift, settings: Settings, thin: number): StressShown | null {
    this.whole.clear();
    this.fine.clear();
    if (!stress) return null;
    const { longest, tetSize } = stress.info;
    let beyond = 0;
    if (longest !== null) {
      const long = 0.9 * blocks.size * settings.vectorSize;
      const of = { longest, arms: stress.f32("arms"), tension: stress.u8("tension") };
      beyond = this.whole.draw(of, ...wholeBlocks(blocks, moved, settings, new Set(stress.u32("tetBlock"))), long, Math.min(long / 14, thin));
      if (tetSize !== null) {
        const fine = { longest, arms: stress.f32("tetArms"), tension: stress.u8("tetTension") };
        const short = FINE * tetSize * settings.vectorSize;
        beyond += this.fine.draw(fine, ...tetrahedra(blocks, moved, settings, stress), short, Math.min(short / 10, thin));
      }
    }
    return { ...stress.info, beyond };
  }
}

/** Arms of crosses (nine numbers each), whether they are in tension (three each), and the size that is drawn longest. */
interface Stresses {
  longest: number;
  arms: Float32Array;
  tension: Uint8Array;
}

/** Principal stresses as crosses through the middles of blocks or tetrahedra; they show through the blocks. */
class Crosses extends Instances {
  /**
   * Draws the chosen crosses at their places (three numbers each). An arm of the size `longest` is `length` long from end
   * to end and `thick` thick, and none is longer. Returns how many have a longer one.
   */
  draw({ longest, arms, tension }: Stresses, chosen: number[], places: Float32Array, length: number, thick: number): number {
    this.clear();
    const step = Math.max(1, Math.ceil(chosen.length / ARROWS));
    const drawn = chosen.filter((_, i) => i % step === 0);
    const mesh = new THREE.InstancedMesh(new THREE.BoxGeometry(1, 1, 1), this.material, 3 * drawn.length);
    const one = new THREE.Object3D();
    const way = new THREE.Vector3();
    const colour = new THREE.Color();
    let n = 0;
    for (const b of drawn) {
      for (let k = 0; k < 3; k++) {
        const size = way.fromArray(arms, 9 * b + 3 * k).length();
        // Too short to be seen; what is no number is left out with it.
        if (!(size > 0.01 * longest)) continue;
        one.position.fromArray(places, 3 * b);
        one.quaternion.setFromUnitVectors(AHEAD, way.divideScalar(size));
        one.scale.set(length * Math.min(1, size / longest), thick, thick);
        one.updateMatrix();
        mesh.setMatrixAt(n, one.matrix);
        mesh.setColorAt(n++, colour.set(tension[3 * b + k] ? PULLED : PRESSED));
      }
    }
    mesh.count = n;
    mesh.frustumCulled = false;
    mesh.renderOrder = 4;
    this.mesh = mesh;
    this.object.add(mesh);
    const beyond = (b: number) => [0, 1, 2].some((k) => way.fromArray(arms, 9 * b + 3 * k).length() > 1.001 * longest);
    return chosen.filter(beyond).length;
  }
}

/** Blocks that have crosses, less those that are `divided`, and where these stand. */
function wholeBlocks(blocks: Blocks, moved: Shift, settings: Settings, divided: Set<number>): [number[], Float32Array] {
  const flat = blocks.dimension === 2;
  const places = new Float32Array(3 * blocks.count);
  const chosen: number[] = [];
  const place = new THREE.Vector3();
  for (let b = 0; b < blocks.count; b++) {
    moved(b, place).multiplyScalar(settings.exaggeration);
    for (let k = 0; k < 3; k++) places[3 * b + k] = blocks.middles[3 * b + k]! + place.getComponent(k);
    const seen = flat || blocks.cutBlocks === 0 ? !blocks.isAway(place.fromArray(places, 3 * b)) : blocks.isCut(b);
    if (flat) places[3 * b + 2] = 0.5;
    if (blocks.isShown(b) && seen && Number.isFinite(place.x) && !divided.has(b)) chosen.push(b);
  }
  return [chosen, places];
}

/** The same of tetrahedra. */
function tetrahedra(blocks: Blocks, moved: Shift, settings: Settings, stress: Packet<StressInfo>): [number[], Float32Array] {
  const [corners, owners] = [stress.f32("tetCorners"), stress.u32("tetBlock")];
  const places = new Float32Array(3 * owners.length);
  const chosen: number[] = [];
  const [corner, middle, shift] = [new THREE.Vector3(), new THREE.Vector3(), new THREE.Vector3()];
  owners.forEach((b, t) => {
    if (b >= blocks.count || !blocks.isShown(b)) return;
    moved(b, shift).multiplyScalar(settings.exaggeration - 1);
    middle.set(0, 0, 0);
    let [away, all] = [0, 0];
    for (; all < 4; all++) {
      corner.fromArray(corners, 12 * t + 3 * all).add(shift);
      if (blocks.isAway(corner)) away++;
      middle.addScaledVector(corner, 0.25);
    }
    middle.toArray(places, 3 * t);
    const seen = blocks.cutBlocks === 0 ? away === 0 : away > 0 && away < all;
    if (seen && Number.isFinite(middle.x)) chosen.push(t);
  });
  return [chosen, places];
}
