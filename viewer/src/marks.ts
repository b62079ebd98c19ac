// What is drawn over the blocks: arrows, contacts, cracks, sources, the picked block.

import * as THREE from "three";
import { surfaces } from "./between";
import type { Blocks } from "./blocks";
import type { BoltInfo, ContactInfo } from "./run";
import type { Packet } from "./wire";

/** Arrows drawn at most; of more, every second, third, ... is. */
export const ARROWS = 4000;

/** States of contacts, as the server numbers them (crates/riprap-view/src/contacts.rs). */
export const STATES = [
  { name: "touching", colour: "#4b8fd6" },
  { name: "sliding", colour: "#f0a020" },
  { name: "softened", colour: "#3aa88f" },
  { name: "broken", colour: "#e0483e" },
  { name: "broken in tension", colour: "#d62728" },
  { name: "broken in shear", colour: "#2c4fb8" },
  { name: "broken and open", colour: "#b05cd0" },
  { name: "open", colour: "#c062a8" },
] as const;
/** States from here on are drawn as faces. */
export const FACES = 2;

/** An arrow along +x of length one, from the origin. */
function arrowShape(flat: boolean): THREE.BufferGeometry {
  if (flat) {
    const shape = new THREE.Shape();
    shape.moveTo(0, -0.025).lineTo(0.7, -0.025).lineTo(0.7, -0.1).lineTo(1, 0);
    shape.lineTo(0.7, 0.1).lineTo(0.7, 0.025).lineTo(0, 0.025).closePath();
    return new THREE.ShapeGeometry(shape);
  }
  const shaft = new THREE.CylinderGeometry(0.025, 0.025, 0.7, 5).translate(0, 0.35, 0);
  const head = new THREE.ConeGeometry(0.09, 0.3, 8).translate(0, 0.85, 0);
  const merged = new THREE.BufferGeometry();
  // Both number their corners from 0.
  const parts = [shaft.toNonIndexed(), head.toNonIndexed()];
  for (const name of ["position", "normal"]) {
    const arrays = parts.map((p) => p.getAttribute(name).array as Float32Array);
    const all = new Float32Array(arrays[0]!.length + arrays[1]!.length);
    all.set(arrays[0]!);
    all.set(arrays[1]!, arrays[0]!.length);
    merged.setAttribute(name, new THREE.BufferAttribute(all, 3));
  }
  return merged.rotateZ(-Math.PI / 2);
}

export const AHEAD = new THREE.Vector3(1, 0, 0);

/** Arrows of one kind. */
export class Arrows {
  readonly object = new THREE.Group();
  private mesh: THREE.InstancedMesh | null = null;
  private readonly material: THREE.MeshBasicMaterial;

  constructor(
    private readonly flat: boolean,
    looks: THREE.MeshBasicMaterialParameters = {},
  ) {
    this.material = new THREE.MeshBasicMaterial({ side: THREE.DoubleSide, ...looks });
  }

  set colour(colour: THREE.ColorRepresentation) {
    this.material.color.set(colour);
  }

  /** Draws vectors at places; the longest is `length` long. Places and vectors have three numbers each. */
  draw(places: Float32Array, vectors: Float32Array, longest: number, length: number): void {
    this.clear();
    const count = vectors.length / 3;
    const some: number[] = [];
    for (let i = 0; i < count; i++) {
      const size = Math.hypot(vectors[3 * i]!, vectors[3 * i + 1]!, vectors[3 * i + 2]!);
      // Before they are thinned out, so that what cannot be seen takes no place of what can.
      if (size > longest * 0.01 && Number.isFinite(places[3 * i]!)) some.push(i);
    }
    const step = Math.max(1, Math.ceil(some.length / ARROWS));
    const drawn = some.filter((_, i) => i % step === 0);
    const mesh = new THREE.InstancedMesh(arrowShape(this.flat), this.material, drawn.length);
    const one = new THREE.Object3D();
    const way = new THREE.Vector3();
    drawn.forEach((i, n) => {
      way.fromArray(vectors, 3 * i);
      const size = way.length();
      one.position.fromArray(places, 3 * i);
      if (this.flat) one.position.z += 0.5;
      one.quaternion.setFromUnitVectors(AHEAD, way.divideScalar(size));
      // Short arrows keep their width down to a third, or they would vanish.
      const long = (size / longest) * length;
      const wide = Math.max(long, length / 3);
      one.scale.set(long, wide, wide);
      one.updateMatrix();
      mesh.setMatrixAt(n, one.matrix);
    });
    mesh.frustumCulled = false;
    mesh.renderOrder = 3;
    this.mesh = mesh;
    this.object.add(mesh);
  }

  clear(): void {
    if (!this.mesh) return;
    this.object.remove(this.mesh);
    this.mesh.geometry.dispose();
    this.mesh.dispose();
    this.mesh = null;
  }
}

