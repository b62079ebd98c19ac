// A flat cut through the blocks: where its plane lies, and the faces that it makes (caps).
//
// A block is cut exactly, from its corners as drawn. Each of its edges that the plane crosses belongs to two faces: one
// ends there, the next begins there, so that the lines on the faces chain into closed loops. Blocks need not be convex.

import * as THREE from "three";

/** What is kept: `keep * (normal . p - at) >= 0`, in drawn coordinates. */
export interface Cut {
  normal: [number, number, number];
  at: number;
  keep: 1 | -1;
  /** Through blocks, with caps; else whole blocks are taken away by their middles. */
  flat: boolean;
}

/** Corners and faces of blocks. */
export interface Solids {
  dimension: 2 | 3;
  count: number;
  offsets: Uint32Array;
  facesOf: Uint32Array;
  faceEnds: Uint32Array;
  corners: Uint32Array;
  positions: Float32Array;
}

/** Normal of a plane by dip and dip direction in degrees: x east, y north, z up, the direction clockwise from north. */
export function normalOf(dip: number, direction: number): [number, number, number] {
  const [d, a] = [dip, direction].map(THREE.MathUtils.degToRad) as [number, number];
  return [Math.sin(d) * Math.sin(a), Math.sin(d) * Math.cos(a), Math.cos(d)];
}

/** Normal of a line in the plane by its angle in degrees anticlockwise from x. */
export function normalInPlane(angle: number): [number, number, number] {
  const a = THREE.MathUtils.degToRad(angle);
  return [-Math.sin(a), Math.cos(a), 0];
}

/** Which side of the cut each block is on: 0 away, 1 kept, 2 cut through. `near`: distances that count as none. */
export function sides(solids: Solids, cut: Cut, near: number, out: Uint8Array): void {
  const { positions, offsets, count } = solids;
  const [x, y, z] = cut.normal.map((n) => cut.keep * n) as [number, number, number];
  const at = cut.keep * cut.at;
  for (let b = 0; b < count; b++) {
    let low = Infinity;
    let high = -Infinity;
    for (let p = 3 * offsets[b]!; p < 3 * offsets[b + 1]!; p += 3) {
      const d = x * positions[p]! + y * positions[p + 1]! + z * positions[p + 2]! - at;
      if (d < low) low = d;
      if (d > high) high = d;
    }
    out[b] = high <= near ? 0 : low >= -near ? 1 : 2;
  }
}

/** More corners than a page can hold: tells edges apart by the numbers of their ends. */
const EDGE = 2 ** 26;

/** A place where the plane crosses an edge of a face. */
interface Crossing {
  /** The edge, the same from both of its faces. */
  edge: number;
  /** Whether the way round the face comes onto the kept side there. */
  up: boolean;
  point: THREE.Vector3;
}

/** Caps of blocks. */
export interface Caps {
  /** Corners of triangles, nine numbers each; none in the plane. */
  triangles: number[];
  /** Block of each triangle. */
  owners: number[];
  /** Outlines, six numbers for each line. */
  lines: number[];
}

/** Cuts the blocks of a list. */
export function caps(solids: Solids, cut: Cut, blocks: Iterable<number>): Caps {
  const out: Caps = { triangles: [], owners: [], lines: [] };
  const normal = new THREE.Vector3(...cut.normal).multiplyScalar(cut.keep);
  const at = cut.keep * cut.at;
  const axes = basis(normal);
  for (const b of blocks) {
    // From the place where the way round a cap comes in to the place where it goes on.
    const next = new Map<number, { to: number; point: THREE.Vector3 }>();
    for (let f = solids.facesOf[b]!; f < solids.facesOf[b + 1]!; f++) {
      const found = crossings(solids, f, normal, at);
      if (found.length < 2) continue;
      if (found.length > 2) sortAlong(found);
      for (let k = 0; k + 1 < found.length; k += 2) {
        const [p, q] = [found[k]!, found[k + 1]!];
        if (solids.dimension === 2) out.lines.push(...p.point.toArray(), ...q.point.toArray());
        const [from, to] = p.up ? [p, q] : [q, p];
        next.set(from.edge, { to: to.edge, point: from.point });
      }
    }
    if (solids.dimension === 3) fill(loops(next), axes, b, out);
  }
  return out;
}

