// One run: what it has, and its frames as they are asked for, with a memory of those seen.

import type { Conditions } from "./conditions";
import { quantity } from "./format";
import type { Charge } from "./marks";
import { heldBlock, heldHistory, nameOf, type Names } from "./held";
import { Problem, type Source } from "./source";
import type { Packet } from "./wire";

/** Bytes of answers kept. */
const MEMORY = 400e6;

export interface Field {
  name: string;
  unit: string;
  components: number;
}

export interface Manifest {
  riprap: string;
  title: string;
  scenario: string;
  variant: string;
  case: string;
  started: string;
  wall_time: number;
  dt: number;
  steps: number;
  time: number;
  threads: number;
  state_hash: string;
  input_hash: string;
  ended: "running" | "finished" | "stopped" | "interrupted" | "unstable";
  message: string;
  warnings: string[];
  fields: { name: string; unit: string; meaning: string }[];
  sources: Charge[];
  /** Not in runs of earlier versions. */
  gravity?: [number, number, number];
  materials?: string[];
  /** A model before it is run. */
  preview?: boolean;
}

export interface Summary {
  name: string;
  problem?: { what: string; hint: string };
  manifest: Manifest;
  live: boolean;
  died: boolean;
  times: number[];
  /** Of each frame: step count and phase. */
  steps: number[];
  phases: string[];
  fields: Field[];
  /** In a report: the fields that it holds. */
  names?: string[];
  /** The answers are in the page itself: vectors that it has, and whether it has contacts. */
  held?: { vectors: string[]; contacts: boolean; stress: boolean };
  note: { what: string; hint: string } | null;
  tables: [boolean, boolean];
  /** Whether frames have cracks of deformable blocks. */
  cracks: boolean;
  /** Whether frames have bolts. */
  bolts?: boolean;
  /** Whether the folder has saved views. */
  views?: boolean;
}

export interface ShapeInfo {
  key: string;
  dimension: 2 | 3;
  size: number;
  origin: [number, number, number];
  low: [number, number, number];
  high: [number, number, number];
}

export interface BoltInfo {
  /** Largest axial force, tension positive; null: no bars. */
  largest: number | null;
  /** Smallest, negative where bars are pressed. */
  smallest: number | null;
  unit: string;
}

export interface StressInfo {
  unit: string;
  /** Smallest and largest principal stress, tension positive; null: no blocks. */
  range: [number, number] | null;
  /** The size that is drawn longest: larger ones are too. Null: no stress. */
  longest: number | null;
  /** Edge of a usual tetrahedron, m; null: none have stresses of their own. */
  tetSize: number | null;
}

export interface MotionInfo {
  shape: string;
  time: number;
  step: number;
  phase: string;
  turnScale: number;
  shutDecade: number;
  steps: number;
}

export interface FieldInfo {
  unit: string;
  range: [number, number] | null;
  /** Of most blocks. */
  most: [number, number] | null;
}

/** Values over all frames: smallest and largest, and those of most blocks. */
export interface Range {
  range: [number, number] | null;
  most: [number, number] | null;
}

export interface ContactInfo {
  fields: Field[];
  forceUnit: string | null;
  longest: number | null;
  flowUnit: string | null;
  /** The largest flow. */
  fastest: number | null;
  /** Area (in the plane: length) in each state. */
  areas: number[];
  areaUnit: string;
}

export interface Table {
  names: string[];
  units: string[];
  /** Without the columns step and time. */
  columns: Float64Array[];
  /** Time in s, or steps. */
  x: Float64Array;
  /** Time stands still throughout, as in runs of static phases. */
  bySteps: boolean;
}

export interface BlockNumbers {
  block: number;
  /** Its name in the scene; empty in runs of earlier versions. */
  name: string;
  groups: string[];
  frame: number;
  columns: { name: string; unit: string; values: (number | string)[] }[];
}

/** When a frame is: in static phases model time stands still, and frames with one time are counted. */
export interface Moment {
  time: number;
  nth: number;
  step: number;
  phase: string;
  /** Whether another frame has the same time. */
  still: boolean;
}

/** A moment in words: phase and step where time does not tell. */
export function saidOf(moment: Moment): string {
  const time = quantity(moment.time, "s");
  if (!moment.still) return time;
  const parts = [moment.phase, `step ${moment.step}`].filter(Boolean);
  return (moment.time === 0 ? parts : [time, ...parts]).join(", ");
}

