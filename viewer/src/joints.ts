// Joints between blocks in colours: by the set of their direction, or by the law of their interface.

import * as THREE from "three";
import type { Blocks } from "./blocks";
import { surfaces } from "./between";
import { overlap } from "./overlap";
import { kindColour } from "./colour";
import type { Conditions, Note } from "./conditions";
import { short } from "./format";

/** Joints whose directions differ by less are of one set, degrees. */
const ONE_SET = 15;
/** Sets with a colour of their own; what is left is grey. */
const SETS = 8;
const OTHER = "#9a9a9a";
/** Share of a block's size by which edges of the plane may lie apart and still be one joint. */
const SAME = 2e-3;

/** A joint at rest: in space a pair of blocks that share a face, in the plane a piece of line. */
interface Joint {
  blocks: [number, number];
  /** Unit normal in space; in the plane the direction. */
  axis: THREE.Vector3;
  /** m²; in the plane m. */
  size: number;
  /**
   * What is not a whole face: three corners of a face of the first block (in the plane both ends of an edge), and the corners of
   * the joint as shares of the ways from the first of them to the others, two numbers each (in the plane one).
   */
  piece?: { base: number[]; shares: number[] };
}

/** What joints have in common: a name for the legend, a colour, and which they are. */
interface Kind {
  note: Note;
  joints: Joint[];
}

export class JointMarks {
  readonly object: THREE.Mesh;
  /** Joints of a shape, and their sets: they are those of the blocks at rest. */
  private readonly known = new WeakMap<Blocks, { joints: Joint[]; sets: Kind[] }>();

  constructor() {
    this.object = new THREE.Mesh(
      new THREE.BufferGeometry(),
      new THREE.MeshLambertMaterial({ vertexColors: true, side: THREE.DoubleSide, flatShading: true }),
    );
    this.object.frustumCulled = false;
    this.object.visible = false;
    this.object.renderOrder = 2;
  }

  /** Draws the joints between blocks that are shown; what to say of them. `materials`: of each block. */
  draw(by: "" | "set" | "interface", blocks: Blocks, conditions: Conditions | null, materials: Float32Array | null): Note[] {
    this.object.visible = false;
    if (by === "") return [];
    let found = this.known.get(blocks);
    if (!found) {
      const joints = blocks.dimension === 3 ? jointsInSpace(blocks) : jointsInPlane(blocks);
      found = { joints, sets: setsOf(joints, blocks.dimension) };
      this.known.set(blocks, found);
    }
    const kinds = by === "set" ? found.sets : lawsOf(found.joints, blocks.dimension, conditions, materials);
    const points: number[] = [];
    const colours: number[] = [];
    for (const { note, joints: of } of kinds) {
      const shown = of.filter((j) => blocks.isShown(j.blocks[0]) && blocks.isShown(j.blocks[1]));
      const before = points.length;
      const whole = shown.filter((j) => !j.piece).map((j) => j.blocks);
      for (const x of surfaces(blocks, whole).points) points.push(x);
      const put = blocks.dimension === 3 ? putPart : putBand;
      for (const { piece } of shown) if (piece) put(blocks, piece, points);
      const colour = new THREE.Color(note.colour).toArray();
      for (let k = before; k < points.length; k += 3) colours.push(...colour);
    }
    const { geometry } = this.object;
    geometry.dispose();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(points, 3));
    geometry.setAttribute("color", new THREE.Float32BufferAttribute(colours, 3));
    geometry.deleteAttribute("normal");
    if (blocks.dimension === 2) {
      geometry.setAttribute("normal", new THREE.Float32BufferAttribute(points.map((_, k) => (k % 3 === 2 ? 1 : 0)), 3));
    }
    (this.object.material as THREE.Material).clippingPlanes = blocks.planes;
    this.object.visible = points.length > 0;
    return kinds.map((k) => k.note);
  }
}

