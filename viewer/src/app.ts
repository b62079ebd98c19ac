// The page: head, pictures, panel, plots, bar of time, and what ties them together.

import { el, iconButton } from "./dom";
import * as film from "./film";
import { listen, sheet, type Shortcut } from "./keys";
import type { Loading } from "./loading";
import { legendElement, legendOf } from "./legend";
import { STATES } from "./marks";
import { labelElements, pinned } from "./notes";
import { Panel, coloured, quickFields } from "./panel";
import { Plots, namesOf, type AlongLine } from "./plots";
import { Run, told, type Moment } from "./run";
import { SavedViews } from "./saved";
import { Choices, type Settings } from "./settings";
import { defaultMap } from "./colour";
import { short, quantity } from "./format";
import type { Source } from "./source";
import { Timeline } from "./timeline";
import * as theme from "./theme";
import { View } from "./view";

/** A running run is asked for news this often, in ms. */
const NEWS = 1000;
/** Settings that need other answers, not only another drawing. */
const REFETCH: (keyof Settings)[] = ["field", "rangeMode", "vectors", "contacts", "cracks", "bolts", "chains", "stress", "supports", "joints"];

interface Pane {
  view: View;
  host: HTMLElement;
  legend: HTMLElement;
  banner: HTMLElement;
  head: HTMLElement;
  triad: HTMLElement;
  notes: HTMLElement;
}

export class App {
  private readonly choices = new Choices();
  private runs: Run[] = [];
  private panes: Pane[] = [];
  /** Those whose run gave no good answer when it was last asked for news. */
  private readonly silent = new Set<Pane>();
  private timeline!: Timeline;
  private panel: Panel | null = null;
  private plots: Plots | null = null;
  private readonly saved = new SavedViews(
    () => this.panes.map(({ view }) => view),
    this.choices,
    (text) => this.setMeasuring(true, text),
  );
  private readonly stages = el("div.stages");
  private readonly badge = el("span.badge");
  private readonly title = el("h1");
  /** Whether the next click is an end of the line. */
  private measuring = false;
  /** A text whose place the next click tells; empty: none. */
  private writing = "";
  private work: AbortController | null = null;

  constructor(
    private readonly host: HTMLElement,
    private readonly loading: Loading,
  ) {}

  async start(sources: Source[]): Promise<void> {
    this.runs = await Promise.all(sources.map((s) => Run.open(s)));
    const good = this.runs.filter((r) => !r.summary.problem);
    await Promise.all(good.map((r) => r.readModel()));
    this.chooseField(good);
    this.timeline = new Timeline(
      this.choices,
      (moment) => this.showMoment(moment),
      (moment) => {
        for (const { view } of this.panes) void view.prefetch(view.run.frameAt(moment), this.choices.now);
      },
    );
    this.layout(good);
    for (const { view } of this.panes) view.others = good.filter((run) => run !== view.run);
    this.timeline.setMoments(this.moments(good));
    this.refreshHead();
    if (good.some((r) => r.summary.live)) {
      this.timeline.following = true;
      this.news();
    }
    // What a run has come to is what people look for first; the start is often a uniform box. Its picture does not wait for the
    // values of all the other frames.
    for (const { view } of this.panes) view.hasty = true;
    await this.timeline.go(this.timeline.moments.length - 1);
    for (const pane of this.panes) this.refreshPane(pane);
    const [leader, ...others] = this.panes;
    if (leader) for (const other of others) other.view.stage.follow(leader.view.stage.standpoint());
    const flat = this.panes[0]?.view.flat ?? true;
    this.panel?.rebuild(flat ? 2 : 3);
    this.panel?.refill();
    document.documentElement.dataset.shown = "true";
    for (const { view } of this.panes) view.hasty = false;
    await this.timeline.go(this.timeline.at);
    await this.saved.load();
    document.documentElement.dataset.ready = "true";
  }

