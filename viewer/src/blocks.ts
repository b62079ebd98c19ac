// The blocks as one mesh: corners move on the processor, faces are shown when somebody can see them.

import * as THREE from "three";
import { boxOf } from "./box";
import type { Scale } from "./colour";
import { moveInPlane, moveInSpace } from "./moving";
import type { MotionInfo, ShapeInfo } from "./run";
import { Section, caps, sides, type Cut } from "./section";
import { NOTHING, Ridges } from "./ridges";
import { litBy, type Lit } from "./shade";
import type { Packet } from "./wire";

/** Faces farther apart than this share of a block, as drawn, are open. */
const OPEN = 0.004;
/** With more faces than this, openings are told from this share of a block on only: nobody sees finer ones then. */
const MANY = 120_000;
const OPEN_IF_MANY = 0.03;
/** Above this many visible faces edges cost more than they show; the second where the processor draws. */
const EDGES = [1_000_000, 100_000] as const;
/** Blocks with more faces than this are ground from a survey. */
const SURVEY = 300;
/** Blocks smaller than the first number of pixels have no edges, or these would be all that is seen; larger than the second, whole ones. */
const FADE = [3, 9] as const;
/** Corners nearer to a cut than this share of a block lie in it. */
const NEAR = 1e-5;

/** A flat cut keeps this share of a block away from faces that lie along it. */
const CLEAR = 0.02;

export interface Look {
  exaggeration: number;
  edges: boolean;
  /** What lies beyond is taken away. */
  clip: Cut | null;
  /** Values outside are taken away. */
  only: [number, number] | null;
}

/** Blocks of one shape. */
export class Blocks {
  readonly object = new THREE.Group();
  /** The same without colours and lines: what stands in the light. */
  readonly solid = new THREE.Group();
  readonly dimension: 2 | 3;
  readonly count: number;
  readonly ids: Uint32Array;
  /** Corners as drawn, three numbers each. */
  readonly positions: Float32Array;
  readonly size: number;
  /** Places of the blocks that are ground from a survey. */
  readonly surveys: number[] = [];
  /** Faces shown now. */
  visibleFaces = 0;

  readonly rest: Float32Array;
  readonly offsets: Uint32Array;
  readonly facesOf: Uint32Array;
  readonly faceEnds: Uint32Array;
  readonly corners: Uint32Array;
  readonly twins: Uint32Array;
  private readonly hollow = new Map<number, Uint32Array>();
  private readonly places = new Map<number, number>();
  readonly blockOf: Uint32Array;
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
  private readonly cast: THREE.Mesh<THREE.BufferGeometry, THREE.MeshBasicMaterial>;
  private readonly lines: THREE.LineSegments;
  private readonly section: Section;
  /** Which side of the flat cut each block is on, as `sides` tells. */
  private readonly side: Uint8Array;
  private cut: Cut | null = null;
  private readonly plane = new THREE.Plane();
  private readonly shown: Uint8Array;
  private readonly faceShown: Uint8Array;
  private readonly ridges: Ridges;
  private triangleFace = new Uint32Array();
  private seen = "";
  private gaps: Uint8Array | null = null;
  private gapLimit = 0;
  private withEdges = false;
  /** Whether there are too many faces for edges. */
  crowded = false;
  private clear = false;
  private ink = "#000000";

  constructor(
    readonly shape: Packet<ShapeInfo>,
    scale: Scale,
    lit: Lit,
    private readonly software: boolean,
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
    for (let b = 0; b < this.count; b++) if (this.isSurvey(b)) this.surveys.push(b);
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
    if (material instanceof THREE.MeshLambertMaterial) litBy(material, lit);
    this.mesh = new THREE.Mesh(this.geometry, material);
    this.cast = new THREE.Mesh(this.geometry, new THREE.MeshBasicMaterial({ colorWrite: false }));
    this.cast.frustumCulled = false;
    this.lines = new THREE.LineSegments(
      this.edgeGeometry,
      new THREE.LineBasicMaterial({ color: 0x000000, transparent: true, opacity: flat ? 0.55 : 0.35 }),
    );
    this.mesh.frustumCulled = false;
    this.lines.frustumCulled = false;
    this.section = new Section(scale.texture);
    this.side = new Uint8Array(this.count);
    this.ridges = new Ridges(this, (b) => this.isSurvey(b));
    this.object.add(this.mesh, this.lines, this.section.object);
    this.solid.add(this.cast, this.section.cast);
  }

  dispose(): void {
    this.geometry.dispose();
    this.edgeGeometry.dispose();
    (this.mesh.material as THREE.Material).dispose();
    this.cast.material.dispose();
    (this.lines.material as THREE.Material).dispose();
    this.section.dispose();
  }