/** Twice the area of a face at rest along its normal. */
function areaOf(blocks: Blocks, face: number): THREE.Vector3 {
  const { rest, corners, faceEnds } = blocks;
  const [out, a, u, v] = [new THREE.Vector3(), new THREE.Vector3(), new THREE.Vector3(), new THREE.Vector3()];
  a.fromArray(rest, 3 * corners[faceEnds[face]!]!);
  for (let i = faceEnds[face]! + 1; i + 1 < faceEnds[face + 1]!; i++) {
    u.fromArray(rest, 3 * corners[i]!).sub(a);
    v.fromArray(rest, 3 * corners[i + 1]!).sub(a);
    out.add(u.cross(v));
  }
  return out;
}

/** Faces that two blocks share at rest, and what they share of faces that differ. */
function jointsInSpace(blocks: Blocks): Joint[] {
  const { twins, blockOf } = blocks;
  const out: Joint[] = [];
  const paired = new Set<number>(twins);
  for (let k = 0; k < twins.length; k += 2) {
    const [f, g] = [twins[k]!, twins[k + 1]!];
    const axis = areaOf(blocks, f);
    const size = 0.5 * axis.length();
    if (size > 0) out.push({ blocks: [blockOf[f]!, blockOf[g]!], axis: axis.normalize(), size });
  }
  return [...out, ...partsInSpace(blocks, paired)];
}

/** A face that is no twin of another, on its plane. */
interface Flat {
  face: number;
  normal: THREE.Vector3;
  off: number;
  low: number[];
  high: number[];
}

/** Parts of faces that lie on parts of faces of other blocks. */
function partsInSpace(blocks: Blocks, paired: Set<number>): Joint[] {
  const { rest, corners, faceEnds, blockOf, size } = blocks;
  const near = SAME * size;
  // Faces by their plane, in steps in which what is the same may lie apart by one; what looks one way apart from what looks the other.
  const planes = new Map<string, Flat[]>();
  const cell = (n: THREE.Vector3, off: number, by: number[]) =>
    [...n.toArray().map((x, k) => Math.round(x / 0.02) + by[k]!), Math.round(off / (4 * near)) + by[3]!].join(" ");
  const flats: Flat[] = [];
  for (let face = 0; face + 1 < faceEnds.length; face++) {
    if (paired.has(face)) continue;
    const normal = areaOf(blocks, face);
    if (!(normal.length() > near * near)) continue;
    normal.normalize();
    const at = Array.from(corners.subarray(faceEnds[face]!, faceEnds[face + 1]!), (c) => Array.from(rest.subarray(3 * c, 3 * c + 3)));
    const [low, high] = [Math.min, Math.max].map((end) => [0, 1, 2].map((k) => end(...at.map((p) => p[k]!)))) as [number[], number[]];
    const flat = { face, normal, off: normal.dot(new THREE.Vector3(...(at[0] as [number, number, number]))), low, high };
    flats.push(flat);
    const key = cell(normal, flat.off, [0, 0, 0, 0]);
    const there = planes.get(key);
    if (there) there.push(flat);
    else planes.set(key, [flat]);
  }
  const steps = [-1, 0, 1];
  const around = steps.flatMap((a) => steps.flatMap((b) => steps.flatMap((c) => steps.map((d) => [a, b, c, d]))));
  const out: Joint[] = [];
  const back = new THREE.Vector3();
  for (const one of flats) {
    back.copy(one.normal).negate();
    for (const by of around) {
      for (const other of planes.get(cell(back, -one.off, by)) ?? []) {
        const [f, g] = [one.face, other.face];
        // Each pair once, from the face that comes first.
        if (g < f || blockOf[f] === blockOf[g] || Math.abs(one.off + other.off) > 2 * near) continue;
        if ([0, 1, 2].some((k) => one.low[k]! > other.high[k]! + near || other.low[k]! > one.high[k]! + near)) continue;
        const part = overlap(blocks, f, g, one.normal);
        if (part && part.size > near * size) out.push({ blocks: [blockOf[f]!, blockOf[g]!], axis: one.normal.clone(), ...part });
      }
    }
  }
  return out;
}

