// The legend on a picture: colours with numbers, arrows, contacts; as elements and drawn into exported pictures.

import { MAPS, TERRAIN, kindColour, type Scale } from "./colour";
import { el } from "./dom";
import { scaleFor, short, ticks, quantity } from "./format";
import { RULER } from "./line";
import { CHAINS, CHARGES, FACES, PRESSED, PULLED, STATES } from "./marks";
import type { Run } from "./run";
import type { Settings } from "./settings";
import { WARNED, type View } from "./view";

export interface LegendText {
  title: string;
  /** Places from 0 to 1 with their texts; kinds have a colour of their own. */
  marks: { at: number; text: string; colour?: string }[];
  kinds: boolean;
  notes: { text: string; colour?: string }[];
}

/** What the legend of a view says. */
export function legendOf(view: View, settings: Settings): LegendText {
  const { scale } = view;
  const out: LegendText = { title: "", marks: [], kinds: scale.kinds, notes: [] };
  const survey = view.blocks?.surveys ?? [];
  if (view.values && settings.field) {
    if (scale.kinds) {
      out.title = settings.field;
      const kinds = [...new Set(view.values)].filter(Number.isFinite).sort((a, b) => a - b);
      // Of more kinds two would have one colour.
      if (kinds.length <= 10) {
        const ground = settings.field === "material" ? survey.map((b) => view.values![b]!) : [];
        const colour = (k: number) => (ground.includes(k) ? TERRAIN : kindColour(k, settings.field));
        out.marks = kinds.map((k, i) => ({ at: i, text: kindName(view.run, settings.field, k), colour: colour(k) }));
      }
    } else {
      const unit = scaleFor(Math.max(Math.abs(scale.low), Math.abs(scale.high)), view.unit);
      out.title = settings.field + (unit.unit ? ` [${unit.unit}]` : "");
      out.marks = marksOf(scale, unit.factor);
      const beyond = view.values.filter((v) => scale.isBeyond(v)).length;
      if (beyond > 0) out.notes.push({ text: `${beyond} block${beyond === 1 ? "" : "s"} beyond` });
    }
  }
  if (survey.length > 0 && !scale.kinds) out.notes.push({ text: "ground, without the field", colour: TERRAIN });
  if (view.warned > 0) out.notes.push({ text: `${view.warned} block${view.warned === 1 ? "" : "s"} with warnings`, colour: WARNED });
  if (view.supports !== null) out.notes.push({ text: `${view.supports} held or moved`, colour: "#2f7bd9" });
  if (view.supports !== null && view.driven > 0) out.notes.push({ text: `${view.driven} of them driven`, colour: "#e07b1a" });
  out.notes.push(...view.conditionNotes);
  const charges = (view.run.summary.manifest.sources ?? []).map((s) => s.name);
  if (settings.charges && charges.length > 0) {
    out.notes.push({ text: charges.length === 1 ? `charge ${charges[0]!}` : `${charges.length} charges`, colour: CHARGES });
  }
  if (view.boltForces && view.boltForces.largest !== null) {
    const { largest, smallest, unit } = view.boltForces;
    out.notes.push({ text: `bolts up to ${quantity(largest, unit, 3)}`, colour: "#d01c1c" });
    if (smallest !== null && smallest < 0) out.notes.push({ text: `bolts down to ${quantity(smallest, unit, 3)}`, colour: "#1d5fd0" });
  }
  if (view.chained) {
    const { count, longest, unit } = view.chained;
    out.notes.push({ text: `${count === 1 ? "force of 1 contact" : `forces of ${count} contacts`} up to ${quantity(longest, unit, 3)}`, colour: CHAINS });
  }
  if (view.trailed) {
    const { count, fastest, left } = view.trailed;
    const of = `trail${count === 1 ? "" : "s"} of ${count} block${count === 1 ? "" : "s"}${left > 0 ? ` (${left} more)` : ""}`;
    out.notes.push(settings.trailColour === "speed" && fastest > 0 ? { text: `${of}, up to ${quantity(fastest, "m/s", 3)}`, colour: MAPS.turbo!(0.95) } : { text: of });
  }
  if (view.stressShown?.range) {
    const { range: [low, high], longest, unit, beyond } = view.stressShown;
    if (low < 0) out.notes.push({ text: `compression up to ${quantity(-low, unit, 3)}`, colour: PRESSED });
    if (high > 0) out.notes.push({ text: `tension up to ${quantity(high, unit, 3)}`, colour: PULLED });
    if (longest !== null) out.notes.push({ text: `longest cross ${quantity(longest, unit, 3)}${beyond > 0 ? `, ${beyond} beyond` : ""}` });
  }
  if (view.arrow && settings.vectors) {
    out.notes.push({ text: `longest ${settings.vectors} ${quantity(view.arrow.longest, view.arrow.unit, 3)}` });
  }
  if (settings.exaggeration !== 1) out.notes.push({ text: `displacements × ${short(settings.exaggeration)}` });
  const line = view.lineText();
  if (line) out.notes.push({ text: line, colour: RULER });
  const cut = view.cutText(settings);
  if (cut) out.notes.push({ text: cut });
  const { between } = view;
  if (between && (settings.contacts || settings.cracks)) {
    STATES.forEach((state, i) => {
      const drawn = (settings.contacts && settings.states[i]) || (settings.cracks && !view.flat && i >= FACES);
      const count = between.counts[i]!;
      if (!drawn || (count === 0 && i > 1)) return;
      const unit = between.unit === "m2" ? "m²" : between.unit;
      const area = i >= FACES ? ` (${short(between.areas[i]!, 3)} ${unit})` : "";
      out.notes.push({ text: `${state.name} ${count}${area}`, colour: state.colour });
    });
  }
  return out;
}

