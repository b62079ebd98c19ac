// Annotations: short texts at places of the model, or on blocks, along with which they go. Kept with the saved views.

import * as THREE from "three";
import type { Blocks } from "./blocks";
import { el } from "./dom";
import { Problem } from "./source";
import type { MotionInfo } from "./run";
import type { Packet } from "./wire";

export interface Annotation {
  text: string;
  /** Where it points to, m, in the axes of the model; on a block: where that is at rest. */
  at: [number, number, number];
  /** Number of its block; null: it stays where it is. */
  block: number | null;
}

/** A text on the picture: from the left and from above, as shares of it. */
export interface Label {
  text: string;
  x: number;
  y: number;
}

/** The longest text. */
export const LONGEST = 80;

/** The annotations of a file. */
export function readNotes(text: string): Annotation[] {
  const given = (JSON.parse(text) as { notes?: unknown }).notes ?? [];
  const wrong = (what: string) => new Problem(`views.json: ${what}.`, "Save the file again from the viewer.");
  if (!Array.isArray(given)) throw wrong("`notes` is no list");
  return given.map((one: Partial<Annotation>, i) => {
    const { text: said, at, block } = one;
    const isPlace = Array.isArray(at) && at.length === 3 && at.every((v) => Number.isFinite(v));
    if (typeof said !== "string" || !isPlace) throw wrong(`note ${i + 1} needs a text and a place \`at\``);
    return { text: said.slice(0, LONGEST), at, block: typeof block === "number" ? block : null };
  });
}

/** How a block moves what is on it: to `middle + shift + turn (place - middle)`, all less the origin. */
function movedBy(blocks: Blocks, b: number, motion: Packet<MotionInfo>, s: number): { turn: THREE.Matrix3; middle: THREE.Vector3; shift: THREE.Vector3 } {
  const middle = new THREE.Vector3().fromArray(blocks.middles, 3 * b);
  const shifts = motion.f32("shifts");
  const q = new THREE.Quaternion();
  const shift = new THREE.Vector3();
  if (blocks.dimension === 2) {
    shift.set(shifts[2 * b]!, shifts[2 * b + 1]!, 0);
    q.setFromAxisAngle(new THREE.Vector3(0, 0, 1), motion.f32("turns")[b]!);
  } else {
    shift.fromArray(shifts, 3 * b);
    const turns = motion.i16("turns");
    const [x, y, z] = [0, 1, 2].map((k) => (turns[3 * b + k]! * motion.info.turnScale) / 32767) as [number, number, number];
    q.set(x, y, z, Math.sqrt(Math.max(0, 1 - x * x - y * y - z * z)));
  }
  // What a turn adds is multiplied, as for the corners.
  const whole = new THREE.Matrix3().setFromMatrix4(new THREE.Matrix4().makeRotationFromQuaternion(q));
  const turn = new THREE.Matrix3();
  whole.elements.forEach((v, i) => (turn.elements[i] = s * v + (i % 4 === 0 ? 1 - s : 0)));
  return { turn, middle, shift: shift.multiplyScalar(s) };
}

/** Where an annotation is drawn, less the origin; null: its block is not there. */
function placeOf(note: Annotation, blocks: Blocks, motion: Packet<MotionInfo>, s: number): THREE.Vector3 | null {
  const place = new THREE.Vector3(...note.at).sub(new THREE.Vector3(...blocks.shape.info.origin));
  if (note.block === null) return place;
  const b = blocks.placeOf(note.block);
  if (b < 0 || !blocks.isShown(b)) return null;
  const { turn, middle, shift } = movedBy(blocks, b, motion, s);
  return place.sub(middle).applyMatrix3(turn).add(middle).add(shift);
}

/** The annotations as a camera sees them. */
export function labelsOf(notes: Annotation[], blocks: Blocks, motion: Packet<MotionInfo>, s: number, camera: THREE.Camera): Label[] {
  return notes.flatMap((note) => {
    const place = placeOf(note, blocks, motion, s);
    if (!place || blocks.isAway(place)) return [];
    const at = place.project(camera);
    const ahead = Math.abs(at.x) < 1 && Math.abs(at.y) < 1 && at.z < 1;
    return ahead ? [{ text: note.text, x: 0.5 + 0.5 * at.x, y: 0.5 - 0.5 * at.y }] : [];
  });
}

/** The annotation of a place as drawn, on a block or not. */
export function pinned(text: string, place: THREE.Vector3, block: number | null, blocks: Blocks, motion: Packet<MotionInfo>, s: number): Annotation {
  const at = place.clone();
  const b = block === null ? -1 : blocks.placeOf(block);
  if (b >= 0) {
    const { turn, middle, shift } = movedBy(blocks, b, motion, s);
    at.sub(middle).sub(shift).applyMatrix3(turn.invert()).add(middle);
  }
  at.add(new THREE.Vector3(...blocks.shape.info.origin));
  if (blocks.dimension === 2) at.z = 0;
  return { text, at: at.toArray(), block: b >= 0 ? block : null };
}

/** Labels as elements over a picture. */
export function labelElements(labels: Label[]): HTMLElement[] {
  return labels.map(({ text, x, y }) => {
    const label = el("div.note-label", {}, el("i"), el("span", {}, text));
    label.style.left = `${(100 * x).toFixed(2)}%`;
    label.style.top = `${(100 * y).toFixed(2)}%`;
    return label;
  });
}

/** Labels drawn into a picture whose upper left corner is at `x`, `y`; `s`: pixels per unit. */
export function paintLabels(ctx: CanvasRenderingContext2D, labels: Label[], [x, y, wide, high]: [number, number, number, number], s: number, [ink, paper]: [string, string]): void {
  ctx.font = `${12 * s}px system-ui, sans-serif`;
  ctx.textBaseline = "middle";
  for (const label of labels) {
    const [px, py] = [x + label.x * wide, y + label.y * high];
    // Boxes stay in the picture.
    const long = Math.min(ctx.measureText(label.text).width, wide - 12 * s);
    const tx = Math.max(x + 6 * s, Math.min(px + 14 * s, x + wide - long - 6 * s));
    const ty = Math.max(py - 18 * s, y + 11 * s);
    ctx.strokeStyle = ink;
    ctx.lineWidth = s;
    ctx.beginPath();
    ctx.moveTo(px, py);
    ctx.lineTo(tx, ty);
    ctx.stroke();
    ctx.fillStyle = paper;
    ctx.fillRect(tx - 4 * s, ty - 9 * s, long + 8 * s, 18 * s);
    ctx.strokeRect(tx - 4 * s, ty - 9 * s, long + 8 * s, 18 * s);
    ctx.fillStyle = ink;
    ctx.fillText(label.text, tx, ty, long);
    ctx.beginPath();
    ctx.arc(px, py, 2.5 * s, 0, 2 * Math.PI);
    ctx.fill();
  }
}
