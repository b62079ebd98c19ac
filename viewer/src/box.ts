// The box that a picture of blocks has to show.

import * as THREE from "three";

interface Extent {
  count: number;
  offsets: Uint32Array;
  positions: Float32Array;
  size: number;
}

/** Blocks that are sorted by their places at least, if there are as many. */
const SAMPLE = 20_000;

/** Box around blocks as drawn, by the middle 99.5 % of them: a stray stone must not make the rest a dot. */
export function boxOf(blocks: Extent): THREE.Box3 {
  const box = new THREE.Box3();
  if (blocks.count === 0) return box;
  // Of many blocks some tell where most are.
  const every = Math.max(1, Math.floor(blocks.count / SAMPLE));
  const limits = [0, 1, 2].map((k) => {
    const all = new Float32Array(Math.ceil(blocks.count / every));
    for (let i = 0; i < all.length; i++) {
      const at = blocks.positions[3 * blocks.offsets[i * every]! + k]!;
      // What is no number is at no end.
      all[i] = Number.isFinite(at) ? at : (all[i - 1] ?? 0);
    }
    all.sort();
    const at = (share: number) => all[Math.round(share * (all.length - 1))] ?? 0;
    const spare = Math.max(0.15 * (at(0.9975) - at(0.0025)), blocks.size);
    return [at(0.0025) - spare, at(0.9975) + spare];
  });
  const { positions, offsets } = blocks;
  const [[xl, xh], [yl, yh], [zl, zh]] = limits as [[number, number], [number, number], [number, number]];
  const isInside = (p: number) => {
    const [x, y, z] = [positions[3 * p]!, positions[3 * p + 1]!, positions[3 * p + 2]!];
    return x >= xl && x <= xh && y >= yl && y <= yh && z >= zl && z <= zh;
  };
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let b = 0; b < blocks.count; b++) {
    const [from, to] = [offsets[b]!, offsets[b + 1]!];
    let p = from;
    // A stray has no corner there; a slab under everything else has its first one outside.
    while (p < to && !isInside(p)) p++;
    if (p === to) continue;
    for (let i = 3 * from; i < 3 * to; i++) {
      const v = positions[i]!;
      const k = (i - 3 * from) % 3;
      if (v < low[k]!) low[k] = v;
      if (v > high[k]!) high[k] = v;
    }
  }
  if (high[0]! >= low[0]!) box.set(new THREE.Vector3(...(low as [number, number, number])), new THREE.Vector3(...(high as [number, number, number])));
  return box;
}
