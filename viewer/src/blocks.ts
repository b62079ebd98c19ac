// The blocks as one mesh: corners move on the processor, faces are shown when somebody can see them.

import * as THREE from "three";
import type { Scale } from "./colour";
import type { MotionInfo, ShapeInfo } from "./run";
import type { Packet } from "./wire";

/** Faces farther apart than this share of a block, as drawn, are open. */
const OPEN = 0.004;
/** With more faces than this, openings are told from this share of a block on only: nobody sees finer ones then. */
const MANY = 120_000;
const OPEN_IF_MANY = 0.03;
/** Above this many visible faces edges cost more than they show. */
const EDGES = 40_000;

export interface Look {
  exaggeration: number;
  edges: boolean;
  /** Blocks beyond are taken away: axis, place, and which side stays. */
  clip: { axis: 0 | 1 | 2; at: number; keep: 1 | -1 } | null;
  /** Values outside are taken away. */
  only: [number, number] | null;
}

/** Blocks of one shape. */
export class Blocks {
  readonly object = new THREE.Group();
  readonly dimension: 2 | 3;
  readonly count: number;
  readonly ids: Uint32Array;
  /** Corners as drawn, three numbers each. */
  readonly positions: Float32Array;
  readonly size: number;
  /** Faces shown now. */
  visibleFaces = 0;

  private readonly rest: Float32Array;
  private readonly offsets: Uint32Array;
  private readonly facesOf: Uint32Array;
  private readonly faceEnds: Uint32Array;
  private readonly corners: Uint32Array;
  private readonly twins: Uint32Array;
  private readonly hollow = new Map<number, Uint32Array>();
  private readonly blockOf: Uint32Array;
  /** Place of the twin pair of each face, or -1. */
  private readonly twinOf: Int32Array;
  /** Means of the corners of each block at rest. */
  readonly middles: Float32Array;
  private readonly geometry = new THREE.BufferGeometry();
  private readonly edgeGeometry = new THREE.BufferGeometry();
  /** Place of each block in the texture of colours. */
  private readonly shades: Float32Array;
  /** Corners that are drawn: which, and of which block. What is hidden is not sent to the graphics. */
  private readonly drawn = { count: 0, points: new Uint32Array(), blocks: new Uint32Array() };
  /** Place of each corner among those drawn. */
  private readonly drawnAs: Uint32Array;
  private readonly mesh: THREE.Mesh;
  private readonly lines: THREE.LineSegments;
  private readonly shown: Uint8Array;
  private readonly faceShown: Uint8Array;
  private triangleFace = new Uint32Array();
  private seen = "";
  private gaps: Uint8Array | null = null;
  private gapLimit = 0;

  constructor(
    readonly shape: Packet<ShapeInfo>,
    scale: Scale,
  ) {
    const { info } = shape;
    this.dimension = info.dimension;
    this.size = info.size;
    this.ids = shape.u32("ids");
    this.count = this.ids.length;
    this.rest = shape.f32("points");
    this.offsets = shape.u32("offsets");
    this.facesOf = shape.u32("facesOf");
    this.faceEnds = shape.u32("faceEnds");
    this.corners = shape.u32("corners");
    this.twins = shape.u32("twins");
    const hollowEnds = shape.u32("hollowEnds");
    const hollowCorners = shape.u32("hollowCorners");
    shape.u32("hollow").forEach((face, i) => {
      this.hollow.set(face, hollowCorners.subarray(hollowEnds[i]!, hollowEnds[i + 1]!));
    });
    const faces = this.faceEnds.length - 1;
    this.blockOf = new Uint32Array(faces);
    for (let b = 0; b < this.count; b++) this.blockOf.fill(b, this.facesOf[b]!, this.facesOf[b + 1]!);
    this.twinOf = new Int32Array(faces).fill(-1);
    for (let k = 0; k < this.twins.length; k++) this.twinOf[this.twins[k]!] = k >> 1;
    this.middles = this.means();
    this.positions = this.rest.slice();
    this.shades = new Float32Array(this.count).fill(0.25);
    this.drawnAs = new Uint32Array(this.positions.length / 3);
    this.shown = new Uint8Array(this.count).fill(1);
    this.faceShown = new Uint8Array(faces);

    this.geometry.boundingSphere = new THREE.Sphere();
    this.edgeGeometry.boundingSphere = this.geometry.boundingSphere;
    const flat = this.dimension === 2;
    const common = {
      map: scale.texture,
      side: flat ? THREE.DoubleSide : THREE.FrontSide,
      polygonOffset: true,
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 1,
    };
    const material = flat
      ? new THREE.MeshBasicMaterial(common)
      : new THREE.MeshLambertMaterial({ ...common, flatShading: true });
    this.mesh = new THREE.Mesh(this.geometry, material);
    this.lines = new THREE.LineSegments(
      this.edgeGeometry,
      new THREE.LineBasicMaterial({ color: 0x000000, transparent: true, opacity: flat ? 0.55 : 0.35 }),
    );
    this.mesh.frustumCulled = false;
    this.lines.frustumCulled = false;
    this.object.add(this.mesh, this.lines);
  }

