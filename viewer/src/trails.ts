// The ways that blocks have taken from frame to frame, as lines up to the frame that is shown.

import * as THREE from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import { MAPS, kindColour } from "./colour";
import type { Loading } from "./loading";
import type { Run } from "./run";
import { Problem } from "./source";

/** A block that has gone farther than this share of a usual block has moved. */
const MOVED = 0.25;
/** Trails at most: of more blocks, those that went farthest. */
const MOST = 1500;
/** Places that a page can look through. */
const PLACES = 30e6;
const WIDTH = 2.5;
/** The processor alone draws no more wide pieces while the camera turns: of more, lines are a pixel wide. */
const WIDE_MOST = 20_000;

/** The way of a block. */
interface Way {
  id: number;
  /** Frames in which it is there. */
  frames: number[];
  /** Its middle at rest, and how far it was shifted in each of these frames, three numbers each. */
  middles: number[];
  shifts: number[];
}

export interface TrailsShown {
  count: number;
  /** The largest mean speed between two frames, m/s. */
  fastest: number;
  left: number;
}

export class Trails {
  readonly object = new THREE.Group();
  private readonly material = new LineMaterial({ linewidth: WIDTH, vertexColors: true });
  private readonly thin = new THREE.LineBasicMaterial({ vertexColors: true });
  private lines: LineSegments2 | THREE.LineSegments | null = null;
  /** Segments that end in frame k or before it. */
  private upTo: number[] = [];
  private ways: Way[] = [];
  private left = 0;
  private read = "";
  private drawn = "";
  private shown: TrailsShown | null = null;

  constructor(
    private readonly run: Run,
    private readonly loading: Loading,
    /** Whether the processor draws. */
    private readonly software: boolean,
  ) {}

  private key(which: "moving" | "picked", picked: number | null): string {
    return `${which} ${which === "picked" ? picked : ""} ${this.run.frames} ${this.run.summary.manifest.started}`;
  }

  /** Whether the ways that are asked for have been read. */
  has(which: "moving" | "picked", picked: number | null): boolean {
    return this.read === this.key(which, picked);
  }

  /** Reads all frames. */
  async load(which: "moving" | "picked", picked: number | null): Promise<void> {
    const { run, loading } = this;
    const key = this.key(which, picked);
    const ways = new Map<number, Way>();
    const far = new Map<number, number>();
    let least = 0;
    const waiting = loading.begin("Reading trails", "frames", run.frames);
    try {
      for (let k = 0; k < run.frames; k++) {
        waiting.got = k;
        const motion = await run.motion(k);
        const shape = await run.shape(motion.info.shape, k);
        const [ids, offsets, points] = [shape.u32("ids"), shape.u32("offsets"), shape.f32("points")];
        if (which === "moving" && ids.length * run.frames > PLACES) {
          throw new Problem(`${ids.length.toLocaleString("en")} blocks in ${run.frames} frames are too many for trails.`, "Pick a block and choose its trail alone.");
        }
        const n = shape.info.dimension;
        const shifts = motion.f32("shifts");
        least = MOVED * shape.info.size;
        ids.forEach((id, b) => {
          if (which === "picked" && id !== picked) return;
          const shift = [shifts[n * b]!, shifts[n * b + 1]!, n === 3 ? shifts[3 * b + 2]! : 0] as const;
          const long = Math.hypot(...shift);
          let way = ways.get(id);
          if (!way) {
            way = { id, frames: [], middles: [], shifts: [] };
            ways.set(id, way);
            far.set(id, -long);
          }
          if (!Number.isFinite(long)) return;
          way.frames.push(k);
          way.shifts.push(...shift);
          way.middles.push(...middleOf(points, offsets[b]!, offsets[b + 1]!));
          far.set(id, Math.max(far.get(id)!, long));
        });
      }
    } finally {
      loading.end(waiting);
    }
    const all = [...ways.values()].filter((way) => which === "picked" || far.get(way.id)! > least);
    all.sort((a, b) => far.get(b.id)! - far.get(a.id)! || a.id - b.id);
    this.ways = all.slice(0, MOST);
    this.left = all.length - this.ways.length;
    this.read = key;
    this.drawn = "";
  }

