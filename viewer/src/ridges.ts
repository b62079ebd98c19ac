// Edges that are seen: where two faces of a block meet at an angle. Faces of one plane, as triangles of a surface are, have none between them.

/** Corners and faces of blocks at rest. */
export interface Surfaces {
  rest: Float32Array;
  facesOf: Uint32Array;
  faceEnds: Uint32Array;
  corners: Uint32Array;
}

/** Faces whose normals have a larger cosine than this are one plane: 11 degrees. */
const PLANE = 0.98;
/** The same of ground from a survey, of which only breaks of the slope are drawn: 40 degrees. */
const SLOPE = 0.766;
/** No face of the block lies beyond an edge. */
export const NOTHING = -1;
/** Blocks with more edges than this are kept: their table takes long. */
const LARGE = 64;

/** Which face lies beyond each edge of each face of a block, twice its number, and one more where they meet at an angle. */
export class Ridges {
  private readonly kept = new Map<number, Int32Array>();
  private readonly turned = new Map<number, number>();
  private scratch = new Int32Array(LARGE);

  constructor(
    private readonly of: Surfaces,
    /** Whether a block is ground from a survey. */
    private readonly survey: (block: number) => boolean,
  ) {}

  /** The table of a block, by the place of the edge's first corner behind the first one of the block. */
  at(b: number): Int32Array {
    const { faceEnds, facesOf } = this.of;
    const count = faceEnds[facesOf[b + 1]!]! - faceEnds[facesOf[b]!]!;
    if (count <= LARGE) return this.fill(b, count, this.scratch);
    const known = this.kept.get(b);
    if (known) return known;
    const made = this.fill(b, count, new Int32Array(count));
    this.kept.set(b, made);
    return made;
  }

  private fill(b: number, count: number, out: Int32Array): Int32Array {
    const { facesOf, faceEnds, corners } = this.of;
    const [first, last] = [facesOf[b]!, facesOf[b + 1]!];
    const start = faceEnds[first]!;
    const least = this.survey(b) ? SLOPE : PLANE;
    const normals = new Float32Array(3 * (last - first));
    for (let f = first; f < last; f++) this.normal(f, normals, 3 * (f - first));
    out.fill(NOTHING, 0, count);
    const meet = (k: number, f: number, l: number, g: number) => {
      const [i, j] = [3 * (f - first), 3 * (g - first)];
      const cos = normals[i]! * normals[j]! + normals[i + 1]! * normals[j + 1]! + normals[i + 2]! * normals[j + 2]!;
      const sharp = cos < least ? 1 : 0;
      out[k - start] = 2 * g + sharp;
      out[l - start] = 2 * f + sharp;
    };
    const { turned } = this;
    const large = count > LARGE;
    const lowest = large ? corners.subarray(start, start + count).reduce((a, c) => Math.min(a, c), 0xffffffff) : 0;
    turned.clear();
    for (let f = first; f < last; f++) {
      const [from, to] = [faceEnds[f]!, faceEnds[f + 1]!];
      for (let k = from; k < to; k++) {
        const [p, q] = [corners[k]!, corners[k + 1 < to ? k + 1 : from]!];
        if (large) {
          const other = turned.get((q - lowest) * 0x400000 + (p - lowest));
          if (other !== undefined) meet(k, f, other, this.faceOf(other, first, last));
          else turned.set((p - lowest) * 0x400000 + (q - lowest), k);
          continue;
        }
        // Faces before this one: the neighbour has the same edge the other way round.
        for (let g = first; g < f && out[k - start] === NOTHING; g++) {
          const [low, high] = [faceEnds[g]!, faceEnds[g + 1]!];
          for (let l = low; l < high; l++) {
            if (corners[l] === q && corners[l + 1 < high ? l + 1 : low] === p) {
              meet(k, f, l, g);
              break;
            }
          }
        }
      }
    }
    return out;
  }

  /** The face that has a place among the corners. */
  private faceOf(k: number, first: number, last: number): number {
    const { faceEnds } = this.of;
    let [low, high] = [first, last];
    while (low + 1 < high) {
      const middle = (low + high) >> 1;
      if (faceEnds[middle]! <= k) low = middle;
      else high = middle;
    }
    return low;
  }

  /** Unit normal of a face, by Newell's sum. */
  private normal(f: number, out: Float32Array, at: number): void {
    const { faceEnds, corners, rest } = this.of;
    const [from, to] = [faceEnds[f]!, faceEnds[f + 1]!];
    const o = 3 * corners[from]!;
    let [x, y, z] = [0, 0, 0];
    for (let k = from + 1; k + 1 < to; k++) {
      const [a, b] = [3 * corners[k]!, 3 * corners[k + 1]!];
      const [ax, ay, az] = [rest[a]! - rest[o]!, rest[a + 1]! - rest[o + 1]!, rest[a + 2]! - rest[o + 2]!];
      const [bx, by, bz] = [rest[b]! - rest[o]!, rest[b + 1]! - rest[o + 1]!, rest[b + 2]! - rest[o + 2]!];
      x += ay * bz - az * by;
      y += az * bx - ax * bz;
      z += ax * by - ay * bx;
    }
    const long = Math.hypot(x, y, z) || 1;
    out[at] = x / long;
    out[at + 1] = y / long;
    out[at + 2] = z / long;
  }
}