  private chooseField(runs: Run[]): void {
    const names = runs.flatMap((r) => namesOf(r));
    // A picture of removable blocks is looked at for them.
    if (names.includes("removable_type")) this.choices.now.field = "removable_type";
    // Runs of earlier versions do not tell materials: all blocks have shades of one colour then.
    if (!names.includes(this.choices.now.field)) this.choices.now.field = "";
    this.choices.now.map = defaultMap(this.choices.now.field);
  }

  private moments(runs: Run[]): Moment[] {
    const later = (a: Moment, b: Moment) => a.time - b.time || a.nth - b.nth;
    const all = runs.flatMap((r) => r.moments()).sort(later);
    return all.filter((m, i) => i === 0 || later(m, all[i - 1]!) > 0);
  }

  private layout(good: Run[]): void {
    for (const run of this.runs) {
      if (run.summary.problem) this.stages.append(problemCard(run.summary.name, run.summary.problem));
      else this.addPane(run);
    }
    const first = good[0];
    const dimension = first?.summary.fields.some((f) => f.components === 3) ? 3 : 2;
    this.panel = new Panel(this.runs, this.choices, this.actions(), this.saved, dimension);
    this.plots = new Plots(
      good,
      (x, bySteps) => void this.timeline.seek(x, bySteps),
      () => this.lines(),
    );
    const shortcuts = this.shortcuts();
    const keys = sheet(shortcuts);
    listen(shortcuts, this.host);
    const toggle = (name: string) => () => {
      this.host.classList.toggle(name);
      if (name === "with-plots") this.openPlots();
    };
    const header = el(
      "header",
      {},
      this.title,
      this.badge,
      el("span.spacer"),
      iconButton("camera", "Save a picture (s)", () => void this.save("picture")),
      iconButton("plots", "Histories (p)", toggle("with-plots")),
      iconButton("theme", "Light or dark (t)", () => this.flipTheme()),
      iconButton("help", "Keys and mouse (?)", () => keys.showModal()),
      iconButton("menu", "Panel (m)", toggle("no-panel")),
    );
    this.host.replaceChildren(header, el("main", {}, el("div.middle", {}, this.stages, this.plots.object), this.panel.object), this.timeline.object, keys, this.loading.object);
    if (window.innerWidth < 760) this.host.classList.add("no-panel");
    this.choices.listen((changed) => void this.changed(changed));
    theme.follow(() => this.themed());
    this.themed();
    if (good.length > 0 && first!.summary.tables[0] && window.innerHeight > 820 && window.innerWidth > 1100) {
      this.host.classList.add("with-plots");
      this.openPlots();
    }
  }

  private addPane(run: Run): void {
    const host = el("div.stage");
    const pane: Pane = {
      host,
      view: new View(run, host, this.loading),
      legend: el("div.legendhost"),
      banner: el("div.banner", { role: "alert", hidden: true }),
      head: el("div.panehead"),
      triad: el("div.triad", { "aria-hidden": "true" }),
      notes: el("div.notes"),
    };
    host.append(pane.notes, pane.head, pane.legend, pane.banner, pane.triad);
    this.stages.append(host);
    this.panes.push(pane);
    const { view } = pane;
    view.stage.onMove = (from) => {
      for (const other of this.panes) if (other !== pane) other.view.stage.follow(from);
    };
    view.stage.onDrawn = () => {
      drawTriad(pane);
      pane.notes.replaceChildren(...labelElements(view.labels()));
    };
    view.onChange = () => this.refreshPane(pane);
    let down: [number, number] | null = null;
    view.stage.canvas.addEventListener("pointerdown", (e) => (down = [e.clientX, e.clientY]));
    view.stage.canvas.addEventListener("pointerup", (e) => {
      // A click, not the end of a drag.
      if (down && Math.hypot(e.clientX - down[0], e.clientY - down[1]) < 5 && e.button === 0) {
        if (this.writing) this.write(view, e.clientX, e.clientY);
        else if (this.measuring) this.measure(view, e.clientX, e.clientY);
        else void this.pick(pane, view.pickAt(e.clientX, e.clientY));
      }
      down = null;
    });
    view.stage.canvas.addEventListener("webglcontextlost", (e) => {
      e.preventDefault();
      this.banner(pane, { what: "The browser has lost its graphics context.", hint: "Reload the page." });
    });
    if (run.frames === 0) this.banner(pane, noFrames(run));
  }

