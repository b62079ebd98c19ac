// One run on its stage: shows a frame as the settings say.

import * as THREE from "three";
import { Blocks, type Look } from "./blocks";
import { KINDS, Scale } from "./colour";
import { ConditionMarks, type Note } from "./conditions";
import { fetchFrame, type Fetched } from "./fetching";
import { quantity, short } from "./format";
import { JointMarks } from "./joints";
import type { Loading } from "./loading";
import { piecesAlong, Ruler, type Piece } from "./line";
import { Arrows, Bolts, Chains, Charges, Contacts, Picked, contactPlaces } from "./marks";
import { told, type BoltInfo, type MotionInfo, type Run } from "./run";
import { cutAway, cutOf, cutText } from "./cutting";
import type { Cut } from "./section";
import type { Settings } from "./settings";
import { Stage } from "./stage";
import { StressMarks, type StressShown } from "./stress";
import { labelsOf, type Annotation, type Label } from "./notes";
import { Trails, type TrailsShown } from "./trails";
import { blocksOf } from "./warnings";
import type { Packet } from "./wire";

/** Outline and dot of blocks that warnings name, and how many of them have these at most. */
export const WARNED = "#e8a200";
const WARNED_MOST = 2000;
/** It takes a while to prepare more blocks than this. */
const MANY = 50_000;
/** A corner nearer than this to the pointer is meant, pixels. */
const SNAP = 9;

export class View {
  readonly stage: Stage;
  readonly scale = new Scale();
  blocks: Blocks | null = null;
  frame = -1;
  motion: Packet<MotionInfo> | null = null;
  unit = "";
  /** Longest arrow and its unit. */
  arrow: { longest: number; unit: string } | null = null;
  /** Contacts by state: how many, and their area (in the plane: length). */
  between: { counts: number[]; areas: number[]; unit: string } | null = null;
  /** What is wrong with the frame that was asked for. */
  trouble: { what: string; hint: string } | null = null;
  picked: number | null = null;
  values: Float32Array | null = null;
  private readonly arrows: { plane: Arrows; space: Arrows };
  private readonly marks: { plane: Contacts; space: Contacts };
  private readonly pickedMark = new Picked();
  private readonly supportMark = new Picked("#2f7bd9", 3);
  private readonly drivenMark = new Picked("#e07b1a", 3);
  private readonly warnedMark = new Picked(WARNED, 4);
  private readonly warnedDots = new THREE.Points(
    new THREE.BufferGeometry(),
    new THREE.PointsMaterial({ color: WARNED, size: 10, sizeAttenuation: false, depthTest: false, transparent: true }),
  );
  private readonly bolts = new Bolts();
  private readonly chains = new Chains();
  private readonly charges = new Charges();
  private readonly stress = new StressMarks();
  private readonly conditions = new ConditionMarks();
  private readonly joints = new JointMarks();
  private readonly ruler = new Ruler();
  /** Ends of the line that was laid into the picture, as drawn, less the origin: none, one or two. */
  ends: THREE.Vector3[] = [];
  /** What the legend says of boundaries, loads, water and joints. */
  conditionNotes: Note[] = [];
  /** Blocks that warnings of a scene name, where the scene is shown before it is run. */
  warned = 0;
  /** Blocks that supports hold, where they are shown. */
  supports: number | null = null;
  /** Of these, blocks that are driven. */
  driven = 0;
  /** Forces of the bolts that are drawn. */
  boltForces: BoltInfo | null = null;
  /** Contacts that force chains are drawn of, the largest force and its unit. */
  chained: { count: number; longest: number; unit: string } | null = null;
  /** Principal stresses that are drawn as crosses, with the number of blocks beyond the longest. */
  stressShown: StressShown | null = null;
  private last: Fetched | null = null;
  private atRest = new THREE.Box3();
  private ticket = 0;
  private ink = "#000000";
  /** Colours span the values of the frame alone where those of the run are not known: these need all frames to be read. */
  hasty = false;
  /** Trails that are drawn. */
  trailed: TrailsShown | null = null;
  /** Texts at places of the model. */
  notes: Annotation[] = [];
  /** Called when something has come that the legend tells of. */
  onChange: (() => void) | null = null;
  private readonly trails: Trails;
  private now: Settings | null = null;
  /** Runs shown with this one: their colours mean the same. */
  others: Run[] = [];

