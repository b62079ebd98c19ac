// What the picture of a frame needs from its run, as the settings say.

import { KINDS } from "./colour";
import { wider, type BoltInfo, type ContactInfo, type FieldInfo, type MotionInfo, type Run, type StressInfo } from "./run";
import type { Settings } from "./settings";
import type { Packet } from "./wire";

/** What a frame needs, fetched. */
export interface Fetched {
  k: number;
  motion: Packet<MotionInfo>;
  field: Packet<FieldInfo> | null;
  range: [number, number] | null;
  vectors: Packet<{ unit: string; longest: number | null }> | null;
  contacts: Packet<ContactInfo> | null;
  cracks: Packet<unknown> | null;
  bolts: Packet<BoltInfo> | null;
  stress: Packet<StressInfo> | null;
  supports: Packet<FieldInfo> | null;
  materials: Packet<FieldInfo> | null;
}

/** Fetches frame `k`; `shown`: runs whose colours mean the same, null where the values of the frame alone are to be spanned. */
export async function fetchFrame(run: Run, k: number, settings: Settings, shown: Run[] | null): Promise<Fetched> {
  const { field, vectors, rangeMode } = settings;
  const { held } = run.summary;
  const ofContacts = vectors === "contact force" || vectors === "seepage flow";
  const needContacts = (settings.contacts || settings.cracks || settings.chains || ofContacts) && (!held || held.contacts);
  const needVectors = vectors !== "" && !ofContacts && run.hasField(vectors) && (!held || held.vectors.includes(vectors));
  const none = Promise.resolve(null);
  const withField = field !== "" && run.hasField(field);
  const needCracks = settings.cracks && run.summary.cracks;
  const needBolts = settings.bolts && run.summary.bolts === true;
  const needStress = settings.stress && run.hasStress;
  const needSupports = (settings.supports || settings.chains) && run.hasField("held");
  const needMaterials = settings.joints === "interface" && run.hasField("material");
  const [motion, values, range, arrows, contacts, cracks, bolts, stress, supports, materials] = await Promise.all([
    run.motion(k),
    withField ? run.field(k, field) : none,
    withField && shown && (rangeMode === "run" || rangeMode === "most") && !KINDS.has(field) ? sharedRange(shown, field, rangeMode) : none,
    needVectors ? run.vectors(k, vectors) : none,
    needContacts ? run.contacts(k) : none,
    // A frame whose cracks are missing shows the faces that its contacts tell of.
    needCracks ? run.cracks(k).catch(() => null) : none,
    // Frames before the first bolt is put in have none.
    needBolts ? run.bolts(k).catch(() => null) : none,
    needStress ? run.stress(k) : none,
    // A report may not hold them.
    needSupports ? run.field(k, "held").catch(() => null) : none,
    needMaterials ? run.field(k, "material").catch(() => null) : none,
  ]);
  return { k, motion, field: values, range, vectors: arrows, contacts, cracks, bolts, stress, supports, materials };
}

/** Range of a field over all runs that are shown. */
async function sharedRange(shown: Run[], field: string, mode: "run" | "most"): Promise<[number, number] | null> {
  const ranges = await Promise.all(shown.map((run) => run.range(field)));
  return ranges.map((r) => (mode === "most" ? r.most : r.range)).reduce(wider, null);
}