  /** Takes a place of the picture as an end of the line. */
  private measure(view: View, x: number, y: number): void {
    const place = view.placeAt(x, y);
    if (!place) return;
    const ends = view.ends.length === 1 ? [view.ends[0]!, place] : [place];
    this.layLine(ends);
    if (ends.length < 2) return;
    this.setMeasuring(false);
    this.host.classList.add("with-plots");
    void this.plots?.open("line");
  }

  /** The same line in all pictures: models that are compared lie in one place. */
  private layLine(ends: View["ends"]): void {
    for (const pane of this.panes) {
      pane.view.lay(ends);
      this.refreshPane(pane);
    }
    this.plots?.changed();
  }

  /** Puts the text that waits where a click was. */
  private write(view: View, x: number, y: number): void {
    const place = view.placeAt(x, y);
    if (!place || !view.blocks || !view.motion) return;
    this.saved.addNote(pinned(this.writing, place, view.pickAt(x, y), view.blocks, view.motion, this.choices.now.exaggeration));
    this.setMeasuring(false);
  }

  /** The next click tells a place: of the line, or of a text. */
  private setMeasuring(on: boolean, text = ""): void {
    this.measuring = on;
    this.writing = text;
    this.host.classList.toggle("measuring", on);
  }

  /** The field along the line in each picture. */
  private lines(): AlongLine[] {
    const { field } = this.choices.now;
    return this.panes.flatMap(({ view }) => {
      const { pieces, length } = view.along();
      if (!view.values || length === 0) return [];
      const parts = pieces.map((p) => ({ from: p.from * length, to: p.to * length, block: view.blocks!.ids[p.block]!, value: view.values![p.block]! }));
      return [{ run: view.run, field, unit: view.unit, length, parts }];
    });
  }

  private async showMoment(moment: Moment): Promise<void> {
    await Promise.all(this.panes.map(({ view }) => view.show(view.run.frameAt(moment), this.choices.now)));
    for (const pane of this.panes) this.refreshPane(pane);
    this.plots?.mark(moment);
    this.plots?.changed();
    const picked = this.panes.find((p) => p.view.picked !== null);
    if (picked && !this.timeline.playing) await this.showNumbers(picked);
  }

  private refreshPane(pane: Pane): void {
    const { view } = pane;
    pane.legend.replaceChildren(legendElement(legendOf(view, this.choices.now), view.scale));
    if (view.run.frames > 0) this.banner(pane, view.trouble ?? view.run.summary.note ?? unread(view.run));
    pane.host.classList.toggle("stale", view.trouble !== null);
    const { summary } = view.run;
    if (this.runs.length > 1) {
      const said = view.run.saidAt(view.frame);
      pane.head.replaceChildren(
        el("b", {}, summary.manifest.title || summary.name),
        el("span", {}, ` ${summary.name}${said ? ` · ${said}` : ""}`),
      );
    }
    view.stage.canvas.dataset.frame = String(view.frame);
    view.stage.canvas.dataset.faces = String(view.blocks?.visibleFaces ?? 0);
    view.stage.canvas.dataset.blocks = String(view.blocks?.count ?? 0);
    view.stage.canvas.dataset.cut = String(view.blocks?.cutBlocks ?? 0);
  }

  private banner(pane: Pane, problem: { what: string; hint: string } | null): void {
    pane.banner.hidden = problem === null;
    if (problem) pane.banner.replaceChildren(el("b", {}, problem.what), el("span", {}, problem.hint));
  }