  /** Draws what was read, up to frame `k`; `colour`: by the number of the block or its speed. */
  draw(k: number, exaggeration: number, colour: "speed" | "block"): TrailsShown {
    const state = `${this.read} ${exaggeration} ${colour}`;
    if (state !== this.drawn) this.build(exaggeration, colour);
    this.drawn = state;
    const count = this.upTo[Math.min(k, this.upTo.length - 1)] ?? 0;
    if (this.lines instanceof LineSegments2) this.lines.geometry.instanceCount = count;
    else this.lines?.geometry.setDrawRange(0, 2 * count);
    this.object.visible = true;
    return this.shown!;
  }

  hide(): void {
    this.object.visible = false;
  }

  private build(exaggeration: number, colour: "speed" | "block"): void {
    if (this.lines) {
      this.object.remove(this.lines);
      this.lines.geometry.dispose();
      this.lines = null;
    }
    const times = this.run.summary.times;
    const pieces: { frame: number; ends: number[]; speed: number; id: number }[] = [];
    for (const { id, frames, middles, shifts } of this.ways) {
      for (let i = 1; i < frames.length; i++) {
        const at = (j: number) => [0, 1, 2].map((x) => middles[3 * j + x]! + exaggeration * shifts[3 * j + x]!);
        const [a, b] = [at(i - 1), at(i)];
        const long = Math.hypot(...[0, 1, 2].map((x) => middles[3 * i + x]! - middles[3 * i - 3 + x]! + shifts[3 * i + x]! - shifts[3 * i - 3 + x]!));
        const took = times[frames[i]!]! - times[frames[i - 1]!]!;
        pieces.push({ frame: frames[i]!, ends: [...a, ...b], speed: took > 0 ? long / took : 0, id });
      }
    }
    pieces.sort((a, b) => a.frame - b.frame);
    const fastest = pieces.reduce((most, piece) => Math.max(most, piece.speed), 0);
    this.shown = { count: this.ways.length, fastest, left: this.left };
    this.upTo = [];
    for (const { frame } of pieces) this.upTo[frame] = (this.upTo[frame] ?? 0) + 1;
    for (let k = 0, sum = 0; k < this.run.frames; k++) this.upTo[k] = sum += this.upTo[k] ?? 0;
    if (pieces.length === 0) return;
    const places = new Float32Array(6 * pieces.length);
    pieces.forEach((piece, i) => places.set(piece.ends, 6 * i));
    const map = MAPS.turbo!;
    const css = (piece: (typeof pieces)[number]) => (colour === "block" ? kindColour(piece.id) : map(0.05 + (0.9 * piece.speed) / (fastest || 1)));
    const one = new THREE.Color();
    const colours = new Float32Array(6 * pieces.length);
    pieces.forEach((piece, i) => {
      one.set(css(piece));
      colours.set([one.r, one.g, one.b, one.r, one.g, one.b], 6 * i);
    });
    if (this.software && pieces.length > WIDE_MOST) {
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute("position", new THREE.BufferAttribute(places, 3));
      geometry.setAttribute("color", new THREE.BufferAttribute(colours, 3));
      this.lines = new THREE.LineSegments(geometry, this.thin);
    } else {
      const geometry = new LineSegmentsGeometry();
      geometry.setPositions(places);
      geometry.setColors(colours);
      this.lines = new LineSegments2(geometry, this.material);
    }
    this.lines.frustumCulled = false;
    this.lines.renderOrder = 3;
    // In the plane over the blocks.
    if (pieces.every((piece) => piece.ends[2] === 0 && piece.ends[5] === 0)) this.lines.position.z = 0.4;
    this.object.add(this.lines);
  }
}

function middleOf(points: Float32Array, from: number, to: number): [number, number, number] {
  let [x, y, z] = [0, 0, 0];
  for (let p = 3 * from; p < 3 * to; p += 3) {
    x += points[p]!;
    y += points[p + 1]!;
    z += points[p + 2]!;
  }
  const n = Math.max(1, to - from);
  return [x / n, y / n, z / n];
}