  dispose(): void {
    this.geometry.dispose();
    this.edgeGeometry.dispose();
    (this.mesh.material as THREE.Material).dispose();
    (this.lines.material as THREE.Material).dispose();
  }

  /** Makes the blocks glass, so that what lies between them can be seen. */
  set glass(on: boolean) {
    const material = this.mesh.material as THREE.Material;
    material.transparent = on;
    material.opacity = on ? 0.14 : 1;
    material.depthWrite = !on;
    material.needsUpdate = true;
  }

  set edgeColour(colour: THREE.ColorRepresentation) {
    (this.lines.material as THREE.LineBasicMaterial).color.set(colour);
  }

  private means(): Float32Array {
    const out = new Float32Array(3 * this.count);
    for (let b = 0; b < this.count; b++) {
      const from = this.offsets[b]!;
      const to = this.offsets[b + 1]!;
      let x = 0;
      let y = 0;
      let z = 0;
      for (let p = 3 * from; p < 3 * to; p += 3) {
        x += this.rest[p]!;
        y += this.rest[p + 1]!;
        z += this.rest[p + 2]!;
      }
      const n = Math.max(1, to - from);
      out.set([x / n, y / n, z / n], 3 * b);
    }
    return out;
  }

  /** Moves the corners. Blocks of which nothing is seen stay behind. */
  move(motion: Packet<MotionInfo>, look: Look): void {
    const shifts = motion.f32("shifts");
    const s = look.exaggeration;
    if (this.dimension === 2) this.movePlane(shifts, motion.f32("turns"), s);
    else this.moveSpace(shifts, motion.i16("turns"), motion.info.turnScale / 32767, s);
    const bent = motion.u32("bent");
    const own = motion.f32("bentShifts");
    let at = 0;
    for (const b of bent) {
      for (let p = 3 * this.offsets[b]!; p < 3 * this.offsets[b + 1]!; p++) {
        this.positions[p] = this.rest[p]! + s * own[at++]!;
      }
    }
    this.gaps = motion.has("gaps") ? motion.u8("gaps") : null;
    // Number of the smallest opening that shows.
    const { shutDecade, steps } = motion.info;
    const limit = (open: number) => Math.ceil((Math.log10(open / Math.max(s, 1e-12)) - shutDecade) * steps) + 1;
    this.gapLimit = limit(OPEN);
    if (this.gaps && this.openFaces(this.gapLimit) > MANY) this.gapLimit = limit(OPEN_IF_MANY);
    this.bound();
  }

  /** Faces of pairs that are open by a limit. */
  private openFaces(limit: number): number {
    const pairs = this.twins.length / 2;
    let open = 0;
    for (let k = 0; k < pairs; k++) if (((this.gaps![k >> 1]! >> (4 * (k & 1))) & 15) >= limit) open += 2;
    return open;
  }

  private movePlane(shifts: Float32Array, turns: Float32Array, s: number): void {
    const { rest, positions, offsets, middles } = this;
    for (let b = 0; b < this.count; b++) {
      const c = Math.cos(turns[b]!) - 1;
      const n = Math.sin(turns[b]!);
      const dx = shifts[2 * b]!;
      const dy = shifts[2 * b + 1]!;
      const mx = middles[3 * b]!;
      const my = middles[3 * b + 1]!;
      for (let p = 3 * offsets[b]!; p < 3 * offsets[b + 1]!; p += 3) {
        const x = rest[p]! - mx;
        const y = rest[p + 1]! - my;
        positions[p] = rest[p]! + s * (dx + c * x - n * y);
        positions[p + 1] = rest[p + 1]! + s * (dy + n * x + c * y);
      }
    }
  }