  constructor(
    readonly run: Run,
    readonly host: HTMLElement,
    private readonly loading: Loading,
  ) {
    this.stage = new Stage(host, 2);
    this.stage.onDraw = (metresPerPixel, quick) => this.blocks?.fade(metresPerPixel, quick);
    this.trails = new Trails(run, loading, this.stage.software);
    this.stage.scene.add(this.trails.object);
    this.arrows = { plane: new Arrows(true), space: new Arrows(false) };
    this.marks = { plane: new Contacts(true), space: new Contacts(false) };
    this.warnedDots.frustumCulled = false;
    this.warnedDots.renderOrder = 4;
    this.stage.scene.add(this.warnedDots);
    for (const one of [...Object.values(this.arrows), ...Object.values(this.marks), this.pickedMark, this.supportMark, this.drivenMark, this.warnedMark, this.bolts, this.chains, this.charges, this.stress, this.conditions, this.joints, this.ruler]) {
      this.stage.scene.add(one.object);
    }
  }

  get flat(): boolean {
    return this.blocks?.dimension !== 3;
  }

  /** Why there are no shadows or edges where there could be; empty if there is nothing to say. */
  get unshaded(): string {
    const { blocks, stage } = this;
    if (!blocks || blocks.dimension === 2) return "";
    if (!blocks.isSolid) return "No shadows between blocks of glass.";
    const many = stage.tooMany(blocks);
    if (!many && !blocks.crowded) return "";
    return `No ${[many ? "shadows" : "", blocks.crowded ? "edges" : ""].filter(Boolean).join(" and ")}: ${blocks.visibleFaces.toLocaleString("en")} faces are too many ${stage.software ? "without graphics hardware" : "for them"}.`;
  }

  setTheme(background: string, ink: string): void {
    this.stage.background = background;
    for (const arrows of Object.values(this.arrows)) arrows.colour = ink;
    this.ink = ink;
    this.blocks?.tint(ink);
    this.stage.redraw();
  }

  /** Shows frame `k`; resolves to false when a later call has overtaken this one. */
  async show(k: number, settings: Settings): Promise<boolean> {
    const ticket = ++this.ticket;
    if (this.run.frames === 0) return true;
    try {
      const fetched = await this.fetch(k, settings);
      if (ticket !== this.ticket) return false;
      const key = fetched.motion.info.shape;
      if (this.blocks?.shape.info.key !== key) {
        const shape = await this.run.shape(key, k);
        if (ticket !== this.ticket) return false;
        const many = shape.u32("ids").length;
        const waiting = many > MANY ? await this.loading.announce(`Preparing ${many.toLocaleString("en")} blocks`) : null;
        if (ticket === this.ticket) this.build(new Blocks(shape, this.scale, this.stage.shading.lit, this.stage.software));
        if (waiting) this.loading.end(waiting);
        if (ticket !== this.ticket) return false;
        // Blocks that were made since.
        const { conditions, blocks } = { conditions: this.run.conditions, blocks: this.blocks! };
        if (conditions && blocks.ids.some((id) => id >= conditions.blocks)) await this.run.readModel();
        if (ticket !== this.ticket) return false;
      }
      const first = this.last === null;
      this.last = fetched;
      this.trouble = null;
      this.apply(settings, true);
      // What has moved far since the start is in the first picture, too.
      if (first && this.blocks) this.stage.look(this.blocks.box().union(this.atRest));
    } catch (error) {
      if (ticket !== this.ticket) return false;
      this.trouble = told(error);
    }
    this.frame = k;
    return true;
  }

  /** Fetches a frame into memory before it is wanted. */
  prefetch(k: number, settings: Settings): Promise<unknown> {
    return this.fetch(k, settings).catch(() => undefined);
  }

  private fetch(k: number, settings: Settings): Promise<Fetched> {
    return fetchFrame(this.run, k, settings, this.hasty ? null : [this.run, ...this.others]);
  }

