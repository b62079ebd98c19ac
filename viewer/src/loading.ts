// What the page waits for: one line and a bar, as soon as it takes longer than a blink.

import { el } from "./dom";

/** Something that is on its way. */
export interface Waiting {
  /** What, in words. */
  what: string;
  /** Of it, so much has come; both in bytes, frames or steps. */
  got: number;
  /** Null: not known yet. */
  of: number | null;
  unit: "bytes" | "frames";
  since: number;
}

/** Nothing is said of what comes sooner, ms. */
const BLINK = 250;

/** All that is on its way, and the sign that tells of it. */
export class Loading {
  readonly object = el("div.loading", { role: "status", "aria-live": "polite", hidden: true });
  private readonly all = new Set<Waiting>();
  private timer = 0;

  begin(what: string, unit: Waiting["unit"] = "bytes", of: number | null = null): Waiting {
    const one: Waiting = { what, got: 0, of, unit, since: performance.now() };
    this.all.add(one);
    if (!this.timer) this.timer = window.setInterval(() => this.say(), BLINK / 2);
    return one;
  }

  end(one: Waiting): void {
    this.all.delete(one);
    if (this.all.size > 0) return;
    clearInterval(this.timer);
    this.timer = 0;
    this.object.hidden = true;
  }

  /** Says what comes next and lets the browser show it, before work during which it shows nothing. */
  async announce(what: string): Promise<Waiting> {
    const one = this.begin(what);
    this.object.hidden = false;
    this.write(one);
    await new Promise((shown) => setTimeout(shown, 30));
    return one;
  }

  private say(): void {
    const now = performance.now();
    // Of several the largest: it is what takes the time.
    const [slowest] = [...this.all].filter((one) => now - one.since > BLINK).sort((a, b) => (b.of ?? 0) - (a.of ?? 0) || a.since - b.since);
    if (!slowest) return;
    this.object.hidden = false;
    this.write(slowest);
  }

  private write({ what, got, of, unit, since }: Waiting): void {
    const seconds = Math.floor((performance.now() - since) / 1000);
    const size = (n: number) => (unit === "bytes" ? (n / 1e6).toFixed(n < 1e7 ? 1 : 0) : String(n));
    const far = of === null ? (seconds > 1 ? `, ${seconds} s` : "") : `: ${size(got)} of ${size(of)} ${unit === "bytes" ? "MB" : "frames"}`;
    const bar = of === null ? null : el("progress", { max: of, value: got });
    this.object.replaceChildren(el("span", {}, `${what}${far}`), ...(bar ? [bar] : []));
  }
}

const NAMES: Record<string, string> = {
  summary: "the run",
  shape: "the shapes of the blocks",
  frame: "the places of the blocks",
  contacts: "the contacts",
  cracks: "the cracks",
  bolts: "the bolts",
  stress: "the stresses",
  conditions: "the conditions",
  names: "the names",
  table: "the histories",
};

/** What a question asks for, in words. */
export function wordsOf(question: string): string {
  const [head, rest = ""] = question.split(/[/?](.*)/s);
  const name = new URLSearchParams(question.split("?")[1] ?? "").get("name");
  if (name) return `Reading ${name}`;
  if (head === "block") return `Reading block ${rest.split("/")[1] ?? ""}`;
  return `Reading ${NAMES[head!] ?? question}`;
}
