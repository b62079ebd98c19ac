// Views that were saved: where the camera stands and what is shown, by name. `riprap shot RUN --saved NAME` draws them from views.json.

import * as THREE from "three";
import { KINDS } from "./colour";
import { choice, el, row, save } from "./dom";
import { LONGEST, readNotes, type Annotation } from "./notes";
import { DEFAULTS, type Choices, type Settings } from "./settings";
import { Problem } from "./source";
import type { Standpoint } from "./stage";
import type { View } from "./view";

type Triple = [number, number, number];

/** An entry of views.json; lengths in m, in the axes of the model. */
export interface SavedView {
  name: string;
  eye: Triple;
  target: Triple;
  up: Triple;
  /** Between the upper and the lower edge of the picture as seen from the eye, deg; null: a parallel projection, that of the plane. */
  angle: number | null;
  /** Of a parallel projection. */
  zoom: number;
  field: string;
  log: boolean;
  /** Values of the first and the last colour, in the unit of the field in SI; null: kinds, or one colour. */
  range: [number, number] | null;
  exaggeration: number;
  /** What lies along the normal beyond `at` is taken away. */
  cut: { normal: Triple; at: number } | null;
  bolts: boolean;
  /** Number of the block whose trail is shown, where one is. */
  picked?: number;
  /** What was chosen in the viewer, where it is not what a new page has. */
  settings: Partial<Settings>;
}

const triple = (v: THREE.Vector3): Triple => v.toArray();

/** What is shown now. */
export function taken(view: View, settings: Settings, name: string): SavedView {
  const { stage, scale } = view;
  const origin = new THREE.Vector3(...view.blocks!.shape.info.origin);
  const { position, target, zoom } = stage.standpoint();
  const ofAmounts = settings.field !== "" && !KINDS.has(settings.field);
  const chosen = Object.entries(settings).filter(([key, value]) => JSON.stringify(value) !== JSON.stringify(DEFAULTS[key as keyof Settings]));
  return {
    name,
    eye: triple(position.add(origin)),
    target: triple(target.add(origin)),
    up: triple(stage.camera.up),
    angle: stage.camera instanceof THREE.PerspectiveCamera ? stage.camera.fov : null,
    zoom,
    field: settings.field,
    log: settings.log,
    range: ofAmounts ? [scale.low, scale.high] : null,
    exaggeration: settings.exaggeration,
    cut: view.cutAway(settings),
    bolts: settings.bolts,
    ...(settings.trails === "picked" && view.picked !== null ? { picked: view.picked } : {}),
    settings: Object.fromEntries(chosen) as Partial<Settings>,
  };
}

/** Where the camera of a view stands, less the origin of what is drawn. */
export function standpointOf(view: View, saved: SavedView): Standpoint {
  const origin = new THREE.Vector3(...view.blocks!.shape.info.origin);
  return {
    position: new THREE.Vector3(...saved.eye).sub(origin),
    target: new THREE.Vector3(...saved.target).sub(origin),
    zoom: saved.zoom,
  };
}

/** How the camera moves while a film is made. */
export type Path = "" | "views" | "round";

/** Places of the camera by the share of the film that has passed, 0 to 1; null: it stays. */
export function camera(view: View, path: Path, saved: SavedView[]): ((share: number) => Standpoint) | null {
  if (path === "views" && saved.length > 1) {
    const stops = saved.map((s) => standpointOf(view, s));
    const eyes = new THREE.CatmullRomCurve3(stops.map((s) => s.position));
    const targets = stops.map((s) => s.target);
    // A curve through places that are one has no direction.
    const still = targets.every((t) => t.distanceTo(targets[0]!) < 1e-9);
    const curve = still ? null : new THREE.CatmullRomCurve3(targets);
    return (share) => {
      const at = share * (stops.length - 1);
      const k = Math.min(stops.length - 2, Math.floor(at));
      const zoom = THREE.MathUtils.lerp(stops[k]!.zoom, stops[k + 1]!.zoom, at - k);
      return { position: eyes.getPoint(share), target: curve?.getPoint(share) ?? targets[0]!.clone(), zoom };
    };
  }
  if (path === "round" && !view.flat) {
    const { position, target, zoom } = view.stage.standpoint();
    const axis = view.stage.camera.up.clone().normalize();
    return (share) => ({ position: position.clone().sub(target).applyAxisAngle(axis, 2 * Math.PI * share).add(target), target: target.clone(), zoom });
  }
  return null;
}

