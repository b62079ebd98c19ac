// Small help with the document.

type Child = Node | string | null | undefined;

/** An element: `el("button.wide", { onclick }, "Play")`. */
export function el<K extends keyof HTMLElementTagNameMap>(
  tag: K | `${K}.${string}`,
  properties: Record<string, unknown> = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const [name, ...classes] = tag.split(".");
  const node = document.createElement(name as K);
  if (classes.length > 0) node.className = classes.join(" ");
  for (const [key, value] of Object.entries(properties)) {
    if (key.startsWith("on") && typeof value === "function") {
      node.addEventListener(key.slice(2), value as EventListener);
    } else if (key in node && !key.startsWith("aria") && key !== "for") {
      (node as unknown as Record<string, unknown>)[key] = value;
    } else if (value !== undefined && value !== false) {
      node.setAttribute(key, String(value));
    }
  }
  node.append(...children.filter((c): c is Node | string => c !== null && c !== undefined));
  return node;
}

/** A labelled row of the panel. */
export function row(label: string, ...controls: Child[]): HTMLElement {
  return el("label.row", {}, el("span.name", {}, label), el("span.controls", {}, ...controls));
}

export function check(label: string, on: boolean, change: (on: boolean) => void, title = ""): HTMLLabelElement {
  const box = el("input", { type: "checkbox", checked: on, onchange: () => change(box.checked) });
  return el("label.check", { title }, box, el("span", {}, label));
}

export function choice(
  options: [value: string, label: string][],
  value: string,
  change: (value: string) => void,
  label: string,
): HTMLSelectElement {
  const list = el("select", { onchange: () => change(list.value), "aria-label": label });
  for (const [v, text] of options) list.append(el("option", { value: v }, text));
  list.value = value;
  return list;
}

/** Offers a file for saving. */
export function save(data: Blob, name: string): void {
  const url = URL.createObjectURL(data);
  const link = el("a", { href: url, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  // The browser begins to read after the click, and does not say when it has.
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

const ICONS: Record<string, string> = {
  play: "M7 4l13 8-13 8z",
  pause: "M6 4h4v16H6zM14 4h4v16h-4z",
  first: "M6 5h2v14H6zM20 5v14L9 12z",
  last: "M16 5h2v14h-2zM4 5v14l11-7z",
  back: "M17 5v14L7 12z",
  next: "M7 5v14l10-7z",
  fit: "M4 9V4h5v2H6v3zM15 4h5v5h-2V6h-3zM4 15h2v3h3v2H4zM18 15h2v5h-5v-2h3z",
  menu: "M4 6h16v2H4zM4 11h16v2H4zM4 16h16v2H4z",
  theme: "M12 3a9 9 0 1 0 9 9 7 7 0 0 1-9-9z",
  help: "M11 17h2v2h-2zM12 4a5 5 0 0 0-5 5h2a3 3 0 1 1 4.6 2.5C12.2 12.4 11 13.3 11 15h2c0-1 .7-1.500 1.700-2.200A5 5 0 0 0 12 4z",
  camera: "M9 5l-1.500 2H4v12h16V7h-3.500L15 5zM12 9.500a3.500 3.500 0 1 1 0 7 3.500 3.500 0 0 1 0-7z",
  plots: "M4 4h2v14h14v2H4zM8 15l4-6 3 3 4-7 1.600 1L15.500 15l-3-3L9.600 16z",
  loop: "M7 7h10v3l4-4-4-4v3H5v6h2zM17 17H7v-3l-4 4 4 4v-3h12v-6h-2z",
};

export function icon(name: string): SVGSVGElement {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("viewBox", "0 0 24 24");
  svg.setAttribute("aria-hidden", "true");
  const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
  path.setAttribute("d", ICONS[name] ?? "");
  svg.append(path);
  return svg;
}

export function iconButton(name: string, label: string, click: () => void): HTMLButtonElement {
  return el("button.icon", { title: label, "aria-label": label, onclick: click, type: "button" }, icon(name));
}
