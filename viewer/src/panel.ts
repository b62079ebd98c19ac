// The panel at the side: everything that can be chosen, and what is known about the run and the picked block.

import { KINDS, MAPS, defaultMap } from "./colour";
import { check, choice, el, row } from "./dom";
import { mp4Codec, type Container } from "./film";
import { quantity, short } from "./format";
import { kindName } from "./legend";
import { STATES } from "./marks";
import { namesOf } from "./plots";
import type { BlockNumbers, Run } from "./run";
import type { SavedViews } from "./saved";
import type { Choices, Settings } from "./settings";
import { blocksOf } from "./warnings";

export interface Actions {
  fit: (side?: "default" | "x" | "y" | "z") => void;
  picture: () => void;
  sequence: () => void;
  film: (container: Container) => void;
  niceExaggeration: () => number;
  unpick: () => void;
  /** Picks the first of some blocks of a run and looks at all of them. */
  goTo: (run: Run, ids: number[]) => void;
  line: () => void;
  history: () => void;
  range: () => [number, number];
  /** Why there are no shadows or edges though they are asked for; empty if there are. */
  unshaded: () => string;
  /** Which states of contacts the frames shown have. */
  states: () => boolean[];
}

export class Panel {
  readonly object: HTMLElement;
  private readonly blockBox = el("div.numbers");
  private readonly status = el("div.exportstate", { role: "status" });
  private readonly colourBox = el("div");
  private readonly moveBox = el("div");
  private readonly marksBox = el("div");

  constructor(
    private readonly runs: Run[],
    private readonly choices: Choices,
    private readonly actions: Actions,
    private readonly saved: SavedViews,
    private dimension: 2 | 3,
  ) {
    this.object = el("aside.panel", { "aria-label": "settings" });
    this.rebuild();
    choices.listen((changed) => {
      // A slider that is being moved must stay.
      const sliding: (keyof Settings)[] = ["clipAt", "clipDip", "clipDirection", "vectorSize"];
      const held = this.object.querySelector("input[type=range]:active, input[type=range]:focus");
      if (!held || !changed.every((c) => sliding.includes(c))) this.refill();
    });
  }

  /** Everything anew: another kind of run, new fields. */
  rebuild(dimension = this.dimension): void {
    this.dimension = dimension;
    // What is to be mended before a scene is run comes first.
    const doubtful = this.runs.filter((r) => r.summary.manifest?.preview && r.summary.manifest.warnings.length > 0);
    this.object.replaceChildren(
      ...doubtful.map((run) => section(`Warnings (${run.summary.manifest.warnings.length})`, true, ...this.warnings(run))),
      section("Colour", true, this.colourBox),
      section("Shape and view", true, this.moveBox),
      section("Vectors and contacts", true, this.marksBox),
      section("Block", true, this.blockBox),
      section("Views", false, this.saved.object),
      section("Save", false, this.saveBox()),
      ...this.runs.map((run, i) => section(this.runs.length > 1 ? `Run ${i + 1}` : "Run", false, aboutRun(run, this.warnings(run)))),
    );
    this.refill();
    if (!this.blockBox.hasChildNodes()) this.showBlock(null);
  }

  /** Warnings of a run; those that name blocks lead there. */
  private warnings(run: Run): HTMLElement[] {
    return (run.summary.manifest?.warnings ?? []).map((text) => {
      const ids = blocksOf(text, run.names);
      if (ids.length === 0) return el("p.warning", {}, text);
      const title = ids.length === 1 ? "Go to this block" : `Go to these ${ids.length} blocks`;
      return el("button.warning", { type: "button", title, onclick: () => this.actions.goTo(run, ids) }, text);
    });
  }

  /** The choices anew: they depend on what is shown. */
  refill(): void {
    this.colourBox.replaceChildren(...this.colourRows());
    this.moveBox.replaceChildren(...this.moveRows());
    this.marksBox.replaceChildren(...this.markRows());
  }

