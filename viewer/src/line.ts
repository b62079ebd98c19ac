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

/** The line is moved aside by these shares of its length, so that it runs along no face, edge or corner of what was built on round numbers. */
const ASIDE = new THREE.Vector3(1.7e-9, 2.9e-9, 2.3e-9);

/** The stretches of the line from `a` to `b` that lie in blocks as drawn, in their order. */
export function piecesAlong(solids: Solids, a: THREE.Vector3, b: THREE.Vector3): Piece[] {
  const out: Piece[] = [];
  const inSpace = solids.dimension === 3 ? throughSolids(solids, a, b) : null;
  for (let block = 0; block < solids.count; block++) {
    const ends = inSpace ? inSpace(block) : crossings(solids, block, a, b);
    for (let k = 0; k + 1 < ends.length; k += 2) {
      const [from, to] = [Math.max(0, ends[k]!), Math.min(1, ends[k + 1]!)];
      if (to - from > NONE) out.push({ from, to, block });
    }
  }
  return out.sort((p, q) => p.from - q.from || p.to - q.to);
}

/**
 * Where the straight line through `a` and `b` goes into and out of a block of any form, ascending: where it meets its faces, triangle by
 * triangle from their first corners. Triangles of hollow faces that lie on each other are met twice at one place.
 */
function throughSolids({ positions, corners, facesOf, faceEnds }: Solids, a: THREE.Vector3, b: THREE.Vector3): (block: number) => number[] {
  const way = new THREE.Vector3().subVectors(b, a);
  const length = way.length();
  const start = new THREE.Vector3().copy(a).addScaledVector(ASIDE, length);
  way.divideScalar(length);
  const across = new THREE.Vector3(1, 0, 0);
  if (Math.abs(way.x) > 0.6) across.set(0, 1, 0);
  const u = new THREE.Vector3().crossVectors(way, across).normalize();
  const v = new THREE.Vector3().crossVectors(way, u);
  // Corners of a face beside the line, by two distances across it, and how far along it they lie.
  const [x, y, z]: [number[], number[], number[]] = [[], [], []];
  return (block) => {
    const out: number[] = [];
    for (let f = facesOf[block]!; f < facesOf[block + 1]!; f++) {
      const [first, count] = [faceEnds[f]!, faceEnds[f + 1]! - faceEnds[f]!];
      let [left, right, below, above] = [false, false, false, false];
      for (let k = 0; k < count; k++) {
        const at = 3 * corners[first + k]!;
        const [px, py, pz] = [positions[at]! - start.x, positions[at + 1]! - start.y, positions[at + 2]! - start.z];
        x[k] = px * u.x + py * u.y + pz * u.z;
        y[k] = px * v.x + py * v.y + pz * v.z;
        z[k] = px * way.x + py * way.y + pz * way.z;
        if (x[k]! >= 0) right = true;
        if (x[k]! <= 0) left = true;
        if (y[k]! >= 0) above = true;
        if (y[k]! <= 0) below = true;
      }
      if (!left || !right || !below || !above) continue;
      // Twice the area of line and edge, the same for both triangles that share the edge but for the sign.
      const edge = (i: number, j: number) => x[i]! * y[j]! - y[i]! * x[j]!;
      for (let k = 1; k + 1 < count; k++) {
        const [p, q, r] = [edge(k, k + 1), edge(k + 1, 0), edge(0, k)];
        const whole = p + q + r;
        if (whole === 0 || !((p >= 0 && q >= 0 && r >= 0) || (p <= 0 && q <= 0 && r <= 0))) continue;
        out.push((p * z[0]! + q * z[k]! + r * z[k + 1]!) / (whole * length));
      }
    }
    return out.sort((p, q) => p - q);
  };
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
