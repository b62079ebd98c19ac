// Histories below the picture: one plot per unit, with a line at the time of the frame.

import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { choice, el, save } from "./dom";
import { short } from "./format";
import type { Field, Moment, Run, Table } from "./run";

const COLOURS = ["#2f7ed8", "#e4572e", "#2a9d5c", "#9a5fc9", "#d99a1c", "#17a2b0", "#c2448d", "#7a7f87"];

interface Curve {
  name: string;
  unit: string;
  x: ArrayLike<number>;
  bySteps: boolean;
  values: ArrayLike<number | null>;
  dash: boolean;
  /** Along a line of the picture, in m, and no history: of which run. */
  along?: string;
}

type Tab = "histories" | "energy" | "block" | "line";

/** A field along the line of one picture. */
export interface AlongLine {
  run: Run;
  field: string;
  unit: string;
  /** m. */
  length: number;
  /** Ends from the start of the line, m, number of the block, value. */
  parts: { from: number; to: number; block: number; value: number }[];
}

export class Plots {
  readonly object: HTMLElement;
  tab: Tab = "histories";
  private now: Moment | null = null;
  private readonly body = el("div.charts");
  private readonly bar = el("div.tabs", { role: "tablist" });
  private readonly extra = el("span.extra");
  private plots: uPlot[] = [];
  private curves: Curve[] = [];
  private blockField = "displacement";
  private picked: { run: Run; id: number } | null = null;
  private stamp = 0;

  constructor(
    private readonly runs: Run[],
    private readonly seek: (x: number, bySteps: boolean) => void,
    private readonly lines: () => AlongLine[],
  ) {
    this.object = el("section.plots", { "aria-label": "histories" }, el("div.plothead", {}, this.bar, this.extra), this.body);
    new ResizeObserver(() => this.resize()).observe(this.body);
    this.tabs();
  }

  private tabs(): void {
    const tabs: [Tab, string][] = [
      ["histories", "Histories"],
      ["energy", "Energy"],
      ["block", "Block"],
      ["line", "Line"],
    ];
    this.bar.replaceChildren(
      ...tabs.map(([tab, label]) =>
        el(
          "button",
          { role: "tab", type: "button", "aria-selected": String(tab === this.tab), onclick: () => void this.open(tab) },
          label,
        ),
      ),
    );
  }

  /** Shows one of the kinds of histories, read anew. */
  async open(tab: Tab): Promise<void> {
    this.tab = tab;
    this.tabs();
    const stamp = ++this.stamp;
    this.extra.replaceChildren();
    if (tab === "block") return this.openBlock(stamp);
    if (tab === "line") return this.openLine();
    const tables = await Promise.all(this.runs.map((run) => run.table(tab).catch(() => null)));
    if (stamp !== this.stamp) return;
    this.curves = tables.flatMap((table, i) => (table ? curvesOf(table, i > 0) : []));
    const none =
      tab === "histories"
        ? "This run recorded no histories. Request them in the scene: [[outputs]] history = { field = \"...\" }"
        : "This run has no energy.csv.";
    this.draw(none);
  }

  /** The block whose history is wanted. */
  setPicked(run: Run, id: number | null): void {
    this.picked = id === null ? null : { run, id };
    if (this.tab === "block") void this.open("block");
  }

  private async openBlock(stamp: number): Promise<void> {
    this.curves = [];
    if (!this.picked) return this.draw("Pick a block in the picture to see its history.");
    const { run, id } = this.picked;
    const names = namesOf(run);
    if (!names.includes(this.blockField)) this.blockField = names[0] ?? "";
    this.extra.replaceChildren(
      el("span", {}, `${run.called(id)}: `),
      choice(
        names.map((n) => [n, n]),
        this.blockField,
        (name) => {
          this.blockField = name;
          void this.open("block");
        },
        "field of the block",
      ),
    );
    this.draw("Reading the frames …");
    const moments = run.moments();
    const bySteps = moments.length > 1 && moments.every((m) => m.time === moments[0]!.time);
    await run.history(id, this.blockField, (values, unit) => {
      if (stamp !== this.stamp) return false;
      const x = moments.slice(0, values.length).map((m) => (bySteps ? m.step : m.time));
      this.curves = [{ name: this.blockField, unit, x, bySteps, values: [...values], dash: false }];
      this.draw("");
      return true;
    });
  }

