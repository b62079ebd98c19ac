// What holds, moves and loads the model, drawn: faces of boundaries in colours, arrows of loads, water tables.

import * as THREE from "three";
import type { Blocks } from "./blocks";
import { quantity } from "./format";
import { bandOf } from "./joints";
import { Arrows, type Shift } from "./marks";

export type FaceKind = "held" | "roller" | "held_along" | "moved" | "viscous" | "loaded";

/** The contents of conditions.json (docs/src/run-folder.md). */
export interface Conditions {
  blocks: number;
  faces: { name: string; kind: FaceKind; count: number; blocks: number[]; centres: Triple[]; tractions: Triple[] }[];
  loads: { kind: "force" | "moment" | "acceleration" | "pressure"; unit: string; block: number; at: Triple; vector: Triple }[];
  supports: { driven: boolean; blocks: number[] }[];
  water: Table[];
  /** Names of the phases, each with the place of the table that stands in it. */
  standing: [string, number | null][];
  interfaces: string[];
  /** Place of the interface between materials a and b, at a * materials + b. */
  pairs: number[];
}

/** A water table: corners along a direction, heights on a grid (lines along x, along y, heights), or several tables. */
interface Table {
  name: string;
  along: [number, number];
  points: [number, number][];
  grid?: [number[], number[], number[]];
  /** Lowest and highest coordinates of where it acts. */
  within?: [number[], number[]];
  parts?: Table[];
  /** Water seeps through joints from it. */
  seeps?: boolean;
}

type Triple = [number, number, number];

export const FACE_KINDS: Record<FaceKind, { name: string; colour: string }> = {
  held: { name: "held", colour: "#2f7bd9" },
  roller: { name: "rollers", colour: "#2aa7a0" },
  held_along: { name: "held along the face", colour: "#6b7fd7" },
  moved: { name: "moved", colour: "#e07b1a" },
  viscous: { name: "viscous", colour: "#8a5cc4" },
  loaded: { name: "loaded", colour: "#d0342c" },
};
const LOADS = "#c2187a";
const WATER = "#1f8fe0";
/** Arrows on loaded faces at most; of more faces, every second, third, ... has one. */
const TRACTIONS = 400;

/** One line of the legend. */
export interface Note {
  text: string;
  colour: string;
}

/** A face of a block under a condition. */
interface Place {
  /** Place of the condition in the list, and of the face in its lists. */
  condition: number;
  item: number;
  block: number;
  face: number;
}

/** Everything that is drawn of the conditions of one run. */
export class ConditionMarks {
  readonly object = new THREE.Group();
  private readonly faces: THREE.Mesh;
  private readonly arrows: { plane: Arrows; space: Arrows };
  private readonly surface: THREE.Mesh;
  private readonly known = new WeakMap<Blocks, Place[]>();
  /** Box around the ends of the arrows that stand outside. */
  readonly reach = new THREE.Box3();

  constructor() {
    this.faces = new THREE.Mesh(
      new THREE.BufferGeometry(),
      new THREE.MeshBasicMaterial({
        vertexColors: true, side: THREE.DoubleSide, transparent: true, opacity: 0.8,
        polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -2,
      }),
    );
    const drawn = { depthTest: false, transparent: true };
    this.arrows = { plane: new Arrows(true, drawn), space: new Arrows(false, drawn) };
    for (const arrows of Object.values(this.arrows)) arrows.colour = LOADS;
    this.surface = new THREE.Mesh(
      new THREE.BufferGeometry(),
      new THREE.MeshBasicMaterial({ color: WATER, side: THREE.DoubleSide, transparent: true, opacity: 0.35, depthWrite: false }),
    );
    for (const one of [this.faces, this.surface]) {
      one.frustumCulled = false;
      one.visible = false;
      one.renderOrder = 2;
    }
    this.object.add(this.faces, this.surface, this.arrows.plane.object, this.arrows.space.object);
  }