export class Run {
  private readonly memory = new Map<string, { answer: Promise<Packet<unknown>>; bytes: number }>();
  private held = 0;
  /** Values over all frames, by field. */
  private readonly ranges = new Map<string, Promise<Range>>();
  /** What holds, moves and loads the model; null in runs of earlier versions. */
  conditions: Conditions | null = null;
  /** Names of its blocks and groups; those of later parts of blocks come when they are there. */
  names: Names = { blocks: [], groups: [] };

  constructor(
    readonly source: Source,
    public summary: Summary,
  ) {}

  static async open(source: Source): Promise<Run> {
    return new Run(source, await source.json<Summary>("summary"));
  }

  get frames(): number {
    return this.summary.times?.length ?? 0;
  }

  /**
   * Reads the summary again; whether another run has taken the folder. One that tells of a problem does not replace one that does not: a
   * file may be read while it is written.
   */
  async refresh(): Promise<boolean> {
    const next = await this.source.json<Summary>("summary");
    if (next.problem && !this.summary.problem) throw new Problem(next.problem.what, next.problem.hint);
    // A scene that is saved twice in a second starts twice at one time.
    const before = this.summary.manifest;
    const other = !next.problem && (next.manifest.started !== before?.started || next.manifest.input_hash !== before.input_hash);
    if (other) {
      this.memory.clear();
      this.held = 0;
    }
    // A new frame may have larger values.
    if (next.times?.length !== this.summary.times?.length) this.ranges.clear();
    this.summary = next;
    return other;
  }

  /** Reads names and conditions; none where there are none or their file is damaged: all else can be shown without them. */
  async readModel(): Promise<void> {
    [this.conditions, this.names] = await Promise.all([
      this.source.json<Conditions | null>("conditions").catch(() => null),
      this.source.json<Names>("names").catch(() => this.names),
    ]);
  }

  /** Whether frames tell the stress of blocks; runs of earlier versions and some reports do not. */
  get hasStress(): boolean {
    const { held, fields } = this.summary;
    return held ? held.stress : (fields ?? []).some((f) => f.name === "stress_shear");
  }

  /** What a block is called: its name, or its number. */
  called(id: number): string {
    return nameOf(this.names, id) || `block ${id}`;
  }

  motion(k: number): Promise<Packet<MotionInfo>> {
    return this.packet<MotionInfo>(`frame/${k}`);
  }

  /** The shape with this key, which frame `k` has. */
  shape(key: string, k: number): Promise<Packet<ShapeInfo>> {
    return this.packet<ShapeInfo>(`shape/${k}`, `shape ${key}`);
  }

  field(k: number, name: string): Promise<Packet<FieldInfo>> {
    return this.packet<FieldInfo>(`field/${k}?name=${encodeURIComponent(name)}`);
  }

  vectors(k: number, name: string): Promise<Packet<{ unit: string; longest: number | null }>> {
    return this.packet(`vectors/${k}?name=${encodeURIComponent(name)}`);
  }

  contacts(k: number): Promise<Packet<ContactInfo>> {
    return this.packet<ContactInfo>(`contacts/${k}`);
  }

  /** Outlines of the broken parts of deformable blocks. */
  cracks(k: number): Promise<Packet<unknown>> {
    return this.packet<unknown>(`cracks/${k}`);
  }

  /** Bars of bolts with their axial forces. */
  bolts(k: number): Promise<Packet<BoltInfo>> {
    return this.packet<BoltInfo>(`bolts/${k}`);
  }

  /** Principal stresses of the blocks. */
  stress(k: number): Promise<Packet<StressInfo>> {
    return this.packet<StressInfo>(`stress/${k}`);
  }

  block(k: number, id: number): Promise<BlockNumbers> {
    if (this.summary.held) return heldBlock(this, k, id);
    return this.source.json<BlockNumbers>(`block/${k}/${id}`);
  }

  /** A field of one block over the frames; `more` is called as frames come in and may say to stop. */
  async history(id: number, name: string, more: (values: (number | null)[], unit: string) => boolean) {
    const values: (number | null)[] = [];
    if (this.summary.held) return heldHistory(this, id, name, more);
    const at = 24;
    for (let from = 0; from < this.frames; from += at) {
      const part = await this.source.json<{ unit: string; values: (number | string | null)[] }>(
        `history/${id}?name=${encodeURIComponent(name)}&from=${from}&count=${at}`,
      );
      values.push(...part.values.map((v) => (typeof v === "number" ? v : null)));
      if (!more(values, part.unit)) return;
    }
  }