  /** Another frame, field or line. */
  changed(): void {
    if (this.tab === "line" && this.object.offsetParent !== null) this.openLine();
  }

  private openLine(): void {
    const lines = this.lines();
    this.extra.replaceChildren();
    if (lines.some((l) => l.parts.length > 0)) {
      this.extra.append(
        el("button", { type: "button", title: "The values as a table (CSV)", onclick: () => save(new Blob([csvOf(lines)], { type: "text/csv" }), csvName(lines)) }, "CSV"),
      );
    }
    this.curves = lines.filter((l) => l.parts.length > 0).map(curveAlong);
    this.draw("Press d and click two points of the picture to see the field along the line between them.");
  }

  /** Moves the line. */
  mark(now: Moment): void {
    this.now = now;
    for (const plot of this.plots) plot.redraw(false);
  }

  private draw(none: string): void {
    for (const plot of this.plots) plot.destroy();
    this.plots = [];
    this.body.replaceChildren();
    if (this.curves.length === 0) {
      this.body.append(el("p.hint", {}, none));
      return;
    }
    const groups = new Map<string, Curve[]>();
    for (const curve of this.curves) {
      const key = `${curve.unit === "-" ? `- ${curve.name}` : curve.unit} ${curve.bySteps} ${curve.along ?? ""}`;
      groups.set(key, [...(groups.get(key) ?? []), curve]);
    }
    for (const curves of groups.values()) this.body.append(this.one(curves));
    this.resize();
  }

  private one(curves: Curve[]): HTMLElement {
    const unit = curves[0]!.unit === "-" ? "" : curves[0]!.unit;
    const { bySteps, along } = curves[0]!;
    const host = el("figure.chart", {});
    const style = getComputedStyle(document.documentElement);
    const ink = style.getPropertyValue("--ink2").trim();
    const grid = style.getPropertyValue("--line").trim();
    const accent = style.getPropertyValue("--accent").trim();
    const names = [...new Set(curves.map((c) => c.name))];
    const log = curves.every((c) => /unbalanced/.test(c.name));
    const values = (_: uPlot, all: number[]) => all.map((v) => (v === null ? "" : short(v)));
    const options: uPlot.Options = {
      width: 300,
      height: 180,
      title: (along ? `${along}` : "") + (names.length === 1 ? names[0] + (unit ? ` [${unit}]` : "") : unit ? `[${unit}]` : ""),
      cursor: { sync: { key: along === undefined ? "riprap" : "riprap line" }, drag: { x: true, y: false } },
      legend: { live: true },
      scales: { x: { time: false }, y: log ? { distr: 3 } : {} },
      axes: [
        { stroke: ink, grid: { stroke: grid, width: 1 }, ticks: { stroke: grid, width: 1 }, size: 28, values },
        { stroke: ink, grid: { stroke: grid, width: 1 }, ticks: { stroke: grid, width: 1 }, size: 62, values },
      ],
      series: [
        { label: along !== undefined ? "distance [m]" : bySteps ? "step" : "time [s]", value: (_, v) => (v === null ? "–" : short(v)) },
        ...curves.map((c, i) => ({
          label: c.dash ? `${c.name} (2)` : c.name,
          stroke: COLOURS[names.indexOf(c.name) % COLOURS.length] ?? COLOURS[i % COLOURS.length]!,
          width: 1.4,
          ...(c.dash ? { dash: [6, 4] } : {}),
          points: { show: c.x.length < 40 && along === undefined, size: 4 },
          // Along a line there is nothing between blocks; a history goes on over rows without its value.
          spanGaps: along === undefined,
          value: (_: uPlot, v: number | null) => (v === null || v === undefined ? "–" : short(v)),
        })),
      ],
      hooks: {
        draw: [
          (u) => {
            if (along !== undefined) return;
            const x = u.valToPos((bySteps ? this.now?.step : this.now?.time) ?? 0, "x", true);
            const { left, top, width, height } = u.bbox;
            if (x < left || x > left + width) return;
            u.ctx.save();
            u.ctx.strokeStyle = accent;
            u.ctx.setLineDash([]);
            u.ctx.lineWidth = 1.5 * devicePixelRatio;
            u.ctx.beginPath();
            u.ctx.moveTo(x, top);
            u.ctx.lineTo(x, top + height);
            u.ctx.stroke();
            u.ctx.restore();
          },
        ],
      },
    };
    const plot = new uPlot(options, joined(curves, log), host);
    plot.over.addEventListener("click", () => {
      const { left } = plot.cursor;
      if (along === undefined && left !== undefined && left !== null && left >= 0) this.seek(plot.posToVal(left, "x"), bySteps);
    });
    this.plots.push(plot);
    return host;
  }