  private build(blocks: Blocks): void {
    const first = this.blocks === null;
    const before = this.blocks;
    if (before) {
      this.stage.scene.remove(before.object);
      before.dispose();
    }
    this.blocks = blocks;
    blocks.tint(this.ink);
    const pull = this.run.summary.manifest.gravity ?? [0, 0, 0];
    // What gravity pulls along y stands along y.
    const up = blocks.dimension === 3 && Math.abs(pull[1]) > Math.max(Math.abs(pull[0]), Math.abs(pull[2])) ? "y" : "z";
    this.stage.setDimension(blocks.dimension, up);
    this.stage.scene.add(blocks.object);
    if (first) {
      this.charges.build(this.run.summary.manifest.sources ?? [], blocks.shape.info.origin, 0.3 * blocks.size);
      this.atRest = blocks.box();
      this.stage.look(this.atRest);
    }
  }

  /** Puts what was fetched on the stage. `moved`: the frame or the exaggeration is another. */
  apply(settings: Settings, moved: boolean): void {
    const { last, blocks } = this;
    if (!last || !blocks) return;
    const look = this.look(settings);
    this.motion = last.motion;
    if (moved) blocks.move(last.motion, look);
    this.values = last.field?.f32("values") ?? null;
    this.unit = last.field?.info.unit ?? "";
    this.tune(settings);
    blocks.paint(this.values, this.scale);
    blocks.reveal(look, this.values);
    blocks.glass = (settings.cracks || settings.chains || settings.joints !== "") && !this.flat;
    this.stage.shadowed = settings.shadows ? blocks : null;
    this.stage.shading.moved();
    const { planes } = blocks;
    for (const marks of Object.values(this.marks)) marks.end(planes);
    this.charges.object.visible = settings.charges;
    this.drawArrows(settings);
    this.drawContacts(settings);
    this.drawBolts(settings);
    this.drawChains(settings);
    const stress = settings.stress ? last.stress : null;
    this.stressShown = this.stress.draw(stress, blocks, (b, target) => this.shiftOf(b, 1, target), settings, this.modelSize() / 250);
    this.drawPicked();
    this.drawWarned();
    this.drawSupports(settings);
    this.drawConditions(settings);
    this.now = settings;
    void this.drawTrails();
    this.stage.redraw();
  }

  /** Draws the trails, after reading them where that has not been done. */
  private async drawTrails(): Promise<void> {
    const { trails, picked, now } = this;
    this.trailed = null;
    if (!now || now.trails === "" || (now.trails === "picked" && picked === null)) {
      trails.hide();
      return;
    }
    const which = now.trails;
    if (!trails.has(which, picked)) {
      trails.hide();
      try {
        await trails.load(which, picked);
      } catch (error) {
        this.trouble = told(error);
      }
      // Another choice may have been made meanwhile.
      if (trails.has(which, picked) && this.now) await this.drawTrails();
      this.stage.redraw();
      this.onChange?.();
      return;
    }
    this.trailed = trails.draw(this.last!.k, now.exaggeration, now.trailColour);
  }

  /** The annotations as they are on the picture. */
  labels(): Label[] {
    const { blocks, motion, now, stage } = this;
    if (!blocks || !motion || !now?.notes) return [];
    return labelsOf(this.notes, blocks, motion, now.exaggeration, stage.camera);
  }

  private drawBolts(settings: Settings): void {
    const bolts = settings.bolts ? this.last!.bolts : null;
    this.boltForces = bolts?.info ?? null;
    if (!bolts) {
      this.bolts.clear();
      return;
    }
    const shift = (b: number, target: THREE.Vector3) => this.shiftOf(b, settings.exaggeration - 1, target);
    this.bolts.draw(bolts, this.blocks!, shift, this.modelSize() / 250);
  }

  private drawChains(settings: Settings): void {
    const contacts = settings.chains ? this.last!.contacts : null;
    this.chained = null;
    this.chains.clear();
    const longest = contacts?.info.longest ?? 0;
    if (!contacts?.has("forces") || !(longest > 0)) return;
    const blocks = this.blocks!;
    const places = this.contactPlaces(settings);
    const place = new THREE.Vector3();
    for (let k = 0; k < places.length; k += 3) if (blocks.isAway(place.fromArray(places, k))) places[k] = NaN;
    const middle = (b: number) => {
      if (b >= blocks.count || !blocks.isShown(b)) return null;
      const at = this.shiftOf(b, settings.exaggeration, new THREE.Vector3());
      return at.add(new THREE.Vector3().fromArray(blocks.middles, 3 * b));
    };
    const thick = 0.015 * this.modelSize() * settings.vectorSize;
    const held = this.last!.supports?.f32("values");
    const count = this.chains.draw(contacts, places, middle, (b) => (held && held[b]! > 0 ? Infinity : blocks.diagonal(b)), thick);
    this.chained = { count, longest, unit: contacts.info.forceUnit ?? "" };
  }