function crossings(solids: Solids, f: number, normal: THREE.Vector3, at: number): Crossing[] {
  const { corners, faceEnds, positions } = solids;
  const from = faceEnds[f]!;
  const to = faceEnds[f + 1]!;
  const distance = (c: number) =>
    normal.x * positions[3 * c]! + normal.y * positions[3 * c + 1]! + normal.z * positions[3 * c + 2]! - at;
  const out: Crossing[] = [];
  let p = corners[to - 1]!;
  let dp = distance(p);
  for (let k = from; k < to; k++) {
    const q = corners[k]!;
    const dq = distance(q);
    if (dp >= 0 !== dq >= 0) {
      // From the same end whichever face asks, so that both find the same place.
      const [i, j, di, dj] = p < q ? [p, q, dp, dq] : [q, p, dq, dp];
      const t = di / (di - dj);
      const point = new THREE.Vector3();
      for (const axis of [0, 1, 2]) {
        const start = positions[3 * i + axis]!;
        point.setComponent(axis, start + t * (positions[3 * j + axis]! - start));
      }
      out.push({ edge: i * EDGE + j, up: dq >= 0, point });
    }
    p = q;
    dp = dq;
  }
  return out;
}

/** Sorts places along the line on which they lie. */
function sortAlong(found: Crossing[]): void {
  const first = found[0]!.point;
  const far = found.reduce((a, b) => (b.point.distanceToSquared(first) > a.point.distanceToSquared(first) ? b : a));
  const way = far.point.clone().sub(first);
  found.sort((a, b) => a.point.dot(way) - b.point.dot(way));
}

function loops(next: Map<number, { to: number; point: THREE.Vector3 }>): THREE.Vector3[][] {
  const out: THREE.Vector3[][] = [];
  for (const start of next.keys()) {
    const loop: THREE.Vector3[] = [];
    let at = start;
    for (let entry = next.get(at); entry; entry = next.get(at)) {
      loop.push(entry.point);
      next.delete(at);
      at = entry.to;
    }
    // One that does not close belongs to a body with a hole in its skin.
    if (at === start && loop.length > 2) out.push(loop);
  }
  return out;
}

/** Axes in the plane, so that caps are anticlockwise seen from the side that was taken away. */
function basis(normal: THREE.Vector3): [THREE.Vector3, THREE.Vector3] {
  const other = Math.abs(normal.z) < 0.9 ? new THREE.Vector3(0, 0, 1) : new THREE.Vector3(1, 0, 0);
  const e = other.cross(normal).normalize();
  return [e, e.clone().cross(normal)];
}

/** Triangles of loops; clockwise ones are holes in the anticlockwise one around them. */
function fill(all: THREE.Vector3[][], [e, f]: [THREE.Vector3, THREE.Vector3], block: number, out: Caps): void {
  const outlines = all.map((points) => ({
    points,
    flat: points.map((p) => new THREE.Vector2(p.dot(e), p.dot(f))),
  }));
  for (const { points } of outlines) {
    points.forEach((p, i) => out.lines.push(...p.toArray(), ...points[(i + 1) % points.length]!.toArray()));
  }
  const put = (p: THREE.Vector3, q: THREE.Vector3, r: THREE.Vector3) => {
    out.triangles.push(p.x, p.y, p.z, q.x, q.y, q.z, r.x, r.y, r.z);
    out.owners.push(block);
  };
  const single = outlines[0];
  if (single && outlines.length === 1 && convex(single.flat)) {
    const { points } = single;
    for (let k = 1; k + 1 < points.length; k++) put(points[0]!, points[k]!, points[k + 1]!);
    return;
  }
  const outer = outlines.filter((o) => THREE.ShapeUtils.area(o.flat) > 0);
  const inner = outlines.filter((o) => THREE.ShapeUtils.area(o.flat) < 0);
  for (const one of outer) {
    const holes = outer.length === 1 ? inner : inner.filter((hole) => inside(hole.flat[0]!, one.flat));
    const points = [...one.points, ...holes.flatMap((h) => h.points)];
    for (const [i, j, k] of THREE.ShapeUtils.triangulateShape(one.flat.slice(), holes.map((h) => h.flat.slice()))) {
      put(points[i!]!, points[j!]!, points[k!]!);
    }
  }
}