  /** The faces of the blocks that the conditions are about: each is the one in whose plane its centre lies. */
  private places(conditions: Conditions, blocks: Blocks): Place[] {
    let found = this.known.get(blocks);
    if (found) return found;
    found = [];
    const { origin } = blocks.shape.info;
    const centre = new THREE.Vector3();
    conditions.faces.forEach(({ blocks: ids, centres }, condition) => {
      ids.forEach((id, item) => {
        const block = blocks.placeOf(id);
        if (block < 0) return;
        const c = centres[item]!;
        centre.set(c[0] - origin[0], c[1] - origin[1], c[2] - origin[2]);
        let face = -1;
        let least = Infinity;
        for (let f = blocks.facesOf[block]!; f < blocks.facesOf[block + 1]!; f++) {
          const far = distance(blocks, f, centre);
          if (far < least) [face, least] = [f, far];
        }
        if (face >= 0) found!.push({ condition, item, block, face });
      });
    });
    this.known.set(blocks, found);
    return found;
  }

  /** Colours the faces of boundaries; what to say of them. */
  drawFaces(conditions: Conditions | null, blocks: Blocks): Note[] {
    this.faces.visible = false;
    if (!conditions || blocks.dimension === 2) return [];
    const points: number[] = [];
    const colours: number[] = [];
    const kinds = conditions.faces.map((c) => new THREE.Color(FACE_KINDS[c.kind].colour).toArray());
    const { positions, corners, faceEnds } = blocks;
    for (const { condition, block, face } of this.places(conditions, blocks)) {
      if (!blocks.isShown(block)) continue;
      const from = faceEnds[face]!;
      for (let k = from + 1; k + 1 < faceEnds[face + 1]!; k++) {
        for (const c of [corners[from]!, corners[k]!, corners[k + 1]!]) {
          points.push(positions[3 * c]!, positions[3 * c + 1]!, positions[3 * c + 2]!);
          colours.push(...kinds[condition]!);
        }
      }
    }
    const { geometry } = this.faces;
    geometry.dispose();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(points, 3));
    geometry.setAttribute("color", new THREE.Float32BufferAttribute(colours, 3));
    this.faces.visible = points.length > 0;
    (this.faces.material as THREE.Material).clippingPlanes = blocks.planes;
    const notes: Note[] = [];
    for (const kind of Object.keys(FACE_KINDS) as FaceKind[]) {
      const of = conditions.faces.filter((c) => c.kind === kind);
      const count = of.reduce((sum, c) => sum + c.count, 0);
      if (count === 0) continue;
      const lost = of.some((c) => c.blocks.length === 0) ? ", too many to draw" : "";
      const { name, colour } = FACE_KINDS[kind];
      notes.push({ text: `${name}: ${count} face${count === 1 ? "" : "s"}${lost}`, colour });
    }
    return notes;
  }

  /** Draws given forces and pressures as arrows, the largest of each kind `length` long; what to say of them. */
  drawLoads(conditions: Conditions | null, blocks: Blocks, shift: Shift, length: number): Note[] {
    const flat = blocks.dimension === 2;
    const arrows = flat ? this.arrows.plane : this.arrows.space;
    for (const one of Object.values(this.arrows)) one.clear();
    this.reach.makeEmpty();
    if (!conditions) return [];
    const all = [...given(conditions, blocks), ...this.tractions(conditions, blocks)];
    const longest = new Map<string, { size: number; unit: string; count: number }>();
    for (const { kind, unit, vector } of all) {
      const known = longest.get(kind);
      const size = vector.length();
      if (known) known.count++;
      if (!known || size > known.size) longest.set(kind, { size, unit, count: known ? known.count : 1 });
    }
    const places: number[] = [];
    const vectors: number[] = [];
    const at = new THREE.Vector3();
    const way = new THREE.Vector3();
    for (const { kind, block, place, vector } of all) {
      const { size } = longest.get(kind)!;
      // A moment about the normal of the plane has no direction in it.
      if (!(size > 0) || (flat && kind === "moment") || !blocks.isShown(block)) continue;
      way.copy(vector).divideScalar(size);
      at.copy(place).add(shift(block, new THREE.Vector3()));
      // The head is where the load acts, so that what pushes stands outside.
      at.addScaledVector(way, -length);
      places.push(...at.toArray());
      this.reach.expandByPoint(at);
      vectors.push(...way.toArray());
    }
    if (places.length > 0) arrows.draw(new Float32Array(places), new Float32Array(vectors), 1, length);
    return [...longest].map(([kind, { size, unit, count }]) => ({
      text: `${count === 1 ? kind : `${count} ${PLURALS[kind] ?? kind}, up to`} ${quantity(size, unit, 3)}`,
      colour: LOADS,
    }));
  }

  /** What acts on loaded faces, thinned where there are many. */
  private tractions(conditions: Conditions, blocks: Blocks): Acting[] {
    if (blocks.dimension === 2) return [];
    const loaded = this.places(conditions, blocks).filter((p) => conditions.faces[p.condition]!.tractions.length > 0);
    const step = Math.max(1, Math.ceil(loaded.length / TRACTIONS));
    const { origin } = blocks.shape.info;
    return loaded
      .filter((_, i) => i % step === 0)
      .map(({ condition, item, block }) => {
        const { centres, tractions } = conditions.faces[condition]!;
        const place = new THREE.Vector3(...centres[item]!).sub(new THREE.Vector3(...origin));
        return { kind: "traction", unit: "Pa", block, place, vector: new THREE.Vector3(...tractions[item]!) };
      });
  }

  /** Draws the water table that stands in a phase; what to say of it. */
  drawWater(conditions: Conditions | null, blocks: Blocks, phase: string): Note[] {
    this.surface.visible = false;
    const standing = conditions?.standing.find(([name]) => name === phase) ?? conditions?.standing[0];
    const table = standing && standing[1] !== null ? conditions!.water[standing[1]] : undefined;
    if (!table) return [];
    const flat = blocks.dimension === 2;
    const points: number[] = [];
    for (const one of table.parts ?? [table]) points.push(...(one.grid ? ofGrid(one.grid, blocks) : ofLine(one, blocks)));
    this.surface.geometry.dispose();
    this.surface.geometry.setAttribute("position", new THREE.Float32BufferAttribute(points, 3));
    (this.surface.material as THREE.Material).opacity = flat ? 0.9 : 0.35;
    this.surface.visible = true;
    return [{ text: `water table ${table.name}`, colour: WATER }];
  }
}