  private async changed(changed: (keyof Settings)[]): Promise<void> {
    const now = this.choices.now;
    if (changed.some((c) => REFETCH.includes(c))) {
      // Of the frame that is wanted: another may be on its way.
      const wanted = this.timeline.moments[this.timeline.at];
      await Promise.all(this.panes.map(({ view }) => view.show(wanted ? view.run.frameAt(wanted) : Math.max(0, view.frame), now)));
      if (changed.includes("contacts") || changed.includes("chains")) this.panel?.refill();
    } else {
      for (const { view } of this.panes) view.apply(now, changed.includes("exaggeration"));
    }
    for (const pane of this.panes) this.refreshPane(pane);
    this.plots?.changed();
  }

  private async pick(pane: Pane, id: number | null): Promise<void> {
    for (const other of this.panes) other.view.pick(other === pane ? id : null);
    this.plots?.setPicked(pane.view.run, id);
    if (id === null) this.panel?.showBlock(null);
    else await this.showNumbers(pane);
  }

  private async showNumbers(pane: Pane): Promise<void> {
    const { view } = pane;
    if (view.picked === null) return;
    try {
      this.panel?.showBlock(await view.run.block(view.frame, view.picked));
    } catch (error) {
      const { what, hint } = told(error);
      this.panel?.showBlock(null, `${what.replace(/\.$/, "")}. ${hint}`);
    }
  }

  private openPlots(): void {
    if (this.host.classList.contains("with-plots")) void this.plots?.open(this.plots.tab);
  }

  private actions(): import("./panel").Actions {
    const first = () => this.panes[0]?.view;
    return {
      fit: (side) => {
        const view = first();
        view?.fit(side);
        if (view) for (const other of this.panes.slice(1)) other.view.stage.follow(view.stage.standpoint());
      },
      picture: () => void this.save("picture"),
      sequence: () => void this.save("sequence"),
      film: (container) => void this.save(container),
      niceExaggeration: () => Math.min(...this.panes.map(({ view }) => view.niceExaggeration())),
      unpick: () => {
        for (const pane of this.panes) void this.pick(pane, null);
      },
      goTo: (run, ids) => {
        const pane = this.panes.find((p) => p.view.run === run);
        if (!pane) return;
        pane.view.goTo(ids);
        for (const other of this.panes) if (other !== pane) other.view.stage.follow(pane.view.stage.standpoint());
        void this.pick(pane, ids[0] ?? null);
      },
      line: () => this.toggleLine(),
      history: () => {
        this.host.classList.add("with-plots");
        void this.plots?.open("block");
      },
      range: () => {
        const scale = first()?.scale;
        return scale ? [scale.low, scale.high] : [0, 1];
      },
      unshaded: () => this.panes.map(({ view }) => view.unshaded).find((why) => why !== "") ?? "",
      states: () => STATES.map((_, i) => this.panes.some(({ view }) => (view.between?.counts[i] ?? 0) > 0)),
    };
  }

  /** Saves pictures; a second call while one is at work stops it. */
  private async save(what: "picture" | "sequence" | film.Container): Promise<void> {
    const views = this.panes.filter((p) => p.view.blocks).map((p) => p.view);
    if (views.length === 0) return;
    if (this.work) {
      this.work.abort();
      return;
    }
    const work = new AbortController();
    this.work = work;
    const progress = (share: number) => {
      this.panel?.say(`${Math.round(100 * share)} %; choose it again to stop`);
      return !work.signal.aborted;
    };
    try {
      if (what === "picture") await film.picture(views, this.choices.now);
      else {
        const playing: film.Playing = [views, this.choices.now, this.timeline, this.saved.move()];
        if (what === "sequence") await film.sequence(playing, progress);
        else await film.film(playing, progress, what);
      }
      this.panel?.say(work.signal.aborted ? "stopped" : "saved");
    } catch (error) {
      this.panel?.say(told(error).what);
    } finally {
      this.work = null;
    }
  }