function convex(flat: THREE.Vector2[]): boolean {
  const n = flat.length;
  for (let k = 0; k < n; k++) {
    const [a, b, c] = [flat[k]!, flat[(k + 1) % n]!, flat[(k + 2) % n]!];
    const [ux, uy, vx, vy] = [b.x - a.x, b.y - a.y, c.x - b.x, c.y - b.y];
    if (ux * vy - uy * vx < -1e-6 * Math.hypot(ux, uy) * Math.hypot(vx, vy)) return false;
  }
  return true;
}

function inside(p: THREE.Vector2, outline: THREE.Vector2[]): boolean {
  let odd = false;
  outline.forEach((a, i) => {
    const b = outline[(i + 1) % outline.length]!;
    if (a.y > p.y !== b.y > p.y && p.x < a.x + ((p.y - a.y) / (b.y - a.y)) * (b.x - a.x)) odd = !odd;
  });
  return odd;
}

/** The caps on the stage. */
export class Section {
  readonly object = new THREE.Group();
  /** The caps without colours. */
  readonly cast: THREE.Mesh<THREE.BufferGeometry, THREE.MeshBasicMaterial>;
  private readonly mesh: THREE.Mesh<THREE.BufferGeometry, THREE.MeshBasicMaterial>;
  private readonly lines: THREE.LineSegments<THREE.BufferGeometry, THREE.LineBasicMaterial>;
  private owners: number[] = [];
  private withEdges = false;

  constructor(texture: THREE.Texture) {
    // Unlit: the colours of a cut are read off, and must be those of the legend.
    const fill = { map: texture, side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };
    this.mesh = new THREE.Mesh(new THREE.BufferGeometry(), new THREE.MeshBasicMaterial(fill));
    this.lines = new THREE.LineSegments(
      new THREE.BufferGeometry(),
      new THREE.LineBasicMaterial({ color: 0x000000, transparent: true, opacity: 0.55 }),
    );
    this.cast = new THREE.Mesh(this.mesh.geometry, new THREE.MeshBasicMaterial({ colorWrite: false, side: THREE.DoubleSide }));
    this.cast.frustumCulled = false;
    for (const one of [this.mesh, this.lines]) {
      one.frustumCulled = false;
      this.object.add(one);
    }
    this.clear();
  }

  get count(): number {
    return new Set(this.owners).size;
  }

  clear(): void {
    this.object.visible = false;
    this.cast.visible = false;
    this.owners = [];
  }

  draw(made: Caps, shades: Float32Array, edges: boolean): void {
    const { triangles, owners, lines } = made;
    this.owners = owners;
    this.object.visible = lines.length > 0;
    this.withEdges = edges;
    this.mesh.visible = triangles.length > 0;
    this.cast.visible = this.mesh.visible;
    const uv = new Float32Array(6 * owners.length);
    owners.forEach((b, t) => {
      for (let k = 0; k < 3; k++) uv[6 * t + 2 * k] = shades[b]!;
    });
    this.mesh.geometry.dispose();
    this.mesh.geometry.setAttribute("position", new THREE.Float32BufferAttribute(triangles, 3));
    this.mesh.geometry.setAttribute("uv", new THREE.BufferAttribute(uv, 2));
    this.mesh.geometry.boundingSphere = null;
    this.lines.geometry.dispose();
    this.lines.geometry.setAttribute("position", new THREE.Float32BufferAttribute(lines, 3));
  }

  /** Edges as far as they may be seen, from 0 to 1. */
  fade(share: number): void {
    this.lines.visible = this.withEdges && share > 0;
    this.lines.material.opacity = 0.55 * share;
  }

  /** The block under a ray and how far it is. */
  pick(ray: THREE.Raycaster): { block: number; distance: number } | null {
    if (!this.object.visible || !this.mesh.visible) return null;
    const hit = ray.intersectObject(this.mesh, false)[0];
    const block = hit?.faceIndex === undefined || hit.faceIndex === null ? undefined : this.owners[hit.faceIndex];
    return hit && block !== undefined ? { block, distance: hit.distance } : null;
  }

  set glass(on: boolean) {
    const { material } = this.mesh;
    material.transparent = on;
    material.opacity = on ? 0.14 : 1;
    material.depthWrite = !on;
    material.needsUpdate = true;
  }

  dispose(): void {
    for (const one of [this.mesh, this.lines]) {
      one.geometry.dispose();
      one.material.dispose();
    }
  }
}