  private colourRows(): HTMLElement[] {
    const { choices } = this;
    const now = choices.now;
    const names = [...new Set(this.runs.flatMap((r) => namesOf(r)))];
    const field = choice(
      [["", "one colour"], ...names.map((n): [string, string] => [n, n])],
      now.field,
      (name) => choices.set(coloured(now, name)),
      "field",
    );
    const quick = quickFields(this.runs).map((name) => {
      const act = () => choices.set(coloured(now, name));
      return el("button", { type: "button", title: "Colour by this field (q: the next)", "aria-pressed": String(name === now.field), onclick: act }, name || "one colour");
    });
    const rows: HTMLElement[] = [row("Field", field)];
    if (quick.length > 1) rows.push(el("div.buttons", {}, ...quick));
    const meaning = this.meaning(now.field);
    if (meaning) rows.push(el("p.hint", {}, meaning));
    // Kinds have their own colours and no range.
    if (!now.field || KINDS.has(now.field)) return rows;
    rows.push(
      row("Colours", choice(Object.keys(MAPS).map((m) => [m, m]), now.map, (map) => choices.set({ map }), "colour map")),
      row(
        "Range",
        choice(
          [
            ["most", "run, 98 % of blocks"],
            ["run", "whole run"],
            ["frame", "this frame"],
            ["fixed", "fixed"],
          ],
          now.rangeMode,
          (mode) => {
            const [low, high] = this.actions.range();
            choices.set({ rangeMode: mode as Settings["rangeMode"], low, high });
          },
          "range of the colours",
        ),
      ),
    );
    if (now.rangeMode === "fixed") {
      const number = (key: "low" | "high", label: string) => {
        const box = el("input", { type: "number", step: "any", value: String(now[key]), "aria-label": label });
        box.addEventListener("change", () => {
          if (Number.isFinite(box.valueAsNumber)) choices.set({ [key]: box.valueAsNumber });
        });
        return box;
      };
      rows.push(row("From, to (SI)", number("low", "lowest value"), number("high", "highest value")));
    }
    rows.push(
      el(
        "div.checks",
        {},
        check("powers of ten", now.log, (log) => choices.set(log && now.map === "blue-red" ? { log, map: "light" } : { log }), "Logarithmic colours"),
        check("only in range", now.only, (only) => choices.set({ only }), "Hide blocks whose value is outside the range"),
      ),
    );
    return rows;
  }

  /** What a number of a kind means, where all runs agree on it. */
  private kindOf(field: string, number: number | undefined): string {
    if (number === undefined) return "";
    const names = this.runs.filter((r) => r.summary.manifest).map((r) => kindName(r, field, number));
    return names.every((n) => n === names[0]) ? (names[0] ?? "") : "";
  }

  private meaning(name: string): string {
    const stem = name.replace(/\.(x|y|z|magnitude)$/, "");
    for (const run of this.runs) {
      const note = run.summary.manifest?.fields?.find((f) => f.name === stem || f.name === `block.${stem}`);
      if (note) return note.meaning;
    }
    return "";
  }

  private moveRows(): HTMLElement[] {
    const { choices, actions } = this;
    const now = choices.now;
    const slider = el("input", { type: "range", min: "0", max: "4", step: "0.02", value: String(Math.log10(Math.max(1, now.exaggeration))), "aria-label": "exaggeration" });
    const factor = el("output", {}, `× ${short(now.exaggeration, 3)}`);
    const value = () => Number((10 ** Number(slider.value)).toPrecision(2));
    slider.addEventListener("input", () => (factor.textContent = `× ${short(value(), 3)}`));
    slider.addEventListener("change", () => choices.set({ exaggeration: value() }));
    const small = (label: string, title: string, act: () => void) => el("button", { type: "button", title, onclick: act }, label);
    const rows = [
      row("Displacement", slider, factor),
      el(
        "div.buttons",
        {},
        small("true", "Displacements as they are", () => choices.set({ exaggeration: 1 })),
        small("visible", "Exaggerate so that the largest displacement can be seen", () => choices.set({ exaggeration: actions.niceExaggeration() })),
        small("fit", "All in view (f)", () => actions.fit()),
        ...(this.dimension === 3
          ? (["x", "y", "z"] as const).map((side) => small(side, `Look along ${side}`, () => actions.fit(side)))
          : []),
        small("line", "Distance, and the field along a line: click both ends; again: remove it (d)", actions.line),
      ),
      el("div.checks", {}, check("edges", now.edges, (edges) => choices.set({ edges }), "Draw the edges of the blocks (e)"),
        this.dimension === 3 ? check("shadows", now.shadows, (shadows) => choices.set({ shadows }), "Shadows of the sun, and darker hollows (y)") : null,
        this.runs.some((r) => r.hasField("held"))
          ? check("supports", now.supports, (supports) => choices.set({ supports }), "Outline the blocks that supports hold or move (u)")
          : null,
        ...this.conditionChecks(),
      ),
      ...((now.shadows || now.edges) && actions.unshaded() ? [el("p.hint", {}, actions.unshaded())] : []),
      row(
        "Joints",
        choice(
          [["", "not shown"], ["set", "by set (direction)"], ...(this.runs.some((r) => r.conditions) ? [["interface", "by interface"] as [string, string]] : [])],
          now.joints,
          (joints) => choices.set({ joints: joints as Settings["joints"] }),
          "joints",
        ),
      ),
      ...this.cutRows(),
    ];
    return rows;
  }