const PLURALS: Record<string, string> = {
  force: "forces",
  moment: "moments",
  pressure: "arrows of pressure",
  acceleration: "accelerations",
  traction: "faces loaded",
};

interface Acting {
  kind: string;
  unit: string;
  block: number;
  place: THREE.Vector3;
  vector: THREE.Vector3;
}

/** Loads on blocks that are there. */
function given(conditions: Conditions, blocks: Blocks): Acting[] {
  const { origin } = blocks.shape.info;
  return conditions.loads.flatMap(({ kind, unit, block, at, vector }) => {
    const b = blocks.placeOf(block);
    const place = new THREE.Vector3(...at).sub(new THREE.Vector3(...origin));
    if (blocks.dimension === 2) place.z = 0;
    return b < 0 ? [] : [{ kind, unit, block: b, place, vector: new THREE.Vector3(...vector) }];
  });
}

/** Triangles of a table on a grid, as far as it is given. */
function ofGrid([x, y, z]: [number[], number[], number[]], blocks: Blocks): number[] {
  const { origin } = blocks.shape.info;
  const place = (i: number, j: number) => [x[i]! - origin[0], y[j]! - origin[1], z[j * x.length + i]! - origin[2]];
  const points: number[] = [];
  for (let j = 0; j + 1 < y.length; j++) {
    for (let i = 0; i + 1 < x.length; i++) {
      const [a, b, c, d] = [place(i, j), place(i + 1, j), place(i + 1, j + 1), place(i, j + 1)];
      points.push(...a, ...b, ...c, ...a, ...c, ...d);
    }
  }
  return points;
}