  private drawSupports(settings: Settings): void {
    const held = settings.supports ? this.last!.supports?.f32("values") : undefined;
    this.supports = null;
    if (!held) {
      this.supportMark.draw(null);
      this.drivenMark.draw(null);
      return;
    }
    const lines: [number[], number[]] = [[], []];
    this.supports = 0;
    this.driven = 0;
    // A later support wins over an earlier one.
    const driven = new Map((this.run.conditions?.supports ?? []).flatMap((s) => s.blocks.map((b): [number, boolean] => [b, s.driven])));
    held.forEach((value, b) => {
      if (!(value > 0)) return;
      this.supports!++;
      const moves = driven.get(this.blocks!.ids[b]!) === true;
      if (moves) this.driven++;
      if (this.blocks!.isShown(b)) for (const x of this.blocks!.outline(b)) lines[moves ? 1 : 0].push(x);
    });
    this.supportMark.draw(new Float32Array(lines[0]));
    this.drivenMark.draw(new Float32Array(lines[1]));
  }

  private drawConditions(settings: Settings): void {
    const { conditions } = this.run;
    const blocks = this.blocks!;
    const shift = (b: number, target: THREE.Vector3) => this.shiftOf(b, settings.exaggeration, target);
    const of = (on: boolean) => (on ? conditions : null);
    this.conditionNotes = [
      ...this.conditions.drawFaces(of(settings.boundaries), blocks),
      ...this.conditions.drawLoads(of(settings.loads), blocks, shift, 0.1 * this.modelSize()),
      ...this.conditions.drawWater(of(settings.water), blocks, this.last!.motion.info.phase),
      ...this.joints.draw(settings.joints, blocks, conditions, this.last!.materials?.f32("values") ?? null),
    ];
  }

  private look(settings: Settings): Look {
    return {
      exaggeration: settings.exaggeration,
      edges: settings.edges,
      clip: cutOf(this.blocks!, settings),
      only: settings.only ? [this.scale.low, this.scale.high] : null,
    };
  }

  /** The cut in the axes of the model: what lies along the normal beyond a place, m, is taken away. */
  cutAway(settings: Settings): { normal: Cut["normal"]; at: number } | null {
    return this.blocks && cutAway(this.blocks, settings);
  }

  /** Where the cut is, in words; empty without one. */
  cutText(settings: Settings): string {
    return this.blocks ? cutText(this.blocks, settings) : "";
  }

  /** Range and colours of the scale. */
  private tune(settings: Settings): void {
    const { scale, last } = this;
    scale.kinds = KINDS.has(settings.field);
    scale.field = settings.field;
    if (!this.values) {
      scale.kinds = false;
      scale.plain();
      return;
    }
    const own = last?.field?.info;
    const ofFrame = settings.rangeMode === "most" ? (own?.most ?? own?.range) : own?.range;
    let [low, high] = (settings.rangeMode === "frame" ? ofFrame : (last?.range ?? ofFrame)) ?? [0, 1];
    if (settings.rangeMode === "fixed") [low, high] = [settings.low, settings.high];
    else if (settings.map === "blue-red" && low < 0 && high > 0 && !settings.log) {
      // White means zero.
      high = Math.max(-low, high);
      low = -high;
    }
    if (settings.log) {
      high = high > 0 ? high : 1;
      low = low > 0 ? low : high * 1e-6;
      low = Math.max(low, high * 1e-9);
    }
    if (!(high > low)) high = low + (Math.abs(low) || 1) * 1e-6;
    scale.low = low;
    scale.high = high;
    scale.log = settings.log;
    scale.paint(settings.map);
  }

