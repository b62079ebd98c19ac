// What the person has chosen; one object, one way to change it.

export interface Settings {
  /** Field with its part (`velocity.x`); empty: one colour. */
  field: string;
  map: string;
  /** `most` leaves out the hundredth of the blocks at either end: one loose block must not colour a whole model. */
  rangeMode: "most" | "frame" | "run" | "fixed";
  low: number;
  high: number;
  log: boolean;
  exaggeration: number;
  edges: boolean;
  /** Shadows of the sun, and darker hollows. */
  shadows: boolean;
  /** Outlines of the blocks that supports hold. */
  supports: boolean;
  /** Faces of boundaries in colours. */
  boundaries: boolean;
  /** Arrows of given forces and pressures. */
  loads: boolean;
  water: boolean;
  /** What joints between blocks are coloured by. */
  joints: "" | "set" | "interface";
  /** Normal of the cut: an axis, or free. */
  clipAxis: "" | "x" | "y" | "z" | "free";
  /** Share of the model. */
  clipAt: number;
  clipFlip: boolean;
  /** Flat through the blocks; else whole blocks are taken away. */
  clipFlat: boolean;
  /** Of a free cut, degrees: dip (in the plane the angle from x) and dip direction. */
  clipDip: number;
  clipDirection: number;
  /** Only blocks whose value is in the range. */
  only: boolean;
  vectors: "" | "displacement" | "velocity" | "force" | "contact force" | "seepage flow";
  vectorSize: number;
  /** Principal stresses of the blocks as crosses. */
  stress: boolean;
  contacts: boolean;
  states: boolean[];
  cracks: boolean;
  bolts: boolean;
  /** Tubes through contacts, as thick as their forces. */
  chains: boolean;
  /** Ways of blocks up to the frame that is shown: of all that have moved, or of the picked one. */
  trails: "" | "moving" | "picked";
  trailColour: "speed" | "block";
  /** Texts at places of the model. */
  notes: boolean;
  /** Stars at charges. */
  charges: boolean;
  speed: number;
  loop: boolean;
}

export const DEFAULTS: Settings = {
  // Until somebody chooses: the start is 0 everywhere, and at the end what the model is made of is seen first.
  field: "material",
  map: "light",
  rangeMode: "most",
  low: 0,
  high: 1,
  log: false,
  exaggeration: 1,
  edges: true,
  shadows: true,
  supports: false,
  boundaries: false,
  loads: false,
  water: true,
  joints: "",
  clipAxis: "",
  clipAt: 0.5,
  clipFlip: false,
  clipFlat: true,
  clipDip: 60,
  // Towards where the camera begins.
  clipDirection: 240,
  only: false,
  vectors: "",
  vectorSize: 1,
  stress: false,
  contacts: false,
  states: [false, true, true, true, true, true, true, true],
  cracks: false,
  bolts: true,
  chains: false,
  trails: "",
  trailColour: "speed",
  notes: true,
  charges: true,
  speed: 10,
  loop: true,
};

type Listener = (changed: (keyof Settings)[]) => void;

export class Choices {
  readonly now: Settings = { ...DEFAULTS, states: [...DEFAULTS.states] };
  private readonly listeners: Listener[] = [];

  set(change: Partial<Settings>): void {
    Object.assign(this.now, change);
    for (const listener of this.listeners) listener(Object.keys(change) as (keyof Settings)[]);
  }

  listen(listener: Listener): void {
    this.listeners.push(listener);
  }
}