  private moveSpace(shifts: Float32Array, turns: Int16Array, scale: number, s: number): void {
    const { rest, positions, offsets, middles } = this;
    for (let b = 0; b < this.count; b++) {
      const i = 3 * b;
      const dx = shifts[i]!;
      const dy = shifts[i + 1]!;
      const dz = shifts[i + 2]!;
      const qx = turns[i]! * scale;
      const qy = turns[i + 1]! * scale;
      const qz = turns[i + 2]! * scale;
      const still = qx === 0 && qy === 0 && qz === 0;
      const qw = Math.sqrt(Math.max(0, 1 - qx * qx - qy * qy - qz * qz));
      const mx = middles[i]!;
      const my = middles[i + 1]!;
      const mz = middles[i + 2]!;
      for (let p = 3 * offsets[b]!; p < 3 * offsets[b + 1]!; p += 3) {
        let ux = dx;
        let uy = dy;
        let uz = dz;
        if (!still) {
          const x = rest[p]! - mx;
          const y = rest[p + 1]! - my;
          const z = rest[p + 2]! - mz;
          // What a unit quaternion adds to a vector: 2 w (q x v) + 2 q x (q x v).
          const tx = 2 * (qy * z - qz * y);
          const ty = 2 * (qz * x - qx * z);
          const tz = 2 * (qx * y - qy * x);
          ux += qw * tx + qy * tz - qz * ty;
          uy += qw * ty + qz * tx - qx * tz;
          uz += qw * tz + qx * ty - qy * tx;
        }
        positions[p] = rest[p]! + s * ux;
        positions[p + 1] = rest[p + 1]! + s * uy;
        positions[p + 2] = rest[p + 2]! + s * uz;
      }
    }
  }

  private bound(): void {
    const box = new THREE.Box3();
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    const { positions } = this;
    for (let p = 0; p < positions.length; p += 3) {
      for (let k = 0; k < 3; k++) {
        const v = positions[p + k]!;
        if (v < low[k]!) low[k] = v;
        if (v > high[k]!) high[k] = v;
      }
    }
    box.min.set(low[0]!, low[1]!, low[2]!);
    box.max.set(high[0]!, high[1]!, high[2]!);
    if (!box.isEmpty()) box.getBoundingSphere(this.geometry.boundingSphere!);
  }

  /** Box around the blocks as drawn, by the middle 99.5 % of them: a stray stone must not make the rest a dot. */
  box(): THREE.Box3 {
    const box = new THREE.Box3();
    if (this.count === 0) return box;
    const limits = [0, 1, 2].map((k) => {
      const all = Float32Array.from({ length: this.count }, (_, b) => this.positions[3 * this.offsets[b]! + k]!)
        .filter(Number.isFinite)
        .sort();
      const at = (share: number) => all[Math.round(share * (all.length - 1))] ?? 0;
      const spare = Math.max(0.15 * (at(0.9975) - at(0.0025)), this.size);
      return [at(0.0025) - spare, at(0.9975) + spare];
    });
    const point = new THREE.Vector3();
    for (let b = 0; b < this.count; b++) {
      const first = 3 * this.offsets[b]!;
      const inside = [0, 1, 2].every((k) => {
        const v = this.positions[first + k]!;
        return v >= limits[k]![0]! && v <= limits[k]![1]!;
      });
      if (!inside) continue;
      for (let p = this.offsets[b]!; p < this.offsets[b + 1]!; p++) box.expandByPoint(point.fromArray(this.positions, 3 * p));
    }
    return box;
  }

  /** Colours the blocks by their values; none: all in the first colour. */
  paint(values: Float32Array | null, scale: Scale): void {
    for (let b = 0; b < this.count; b++) this.shades[b] = values ? scale.place(values[b]!) : 0.25;
  }

  /** Decides which faces are drawn. */
  reveal(look: Look, values: Float32Array | null): void {
    const { shown, faceShown, twins, blockOf } = this;
    shown.fill(1);
    if (look.clip) {
      const { axis, at, keep } = look.clip;
      for (let b = 0; b < this.count; b++) {
        if (keep * (this.middles[3 * b + axis]! - at) < 0) shown[b] = 0;
      }
    }
    if (look.only && values) {
      const [low, high] = look.only;
      for (let b = 0; b < this.count; b++) {
        if (!(values[b]! >= low && values[b]! <= high)) shown[b] = 0;
      }
    }
    for (let f = 0; f < faceShown.length; f++) faceShown[f] = shown[blockOf[f]!]!;
    for (let k = 0; k < twins.length; k += 2) {
      const f = twins[k]!;
      const g = twins[k + 1]!;
      if (!faceShown[f] || !faceShown[g]) continue;
      const pair = k >> 1;
      const code = this.gaps ? (this.gaps[pair >> 1]! >> (4 * (pair & 1))) & 15 : 15;
      if (code < this.gapLimit) {
        faceShown[f] = 0;
        faceShown[g] = 0;
      }
    }
    this.index(look.edges);
    this.send();
  }