/** Triangles of a table with corners, level beyond both ends as far as the model or where it acts reaches. */
function ofLine(table: Table, blocks: Blocks): number[] {
  const { low, high, origin } = blocks.shape.info;
  const flat = blocks.dimension === 2;
  const far = (x: number, y: number) => table.along[0] * (x + origin[0]) + table.along[1] * (y + origin[1]);
  const reach = flat ? [low[0] + origin[0], high[0] + origin[0]] : [0, 1, 2, 3].map((k) => far(k & 1 ? high[0] : low[0], k & 2 ? high[1] : low[1]));
  let [from, to] = [Math.min(...reach), Math.max(...reach)];
  if (flat && table.within) [from, to] = [Math.max(from, table.within[0][0]!), Math.min(to, table.within[1][0]!)];
  const line = profile(table.points, from, to);
  const points: number[] = [];
  if (flat) {
    const half = bandOf(blocks);
    for (let k = 0; k + 1 < line.length; k++) {
      const [[x, y], [u, v]] = [line[k]!, line[k + 1]!].map(([d, h]) => [d - origin[0], h - origin[1]]) as [[number, number], [number, number]];
      points.push(x, y - half, 0.45, u, v - half, 0.45, u, v + half, 0.45, x, y - half, 0.45, u, v + half, 0.45, x, y + half, 0.45);
    }
    return points;
  }
  const [ax, ay] = table.along;
  // Half the diagonal covers the model whichever way the table lies.
  const wide = 0.5 * Math.hypot(high[0] - low[0], high[1] - low[1]);
  const middle = [origin[0] + 0.5 * (low[0] + high[0]), origin[1] + 0.5 * (low[1] + high[1])] as const;
  const across = -ay * middle[0] + ax * middle[1];
  const place = ([d, h]: [number, number], side: number) => {
    const c = across + side * wide;
    return [ax * d - ay * c - origin[0], ay * d + ax * c - origin[1], h - origin[2]];
  };
  for (let k = 0; k + 1 < line.length; k++) {
    const [a, b] = [line[k]!, line[k + 1]!];
    points.push(...place(a, -1), ...place(b, -1), ...place(b, 1), ...place(a, -1), ...place(b, 1), ...place(a, 1));
  }
  return points;
}

/** Corners of a table from one distance to another: its own between them, level beyond its ends. */
function profile(points: [number, number][], from: number, to: number): [number, number][] {
  const height = (d: number): number => {
    const k = points.findIndex((p) => p[0] > d);
    if (k === 0) return points[0]![1];
    if (k < 0) return points.at(-1)![1];
    const [[d0, h0], [d1, h1]] = [points[k - 1]!, points[k]!];
    return h0 + ((h1 - h0) * (d - d0)) / (d1 - d0);
  };
  return [[from, height(from)], ...points.filter((p) => p[0] > from && p[0] < to), [to, height(to)]];
}

/** Distance of a point from the plane of a face at rest. */
function distance(blocks: Blocks, face: number, point: THREE.Vector3): number {
  const { rest, corners, faceEnds } = blocks;
  const [from, to] = [faceEnds[face]!, faceEnds[face + 1]!];
  const a = new THREE.Vector3().fromArray(rest, 3 * corners[from]!);
  const normal = new THREE.Vector3();
  const [u, v] = [new THREE.Vector3(), new THREE.Vector3()];
  for (let k = from + 1; k + 1 < to; k++) {
    u.fromArray(rest, 3 * corners[k]!).sub(a);
    v.fromArray(rest, 3 * corners[k + 1]!).sub(a);
    normal.add(u.cross(v));
  }
  return Math.abs(normal.normalize().dot(u.subVectors(point, a)));
}
