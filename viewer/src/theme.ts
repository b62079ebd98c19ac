// Light or dark: what was chosen, else what the page came with, else what the system prefers.

export type Theme = "light" | "dark";

const KEY = "riprap-theme";
const dark = window.matchMedia("(prefers-color-scheme: dark)");
const root = document.documentElement;
/** A report comes with one. */
const given = root.dataset.theme as Theme | undefined;

function stored(): Theme | null {
  try {
    return localStorage.getItem(KEY) as Theme | null;
  } catch {
    // Pages without an origin have no memory.
    return null;
  }
}

function apply(): void {
  root.dataset.theme = stored() ?? given ?? (dark.matches ? "dark" : "light");
}

/** Sets the theme now and whenever the system's changes; `changed` is called after that. */
export function follow(changed: () => void = () => undefined): void {
  apply();
  dark.addEventListener("change", () => {
    apply();
    changed();
  });
}

export function flip(): void {
  const next: Theme = root.dataset.theme === "dark" ? "light" : "dark";
  root.dataset.theme = next;
  try {
    localStorage.setItem(KEY, next);
  } catch {
    // It holds until the page is closed.
  }
}