  /** Of what holds and loads the model, what there is. */
  private conditionChecks(): HTMLElement[] {
    const { choices } = this;
    const now = choices.now;
    const all = this.runs.flatMap((r) => r.conditions ?? []);
    const out: HTMLElement[] = [];
    if (all.some((c) => c.faces.length > 0)) {
      out.push(check("boundaries", now.boundaries, (boundaries) => choices.set({ boundaries }), "Colour the faces that are held, moved, viscous or loaded (h)"));
    }
    if (all.some((c) => c.loads.length > 0 || c.faces.some((f) => f.kind === "loaded"))) {
      out.push(check("loads", now.loads, (loads) => choices.set({ loads }), "Arrows of given forces and pressures, at their full size (l)"));
    }
    if (all.some((c) => c.water.length > 0)) {
      out.push(check("water table", now.water, (water) => choices.set({ water }), "The water table of the phase (w)"));
    }
    return out;
  }

  /** What is taken away to look inside. */
  private cutRows(): HTMLElement[] {
    const { choices } = this;
    const now = choices.now;
    const axes = this.dimension === 3 ? ["x", "y", "z"] : ["x", "y"];
    const axis = choice(
      [["", "nothing"], ...axes.map((a): [string, string] => [a, `along ${a}`]), ["free", this.dimension === 3 ? "any plane" : "any line"]],
      now.clipAxis,
      (a) => choices.set({ clipAxis: a as Settings["clipAxis"] }),
      "clipping plane",
    );
    const rows = [row("Cut away", axis)];
    if (!now.clipAxis) return rows;
    const slider = (key: "clipAt" | "clipDip" | "clipDirection", high: number, step: number, label: string) => {
      const box = el("input", { type: "range", min: "0", max: String(high), step: String(step), value: String(now[key]), "aria-label": label });
      const said = key === "clipAt" ? null : el("output", {}, `${now[key]}°`);
      box.addEventListener("input", () => {
        if (said) said.textContent = `${box.value}°`;
        choices.set({ [key]: Number(box.value) });
      });
      return [box, said] as const;
    };
    const how = choice(
      [
        ["flat", "flat, through blocks"],
        ["whole", "whole blocks"],
      ],
      now.clipFlat ? "flat" : "whole",
      (way) => choices.set({ clipFlat: way === "flat" }),
      "kind of cut",
    );
    how.title = "Flat, or whole blocks (b)";
    rows.push(row("Cut is", how), row("Plane at", ...slider("clipAt", 1, 0.002, "place of the cut")));
    if (now.clipAxis === "free") {
      if (this.dimension === 2) rows.push(row("Angle from x", ...slider("clipDip", 180, 1, "angle of the cut")));
      else {
        rows.push(
          row("Dip", ...slider("clipDip", 90, 1, "dip of the cut")),
          row("Dip direction", ...slider("clipDirection", 360, 1, "dip direction of the cut")),
        );
      }
    }
    rows.push(el("div.checks", {}, check("flip", now.clipFlip, (clipFlip) => choices.set({ clipFlip }), "Remove the other side (o)")));
    return rows;
  }