  private resize(): void {
    const charts = this.plots.length;
    if (charts === 0) return;
    const wide = this.body.clientWidth;
    const across = Math.max(1, Math.min(charts, Math.floor(wide / 300)));
    const width = Math.floor((wide - 24) / across) - 12;
    const tall = charts > across ? 190 : Math.max(150, this.body.clientHeight - 66);
    for (const plot of this.plots) plot.setSize({ width, height: Math.min(tall, 320) });
  }

  /** Colours follow the theme. */
  retheme(): void {
    if (this.curves.length > 0) this.draw("");
  }
}

/** Steps from block to block, with gaps where there is none. */
function curveAlong({ run, field, unit, parts }: AlongLine, _: number, all: AlongLine[]): Curve {
  const x: number[] = [];
  const values: (number | null)[] = [];
  parts.forEach(({ from, to, value }, k) => {
    if (k > 0 && from > parts[k - 1]!.to * (1 + 1e-9)) {
      x.push(0.5 * (parts[k - 1]!.to + from));
      values.push(null);
    }
    x.push(from, to);
    values.push(value, value);
  });
  const along = all.length > 1 ? `${run.summary.name}: ` : "";
  return { name: field, unit, x, bySteps: false, values, dash: false, along };
}

/** Text as a cell of a table. */
function quoted(text: string): string {
  return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

function csvOf(lines: AlongLine[]): string {
  const { field, unit } = lines[0]!;
  const many = lines.length > 1;
  const head = [...(many ? ["run"] : []), "from [m]", "to [m]", "block", "name", unit === "-" ? field : `${field} [${unit}]`];
  const rows = lines.flatMap(({ run, parts }) =>
    parts.map((p) => [...(many ? [quoted(run.summary.name)] : []), p.from, p.to, p.block, quoted(run.called(p.block)), p.value].join(",")),
  );
  return [head.join(","), ...rows, ""].join("\n");
}

function csvName(lines: AlongLine[]): string {
  return `${lines[0]!.run.summary.name.replace(/\.run$/, "")}_${lines[0]!.field}_line.csv`;
}

function curvesOf(table: Table, dash: boolean): Curve[] {
  return table.names.map((name, i) => ({
    name,
    unit: table.units[i]!,
    x: table.x,
    bySteps: table.bySteps,
    values: table.columns[i]!,
    dash,
  }));
}

/** Names of the fields of a run. */
export function namesOf(run: Run): string[] {
  return run.summary.names ?? fieldNames(run.summary.fields ?? []);
}

/** Names of numbers among fields: parts of vectors one by one. */
function fieldNames(fields: Field[]): string[] {
  return fields.flatMap((f) =>
    f.components === 1
      ? [f.name]
      : [f.name, ...["x", "y", "z"].slice(0, f.components).map((part) => `${f.name}.${part}`)],
  );
}

/** Curves over one time axis, gaps where one has no value. */
function joined(curves: Curve[], positive: boolean): uPlot.AlignedData {
  const tables = curves.map((c): uPlot.AlignedData => {
    const time = Array.from(c.x);
    const values = Array.from(c.values, (v) => (v === null || !Number.isFinite(v) || (positive && v <= 0) ? null : v));
    return [time, values];
  });
  const first = curves[0]!.x;
  if (curves.every((c) => c.x === first)) {
    return [tables[0]![0], ...tables.map((t) => t[1]!)] as uPlot.AlignedData;
  }
  return uPlot.join(tables);
}