  private shortcuts(): Shortcut[] {
    const { choices, timeline } = this;
    const actions = this.actions();
    const times = (factor: number) => () =>
      choices.set({ exaggeration: Math.min(1e4, Math.max(1, Number((choices.now.exaggeration * factor).toPrecision(2)))) });
    const nextCut = () => {
      const all = ["", "x", "y", "z", "free"] as const;
      const clip = all.filter((axis) => axis !== "z" || this.panes.some(({ view }) => !view.flat));
      choices.set({ clipAxis: clip[(clip.indexOf(choices.now.clipAxis) + 1) % clip.length]! });
    };
    const nextField = () => {
      const all = quickFields(this.runs);
      const field = all[(all.indexOf(choices.now.field) + 1) % all.length];
      if (field !== undefined) choices.set(coloured(choices.now, field));
    };
    const nextJoints = () => {
      const all = ["", "set", "interface"] as const;
      choices.set({ joints: all[(all.indexOf(choices.now.joints) + 1) % all.length]! });
    };
    const moveCut = (by: number) => (shift: boolean) =>
      choices.set({ clipAt: Math.min(1, Math.max(0, Number((choices.now.clipAt + (shift ? 10 : 1) * by).toFixed(4)))) });
    return [
      { keys: [" "], label: "space", what: "play, pause", act: () => timeline.toggle() },
      { keys: ["ArrowLeft"], label: "←", what: "one frame back (shift: ten)", act: (shift: boolean) => timeline.step(shift ? -10 : -1) },
      { keys: ["ArrowRight"], label: "→", what: "one frame forward (shift: ten)", act: (shift: boolean) => timeline.step(shift ? 10 : 1) },
      { keys: ["Home"], label: "Home", what: "first frame", act: () => void timeline.go(0) },
      { keys: ["End"], label: "End", what: "last frame", act: () => void timeline.go(timeline.moments.length - 1) },
      { keys: ["g"], label: "g", what: "follow a run in progress", act: () => this.follow() },
      { keys: ["f"], label: "f", what: "all in view", act: () => actions.fit() },
      ...(["x", "y", "z"] as const).map((side, i) => ({
        keys: [String(i + 1)],
        label: String(i + 1),
        what: `look along ${side} (in space)`,
        act: () => actions.fit(side),
      })),
      { keys: ["e"], label: "e", what: "edges", act: () => choices.set({ edges: !choices.now.edges }) },
      { keys: ["y"], label: "y", what: "light and shadow (in space)", act: () => choices.set({ shadows: !choices.now.shadows }) },
      { keys: ["q"], label: "q", what: "colours: materials, displacement, velocity", act: nextField },
      { keys: ["u"], label: "u", what: "supports", act: () => choices.set({ supports: !choices.now.supports }) },
      { keys: ["h"], label: "h", what: "boundaries: held, moved, viscous, loaded faces (in space)", act: () => choices.set({ boundaries: !choices.now.boundaries }) },
      { keys: ["l"], label: "l", what: "loads: arrows", act: () => choices.set({ loads: !choices.now.loads }) },
      { keys: ["w"], label: "w", what: "water table", act: () => choices.set({ water: !choices.now.water }) },
      { keys: ["j"], label: "j", what: "joints: by set, by interface, not", act: nextJoints },
      { keys: ["c"], label: "c", what: "contacts", act: () => choices.set({ contacts: !choices.now.contacts }) },
      { keys: ["n"], label: "n", what: "force chains: tubes as thick as the contact force", act: () => choices.set({ chains: !choices.now.chains }) },
      { keys: ["k"], label: "k", what: "cracks (in space)", act: () => choices.set({ cracks: !choices.now.cracks }) },
      { keys: ["r"], label: "r", what: "bolts: rods, red in tension, blue in compression", act: () => choices.set({ bolts: !choices.now.bolts }) },
      { keys: ["i"], label: "i", what: "charges: stars where they are (in space)", act: () => choices.set({ charges: !choices.now.charges }) },
      { keys: ["a"], label: "a", what: "principal stresses as crosses", act: () => choices.set({ stress: !choices.now.stress }) },
      { keys: ["d"], label: "d", what: "distance, and the field along a line: click both ends (again: remove it)", act: () => this.toggleLine() },
      { keys: ["v"], label: "v", what: "velocity arrows", act: () => choices.set({ vectors: choices.now.vectors ? "" : "velocity" }) },
      { keys: ["x"], label: "x", what: "cut away: along x, y, z, any plane, nothing", act: nextCut },
      { keys: ["b"], label: "b", what: "cut flat, or whole blocks", act: () => choices.set({ clipFlat: !choices.now.clipFlat }) },
      { keys: ["o"], label: "o", what: "cut away the other side", act: () => choices.set({ clipFlip: !choices.now.clipFlip }) },
      { keys: [",", ";", "<"], label: ",", what: "cut back (shift: ten times as far)", act: moveCut(-0.01) },
      { keys: [".", ":", ">"], label: ".", what: "cut forward (shift: ten times as far)", act: moveCut(0.01) },
      { keys: ["["], label: "[", what: "less exaggeration", act: times(0.5) },
      { keys: ["]"], label: "]", what: "more exaggeration", act: times(2) },
      { keys: ["p"], label: "p", what: "histories", act: () => this.toggle("with-plots") },
      { keys: ["m"], label: "m", what: "panel", act: () => this.toggle("no-panel") },
      { keys: ["s"], label: "s", what: "save a picture", act: () => void this.save("picture") },
      { keys: ["t"], label: "t", what: "light, dark", act: () => this.flipTheme() },
      {
        keys: ["Escape"],
        label: "Esc",
        what: "deselect the block; no note after all",
        act: () => {
          if (this.writing) this.setMeasuring(false);
          actions.unpick();
        },
      },
      { keys: ["?"], label: "?", what: "this sheet", act: () => document.querySelector<HTMLDialogElement>("dialog.sheet")?.showModal() },
    ];
  }