/** Pieces of edges of the plane that lie on edges of other blocks at rest. */
function jointsInPlane(blocks: Blocks): Joint[] {
  const { rest, corners, faceEnds, blockOf, size } = blocks;
  const near = SAME * size;
  interface Edge {
    block: number;
    corners: [number, number];
    /** Ends along the line, ascending or not. */
    ends: [number, number];
    direction: [number, number];
    off: number;
  }
  // Edges by their line: direction and distance from the origin, both in steps in which what is the same may lie apart by one.
  const lines = new Map<string, Edge[]>();
  const cell = (e: Edge, i: number, j: number) => `${Math.round(Math.atan2(e.direction[1], e.direction[0]) / 0.01) + i} ${Math.round(e.off / (4 * near)) + j}`;
  const out: Joint[] = [];
  for (let f = 0; f + 1 < faceEnds.length; f++) {
    for (let k = faceEnds[f]!; k < faceEnds[f + 1]!; k++) {
      const [p, q] = [corners[k]!, corners[k + 1 < faceEnds[f + 1]! ? k + 1 : faceEnds[f]!]!];
      let [dx, dy] = [rest[3 * q]! - rest[3 * p]!, rest[3 * q + 1]! - rest[3 * p + 1]!];
      const long = Math.hypot(dx, dy);
      if (!(long > near)) continue;
      // Of both directions of a line the one to the right, or straight up.
      const sign = dx > 1e-6 * long || (Math.abs(dx) <= 1e-6 * long && dy > 0) ? 1 : -1;
      [dx, dy] = [(sign * dx) / long, (sign * dy) / long];
      const along = (c: number) => dx * rest[3 * c]! + dy * rest[3 * c + 1]!;
      const edge: Edge = { block: blockOf[f]!, corners: [p, q], ends: [along(p), along(q)], direction: [dx, dy], off: dx * rest[3 * p + 1]! - dy * rest[3 * p]! };
      const [low, high] = [Math.min(...edge.ends), Math.max(...edge.ends)];
      for (let i = -1; i <= 1; i++) {
        for (let j = -1; j <= 1; j++) {
          for (const other of lines.get(cell(edge, i, j)) ?? []) {
            const from = Math.max(low, Math.min(...other.ends));
            const to = Math.min(high, Math.max(...other.ends));
            if (other.block === edge.block || to - from <= near || Math.abs(other.off - edge.off) > 2 * near) continue;
            const share = (x: number) => (x - edge.ends[0]) / (edge.ends[1] - edge.ends[0]);
            out.push({
              blocks: [edge.block, other.block],
              axis: new THREE.Vector3(dx, dy, 0),
              size: to - from,
              piece: { base: [p, q], shares: [share(from), share(to)] },
            });
          }
        }
      }
      const key = cell(edge, 0, 0);
      const there = lines.get(key);
      if (there) there.push(edge);
      else lines.set(key, [edge]);
    }
  }
  return out;
}

/** Half the width of bands in the plane: to be seen beside blocks, and beside the model where these are large. */
export function bandOf(blocks: Blocks): number {
  const { low, high } = blocks.shape.info;
  return Math.min(0.025 * blocks.size, Math.hypot(high[0] - low[0], high[1] - low[1]) / 500);
}

/** A piece of an edge as drawn, as a thin band. */
function putBand(blocks: Blocks, { base, shares }: NonNullable<Joint["piece"]>, points: number[]): void {
  const { positions } = blocks;
  const end = (n: number, k: number) => (1 - shares[n]!) * positions[3 * base[0]! + k]! + shares[n]! * positions[3 * base[1]! + k]!;
  const [ax, ay, bx, by] = [end(0, 0), end(0, 1), end(1, 0), end(1, 1)];
  const long = Math.hypot(bx - ax, by - ay) || 1;
  const half = bandOf(blocks);
  const [nx, ny] = [(-(by - ay) / long) * half, ((bx - ax) / long) * half];
  const z = 0.35;
  points.push(ax - nx, ay - ny, z, bx - nx, by - ny, z, bx + nx, by + ny, z, ax - nx, ay - ny, z, bx + nx, by + ny, z, ax + nx, ay + ny, z);
}

