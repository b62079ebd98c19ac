// Faces that two blocks share at rest.

import type { Blocks } from "./blocks";

/** Places in the list of twins by the places of both blocks; made once for each shape, when first asked for. */
const known = new WeakMap<Blocks, Map<number, number>>();

function twinsOf(blocks: Blocks): Map<number, number> {
  let between = known.get(blocks);
  if (!between) {
    between = new Map();
    const { twins, blockOf, count } = blocks;
    for (let k = 0; k < twins.length; k += 2) {
      const i = blockOf[twins[k]!]!;
      const j = blockOf[twins[k + 1]!]!;
      // One number for a pair in either order; exact, since no page holds 2^26 blocks.
      between.set(Math.min(i, j) * count + Math.max(i, j), k);
    }
    known.set(blocks, between);
  }
  return between;
}

/** Triangles of the faces between pairs of blocks, in current position, and of which pair each is. */
export function surfaces(blocks: Blocks, pairs: [number, number][]): { points: number[]; pair: number[] } {
  const between = twinsOf(blocks);
  const { twins, faceEnds, corners, positions, count } = blocks;
  const points: number[] = [];
  const pair: number[] = [];
  pairs.forEach(([a, b], n) => {
    const twin = between.get(Math.min(a, b) * count + Math.max(a, b));
    if (twin === undefined) return;
    const f = twins[twin]!;
    const from = faceEnds[f]!;
    const to = faceEnds[f + 1]!;
    for (let k = from + 1; k + 1 < to; k++) {
      for (const c of [corners[from]!, corners[k]!, corners[k + 1]!]) {
        points.push(positions[3 * c]!, positions[3 * c + 1]!, positions[3 * c + 2]!);
      }
      pair.push(n);
    }
  });
  return { points, pair };
}