  private toggleLine(): void {
    const there = this.measuring || this.panes.some(({ view }) => view.ends.length > 0);
    this.layLine([]);
    this.setMeasuring(!there);
  }

  private toggle(name: string): void {
    this.host.classList.toggle(name);
    this.openPlots();
  }

  private follow(): void {
    this.timeline.following = !this.timeline.following;
    this.refreshHead();
    if (this.timeline.following) void this.timeline.go(this.timeline.moments.length - 1);
  }

  /** Asks running runs for news until they end. After a bad answer what is there is kept and asked for again. */
  private news(): void {
    // One after the other, not at intervals: a slow answer would be asked for again before it has come.
    setTimeout(async () => {
      const good = this.panes.map((p) => p.view.run);
      const answers = await Promise.allSettled(good.map((r) => r.refresh()));
      if (answers.some((a) => a.status === "fulfilled" && a.value)) {
        // Another run has the folder: blocks, names and memory are all of the old one.
        location.reload();
        return;
      }
      const moments = this.moments(good);
      const more = moments.length !== this.timeline.moments.length;
      this.timeline.setMoments(moments);
      this.refreshHead();
      for (const pane of this.panes) if (pane.view.run.summary.manifest?.preview) this.refreshPane(pane);
      if (more) {
        if (this.timeline.following) await this.timeline.go(moments.length - 1);
        else for (const pane of this.panes) this.refreshPane(pane);
        for (const pane of this.panes) if (pane.view.run.frames === 0) this.banner(pane, noFrames(pane.view.run));
      }
      if (more && this.plots && this.plots.tab !== "block") this.openPlots();
      this.panes.forEach((pane, k) => this.answered(pane, answers[k]!));
      if (good.some((r) => r.summary.live)) this.news();
      else this.panel?.rebuild();
    }, NEWS);
  }

  /** Tells of a bad answer as long as no good one has come. */
  private answered(pane: Pane, answer: PromiseSettledResult<boolean>): void {
    if (answer.status === "rejected") {
      this.silent.add(pane);
      this.banner(pane, told(answer.reason));
    } else if (this.silent.delete(pane)) {
      if (pane.view.run.frames === 0) this.banner(pane, noFrames(pane.view.run));
      else this.refreshPane(pane);
    }
  }