/** Contacts as points, coloured by state. */
export class Contacts {
  readonly object = new THREE.Group();
  private readonly geometry = new THREE.BufferGeometry();
  private readonly points: THREE.Points;
  /** Faces between blocks that have come apart. */
  private readonly cracks: THREE.Mesh;

  constructor(flat: boolean) {
    this.points = new THREE.Points(
      this.geometry,
      new THREE.PointsMaterial({ size: flat ? 6 : 5, sizeAttenuation: false, vertexColors: true, depthTest: !flat }),
    );
    this.cracks = new THREE.Mesh(
      new THREE.BufferGeometry(),
      new THREE.MeshLambertMaterial({ vertexColors: true, side: THREE.DoubleSide, flatShading: true }),
    );
    for (const one of [this.points, this.cracks]) {
      one.frustumCulled = false;
      this.object.add(one);
    }
    this.points.renderOrder = 2;
    this.clear();
  }

  clear(): void {
    this.points.visible = false;
    this.cracks.visible = false;
  }

  /** Ends everything at planes. */
  end(planes: THREE.Plane[]): void {
    for (const one of [this.points, this.cracks]) (one.material as THREE.Material).clippingPlanes = planes;
  }

  /** How many there are of each state. */
  static count(contacts: Packet<ContactInfo>): number[] {
    const counts = STATES.map(() => 0);
    for (const s of contacts.u8("states")) counts[s] = (counts[s] ?? 0) + 1;
    return counts;
  }

  /** Draws points of the chosen states. */
  drawPoints(contacts: Packet<ContactInfo>, places: Float32Array, chosen: boolean[]): void {
    const states = contacts.u8("states");
    const colours = STATES.map((s) => new THREE.Color(s.colour));
    const points: number[] = [];
    const colour: number[] = [];
    states.forEach((s, i) => {
      if (!chosen[s]) return;
      points.push(places[3 * i]!, places[3 * i + 1]!, places[3 * i + 2]!);
      colour.push(...colours[s]!.toArray());
    });
    this.geometry.dispose();
    this.geometry.setAttribute("position", new THREE.Float32BufferAttribute(points, 3));
    this.geometry.setAttribute("color", new THREE.Float32BufferAttribute(colour, 3));
    this.points.visible = points.length > 0;
  }

  /**
   * Draws faces between blocks whose contact has softened, broken or opened. `outlines`: the broken parts of deformable
   * blocks as they are; without them the faces that blocks share at rest are drawn.
   */
  drawCracks(contacts: Packet<ContactInfo>, outlines: Packet<unknown> | null, blocks: Blocks, shift: Shift): void {
    const states = contacts.u8("states");
    const a = contacts.u32("blockA");
    const b = contacts.u32("blockB");
    const pairs: [number, number][] = [];
    const kinds: number[] = [];
    states.forEach((s, i) => {
      const [i0, i1] = [a[i] ?? NOBODY, b[i] ?? NOBODY];
      const outlined = outlines !== null && (s === 4 || s === 5);
      if (s < FACES || outlined || i0 === NOBODY || i1 === NOBODY) return;
      if (!blocks.isShown(i0) || !blocks.isShown(i1)) return;
      pairs.push([i0, i1]);
      kinds.push(s);
    });
    const { points, pair } = surfaces(blocks, pairs);
    const of = pair.map((n) => kinds[n]!);
    if (outlines) addOutlines(outlines, blocks, shift, points, of);
    const colours = STATES.map((s) => new THREE.Color(s.colour));
    const colour = new Float32Array(points.length);
    of.forEach((state, t) => {
      for (let k = 0; k < 3; k++) colours[state]!.toArray(colour, 9 * t + 3 * k);
    });
    this.cracks.geometry.dispose();
    this.cracks.geometry.setAttribute("position", new THREE.Float32BufferAttribute(points, 3));
    this.cracks.geometry.setAttribute("color", new THREE.BufferAttribute(colour, 3));
    this.cracks.visible = points.length > 0;
  }

  hide(which: "points" | "cracks"): void {
    this[which].visible = false;
  }
}

/** One form at many places, in one go, that shows through the blocks. */
export class Instances {
  protected mesh: THREE.InstancedMesh | null = null;
  readonly object = new THREE.Group();
  protected readonly material = new THREE.MeshBasicMaterial({ depthTest: false, transparent: true });

  clear(): void {
    if (!this.mesh) return;
    this.object.remove(this.mesh);
    this.mesh.geometry.dispose();
    this.mesh.dispose();
    this.mesh = null;
  }
}