  /** Puts corners and colours of what is drawn where the graphics take them from. */
  private send(): void {
    const { count, points, blocks } = this.drawn;
    const position = this.geometry.getAttribute("position") as THREE.BufferAttribute;
    const uv = this.geometry.getAttribute("uv") as THREE.BufferAttribute;
    const to = position.array as Float32Array;
    const shade = uv.array as Float32Array;
    const { positions, shades } = this;
    for (let i = 0; i < count; i++) {
      const p = 3 * points[i]!;
      to[3 * i] = positions[p]!;
      to[3 * i + 1] = positions[p + 1]!;
      to[3 * i + 2] = positions[p + 2]!;
      shade[2 * i] = shades[blocks[i]!]!;
    }
    update(position, 3 * count);
    update(uv, 2 * count);
  }

  /** Room for so many corners, and numbers of triangles and edges. Grows in steps, so that buffers live long. */
  private room(corners: number, index: number, lines: number): void {
    const have = this.geometry.getAttribute("position") as THREE.BufferAttribute | undefined;
    if (!have || have.count < corners) {
      const size = Math.ceil(1.25 * corners) + 64;
      this.geometry.dispose();
      this.edgeGeometry.dispose();
      const position = new THREE.BufferAttribute(new Float32Array(3 * size), 3).setUsage(THREE.DynamicDrawUsage);
      const uv = new THREE.BufferAttribute(new Float32Array(2 * size), 2).setUsage(THREE.DynamicDrawUsage);
      this.geometry.setAttribute("position", position);
      this.geometry.setAttribute("uv", uv);
      this.edgeGeometry.setAttribute("position", position);
      this.drawn.points = new Uint32Array(size);
      this.drawn.blocks = new Uint32Array(size);
    }
    for (const [geometry, size] of [[this.geometry, index], [this.edgeGeometry, lines]] as const) {
      const now = geometry.getIndex();
      if (now && now.count >= size) continue;
      geometry.dispose();
      const attribute = new THREE.BufferAttribute(new Uint32Array(Math.ceil(1.25 * size) + 64), 1);
      geometry.setIndex(attribute.setUsage(THREE.DynamicDrawUsage));
    }
  }

  private index(edges: boolean): void {
    const { faceShown, faceEnds, corners } = this;
    let faces = 0;
    let triangles = 0;
    let sides = 0;
    // Equal sets of faces give equal buffers: say so before building them.
    let hash = 0;
    for (let f = 0; f < faceShown.length; f++) {
      if (!faceShown[f]) continue;
      hash = (Math.imul(hash, 31) + f) | 0;
      faces++;
      sides += faceEnds[f + 1]! - faceEnds[f]!;
      triangles += this.hollow.has(f) ? this.hollow.get(f)!.length / 3 : faceEnds[f + 1]! - faceEnds[f]! - 2;
    }
    this.visibleFaces = faces;
    const withEdges = edges && (faces <= EDGES || this.dimension === 2);
    const state = `${hash} ${faces} ${withEdges}`;
    this.lines.visible = withEdges;
    if (state === this.seen) return;
    this.seen = state;
    this.room(sides, 3 * triangles, withEdges ? 2 * sides : 0);
    const index = this.geometry.getIndex()!.array as Uint32Array;
    const lines = this.edgeGeometry.getIndex()!.array as Uint32Array;
    const owner = new Uint32Array(triangles);
    const { drawn, drawnAs } = this;
    const none = 0xffffffff;
    drawnAs.fill(none);
    drawn.count = 0;
    let t = 0;
    let e = 0;
    let block = -1;
    let begun = 0;
    for (let f = 0; f < faceShown.length; f++) {
      if (!faceShown[f]) continue;
      const from = faceEnds[f]!;
      const to = faceEnds[f + 1]!;
      for (let k = from; k < to; k++) {
        const p = corners[k]!;
        if (drawnAs[p] !== none) continue;
        drawnAs[p] = drawn.count;
        drawn.points[drawn.count] = p;
        drawn.blocks[drawn.count++] = this.blockOf[f]!;
      }
      const cut = this.hollow.get(f);
      if (cut) {
        owner.fill(f, t / 3, (t + cut.length) / 3);
        for (const p of cut) index[t++] = drawnAs[p]!;
      } else {
        for (let k = from + 1; k + 1 < to; k++) {
          owner[t / 3] = f;
          index[t++] = drawnAs[corners[from]!]!;
          index[t++] = drawnAs[corners[k]!]!;
          index[t++] = drawnAs[corners[k + 1]!]!;
        }
      }
      if (withEdges) {
        if (this.blockOf[f] !== block) {
          block = this.blockOf[f]!;
          begun = e;
        }
        for (let k = from; k < to; k++) {
          const p = drawnAs[corners[k]!]!;
          const q = drawnAs[corners[k + 1 < to ? k + 1 : from]!]!;
          // The neighbouring face of the block has the same edge the other way round.
          let known = false;
          for (let i = this.dimension === 3 ? begun : e; i < e && !known; i += 2) known = lines[i] === q && lines[i + 1] === p;
          if (known) continue;
          lines[e++] = p;
          lines[e++] = q;
        }
      }
    }
    this.triangleFace = owner;
    update(this.geometry.getIndex()!, t);
    update(this.edgeGeometry.getIndex()!, e);
    this.geometry.setDrawRange(0, t);
    this.edgeGeometry.setDrawRange(0, e);
  }

