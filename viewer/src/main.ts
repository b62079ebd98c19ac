// Puts the page together.

import "./style.css";
import { App } from "./app";
import { el } from "./dom";
import { Loading } from "./loading";
import { told } from "./run";
import { Held, Served, type Source } from "./source";
import { follow } from "./theme";

/** Runs that the page itself holds (a report), else those of the server. */
async function sources(): Promise<Source[]> {
  const held = document.getElementById("riprap-run");
  if (held?.textContent) {
    return [new Held(new Map(Object.entries(JSON.parse(held.textContent) as Record<string, string | { as: string }>)))];
  }
  const response = await fetch("api/runs");
  const { runs } = (await response.json()) as { runs: number };
  return Array.from({ length: runs }, (_, i) => new Served(i, loading));
}

follow();
const host = document.getElementById("app") ?? el("div");
const loading = new Loading();
host.append(loading.object);
try {
  await new App(host, loading).start(await sources());
} catch (error) {
  const { what, hint } = told(error);
  host.replaceChildren(el("div.card.problem", { role: "alert" }, el("h1", {}, "The viewer cannot start"), el("p", {}, what), el("p.hint", {}, hint)));
}