  /** Makes the blocks glass, so that what lies between them can be seen. */
  set glass(on: boolean) {
    const material = this.mesh.material as THREE.Material;
    material.transparent = on;
    material.opacity = on ? 0.14 : 1;
    material.depthWrite = !on;
    material.needsUpdate = true;
    this.section.glass = on;
    this.clear = on;
    this.tint(this.ink);
  }

  /** Colour of what is written: the edges of glass have it, since the ground shows through. */
  tint(ink: string): void {
    this.ink = ink;
    (this.lines.material as THREE.LineBasicMaterial).color.set(this.clear ? ink : "#000000");
  }

  /** Fits the edges to the scale of the picture. */
  fade(metresPerPixel: number, quick = false): void {
    const pixels = this.size / metresPerPixel;
    const share = quick ? 0 : Math.min(1, (pixels - FADE[0]) / (FADE[1] - FADE[0]));
    this.lines.visible = this.withEdges && share > 0;
    (this.lines.material as THREE.Material).opacity = share * (this.dimension === 2 ? 0.55 : 0.35);
    this.section.fade(share);
  }

  /** Whether light and shadow belong to them: not in the plane, and glass has none. */
  get isSolid(): boolean {
    return this.dimension === 3 && !this.clear;
  }

  /** Around what is drawn. */
  get sphere(): THREE.Sphere {
    return this.geometry.boundingSphere!;
  }

  /** Blocks that the flat cut goes through. */
  get cutBlocks(): number {
    return this.section.count;
  }

  /** Whether the flat cut goes through a block. */
  isCut(b: number): boolean {
    return this.cut !== null && this.side[b] === 2;
  }

  /** The planes at which the graphics end what is drawn with these blocks. */
  get planes(): THREE.Plane[] {
    return this.cut ? [this.plane] : [];
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
    if (this.dimension === 2) moveInPlane(this, shifts, motion.f32("turns"), s);
    else moveInSpace(this, shifts, motion.i16("turns"), motion.info.turnScale / 32767, s);
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

  /** Box around the blocks as drawn, without strays. */
  box(): THREE.Box3 {
    return boxOf(this);
  }

  /** Colours the blocks by their values; none: all in the first colour. */
  paint(values: Float32Array | null, scale: Scale): void {
    const { ids, shades } = this;
    for (let b = 0; b < this.count; b++) {
      // Its kinds are told, its amounts are those of all that stands still.
      const survey = (!scale.kinds || scale.field === "material") && this.isSurvey(b);
      shades[b] = survey ? scale.terrain : values ? scale.place(values[b]!, ids[b]!) : scale.tone(ids[b]!);
    }
  }

  /** Whether a block is ground from a survey. */
  isSurvey(b: number): boolean {
    return this.dimension === 3 && this.facesOf[b + 1]! - this.facesOf[b]! > SURVEY;
  }

  /** Decides which faces are drawn. */
  reveal(look: Look, values: Float32Array | null): void {
    const { shown, faceShown, twins, blockOf } = this;
    shown.fill(1);
    if (look.clip) this.takeAway(look.clip);
    this.cut = look.clip?.flat ? look.clip : null;
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
      // Near the cut one of two blocks may be through and the other not: their faces are both needed.
      if (this.cut && (this.side[blockOf[f]!] === 2 || this.side[blockOf[g]!] === 2)) continue;
      const pair = k >> 1;
      const code = this.gaps ? (this.gaps[pair >> 1]! >> (4 * (pair & 1))) & 15 : 15;
      if (code < this.gapLimit) {
        faceShown[f] = 0;
        faceShown[g] = 0;
      }
    }
    this.index(look.edges);
    this.send();
    this.close(look.edges);
  }

  /** The place nearest to `at` where no face of a block lies in a cut of that normal; `at` itself where there is none. */
  clearOf(normal: Cut["normal"], at: number): number {
    if (this.dimension === 2) return at;
    const { positions, corners, faceEnds } = this;
    const near = CLEAR * this.size;
    const [x, y, z] = normal;
    const far = new Float32Array(positions.length / 3);
    for (let p = 0; p < far.length; p++) far[p] = x * positions[3 * p]! + y * positions[3 * p + 1]! + z * positions[3 * p + 2]! - at;
    const free = (shift: number) => {
      for (let f = 0; f + 1 < faceEnds.length; f++) {
        let k = faceEnds[f]!;
        while (k < faceEnds[f + 1]! && Math.abs(far[corners[k]!]! - shift) < near) k++;
        if (k === faceEnds[f + 1]!) return false;
      }
      return true;
    };
    for (const k of [0, 1, -1, 2, -2, 4, -4]) if (free(2 * k * near)) return at + 2 * k * near;
    return at;
  }

