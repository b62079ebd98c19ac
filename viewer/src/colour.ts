// Colour maps: a texture for the blocks, a strip for the legend.

import {
  interpolateCividis,
  interpolateMagma,
  interpolateRdBu,
  interpolateTurbo,
  interpolateViridis,
  interpolateYlGnBu,
  schemeTableau10,
} from "d3-scale-chromatic";
import * as THREE from "three";

export const MAPS: Record<string, (t: number) => string> = {
  // Most blocks of most runs have low values: light ones leave their edges to be seen.
  light: (t) => interpolateYlGnBu(0.12 + 0.88 * t),
  viridis: interpolateViridis,
  cividis: interpolateCividis,
  magma: interpolateMagma,
  turbo: interpolateTurbo,
  "blue-red": (t) => interpolateRdBu(1 - t),
};

/** Fields whose values are kinds, not amounts. */
export const KINDS = new Set(["block", "material", "level", "held", "surface", "removable_type", "removable_mode"]);
/** Colours of kinds that are better or worse, by their numbers. */
const RANKED: Record<string, string[]> = {
  removable_type: ["#a8adb3", "#d62728", "#f2a33a", "#59a14f", "#6f9bd1"],
  removable_mode: ["#a8adb3", "#59a14f", "#f2a33a", "#e0662b", "#a3123a"],
};
/** Hues of materials, muted: the lightness tells blocks apart, and marks stand out. */
const MATERIALS = ["#c3ac87", "#86a3bd", "#b98474", "#93ab7d", "#a091b5", "#cda552", "#76aca4", "#bd93a8", "#a3a39a", "#d2bfa6"];
/** Blocks of one material have so many shades of its hue, lighter and darker by this share at most. */
const TONES = 16;
const SPREAD = 0.15;
/** Ground with so many faces that it is a survey: grey, so that its relief is seen and not a field that it does not have. */
export const TERRAIN = "#b3b1ab";
/** Field names that have a sign by nature. */
const SIGNED = /\.(x|y|z)$|^rotation$|^spin$|pressure|sigma/;

export function defaultMap(field: string): string {
  return SIGNED.test(field) ? "blue-red" : "light";
}

/** Number of colours of a map; the texture has as many of the colour of no value after them. */
const STEPS = 256;
const NONE: [number, number, number] = [128, 128, 128];

const probe = document.createElement("canvas").getContext("2d", { willReadFrequently: true })!;

/** Red, green, blue of 0 to 255. */
export function rgb(css: string): [number, number, number] {
  // What is no colour is ignored by the canvas: it is black then, not the colour of the last call.
  probe.fillStyle = "#000";
  probe.fillStyle = css;
  probe.fillRect(0, 0, 1, 1);
  const [r, g, b] = probe.getImageData(0, 0, 1, 1).data;
  return [r!, g!, b!];
}

export function kindColour(value: number, field = ""): string {
  if (field === "material") return MATERIALS[((Math.round(value) % 10) + 10) % 10]!;
  const ranked = RANKED[field];
  if (ranked) return ranked[Math.round(value)] ?? ranked[0]!;
  return schemeTableau10[((Math.round(value) % 10) + 10) % 10]!;
}

/** Shade of a block by its number: neighbours in a row differ, and a block keeps its own in all frames and runs. */
function toneOf(id: number): number {
  // Mixed twice: rows of numbers must leave no stripes.
  let h = Math.imul(id ^ 0x2c1b3c6d, 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return (h ^ (h >>> 16)) >>> 0 & (TONES - 1);
}

/** A colour in one of its shades, from 0 to 255. */
function shaded(css: string, tone: number): [number, number, number] {
  const by = SPREAD * ((2 * tone) / (TONES - 1) - 1);
  return rgb(css).map((part) => Math.round(by > 0 ? part + by * (255 - part) : part * (1 + by))) as [number, number, number];
}

/** How numbers become colours. */
export class Scale {
  readonly texture: THREE.DataTexture;
  low = 0;
  high = 1;
  log = false;
  kinds = false;
  /** The field whose kinds they are. */
  field = "";
  private readonly data = new Uint8Array(4 * 2 * STEPS);

  constructor() {
    this.texture = new THREE.DataTexture(this.data, 2 * STEPS, 1);
    this.texture.colorSpace = THREE.SRGBColorSpace;
    // Between the colours of two kinds, or of a value and of none, there is nothing.
    this.texture.magFilter = THREE.NearestFilter;
    this.texture.minFilter = THREE.NearestFilter;
    this.paint("light");
  }

  /** Fills the texture. */
  paint(map: string): void {
    const at = MAPS[map] ?? interpolateYlGnBu;
    this.fill((i) => {
      if (this.toned) return shaded(kindColour(Math.floor(i / TONES), "material"), i % TONES);
      return rgb(this.kinds ? kindColour(i % 250, this.field) : at(i / (STEPS - 1)));
    });
  }

  /** Shades of one colour for everything. */
  plain(): void {
    this.fill((i) => shaded(MATERIALS[0]!, i % TONES));
  }

  private fill(colour: (i: number) => [number, number, number]): void {
    for (let i = 0; i < 2 * STEPS; i++) this.data.set([...(i < STEPS ? colour(i) : NONE), 255], 4 * i);
    this.data.set([...rgb(TERRAIN), 255], 4 * (2 * STEPS - 1));
    this.texture.needsUpdate = true;
  }

  /** Whether the colours are those of materials. */
  private get toned(): boolean {
    return this.kinds && this.field === "material";
  }

  /** Place of the colour of surveyed ground. */
  get terrain(): number {
    return 1 - 0.25 / STEPS;
  }

  /** Place of the shade of a block where there is one colour. */
  tone(id: number): number {
    return (toneOf(id) + 0.5) / (2 * STEPS);
  }

  /** Share of the range that lies below a value: below 0 or above 1 outside it. */
  private share(value: number): number {
    if (!this.log) return (value - this.low) / (this.high - this.low);
    return value > 0 ? Math.log(value / this.low) / Math.log(this.high / this.low) : -Infinity;
  }

  /** Whether a value has the colour of an end of the range while its own would be another. */
  isBeyond(value: number): boolean {
    const far = 1 / (STEPS - 1);
    return this.share(value) < -far || this.share(value) > 1 + far;
  }

  /** Place of the value of a block in the texture, from 0 to 1. */
  place(value: number, id: number): number {
    if (!Number.isFinite(value)) return 0.75;
    if (this.toned) return (TONES * (((Math.round(value) % 10) + 10) % 10) + toneOf(id) + 0.5) / (2 * STEPS);
    if (this.kinds) return ((((Math.round(value) % 250) + 250) % 250) + 0.5) / (2 * STEPS);
    let t = this.share(value);
    if (!(t > 0)) t = 0;
    else if (t > 1) t = 1;
    return (t * (STEPS - 1) + 0.5) / (2 * STEPS);
  }

  css(t: number): string {
    const i = 4 * Math.round(Math.min(1, Math.max(0, t)) * (STEPS - 1));
    return `rgb(${this.data[i]}, ${this.data[i + 1]}, ${this.data[i + 2]})`;
  }
}