  hasField(name: string): boolean {
    const stem = name.replace(/\.(x|y|z|magnitude)$/, "");
    return (this.summary.fields ?? []).some((f) => f.name === stem);
  }

  /** Range of a field over the whole run. */
  range(name: string): Promise<Range> {
    const known = this.ranges.get(name);
    if (known !== undefined) return known;
    const found = this.readRange(name);
    this.ranges.set(name, found);
    found.catch(() => this.ranges.delete(name));
    return found;
  }

  private async readRange(name: string): Promise<Range> {
    const all: Range = { range: null, most: null };
    const at = 24;
    const held = this.summary.held !== undefined;
    for (let from = 0; from < (held ? 1 : this.frames); from += at) {
      const part = held ? "" : `&from=${from}&count=${at}`;
      const found = await this.source.json<Range>(`range?name=${held ? name : encodeURIComponent(name)}${part}`);
      all.range = wider(all.range, found.range);
      all.most = wider(all.most, found.most ?? found.range);
    }
    return all;
  }

  async table(name: "histories" | "energy"): Promise<Table> {
    const packet = await this.source.packet<{ columns: { name: string; unit: string }[] }>(`table/${name}`);
    const heads = packet.info.columns;
    const keep = heads.map((_, i) => i).filter((i) => !["time", "step"].includes(heads[i]!.name));
    const column = (name: string) => {
      const at = heads.findIndex((h) => h.name === name);
      return at < 0 ? new Float64Array() : packet.f64(String(at));
    };
    const times = column("time");
    const bySteps = times.length > 1 && times.every((t) => t === times[0]);
    return {
      names: keep.map((i) => heads[i]!.name),
      units: keep.map((i) => heads[i]!.unit),
      columns: keep.map((i) => packet.f64(String(i))),
      x: bySteps ? column("step") : times,
      bySteps,
    };
  }

  /** The moments of the frames. */
  moments(): Moment[] {
    let nth = 0;
    const { steps, phases } = this.summary;
    return (this.summary.times ?? []).map((time, i, all) => {
      nth = i > 0 && all[i - 1] === time ? nth + 1 : 0;
      const still = nth > 0 || all[i + 1] === time;
      return { time, nth, step: steps[i] ?? 0, phase: phases[i] ?? "", still };
    });
  }

  /** When frame `k` is, in words. */
  saidAt(k: number): string {
    const moment = this.moments()[k];
    return moment ? saidOf(moment) : "";
  }

  /** The last frame not later than a moment. */
  frameAt(moment: Pick<Moment, "time" | "nth">): number {
    const all = this.moments();
    // Times of runs that are shown side by side are sums of different steps.
    const slack = 1e-9 * Math.abs(moment.time);
    let low = 0;
    let high = all.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      const { time, nth } = all[middle]!;
      const same = Math.abs(time - moment.time) <= slack;
      if (same ? nth <= moment.nth : time < moment.time) low = middle + 1;
      else high = middle;
    }
    return Math.max(0, low - 1);
  }

  private packet<T>(question: string, key = question): Promise<Packet<T>> {
    const known = this.memory.get(key);
    if (known) {
      this.memory.delete(key);
      // Behind all others: those asked for longest ago are let go first.
      this.memory.set(key, known);
      return known.answer as Promise<Packet<T>>;
    }
    const answer = this.source.packet<T>(question);
    const entry = { answer: answer as Promise<Packet<unknown>>, bytes: 0 };
    this.memory.set(key, entry);
    answer.then(
      (packet) => {
        entry.bytes = packet.bytes;
        this.held += packet.bytes;
        for (const [name, old] of this.memory) {
          if (this.held < MEMORY) break;
          // What is still on its way has no size, and somebody waits for it.
          if (old !== entry && old.bytes > 0) {
            this.memory.delete(name);
            this.held -= old.bytes;
          }
        }
      },
      // A failure is not kept: the file may be whole the next time.
      () => this.memory.delete(key),
    );
    return answer;
  }
}

/** The range over two ranges. */
export function wider(a: [number, number] | null, b: [number, number] | null): [number, number] | null {
  return a && b ? [Math.min(a[0], b[0]), Math.max(a[1], b[1])] : (a ?? b);
}

/** What to tell about an error. */
export function told(error: unknown): { what: string; hint: string } {
  if (error instanceof Problem) return { what: error.what, hint: error.hint };
  return { what: error instanceof Error ? error.message : String(error), hint: "Reload the page." };
}