function isTriple(value: unknown): value is Triple {
  return Array.isArray(value) && value.length === 3 && value.every((v) => Number.isFinite(v));
}

/** The views of a file; what it lacks is as in a new page. */
export function read(text: string): SavedView[] {
  const wrong = (what: string) => new Problem(`views.json: ${what}.`, "Save the file again from the viewer.");
  let given: unknown;
  try {
    given = (JSON.parse(text) as { views?: unknown }).views;
  } catch (error) {
    throw wrong(String(error));
  }
  if (!Array.isArray(given)) throw wrong("it has no list `views`");
  return given.map((one: Partial<SavedView>, i) => {
    const { name, eye, target } = one;
    if (typeof name !== "string" || !isTriple(eye) || !isTriple(target)) throw wrong(`view ${i + 1} needs a name, an eye and a target`);
    const rest = { up: [0, 0, 1] as Triple, angle: 32, zoom: 1, field: "displacement", log: false, range: null, exaggeration: 1, cut: null, bolts: true };
    return { ...rest, ...one, name, eye, target, settings: one.settings ?? {} };
  });
}

/** The list in the panel: a name and what is shown now are kept, a click goes back there. */
export class SavedViews {
  readonly object = el("div");
  /** How the camera of a film moves. */
  path: Path = "";
  private all: SavedView[] = [];
  private notes: Annotation[] = [];
  private readonly noteList = el("div.buttons");
  private readonly said = el("p.hint", { role: "status" });
  private readonly list = el("div.buttons");

  constructor(
    private readonly views: () => View[],
    private readonly choices: Choices,
    /** Lets somebody click the place of a text. */
    private readonly annotate: (text: string) => void,
  ) {
    const name = el("input", { type: "text", placeholder: "name", "aria-label": "name of the view", maxLength: 60 });
    const keep = () => {
      this.add(name.value.trim() || `view ${this.all.length + 1}`);
      name.value = "";
    };
    name.addEventListener("keydown", (e) => {
      if (e.key === "Enter") keep();
    });
    const button = (label: string, title: string, act: () => void) => el("button", { type: "button", title, onclick: act }, label);
    this.object.append(
      el("div.buttons", {}, name, button("save view", "Keep camera, colours and cut under this name", keep), button("views.json", "All saved views in a file: riprap shot RUN --views FILE --saved NAME draws them; in the run folder the viewer finds them again", () => this.write())),
      this.list,
      this.noteRow(),
      this.noteList,
      this.said,
    );
    this.fill();
  }

  /** Where texts are written. */
  private noteRow(): HTMLElement {
    const text = el("input", { type: "text", placeholder: "text", "aria-label": "text of the note", maxLength: LONGEST });
    const put = () => {
      const said = text.value.trim();
      if (!said) {
        this.said.textContent = "Write a text first, then click its place.";
        return;
      }
      this.said.textContent = "Click its place: on a block it goes along with it.";
      this.annotate(said);
      text.value = "";
      text.blur();
    };
    text.addEventListener("keydown", (e) => {
      if (e.key === "Enter") put();
    });
    return el("div.buttons", {}, text, el("button", { type: "button", title: "Put this text on a block or a place of the model; it is kept with the views, and in pictures and films", onclick: put }, "note"));
  }

  /** Keeps a text. */
  addNote(note: Annotation): void {
    this.notes.push(note);
    this.kept();
  }