  private shiftOf(b: number, factor: number, target: THREE.Vector3): THREE.Vector3 {
    const shifts = this.last!.motion.f32("shifts");
    if (this.flat) target.set(shifts[2 * b]!, shifts[2 * b + 1]!, 0);
    else target.fromArray(shifts, 3 * b);
    return target.multiplyScalar(factor);
  }

  private drawArrows(settings: Settings): void {
    const { last, blocks } = this;
    this.arrow = null;
    const arrows = this.flat ? this.arrows.plane : this.arrows.space;
    const place = new THREE.Vector3();
    const length = 0.08 * this.modelSize() * settings.vectorSize;
    const flows = settings.vectors === "seepage flow";
    const name = flows ? "flows" : "forces";
    if ((flows || settings.vectors === "contact force") && last!.contacts?.has(name)) {
      const contacts = last!.contacts;
      const longest = (flows ? contacts.info.fastest : contacts.info.longest) ?? 0;
      const places = this.contactPlaces(settings);
      for (let k = 0; k < places.length; k += 3) if (blocks!.isAway(place.fromArray(places, k))) places[k] = NaN;
      if (longest > 0) arrows.draw(places, contacts.f32(name), longest, length);
      else arrows.clear();
      this.arrow = { longest, unit: (flows ? contacts.info.flowUnit : contacts.info.forceUnit) ?? "" };
    } else if (last!.vectors) {
      const places = new Float32Array(3 * blocks!.count);
      const vectors = last!.vectors.f32("values");
      for (let b = 0; b < blocks!.count; b++) {
        this.shiftOf(b, settings.exaggeration, place);
        for (let k = 0; k < 3; k++) places[3 * b + k] = blocks!.middles[3 * b + k]! + place.getComponent(k);
        const hidden = !blocks!.isShown(b) || blocks!.isAway(place.fromArray(places, 3 * b));
        if (hidden) places[3 * b] = NaN;
      }
      const longest = last!.vectors.info.longest ?? 0;
      if (longest > 0) arrows.draw(places, vectors, longest, length);
      else arrows.clear();
      this.arrow = { longest, unit: last!.vectors.info.unit };
    } else {
      arrows.clear();
    }
  }