  private refreshHead(): void {
    const first = this.runs[0]!;
    const { manifest, name } = first.summary;
    const titles = this.runs.map((r) => r.summary.manifest?.title || r.summary.name);
    this.title.textContent = [...new Set(titles)].join(" | ");
    this.title.title = name;
    document.title = `${titles[0]} – riprap`;
    const live = this.runs.some((r) => r.summary.live);
    const died = this.runs.some((r) => r.summary.died);
    const state = !manifest ? "unreadable" : manifest.preview ? "not run" : live ? "running" : died ? "unfinished" : manifest.ended;
    this.badge.textContent = live && this.timeline.following && !manifest?.preview ? "running, followed" : state;
    this.badge.className = `badge ${state}`;
    this.badge.title = !manifest
      ? ""
      : live
        ? `step ${manifest.steps.toLocaleString("en")}; g follows the newest frame`
        : died
          ? "The program that wrote this run has died. Its results so far are shown; riprap resume continues from the last checkpoint."
          : `${manifest.message || "all phases are complete"}; ${short(manifest.wall_time, 3)} s`;
  }

  private flipTheme(): void {
    theme.flip();
    this.themed();
  }

  /** Colours that the style sheet cannot reach. */
  private themed(): void {
    const style = getComputedStyle(document.documentElement);
    const paper = style.getPropertyValue("--paper").trim();
    const ink = style.getPropertyValue("--ink").trim();
    for (const { view } of this.panes) view.setTheme(paper, ink);
    this.plots?.retheme();
  }
}

function problemCard(name: string, problem: { what: string; hint: string }): HTMLElement {
  return el(
    "div.cardhost",
    {},
    el(
      "div.card.problem",
      { role: "alert" },
      el("h2", {}, `${name} cannot be shown`),
      el("p", {}, problem.what),
      el("p.hint", {}, problem.hint),
    ),
  );
}

/** What is wrong with a scene that was saved, while its last sound model is shown. */
function unread(run: Run): { what: string; hint: string } | null {
  const { preview, message } = run.summary.manifest ?? {};
  return preview && message ? { what: "The scene as saved cannot be shown.", hint: message } : null;
}

function noFrames(run: Run): { what: string; hint: string } {
  return run.summary.live
    ? { what: "No frame yet.", hint: "The run has started; the first frame will be shown when it is written." }
    : {
        what: "This run has no frames.",
        hint: "Request them in the scene and run it again: [[outputs]] frames = { every = \"10 ms\" }. Its histories are available (p).",
      };
}

/** The directions of the axes in the corner. */
function drawTriad(pane: Pane): void {
  const { view } = pane;
  if (!view.blocks) return;
  const ends = view.stage.triad();
  const names = view.flat ? ["x", "y"] : ["x", "y", "z"];
  const colours = ["#d9483b", "#2f9e57", "#3576d6"];
  const lines = names.map((n, i) => {
    const [x, y] = [32 + 24 * ends[i]![0], 32 - 24 * ends[i]![1]];
    const [tx, ty] = [32 + 30 * ends[i]![0], 32 - 30 * ends[i]![1]];
    return `<line x1="32" y1="32" x2="${x}" y2="${y}" stroke="${colours[i]}"/><text x="${tx}" y="${ty}" fill="${colours[i]}">${n}</text>`;
  });
  const perPixel = view.stage.metresPerPixel();
  const raw = 90 * perPixel;
  const power = 10 ** Math.floor(Math.log10(raw));
  const bar = ([5, 2, 1].find((k) => k * power <= raw) ?? 1) * power;
  pane.triad.innerHTML =
    `<svg viewBox="0 0 64 64" width="64" height="64">${lines.join("")}</svg>` +
    `<span class="bar" style="width:${(bar / perPixel).toFixed(1)}px">${quantity(bar, "m", 3)}</span>`;
}