  private markRows(): HTMLElement[] {
    const { choices } = this;
    const now = choices.now;
    const names = new Set(this.runs.flatMap((r) => (r.summary.fields ?? []).filter((f) => f.components > 1).map((f) => f.name)));
    const kinds = (["displacement", "velocity", "force"] as const).filter((v) => names.has(v));
    // A report holds what there was room for.
    const held = this.runs.map((r) => r.summary.held).filter((h) => h !== undefined);
    const vectors = kinds.filter((v) => held.every((h) => h.vectors.includes(v)));
    const contacts = held.every((h) => h.contacts);
    const missing = kinds.length > vectors.length || !contacts;
    const hint = missing ? [el("p.hint", {}, "This report holds only part of the arrows and contacts; riprap view shows all.")] : [];
    const stress = this.runs.some((r) => r.hasStress);
    if (vectors.length === 0 && !contacts && !stress) return hint;
    const seeps = this.runs.some((r) => r.conditions?.water.some((table) => table.seeps));
    const ofContacts = contacts ? ["contact force", ...(seeps ? ["seepage flow"] : [])] : [];
    const rows: HTMLElement[] = [
      row(
        "Arrows",
        choice(
          [["", "none"], ...[...vectors, ...ofContacts].map((k): [string, string] => [k, k])],
          now.vectors,
          (v) => choices.set({ vectors: v as Settings["vectors"] }),
          "vectors",
        ),
      ),
    ];
    if (stress) {
      rows.push(el("div.checks", {}, check("stress", now.stress, (stress) => choices.set({ stress }), "Principal stresses as crosses: blue in compression, red in tension (a)")));
    }
    if (now.vectors || now.stress || now.chains) {
      const size = el("input", { type: "range", min: "-1", max: "1", step: "0.05", value: String(Math.log10(now.vectorSize)), "aria-label": "size of arrows, crosses and chains" });
      size.addEventListener("input", () => choices.set({ vectorSize: 10 ** Number(size.value) }));
      rows.push(row("Size", size));
    }
    if (this.runs.some((r) => r.frames > 1)) rows.push(...this.trailRows());
    if (!contacts) return [...rows, ...hint];
    rows.push(
      el(
        "div.checks",
        {},
        check("contacts", now.contacts, (contacts) => choices.set({ contacts }), "Points at contacts, coloured by state (c)"),
        check("force chains", now.chains, (chains) => choices.set({ chains }), "Tubes from block to block, as thick and dark as the contact force (n)"),
        this.dimension === 3
          ? check("cracks", now.cracks, (cracks) => choices.set({ cracks }), "Broken and open faces between glassy blocks (k)")
          : null,
        this.runs.some((r) => r.summary.bolts)
          ? check("bolts", now.bolts, (bolts) => choices.set({ bolts }), "Bars of bolts, red in tension, blue in compression (r)")
          : null,
        this.runs.some((r) => (r.summary.manifest?.sources ?? []).length > 0)
          ? check("charges", now.charges, (charges) => choices.set({ charges }), "Stars where charges are (i)")
          : null,
      ),
    );
    if (now.contacts) {
      const there = this.actions.states();
      rows.push(
        el(
          "div.checks",
          {},
          ...STATES.flatMap((state, i) => {
            if (i > 1 && !there[i]) return [];
            const box = check(state.name, now.states[i]!, (on) => choices.set({ states: now.states.map((s, j) => (j === i ? on : s)) }));
            box.style.setProperty("--chip", state.colour);
            box.classList.add("chipped");
            return box;
          }),
        ),
      );
    }
    return [...rows, ...hint];
  }

  private trailRows(): HTMLElement[] {
    const { choices } = this;
    const { trails, trailColour } = choices.now;
    const which: [Settings["trails"], string][] = [["", "none"], ["moving", "of all that moved"], ["picked", "of the picked block"]];
    const colour: [Settings["trailColour"], string][] = [["speed", "by speed"], ["block", "by block"]];
    return [
      row(
        "Trails",
        choice(which, trails, (v) => choices.set({ trails: v as Settings["trails"] }), "trails"),
      ),
      ...(trails ? [row("Coloured", choice(colour, trailColour, (v) => choices.set({ trailColour: v as Settings["trailColour"] }), "colour of trails"))] : []),
    ];
  }

  private saveBox(): HTMLElement {
    const button = (label: string, title: string, act: () => void) => el("button", { type: "button", title, onclick: act }, label);
    const mp4 = button("MP4", "", () => this.actions.film("mp4"));
    mp4.hidden = true;
    void mp4Codec().then((codec) => {
      if (codec === null) return;
      mp4.hidden = false;
      mp4.textContent = `MP4 (${codec})`;
      mp4.title = `The same film as MP4, its pictures in ${codec}${codec === "H.264" ? "" : ", which slides and older players may not show"}`;
    });
    return el(
      "div",
      {},
      el(
        "div.buttons",
        {},
        button("Picture", "PNG of what is shown (s)", this.actions.picture),
        button("All frames", "PNG of every frame, in a zip", this.actions.sequence),
        button("Film", "WebM with every frame once, at the frames per second of the bar below", () => this.actions.film("webm")),
        mp4,
      ),
      this.saved.pathRow(this.dimension),
      this.status,
    );
  }