/** Bars of bolts as rods that show through the blocks, coloured by axial force. */
export class Bolts extends Instances {
  /** Draws the bars, `thick` wide; ends go along with their blocks. The colour is white without force. */
  draw(bolts: Packet<BoltInfo>, blocks: Blocks, shift: Shift, thick: number): void {
    this.clear();
    const points = bolts.f32("points");
    const forces = bolts.f32("forces");
    const states = bolts.u8("states");
    const sides = [bolts.u32("blockA"), bolts.u32("blockB")] as const;
    const most = Math.max(Math.abs(bolts.info.largest ?? 0), Math.abs(bolts.info.smallest ?? 0)) || 1;
    const mesh = new THREE.InstancedMesh(new THREE.CylinderGeometry(0.5, 0.5, 1, 6).rotateZ(-Math.PI / 2), this.material, forces.length);
    const one = new THREE.Object3D();
    const [a, b, way] = [new THREE.Vector3(), new THREE.Vector3(), new THREE.Vector3()];
    const colour = new THREE.Color();
    forces.forEach((force, n) => {
      [a, b].forEach((end, side) => {
        const block = sides[side]![n]!;
        end.fromArray(points, 6 * n + 3 * side);
        if (block < blocks.count) end.add(shift(block, way));
      });
      way.subVectors(b, a);
      const long = way.length();
      one.position.addVectors(a, b).multiplyScalar(0.5);
      if (long > 0) one.quaternion.setFromUnitVectors(AHEAD, way.divideScalar(long));
      const broken = states[n] === BROKEN_BAR;
      one.scale.set(long, broken ? thick / 3 : thick, broken ? thick / 3 : thick);
      one.updateMatrix();
      mesh.setMatrixAt(n, one.matrix);
      mesh.setColorAt(n, broken ? colour.set("#444444") : boltColour(force / most, colour));
    });
    mesh.frustumCulled = false;
    mesh.renderOrder = 4;
    this.mesh = mesh;
    this.object.add(mesh);
  }
}

/** Forces below this share of the largest are no part of chains. */
export const WEAK = 0.02;

/**
 * Held blocks, and those so many times as large as the other one of a contact, are ground to it: the tube ends at the contact, since the
 * middle of a slab or of a slope is not where the force goes. crates/riprap-plot/src/shot/chains.rs has the same.
 */
const GROUND = 3;

/** Tubes from the middle of a block over a contact to the middle of the other, as thick and dark as the force; they show through the blocks. */
export class Chains extends Instances {
  /**
   * Draws those of the contacts at `places`, the thickest `thick` wide; `middle` is where a block is drawn, null where it is not, `size` the
   * diagonal of the box around it, without end where it is held. How many contacts.
   */
  draw(contacts: Packet<ContactInfo>, places: Float32Array, middle: (block: number) => THREE.Vector3 | null, size: (block: number) => number, thick: number): number {
    this.clear();
    const forces = contacts.f32("forces");
    const sides = [contacts.u32("blockA"), contacts.u32("blockB")] as const;
    const longest = contacts.info.longest ?? 0;
    const tubes: { from: THREE.Vector3; to: THREE.Vector3; share: number }[] = [];
    let drawn = 0;
    for (let i = 0; 3 * i < forces.length; i++) {
      const share = Math.hypot(forces[3 * i]!, forces[3 * i + 1]!, forces[3 * i + 2]!) / longest;
      if (!(share > WEAK) || !Number.isFinite(places[3 * i]!)) continue;
      const at = new THREE.Vector3().fromArray(places, 3 * i);
      const blocks = sides.map((side) => side[i] ?? NOBODY);
      const sizes = blocks.map(size);
      const ends = blocks.flatMap((block, side) => (sizes[side]! > GROUND * sizes[1 - side]! ? [] : (middle(block) ?? [])));
      tubes.push(...ends.map((to) => ({ from: at, to, share })));
      drawn += ends.length > 0 ? 1 : 0;
    }
    const mesh = new THREE.InstancedMesh(new THREE.CylinderGeometry(0.5, 0.5, 1, 8).rotateZ(-Math.PI / 2), this.material, tubes.length);
    const one = new THREE.Object3D();
    const way = new THREE.Vector3();
    const colour = new THREE.Color();
    // The largest last, so that none is hidden by a smaller one.
    tubes.sort((a, b) => a.share - b.share).forEach(({ from, to, share }, n) => {
      way.subVectors(to, from);
      const long = way.length();
      one.position.addVectors(from, to).multiplyScalar(0.5);
      if (long > 0) one.quaternion.setFromUnitVectors(AHEAD, way.divideScalar(long));
      one.scale.set(long, thick * share, thick * share);
      one.updateMatrix();
      mesh.setMatrixAt(n, one.matrix);
      mesh.setColorAt(n, colour.set("#f7c873").lerp(new THREE.Color(CHAINS), share));
    });
    mesh.frustumCulled = false;
    mesh.renderOrder = 4;
    this.mesh = mesh;
    this.object.add(mesh);
    return drawn;
  }
}