  /** The block under a ray, as its place in the frame. */
  pick(ray: THREE.Raycaster): number | null {
    const hit = ray.intersectObject(this.mesh, false)[0];
    if (!hit || hit.faceIndex === undefined || hit.faceIndex === null) return null;
    return this.blockOf[this.triangleFace[hit.faceIndex]!] ?? null;
  }

  placeOf(id: number): number {
    return this.ids.indexOf(id);
  }

  /** Middle of a block as drawn. */
  middle(b: number, target: THREE.Vector3): THREE.Vector3 {
    target.set(0, 0, 0);
    const from = this.offsets[b]!;
    const to = this.offsets[b + 1]!;
    for (let p = from; p < to; p++) {
      target.x += this.positions[3 * p]!;
      target.y += this.positions[3 * p + 1]!;
      target.z += this.positions[3 * p + 2]!;
    }
    return target.divideScalar(Math.max(1, to - from));
  }

  isShown(b: number): boolean {
    return this.shown[b] === 1;
  }

  /** Edges of one block, two points each. */
  outline(b: number): Float32Array {
    const out: number[] = [];
    for (let f = this.facesOf[b]!; f < this.facesOf[b + 1]!; f++) {
      const from = this.faceEnds[f]!;
      const to = this.faceEnds[f + 1]!;
      for (let k = from; k < to; k++) {
        for (const corner of [this.corners[k]!, this.corners[k + 1 < to ? k + 1 : from]!]) {
          out.push(...this.positions.subarray(3 * corner, 3 * corner + 3));
        }
      }
    }
    return Float32Array.from(out);
  }

  /** Faces between two blocks, by the places of the blocks. Made once, when first asked for. */
  private between: Map<number, number> | null = null;

  private twinBetween(a: number, b: number): number | undefined {
    if (!this.between) {
      this.between = new Map();
      for (let k = 0; k < this.twins.length; k += 2) {
        const i = this.blockOf[this.twins[k]!]!;
        const j = this.blockOf[this.twins[k + 1]!]!;
        this.between.set(Math.min(i, j) * this.count + Math.max(i, j), k);
      }
    }
    return this.between.get(Math.min(a, b) * this.count + Math.max(a, b));
  }

  /** Triangles of the faces between pairs of blocks, in current position, and of which pair each is. */
  surfaces(pairs: [number, number][]): { points: Float32Array; pair: number[] } {
    const points: number[] = [];
    const pair: number[] = [];
    pairs.forEach(([a, b], n) => {
      const twin = this.twinBetween(a, b);
      if (twin === undefined) return;
      const f = this.twins[twin]!;
      const from = this.faceEnds[f]!;
      const to = this.faceEnds[f + 1]!;
      for (let k = from + 1; k + 1 < to; k++) {
        for (const c of [this.corners[from]!, this.corners[k]!, this.corners[k + 1]!]) {
          points.push(this.positions[3 * c]!, this.positions[3 * c + 1]!, this.positions[3 * c + 2]!);
        }
        pair.push(n);
      }
    });
    return { points: Float32Array.from(points), pair };
  }
}

/** Marks the first numbers of a buffer as changed. */
function update(attribute: THREE.BufferAttribute, numbers: number): void {
  attribute.clearUpdateRanges();
  attribute.addUpdateRange(0, numbers);
  attribute.needsUpdate = true;
}