/** What a value of a field of kinds means. */
export function kindName(run: Run, field: string, value: number): string {
  switch (field) {
    case "block":
      return run.called(value);
    case "material":
      return run.summary.manifest.materials?.[value] ?? short(value);
    case "held":
      return value > 0 ? "held or driven" : "free";
    case "surface":
      return value > 0 ? "at the surface" : "inside";
    case "removable_type":
      return ["inside, or ground", "key block", "held by strength", "held by weight", "tapered"][value] ?? short(value);
    case "removable_mode":
      return ["not removable", "stays", "slides on one plane", "slides on two planes", "falls"][value] ?? short(value);
    case "level":
      return value > 0 ? `split ${short(value)} times` : "not split";
    default:
      return short(value);
  }
}

function marksOf(scale: Scale, factor: number): LegendText["marks"] {
  const { low, high } = scale;
  if (scale.log) {
    const decades: LegendText["marks"] = [];
    const from = Math.ceil(Math.log10(low) - 1e-9);
    const to = Math.floor(Math.log10(high) + 1e-9);
    const step = Math.max(1, Math.ceil((to - from) / 5));
    for (let k = from; k <= to; k += step) {
      const at = (k - Math.log10(low)) / (Math.log10(high) - Math.log10(low));
      decades.push({ at, text: short(10 ** k * factor, 3) });
    }
    return decades;
  }
  const round = ticks(low * factor, high * factor, 4);
  return round.map((v) => ({ at: (v / factor - low) / (high - low), text: short(v, 4) }));
}

/** The legend as an element. */
export function legendElement(text: LegendText, scale: Scale): HTMLElement {
  const box = el("div.legend");
  if (text.title) box.append(el("div.title", {}, text.title));
  if (text.kinds) {
    for (const mark of text.marks) {
      const chip = el("i.chip");
      chip.style.background = mark.colour ?? "";
      box.append(el("div.note", {}, chip, mark.text));
    }
  } else if (text.marks.length > 0) {
    const strip = el("div.strip");
    const stops = Array.from({ length: 17 }, (_, i) => scale.css(i / 16));
    strip.style.background = `linear-gradient(to top, ${stops.join(",")})`;
    const scaleBox = el("div.scale", {}, strip);
    for (const mark of text.marks) {
      const tick = el("span.tick", {}, mark.text);
      tick.style.bottom = `${100 * mark.at}%`;
      scaleBox.append(tick);
    }
    box.append(scaleBox);
  }
  for (const note of text.notes) {
    const chip = note.colour ? el("i.chip") : null;
    if (chip) chip.style.background = note.colour!;
    box.append(el("div.note", {}, chip, note.text));
  }
  return box;
}

/** The legend drawn into a picture; `x`, `y`: its upper left corner, `wide`: its room; longer lines are narrowed, `s`: pixels per unit. */
export function paintLegend(
  ctx: CanvasRenderingContext2D,
  text: LegendText,
  scale: Scale,
  [x, y, wide]: [number, number, number],
  s: number,
  ink: string,
): void {
  ctx.textBaseline = "middle";
  ctx.font = `600 ${12 * s}px system-ui, sans-serif`;
  ctx.fillStyle = ink;
  let line = y + 10 * s;
  if (text.title) {
    ctx.fillText(text.title, x, line, wide);
    line += 16 * s;
  }
  ctx.font = `${11 * s}px system-ui, sans-serif`;
  const chip = (colour: string) => {
    ctx.fillStyle = colour;
    ctx.fillRect(x, line - 5 * s, 10 * s, 10 * s);
    ctx.fillStyle = ink;
  };
  if (text.kinds) {
    for (const mark of text.marks) {
      chip(mark.colour ?? ink);
      ctx.fillText(mark.text, x + 16 * s, line, wide - 16 * s);
      line += 15 * s;
    }
  } else if (text.marks.length > 0) {
    const tall = 140 * s;
    const gradient = ctx.createLinearGradient(0, line + tall, 0, line);
    for (let i = 0; i <= 16; i++) gradient.addColorStop(i / 16, scale.css(i / 16));
    ctx.fillStyle = gradient;
    ctx.fillRect(x, line, 14 * s, tall);
    ctx.fillStyle = ink;
    for (const mark of text.marks) ctx.fillText(mark.text, x + 20 * s, line + tall * (1 - mark.at));
    line += tall + 14 * s;
  }
  for (const note of text.notes) {
    if (note.colour) chip(note.colour);
    const from = note.colour ? 16 * s : 0;
    ctx.fillText(note.text, x + from, line, wide - from);
    line += 15 * s;
  }
}