/** A part of a face as drawn, as triangles. */
function putPart(blocks: Blocks, { base, shares }: NonNullable<Joint["piece"]>, points: number[]): void {
  const { positions } = blocks;
  const [o, p, q] = base as [number, number, number];
  const put = (n: number) => {
    for (let k = 0; k < 3; k++) {
      const from = positions[3 * o + k]!;
      points.push(from + shares[2 * n]! * (positions[3 * p + k]! - from) + shares[2 * n + 1]! * (positions[3 * q + k]! - from));
    }
  };
  for (let n = 1; 2 * n + 2 < shares.length; n++) [0, n, n + 1].forEach(put);
}

/** Joints by their direction: each goes to the set whose mean direction is nearest, or begins one; large ones first. */
function setsOf(joints: Joint[], dimension: 2 | 3): Kind[] {
  const limit = Math.cos(THREE.MathUtils.degToRad(ONE_SET));
  const sets: { sum: THREE.Vector3; size: number; joints: Joint[] }[] = [];
  for (const joint of [...joints].sort((a, b) => b.size - a.size)) {
    let best: (typeof sets)[number] | undefined;
    let most = limit;
    for (const set of sets) {
      const share = Math.abs(set.sum.dot(joint.axis)) / set.sum.length();
      if (share > most) [best, most] = [set, share];
    }
    if (!best) {
      best = { sum: new THREE.Vector3(), size: 0, joints: [] };
      sets.push(best);
    }
    best.sum.addScaledVector(joint.axis, best.sum.dot(joint.axis) < 0 ? -joint.size : joint.size);
    best.size += joint.size;
    best.joints.push(joint);
  }
  sets.sort((a, b) => b.size - a.size);
  const kinds = sets.slice(0, SETS).map((set, i) => ({
    note: { text: `set ${i + 1}: ${directionOf(set.sum, dimension)}, ${amount(set.size, dimension)}`, colour: kindColour(i) },
    joints: set.joints,
  }));
  const rest = sets.slice(SETS);
  if (rest.length > 0) {
    const size = rest.reduce((sum, s) => sum + s.size, 0);
    kinds.push({ note: { text: `other directions, ${amount(size, dimension)}`, colour: OTHER }, joints: rest.flatMap((s) => s.joints) });
  }
  return kinds;
}

/** Joints by the law between the materials of their blocks. */
function lawsOf(joints: Joint[], dimension: 2 | 3, conditions: Conditions | null, materials: Float32Array | null): Kind[] {
  if (!conditions || !materials) return [];
  const count = Math.round(Math.sqrt(conditions.pairs.length));
  const kinds = new Map<number, { size: number; joints: Joint[] }>();
  for (const joint of joints) {
    const [a, b] = joint.blocks.map((block) => materials[block]!) as [number, number];
    const law = conditions.pairs[a * count + b] ?? -1;
    const kind = kinds.get(law) ?? { size: 0, joints: [] };
    kind.size += joint.size;
    kind.joints.push(joint);
    kinds.set(law, kind);
  }
  return [...kinds]
    .sort(([a], [b]) => a - b)
    .map(([law, { size, joints: of }]) => ({
      note: { text: `${conditions.interfaces[law] ?? "no law"}: ${amount(size, dimension)}`, colour: law < 0 ? OTHER : kindColour(law) },
      joints: of,
    }));
}

/** Dip and dip direction of a normal; in the plane the angle from x. */
export function directionOf(axis: THREE.Vector3, dimension: 2 | 3): string {
  const degrees = (v: number) => Math.round(THREE.MathUtils.radToDeg(v));
  if (dimension === 2) return `${(degrees(Math.atan2(axis.y, axis.x)) + 180) % 180}° from x`;
  const up = axis.clone().normalize();
  if (up.z < 0) up.negate();
  const dip = degrees(Math.acos(Math.min(1, up.z)));
  const to = (degrees(Math.atan2(up.x, up.y)) + 360) % 360;
  // What lies flat dips nowhere.
  return `${String(dip).padStart(2, "0")}°/${dip === 0 ? "–" : `${String(to).padStart(3, "0")}°`}`;
}

function amount(size: number, dimension: 2 | 3): string {
  return `${short(size, 3)} ${dimension === 3 ? "m²" : "m"}`;
}
