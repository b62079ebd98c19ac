// The bar below: play, step, scrub.

import { choice, el, icon, iconButton } from "./dom";
import { saidOf, type Moment } from "./run";
import type { Choices } from "./settings";

export class Timeline {
  readonly object: HTMLElement;
  /** What can be shown, ascending. */
  moments: Moment[] = [];
  at = 0;
  playing = false;
  /** Stay at the newest frame of a run that goes on. */
  following = false;
  private readonly slider: HTMLInputElement;
  private readonly label: HTMLElement;
  private readonly playButton: HTMLButtonElement;
  private busy = false;
  private wanted: number | null = null;

  constructor(
    private readonly choices: Choices,
    /** Shows the frame at a moment and resolves when it stands. */
    private readonly show: (moment: Moment) => Promise<void>,
    /** Called before the next frame is due, to have it ready. */
    private readonly ahead: (moment: Moment) => void,
  ) {
    this.slider = el("input.scrub", { type: "range", min: "0", max: "0", step: "1", value: "0", "aria-label": "time" });
    this.slider.addEventListener("input", () => {
      this.pause();
      this.following = false;
      void this.go(Number(this.slider.value));
    });
    this.label = el("output.time", { "aria-live": "off" });
    this.playButton = iconButton("play", "Play (space)", () => this.toggle());
    this.playButton.classList.add("primary");
    const speeds: [string, string][] = [1, 2, 5, 10, 20, 30].map((n) => [String(n), `${n}/s`]);
    const speed = choice(speeds, String(choices.now.speed), (v) => choices.set({ speed: Number(v) }), "frames per second");
    speed.title = "Frames per second";
    this.object = el(
      "div.timeline",
      {},
      iconButton("first", "First frame (Home)", () => void this.go(0)),
      iconButton("back", "One frame back (←)", () => this.step(-1)),
      this.playButton,
      iconButton("next", "One frame forward (→)", () => this.step(1)),
      iconButton("last", "Last frame (End)", () => void this.go(this.moments.length - 1)),
      this.slider,
      this.label,
      speed,
    );
  }

  setMoments(moments: Moment[]): void {
    this.moments = moments;
    this.slider.max = String(Math.max(0, moments.length - 1));
    this.object.classList.toggle("empty", moments.length === 0);
    this.say();
  }

  private say(): void {
    const moment = this.moments[this.at];
    const said = moment ? saidOf(moment) : "";
    this.slider.value = String(this.at);
    this.label.replaceChildren(
      el("b", { title: said }, said || "no frames"),
      el("small", {}, this.moments.length ? `${this.at + 1} of ${this.moments.length}` : ""),
    );
    this.slider.setAttribute("aria-valuetext", said);
  }

  /** Goes to a place. Calls that come while one is under way are joined: only the last counts. */
  async go(at: number): Promise<void> {
    const last = this.moments.length - 1;
    this.at = Math.min(Math.max(0, at), Math.max(0, last));
    this.say();
    if (last < 0) return;
    if (this.busy) {
      this.wanted = this.at;
      return;
    }
    this.busy = true;
    try {
      await this.show(this.moments[this.at]!);
    } finally {
      this.busy = false;
    }
    if (this.wanted !== null) {
      const next = this.wanted;
      this.wanted = null;
      if (next !== at) await this.go(next);
    }
  }

  /** The place nearest to a time, or to a step. */
  async seek(x: number, bySteps: boolean): Promise<void> {
    const far = (m: Moment) => Math.abs((bySteps ? m.step : m.time) - x);
    let best = 0;
    this.moments.forEach((m, i) => {
      if (far(m) < far(this.moments[best]!)) best = i;
    });
    this.following = false;
    await this.go(best);
  }

  step(by: number): void {
    this.pause();
    this.following = false;
    void this.go(this.at + by);
  }

  toggle(): void {
    if (this.playing) this.pause();
    else void this.play();
  }

  pause(): void {
    this.playing = false;
    this.face();
  }

  private face(): void {
    this.playButton.replaceChildren(icon(this.playing ? "pause" : "play"));
    const label = this.playing ? "Pause (space)" : "Play (space)";
    this.playButton.title = label;
    this.playButton.setAttribute("aria-label", label);
  }

  async play(): Promise<void> {
    if (this.playing || this.moments.length < 2) return;
    this.playing = true;
    this.following = false;
    this.face();
    if (this.at >= this.moments.length - 1) await this.go(0);
    while (this.playing) {
      const begun = performance.now();
      if (this.at >= this.moments.length - 1 && !this.choices.now.loop) break;
      const next = (this.at + 1) % this.moments.length;
      for (const k of [1, 2]) {
        const moment = this.moments[(next + k) % this.moments.length];
        if (moment !== undefined) this.ahead(moment);
      }
      await this.go(next);
      // The browser draws in between; what is left of the frame's share is slept.
      await new Promise((done) => requestAnimationFrame(done));
      const rest = 1000 / this.choices.now.speed - (performance.now() - begun);
      if (rest > 1) await new Promise((done) => setTimeout(done, rest));
    }
    this.pause();
  }
}