  /** Blocks beyond the cut. */
  private takeAway(cut: Cut): void {
    const { shown, side, middles } = this;
    if (cut.flat) {
      sides(this, cut, NEAR * this.size, side);
      for (let b = 0; b < this.count; b++) if (side[b] === 0) shown[b] = 0;
      return;
    }
    const [x, y, z] = cut.normal;
    for (let b = 0; b < this.count; b++) {
      const d = x * middles[3 * b]! + y * middles[3 * b + 1]! + z * middles[3 * b + 2]! - cut.at;
      if (cut.keep * d < 0) shown[b] = 0;
    }
  }

  /** Ends everything at the flat cut and fills what it opens. */
  private close(edges: boolean): void {
    const { cut, side, shown } = this;
    for (const one of [this.mesh, this.lines, this.cast]) (one.material as THREE.Material).clippingPlanes = this.planes;
    if (!cut) {
      this.section.clear();
      return;
    }
    // A little beyond the cut: faces that lie in it stay.
    this.plane.normal.set(...cut.normal).multiplyScalar(cut.keep);
    this.plane.constant = NEAR * this.size - cut.keep * cut.at;
    const through: number[] = [];
    for (let b = 0; b < this.count; b++) if (side[b] === 2 && shown[b]) through.push(b);
    this.section.draw(caps(this, cut, through), this.shades, edges);
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
    this.crowded = faces > EDGES[this.software ? 1 : 0] && this.dimension === 3;
    const withEdges = edges && !this.crowded;
    const state = `${hash} ${faces} ${withEdges}`;
    this.withEdges = withEdges;
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
    const flat = this.dimension === 2;
    let block = -1;
    let begun = 0;
    let ridges: Int32Array = new Int32Array();
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
        const b = this.blockOf[f]!;
        if (!flat && b !== block) {
          block = b;
          begun = faceEnds[this.facesOf[b]!]!;
          ridges = this.ridges.at(b);
        }
        for (let k = from; k < to; k++) {
          if (!flat) {
            const beyond = ridges[k - begun]!;
            const g = beyond >> 1;
            // Where the face beyond is seen too, one of them draws what is between them, if they meet at an angle.
            if (beyond !== NOTHING && faceShown[g] && (g < f || !(beyond & 1))) continue;
          }
          lines[e++] = drawnAs[corners[k]!]!;
          lines[e++] = drawnAs[corners[k + 1 < to ? k + 1 : from]!]!;
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
    return this.hit(ray)?.block ?? null;
  }

  /** The block under a ray, and where it is met. */
  hit(ray: THREE.Raycaster): { block: number; point: THREE.Vector3 } | null {
    const cap = this.section.pick(ray);
    const hit = ray.intersectObject(this.mesh, false).find((h) => !this.isAway(h.point));
    if (cap && (!hit || cap.distance < hit.distance)) return { block: cap.block, point: ray.ray.at(cap.distance, new THREE.Vector3()) };
    if (!hit || hit.faceIndex === undefined || hit.faceIndex === null) return null;
    const block = this.blockOf[this.triangleFace[hit.faceIndex]!];
    return block === undefined ? null : { block, point: hit.point };
  }

  /** Corners of a block as drawn. */
  cornersOf(b: number): THREE.Vector3[] {
    const out: THREE.Vector3[] = [];
    for (let p = this.offsets[b]!; p < this.offsets[b + 1]!; p++) out.push(new THREE.Vector3().fromArray(this.positions, 3 * p));
    return out;
  }

  /** Diagonal of the box around a block at rest, m; NaN: no such block. */
  diagonal(b: number): number {
    if (b >= this.count) return NaN;
    const [low, high] = [new THREE.Vector3(Infinity, Infinity, Infinity), new THREE.Vector3(-Infinity, -Infinity, -Infinity)];
    const at = new THREE.Vector3();
    for (let p = this.offsets[b]!; p < this.offsets[b + 1]!; p++) {
      at.fromArray(this.rest, 3 * p);
      low.min(at);
      high.max(at);
    }
    return high.distanceTo(low);
  }

  /** Place of a block in the frame by its number; below zero if it is not there. */
  placeOf(id: number): number {
    if (this.places.size === 0) this.ids.forEach((of, b) => this.places.set(of, b));
    return this.places.get(id) ?? -1;
  }

  /** Whether a block, or a part of it, is drawn. */
  isShown(b: number): boolean {
    return this.shown[b] === 1;
  }

  /** Whether the flat cut takes away a place as drawn. */
  isAway(point: THREE.Vector3): boolean {
    return this.cut !== null && this.plane.distanceToPoint(point) < 0;
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
}

/** Marks the first numbers of a buffer as changed. */
function update(attribute: THREE.BufferAttribute, numbers: number): void {
  attribute.clearUpdateRanges();
  attribute.addUpdateRange(0, numbers);
  attribute.needsUpdate = true;
}
