// A line between two places of the picture: how long it is, and what a field is along it.

import * as THREE from "three";
import type { Solids } from "./section";

/** Pieces shorter than this share of the line are none. */
const NONE = 1e-7;

/** A stretch of the line inside a block: shares of its length. */
export interface Piece {
  from: number;
  to: number;
  block: number;
}

/** The stretches of the line from `a` to `b` that lie in blocks as drawn, in their order. */
export function piecesAlong(solids: Solids, a: THREE.Vector3, b: THREE.Vector3): Piece[] {
  const out: Piece[] = [];
  for (let block = 0; block < solids.count; block++) {
    if (solids.dimension === 3) {
      const [from, to] = insideConvex(solids, block, a, b);
      if (to - from > NONE) out.push({ from, to, block });
    } else {
      const ends = crossings(solids, block, a, b);
      for (let k = 0; k + 1 < ends.length; k += 2) {
        const [from, to] = [Math.max(0, ends[k]!), Math.min(1, ends[k + 1]!)];
        if (to - from > NONE) out.push({ from, to, block });
      }
    }
  }
  return out.sort((p, q) => p.from - q.from || p.to - q.to);
}

const [normal, corner, u, v] = [new THREE.Vector3(), new THREE.Vector3(), new THREE.Vector3(), new THREE.Vector3()];

/** Where the line is behind all faces of a convex block; nowhere: the second share is below the first. */
function insideConvex({ positions, corners, facesOf, faceEnds }: Solids, block: number, a: THREE.Vector3, b: THREE.Vector3): [number, number] {
  let [from, to] = [0, 1];
  for (let f = facesOf[block]!; f < facesOf[block + 1]! && from < to; f++) {
    const [first, end] = [faceEnds[f]!, faceEnds[f + 1]!];
    corner.fromArray(positions, 3 * corners[first]!);
    normal.set(0, 0, 0);
    for (let k = first + 1; k + 1 < end; k++) {
      u.fromArray(positions, 3 * corners[k]!).sub(corner);
      v.fromArray(positions, 3 * corners[k + 1]!).sub(corner);
      normal.add(u.cross(v));
    }
    // Of any length: only signs and ratios are read.
    const [da, db] = [normal.dot(u.subVectors(a, corner)), normal.dot(v.subVectors(b, corner))];
    if (da >= 0 && db >= 0) return [1, 0];
    const at = da / (da - db);
    if (da > 0) from = Math.max(from, at);
    else if (db > 0) to = Math.min(to, at);
  }
  return [from, to];
}

/** Where the straight line through `a` and `b` goes into and out of a polygon of the plane, ascending. */
function crossings({ positions, corners, facesOf, faceEnds }: Solids, block: number, a: THREE.Vector3, b: THREE.Vector3): number[] {
  const out: number[] = [];
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  for (let f = facesOf[block]!; f < facesOf[block + 1]!; f++) {
    const [first, end] = [faceEnds[f]!, faceEnds[f + 1]!];
    for (let k = first; k < end; k++) {
      const [p, q] = [3 * corners[k]!, 3 * corners[k + 1 < end ? k + 1 : first]!];
      const side = (i: number) => dx * (positions[i + 1]! - a.y) - dy * (positions[i]! - a.x);
      const [sp, sq] = [side(p), side(q)];
      // A corner on the line belongs to one of its edges alone.
      if (sp >= 0 === sq >= 0) continue;
      const s = sp / (sp - sq);
      const [x, y] = [positions[p]! + s * (positions[q]! - positions[p]!), positions[p + 1]! + s * (positions[q + 1]! - positions[p + 1]!)];
      out.push(((x - a.x) * dx + (y - a.y) * dy) / (dx * dx + dy * dy));
    }
  }
  return out.sort((p, q) => p - q);
}

/** The line and its ends. */
export class Ruler {
  readonly object = new THREE.Group();
  private readonly line: THREE.Line;
  private readonly ends: THREE.Points;

  constructor() {
    const looks = { color: RULER, depthTest: false, transparent: true };
    this.line = new THREE.Line(new THREE.BufferGeometry(), new THREE.LineBasicMaterial(looks));
    this.ends = new THREE.Points(new THREE.BufferGeometry(), new THREE.PointsMaterial({ ...looks, size: 9, sizeAttenuation: false }));
    for (const one of [this.line, this.ends]) {
      one.frustumCulled = false;
      one.renderOrder = 6;
      this.object.add(one);
    }
    this.object.visible = false;
  }

  draw(ends: THREE.Vector3[], flat: boolean): void {
    this.object.visible = ends.length > 0;
    const points = ends.flatMap((p) => [p.x, p.y, flat ? 0.6 : p.z]);
    for (const one of [this.line, this.ends]) {
      one.geometry.dispose();
      one.geometry.setAttribute("position", new THREE.Float32BufferAttribute(points, 3));
    }
  }
}

export const RULER = "#e0007a";
