// Blocks for tests that need no page.

import type { Solids } from "../src/section";

/** A prism over an outline (anticlockwise in x, y) from z = 0 to 1. */
export function prism(outline: [number, number][]): Solids {
  const n = outline.length;
  const points = [0, 1].flatMap((z) => outline.flatMap(([x, y]) => [x, y, z]));
  const below = outline.map((_, k) => n - 1 - k);
  const above = outline.map((_, k) => n + k);
  const around = outline.map((_, k) => [k, (k + 1) % n, n + ((k + 1) % n), n + k]);
  const faces = [below, above, ...around];
  const ends = faces.reduce((all, f) => [...all, all.at(-1)! + f.length], [0]);
  return {
    dimension: 3,
    count: 1,
    offsets: Uint32Array.of(0, 2 * n),
    facesOf: Uint32Array.of(0, faces.length),
    faceEnds: Uint32Array.from(ends),
    corners: Uint32Array.from(faces.flat()),
    positions: Float32Array.from(points),
  };
}

export const SQUARE: [number, number][] = [[0, 0], [1, 0], [1, 1], [0, 1]];
/** Two towers on a base. */
export const U: [number, number][] = [[0, 0], [3, 0], [3, 2], [2, 2], [2, 1], [1, 1], [1, 2], [0, 2]];