  say(text: string): void {
    this.status.textContent = text;
  }

  /** Numbers of the picked block. */
  showBlock(numbers: BlockNumbers | null, problem = ""): void {
    if (!numbers) {
      this.blockBox.replaceChildren(el("p.hint", {}, problem || "Click a block to see its numbers and their history."));
      return;
    }
    const rows = numbers.columns
      .filter((c) => c.name !== "block")
      .map((c) => {
        const parts = c.values.map((v) => (typeof v === "number" ? v : Number.NaN));
        const text =
          parts.length > 1
            ? `${quantity(Math.hypot(...parts), c.unit)}`
            : c.unit === "-" ? short(parts[0] ?? Number.NaN) : quantity(parts[0] ?? Number.NaN, c.unit);
        const kind = KINDS.has(c.name) ? this.kindOf(c.name, parts[0]) : "";
        const detail = parts.length > 1 ? `(${parts.map((p) => short(p, 3)).join(", ")})` : "";
        return el("tr", {}, el("td", {}, c.name), el("td", {}, kind || text, detail ? el("small", {}, detail) : null));
      });
    const groups = numbers.groups.length ? [named(numbers.groups.length > 1 ? "groups" : "group", numbers.groups.join(", "))] : [];
    this.blockBox.replaceChildren(
      el(
        "div.buttons.pickhead",
        {},
        el("b", {}, numbers.name || `block ${numbers.block}`),
        el("button", { type: "button", onclick: this.actions.history }, "history"),
        el("button", { type: "button", onclick: this.actions.unpick, title: "Deselect (Esc)" }, "clear"),
      ),
      el("table", {}, ...(numbers.name ? [named("number", String(numbers.block))] : []), ...groups, ...rows),
    );
  }
}

/** Fields that most people look at. */
export function quickFields(runs: Run[]): string[] {
  const names = new Set(runs.flatMap((r) => namesOf(r)));
  return [names.has("material") ? "material" : "", ...["displacement", "velocity"].filter((name) => names.has(name))];
}

/** Another field for the colours, with what goes with it. */
export function coloured(now: Settings, field: string): Partial<Settings> {
  return { field, map: defaultMap(field), log: false, rangeMode: now.rangeMode === "fixed" ? "most" : now.rangeMode };
}

function named(name: string, text: string): HTMLElement {
  return el("tr", {}, el("td", {}, name), el("td", {}, text));
}

function section(title: string, open: boolean, ...children: HTMLElement[]): HTMLElement {
  return el("details", { open }, el("summary", {}, title), ...children);
}

/** What ended how, with what. */
function aboutRun(run: Run, warnings: HTMLElement[]): HTMLElement {
  const { manifest: m, name } = run.summary;
  if (!m) return el("p.hint", {}, "This folder cannot be read.");
  const rows: [string, string][] = [
    ["folder", name],
    ["scene", m.scenario],
    ["case", [m.variant, m.case].filter((t, i, all) => t && t !== "default" && all.indexOf(t) === i).join(", ")],
    ["ended", m.ended + (m.message ? `: ${m.message}` : "")],
    ["model time", quantity(m.time, "s")],
    ["steps", m.steps.toLocaleString("en")],
    ["time step", quantity(m.dt, "s")],
    ["wall time", `${short(m.wall_time, 3)} s on ${m.threads} thread${m.threads === 1 ? "" : "s"}`],
    ["started", m.started.replace("T", " ").replace("Z", " UTC")],
    ["riprap", m.riprap],
    ["state hash", m.state_hash.slice(0, 16)],
  ];
  const files = ["scenario.resolved.toml", "manifest.json", "histories.csv", "energy.csv", "events.jsonl"];
  const links = files.flatMap((file) => {
    const href = run.source.file(file);
    return href ? [el("a", { href, target: "_blank", rel: "noopener" }, file), " "] : [];
  });
  return el(
    "div",
    {},
    el("table", {}, ...rows.filter(([, v]) => v).map(([k, v]) => el("tr", {}, el("td", {}, k), el("td", {}, v)))),
    ...(m.preview ? [] : warnings),
    el("p.files", {}, ...links),
  );
}