/** Colour of the largest force of chains. */
export const CHAINS = "#8c1313";

/** Colour of charges. */
export const CHARGES = "#ff7a00";

/** A charge of a scene: a point, or a line from the first corner to the last (m, global axes). */
export interface Charge {
  name: string;
  centre?: number[];
  line?: number[][];
}

/** Charges as small stars, with rods along those that are lines; they show through the blocks. */
export class Charges {
  readonly object = new THREE.Group();
  private readonly material = new THREE.MeshBasicMaterial({ color: CHARGES, depthTest: false, transparent: true, opacity: 0.85 });

  /** Puts up stars of the radius `size`, in m; `origin` is what places are drawn less of. */
  build(charges: Charge[], origin: readonly number[], size: number): void {
    for (const charge of charges) {
      const ends = (charge.centre ? [charge.centre] : (charge.line ?? [])).map((p) => new THREE.Vector3(p[0]! - origin[0]!, p[1]! - origin[1]!, p[2]! - origin[2]!));
      for (const end of ends) this.add(new THREE.OctahedronGeometry(size)).position.copy(end);
      for (let k = 0; k + 1 < ends.length; k++) {
        const way = ends[k + 1]!.clone().sub(ends[k]!);
        const rod = this.add(new THREE.CylinderGeometry(size / 5, size / 5, way.length(), 6).rotateZ(-Math.PI / 2));
        rod.position.copy(ends[k]!).addScaledVector(way, 0.5);
        rod.quaternion.setFromUnitVectors(AHEAD, way.normalize());
      }
    }
  }

  private add(geometry: THREE.BufferGeometry): THREE.Mesh {
    const mesh = new THREE.Mesh(geometry, this.material);
    mesh.renderOrder = 4;
    this.object.add(mesh);
    return mesh;
  }
}

/** Colours of principal stresses: those of bolts. */
export const PRESSED = "#1d5fd0";
export const PULLED = "#d01c1c";

/** State of a bar that has broken, as the server numbers them (crates/riprap-spatial/src/read/bars.rs). */
const BROKEN_BAR = 3;

/** White without force, red in tension, blue in compression; `share` of the largest force, -1 to 1. */
export function boltColour(share: number, out: THREE.Color): THREE.Color {
  const size = Math.min(1, Math.abs(share));
  return out.set("#f4f0ea").lerp(new THREE.Color(share < 0 ? PRESSED : PULLED), size);
}

/** What is to be added to the present place of something on a block, to have it where the block is drawn. */
export type Shift = (block: number, target: THREE.Vector3) => THREE.Vector3;

/** No block of the frame. */
const NOBODY = 0xffffffff;

/** Adds triangles of cracks, each between where its two blocks are drawn. */
function addOutlines(outlines: Packet<unknown>, blocks: Blocks, shift: Shift, points: number[], of: number[]): void {
  const own = outlines.f32("points");
  const sides = [outlines.u32("blockA"), outlines.u32("blockB")] as const;
  const [one, all] = [new THREE.Vector3(), new THREE.Vector3()];
  outlines.u8("states").forEach((state, t) => {
    const there = sides.map((s) => s[t]!).filter((b) => b < blocks.count);
    if (!there.some((b) => blocks.isShown(b))) return;
    all.set(0, 0, 0);
    for (const b of there) all.addScaledVector(shift(b, one), 1 / there.length);
    for (let k = 0; k < 9; k++) points.push(own[9 * t + k]! + all.getComponent(k % 3));
    of.push(state);
  });
}

/** Places of contacts as drawn: each goes along with its first block. */
export function contactPlaces(
  contacts: Packet<ContactInfo>,
  blocks: Blocks,
  shift: Shift,
): Float32Array {
  const points = contacts.f32("points").slice();
  const owners = contacts.u32("blockA");
  const way = new THREE.Vector3();
  for (let i = 0; i < owners.length; i++) {
    const b = owners[i]!;
    if (b >= blocks.count) continue;
    shift(b, way);
    points[3 * i] = points[3 * i]! + way.x;
    points[3 * i + 1] = points[3 * i + 1]! + way.y;
    points[3 * i + 2] = points[3 * i + 2]! + way.z;
  }
  return points;
}

/** Outline of the picked block. */
export class Picked {
  readonly object: THREE.LineSegments;

  constructor(color = "#ff2e88", order = 5) {
    this.object = new THREE.LineSegments(
      new THREE.BufferGeometry(),
      new THREE.LineBasicMaterial({ color, depthTest: false, transparent: true }),
    );
    this.object.renderOrder = order;
    this.object.frustumCulled = false;
    this.object.visible = false;
  }

  draw(points: Float32Array | null): void {
    this.object.visible = points !== null;
    if (!points) return;
    this.object.geometry.dispose();
    this.object.geometry.setAttribute("position", new THREE.BufferAttribute(points, 3));
  }
}
