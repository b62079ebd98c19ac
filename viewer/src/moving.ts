// Rigid motion of blocks: from places at rest to places as drawn.

export interface Corners {
  count: number;
  offsets: Uint32Array;
  rest: Float32Array;
  positions: Float32Array;
  middles: Float32Array;
}

/** Puts the corners of blocks in the plane where their shifts (m) and turns (rad) have them, `s` times as far. */
export function moveInPlane(blocks: Corners, shifts: Float32Array, turns: Float32Array, s: number): void {
  const { rest, positions, offsets, middles } = blocks;
  for (let b = 0; b < blocks.count; b++) {
    // What a turn adds to an arm: that alone is multiplied by `s`.
    const c = Math.cos(turns[b]!) - 1;
    const n = Math.sin(turns[b]!);
    const dx = shifts[2 * b]!;
    const dy = shifts[2 * b + 1]!;
    const mx = middles[3 * b]!;
    const my = middles[3 * b + 1]!;
    for (let p = 3 * offsets[b]!; p < 3 * offsets[b + 1]!; p += 3) {
      const x = rest[p]! - mx;
      const y = rest[p + 1]! - my;
      positions[p] = rest[p]! + s * (dx + c * x - n * y);
      positions[p + 1] = rest[p + 1]! + s * (dy + n * x + c * y);
    }
  }
}

/** The same in space; turns are vector parts of unit quaternions over `scale`. */
export function moveInSpace(blocks: Corners, shifts: Float32Array, turns: Int16Array, scale: number, s: number): void {
  const { rest, positions, offsets, middles } = blocks;
  for (let b = 0; b < blocks.count; b++) {
    const i = 3 * b;
    const dx = shifts[i]!;
    const dy = shifts[i + 1]!;
    const dz = shifts[i + 2]!;
    const qx = turns[i]! * scale;
    const qy = turns[i + 1]! * scale;
    const qz = turns[i + 2]! * scale;
    const still = qx === 0 && qy === 0 && qz === 0;
    const qw = Math.sqrt(Math.max(0, 1 - qx * qx - qy * qy - qz * qz));
    const mx = middles[i]!;
    const my = middles[i + 1]!;
    const mz = middles[i + 2]!;
    for (let p = 3 * offsets[b]!; p < 3 * offsets[b + 1]!; p += 3) {
      let ux = dx;
      let uy = dy;
      let uz = dz;
      if (!still) {
        const x = rest[p]! - mx;
        const y = rest[p + 1]! - my;
        const z = rest[p + 2]! - mz;
        // What a unit quaternion adds to a vector: 2 w (q x v) + 2 q x (q x v).
        const tx = 2 * (qy * z - qz * y);
        const ty = 2 * (qz * x - qx * z);
        const tz = 2 * (qx * y - qy * x);
        ux += qw * tx + qy * tz - qz * ty;
        uy += qw * ty + qz * tx - qx * tz;
        uz += qw * tz + qx * ty - qy * tx;
      }
      positions[p] = rest[p]! + s * ux;
      positions[p + 1] = rest[p + 1]! + s * uy;
      positions[p + 2] = rest[p + 2]! + s * uz;
    }
  }
}
