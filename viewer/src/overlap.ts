// What two faces in one plane have in common.

import * as THREE from "three";
import type { Blocks } from "./blocks";

type Point = [number, number];

/** Twice the area of a polygon. */
function twice(polygon: Point[]): number {
  return polygon.reduce((sum, [x, y], k) => {
    const [u, v] = polygon[(k + 1) % polygon.length]!;
    return sum + x * v - u * y;
  }, 0);
}

/** What of a polygon lies in a convex one that goes round anticlockwise (Sutherland and Hodgman). */
export function clipped(polygon: Point[], by: Point[]): Point[] {
  let left = polygon;
  by.forEach(([ax, ay], k) => {
    const [bx, by_] = by[(k + 1) % by.length]!;
    const inside = ([x, y]: Point) => (bx - ax) * (y - ay) - (by_ - ay) * (x - ax);
    const kept: Point[] = [];
    left.forEach((p, i) => {
      const q = left[(i + 1) % left.length]!;
      const [dp, dq] = [inside(p), inside(q)];
      if (dp >= 0) kept.push(p);
      if (dp >= 0 !== dq >= 0) {
        const s = dp / (dp - dq);
        kept.push([p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1])]);
      }
    });
    left = kept;
  });
  return left;
}

/**
 * The part of convex face `f` that lies on face `g`, at rest: its area, and its corners by three of the corners of `f`. Null where
 * there is none.
 */
export function overlap(blocks: Blocks, f: number, g: number, normal: THREE.Vector3): { size: number; piece: { base: number[]; shares: number[] } } | null {
  const { rest, corners, faceEnds } = blocks;
  const of = (face: number) => Array.from(corners.subarray(faceEnds[face]!, faceEnds[face + 1]!));
  const [own, their] = [of(f), of(g)];
  const e = new THREE.Vector3().fromArray(rest, 3 * own[1]!).sub(new THREE.Vector3().fromArray(rest, 3 * own[0]!)).normalize();
  const n = normal.clone().cross(e);
  const at = (c: number): Point => {
    const p = new THREE.Vector3().fromArray(rest, 3 * c).sub(new THREE.Vector3().fromArray(rest, 3 * own[0]!));
    return [e.dot(p), n.dot(p)];
  };
  const [one, other] = [own.map(at), their.map(at)];
  // Seen from the side of `f`, corners of `g` go round the other way.
  const common = clipped(one, twice(other) < 0 ? other.reverse() : other);
  const size = 0.5 * twice(common);
  if (common.length < 3 || !(size > 0)) return null;
  // The corner that spans the largest triangle with the first two: shares of its sides are then well told.
  const wide = (k: number) => Math.abs(one[1]![0] * one[k]![1] - one[1]![1] * one[k]![0]);
  let third = 2;
  for (let k = 3; k < one.length; k++) if (wide(k) > wide(third)) third = k;
  const [[ax, ay], [bx, by]] = [one[1]!, one[third]!];
  const det = ax * by - ay * bx;
  const shares = common.flatMap(([x, y]) => [(x * by - y * bx) / det, (ax * y - ay * x) / det]);
  return { size, piece: { base: [own[0]!, own[1]!, own[third]!], shares } };
}