  private modelSize(): number {
    const { low, high } = this.blocks!.shape.info;
    return Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]) || 1;
  }

  private contactPlaces(settings: Settings): Float32Array {
    return contactPlaces(this.last!.contacts!, this.blocks!, (b, target) =>
      this.shiftOf(b, settings.exaggeration - 1, target),
    );
  }

  private drawContacts(settings: Settings): void {
    const contacts = this.last!.contacts;
    const marks = this.flat ? this.marks.plane : this.marks.space;
    this.between = contacts ? { counts: Contacts.count(contacts), areas: contacts.info.areas, unit: contacts.info.areaUnit } : null;
    if (contacts && settings.contacts) marks.drawPoints(contacts, this.contactPlaces(settings), settings.states);
    else marks.hide("points");
    if (contacts && settings.cracks && !this.flat) {
      const shift = (b: number, target: THREE.Vector3) => this.shiftOf(b, settings.exaggeration - 1, target);
      marks.drawCracks(contacts, this.last!.cracks, this.blocks!, shift);
    } else marks.hide("cracks");
  }

  private drawPicked(): void {
    const at = this.picked === null ? -1 : this.blocks!.placeOf(this.picked);
    this.pickedMark.draw(at < 0 ? null : this.blocks!.outline(at));
  }

  /** Outlines the blocks that warnings name; a run has moved on from what was said of its start. */
  private drawWarned(): void {
    const blocks = this.blocks!;
    const { preview, warnings } = this.run.summary.manifest;
    const named = preview ? new Set(warnings.flatMap((w) => blocksOf(w, this.run.names))) : new Set<number>();
    this.warned = named.size;
    const places = [...named].map((id) => blocks.placeOf(id)).filter((at) => at >= 0 && blocks.isShown(at));
    const marked = places.slice(0, WARNED_MOST);
    const lines = marked.flatMap((at) => [...blocks.outline(at)]);
    this.warnedMark.draw(lines.length > 0 ? new Float32Array(lines) : null);
    // A block that is too small to be seen has a dot.
    const dots = marked.flatMap((at) => [...blocks.middles.subarray(3 * at, 3 * at + 2), this.flat ? 0.6 : blocks.middles[3 * at + 2]!]);
    this.warnedDots.geometry.dispose();
    this.warnedDots.geometry.setAttribute("position", new THREE.Float32BufferAttribute(dots, 3));
    this.warnedDots.visible = dots.length > 0;
  }

  /** Looks at blocks from where the camera stands, with as much again around them. */
  goTo(ids: number[]): void {
    const { blocks } = this;
    if (!blocks) return;
    const box = new THREE.Box3();
    for (const at of ids.map((id) => blocks.placeOf(id))) if (at >= 0) for (const corner of blocks.cornersOf(at)) box.expandByPoint(corner);
    if (box.isEmpty()) return;
    this.stage.look(box.expandByScalar(box.getSize(new THREE.Vector3()).length()));
  }

  /** Picks the block under a place of the screen; null: none there. */
  pickAt(x: number, y: number): number | null {
    if (!this.blocks) return null;
    const at = this.blocks.pick(this.stage.ray(x, y));
    return at === null ? null : this.blocks.ids[at]!;
  }

  /** The place of the model under a place of the screen; a corner of its block where one is near. Null: nothing there. */
  placeAt(x: number, y: number): THREE.Vector3 | null {
    if (!this.blocks) return null;
    const ray = this.stage.ray(x, y);
    const hit = this.blocks.hit(ray);
    const far = (p: THREE.Vector3) => {
      const [px, py] = this.stage.onScreen(p);
      return Math.hypot(px - x, py - y);
    };
    const near = hit ? this.blocks.cornersOf(hit.block).reduce((a, b) => (far(b) < far(a) ? b : a)) : null;
    if (near && far(near) < SNAP && !this.blocks.isAway(near)) return near;
    if (this.flat) {
      const { origin, direction } = ray.ray;
      return origin.clone().addScaledVector(direction, -origin.z / direction.z);
    }
    return hit?.point ?? null;
  }

  /** Lays the line anew. */
  lay(ends: THREE.Vector3[]): void {
    this.ends = ends;
    this.ruler.draw(ends, this.flat);
    this.stage.redraw();
  }

  /** Length of the line in words; empty without one. */
  lineText(): string {
    const [a, b] = this.ends;
    if (!a) return "";
    if (!b) return "line: click its other end";
    const way = b.clone().sub(a);
    // What single precision leaves of nothing is nothing.
    const part = (v: number) => short(Math.abs(v) < 1e-6 * way.length() ? 0 : v, 4);
    const parts = (this.flat ? [way.x, way.y] : way.toArray()).map(part).join(", ");
    return `distance ${quantity(way.length(), "m", 5)} (${parts})`;
  }

  /** The blocks along the line. */
  along(): { pieces: Piece[]; length: number } {
    const [a, b] = this.ends;
    if (!a || !b || !this.blocks) return { pieces: [], length: 0 };
    return { pieces: piecesAlong(this.blocks, a, b).filter((p) => this.blocks!.isShown(p.block)), length: a.distanceTo(b) };
  }

  pick(id: number | null): void {
    this.picked = id;
    if (this.blocks) this.drawPicked();
    if (this.now?.trails === "picked") void this.drawTrails();
    this.stage.redraw();
  }

  /** An exaggeration at which the largest displacement is a twentieth of the model. */
  niceExaggeration(): number {
    const shifts = this.last?.motion.f32("shifts");
    if (!shifts) return 1;
    const n = this.flat ? 2 : 3;
    let far = 0;
    for (let i = 0; i < shifts.length; i += n) {
      far = Math.max(far, Math.hypot(shifts[i]!, shifts[i + 1]!, n === 3 ? shifts[i + 2]! : 0));
    }
    if (!(far > 0)) return 1;
    const raw = (0.05 * this.modelSize()) / far;
    const power = 10 ** Math.floor(Math.log10(raw));
    return Math.max(1, power * Math.floor(raw / power));
  }

  fit(side?: "default" | "x" | "y" | "z"): void {
    if (this.blocks) this.stage.look(this.blocks.box().union(this.conditions.reach), side);
  }
}