  /** What the camera does while frames and films are saved. */
  pathRow(dimension: 2 | 3): HTMLElement {
    const ways: [Path, string][] = [["", "stays"], ["views", "through the saved views"], ...(dimension === 3 ? [["round", "once around"] as [Path, string]] : [])];
    return row("Camera", choice(ways, this.path, (path) => (this.path = path as Path), "camera of a film"));
  }

  /** The way of the camera; null: it stays. */
  move(): ((share: number) => Standpoint) | null {
    if (this.path === "views" && this.all.length < 2) throw new Error("Save two views or more: the camera goes through them in their order.");
    const view = this.views()[0];
    return view?.blocks ? camera(view, this.path, this.all) : null;
  }

  /** Takes over what this browser kept of a run, then the file of its folder. */
  async load(): Promise<void> {
    const run = this.views()[0]?.run;
    if (!run) return;
    try {
      const kept = localStorage.getItem(this.key());
      if (kept) [this.all, this.notes] = [read(kept), readNotes(kept)];
    } catch {
      // A page that may keep nothing, or what another version kept.
    }
    try {
      const href = run.summary.views ? run.source.file("views.json") : undefined;
      const text = href ? await (await fetch(href)).text() : null;
      if (text !== null) {
        for (const view of read(text)) this.put(view);
        const same = (a: Annotation, b: Annotation) => a.text === b.text && a.block === b.block && a.at.every((v, k) => v === b.at[k]);
        for (const note of readNotes(text)) if (!this.notes.some((other) => same(note, other))) this.notes.push(note);
      }
    } catch (error) {
      this.said.textContent = error instanceof Problem ? `${error.what} ${error.hint}` : String(error);
    }
    this.fill();
  }

  private key(): string {
    return `riprap.views.${this.views()[0]?.run.summary.name ?? ""}`;
  }

  private put(view: SavedView): void {
    const at = this.all.findIndex((v) => v.name === view.name);
    if (at < 0) this.all.push(view);
    else this.all[at] = view;
  }

  private add(name: string): void {
    const view = this.views()[0];
    if (!view?.blocks) return;
    this.put(taken(view, this.choices.now, name));
    this.kept();
  }

  private kept(): void {
    this.fill();
    try {
      localStorage.setItem(this.key(), this.text());
    } catch {
      // Not kept beyond this page; the file can be saved.
    }
  }

  private text(): string {
    return JSON.stringify({ views: this.all, notes: this.notes }, null, 1);
  }

  private write(): void {
    if (this.all.length + this.notes.length === 0) this.said.textContent = "No views and no notes saved yet.";
    else save(new Blob([this.text()], { type: "application/json" }), "views.json");
  }

  private fill(): void {
    this.list.replaceChildren(
      ...this.all.map((view) =>
        el(
          "span.saved",
          {},
          el("button", { type: "button", title: "Go to this view", onclick: () => this.go(view) }, view.name),
          el("button", { type: "button", title: `Remove ${view.name}`, "aria-label": `remove ${view.name}`, onclick: () => this.remove(view) }, "×"),
        ),
      ),
    );
    this.noteList.replaceChildren(
      ...this.notes.map((note) => {
        const drop = () => {
          this.notes = this.notes.filter((n) => n !== note);
          this.kept();
        };
        return el("span.saved", {}, el("span", {}, note.text), el("button", { type: "button", title: "Remove this note", "aria-label": `remove note ${note.text}`, onclick: drop }, "×"));
      }),
    );
    this.said.textContent = "";
    for (const view of this.views()) {
      view.notes = this.notes;
      view.stage.redraw();
    }
  }

  private remove(view: SavedView): void {
    this.all = this.all.filter((v) => v !== view);
    this.kept();
  }

  private go(saved: SavedView): void {
    // The field stands in the view itself: files of earlier versions do not repeat that of a new page.
    const { states, ...rest } = { ...DEFAULTS, ...saved.settings, field: saved.field };
    this.choices.set({ ...rest, states: [...states] });
    for (const view of this.views()) if (view.blocks) view.stage.follow(standpointOf(view, saved));
  }
}
