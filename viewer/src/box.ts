// The box that a picture of blocks has to show.

import * as THREE from "three";

interface Extent {
  count: number;
  offsets: Uint32Array;
  positions: Float32Array;
  size: number;
}

/** Box around blocks as drawn, by the middle 99.5 % of them: a stray stone must not make the rest a dot. */
export function boxOf(blocks: Extent): THREE.Box3 {
  const box = new THREE.Box3();
  if (blocks.count === 0) return box;
  const limits = [0, 1, 2].map((k) => {
    const all = Float32Array.from({ length: blocks.count }, (_, b) => blocks.positions[3 * blocks.offsets[b]! + k]!)
      .filter(Number.isFinite)
      .sort();
    const at = (share: number) => all[Math.round(share * (all.length - 1))] ?? 0;
    const spare = Math.max(0.15 * (at(0.9975) - at(0.0025)), blocks.size);
    return [at(0.0025) - spare, at(0.9975) + spare];
  });
  const point = new THREE.Vector3();
  for (let b = 0; b < blocks.count; b++) {
    const first = 3 * blocks.offsets[b]!;
    const inside = [0, 1, 2].every((k) => {
      const v = blocks.positions[first + k]!;
      return v >= limits[k]![0]! && v <= limits[k]![1]!;
    });
    if (!inside) continue;
    for (let p = blocks.offsets[b]!; p < blocks.offsets[b + 1]!; p++) box.expandByPoint(point.fromArray(blocks.positions, 3 * p));
  }
  return box;
}
