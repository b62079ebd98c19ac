// Keyboard shortcuts, and the sheet that lists them.

import { el } from "./dom";

export interface Shortcut {
  keys: string[];
  label: string;
  what: string;
  act: (shift: boolean) => void;
}

/** `host`: where the keys count; in a report only while the pointer or the focus is in it. */
export function listen(shortcuts: Shortcut[], host: HTMLElement): void {
  const by = new Map(shortcuts.flatMap((s) => s.keys.map((k) => [k, s] as const)));
  document.addEventListener("keydown", (event) => {
    // An open sheet has its own keys: Esc closes it.
    if (document.querySelector("dialog[open]")) return;
    const inside = host.matches(":hover") || host.contains(document.activeElement);
    if (host.classList.contains("replay") && !inside) return;
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const target = event.target as HTMLElement;
    const typing = target instanceof HTMLSelectElement || (target instanceof HTMLInputElement && ["number", "text"].includes(target.type));
    if (typing) return;
    // A slider or button keeps the keys that move or press it.
    const slider = target instanceof HTMLInputElement && target.type === "range";
    if (slider && event.key.startsWith("Arrow")) return;
    if (target instanceof HTMLButtonElement && (event.key === " " || event.key === "Enter")) return;
    const found = by.get(event.key.length === 1 ? event.key.toLowerCase() : event.key);
    if (!found) return;
    event.preventDefault();
    found.act(event.shiftKey);
  });
}

/** A sheet over the page with all shortcuts. */
export function sheet(shortcuts: Shortcut[]): HTMLDialogElement {
  const dialog = el("dialog.sheet", { "aria-label": "keyboard shortcuts" });
  const rows = shortcuts.map((s) => el("tr", {}, el("td", {}, el("kbd", {}, s.label)), el("td", {}, s.what)));
  const mouse: [string, string][] = [
    ["drag", "rotate (in the plane: move)"],
    ["right drag", "move"],
    ["wheel, pinch", "zoom"],
    ["click", "pick a block; after d an end of the line"],
    ["click in a plot", "go to that time"],
  ];
  dialog.append(
    el("h2", {}, "Keys and mouse"),
    el("div.columns", {}, el("table", {}, ...rows), el("table", {}, ...mouse.map(([a, b]) => el("tr", {}, el("td", {}, el("kbd", {}, a)), el("td", {}, b))))),
    el("button", { type: "button", onclick: () => dialog.close() }, "Close"),
  );
  dialog.addEventListener("click", (event) => {
    if (event.target === dialog) dialog.close();
  });
  return dialog;
}
