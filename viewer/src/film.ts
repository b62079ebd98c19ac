// Pictures for elsewhere: a PNG of the present frame, all frames as PNG in a zip, a WebM film.

import { zipSync } from "fflate";
import { save } from "./dom";
import { legendOf, paintLegend } from "./legend";
import type { Settings } from "./settings";
import type { Timeline } from "./timeline";
import type { View } from "./view";

/** Frames of a zip at most: it is put together in memory. */
const FRAMES = 2000;

/** The views side by side with title, time and legend. */
export function compose(views: View[], settings: Settings, canvas = document.createElement("canvas")): HTMLCanvasElement {
  const ratio = views[0]!.stage.renderer.getPixelRatio();
  const style = getComputedStyle(document.documentElement);
  const ink = style.getPropertyValue("--ink").trim();
  const paper = style.getPropertyValue("--paper").trim();
  const head = Math.round(26 * ratio);
  for (const view of views) view.stage.draw();
  const sizes = views.map((v) => [v.stage.canvas.width, v.stage.canvas.height] as const);
  // Films want even sizes.
  const width = sizes.reduce((sum, s) => sum + s[0], 0) & ~1;
  const height = (Math.max(...sizes.map((s) => s[1])) + head) & ~1;
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
  }
  const ctx = canvas.getContext("2d")!;
  ctx.fillStyle = paper;
  ctx.fillRect(0, 0, width, height);
  let x = 0;
  views.forEach((view, i) => {
    ctx.drawImage(view.stage.canvas, x, head);
    const { manifest } = view.run.summary;
    const time = view.run.saidAt(view.frame);
    ctx.fillStyle = ink;
    ctx.textBaseline = "middle";
    ctx.font = `600 ${13 * ratio}px system-ui, sans-serif`;
    ctx.fillText(`${manifest.title || view.run.summary.name}   ${time}`, x + 12 * ratio, head / 2, sizes[i]![0] - 24 * ratio);
    paintLegend(ctx, legendOf(view, settings), view.scale, [x + 14 * ratio, head + 8 * ratio], ratio, ink);
    x += sizes[i]![0];
  });
  return canvas;
}

function blobOf(canvas: HTMLCanvasElement): Promise<Blob> {
  return new Promise((done, failed) => {
    canvas.toBlob((blob) => (blob ? done(blob) : failed(new Error("the browser made no picture"))), "image/png");
  });
}

function nameOf(views: View[]): string {
  return views.map((v) => v.run.summary.name.replace(/\.run$/, "")).join("_");
}

export async function picture(views: View[], settings: Settings): Promise<void> {
  const blob = await blobOf(compose(views, settings));
  save(blob, `${nameOf(views)}_${String(views[0]!.frame + 1).padStart(6, "0")}.png`);
}

/** How far it is, from 0 to 1; false from it stops the work. */
export type Progress = (share: number) => boolean;

export async function sequence(views: View[], settings: Settings, timeline: Timeline, progress: Progress): Promise<void> {
  timeline.pause();
  const back = timeline.at;
  const files: Record<string, [Uint8Array, { level: 0 }]> = {};
  const canvas = document.createElement("canvas");
  const count = Math.min(FRAMES, timeline.moments.length);
  for (let k = 0; k < count; k++) {
    if (!progress(k / count)) return;
    await timeline.go(k);
    const blob = await blobOf(compose(views, settings, canvas));
    // Stored as they are: a PNG is packed already.
    files[`frame_${String(k + 1).padStart(6, "0")}.png`] = [new Uint8Array(await blob.arrayBuffer()), { level: 0 }];
  }
  await timeline.go(back);
  save(new Blob([zipSync(files) as Uint8Array<ArrayBuffer>], { type: "application/zip" }), `${nameOf(views)}_frames.zip`);
}

export async function film(views: View[], settings: Settings, timeline: Timeline, progress: Progress): Promise<void> {
  const kinds = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm"];
  const kind = typeof MediaRecorder === "undefined" ? undefined : kinds.find((k) => MediaRecorder.isTypeSupported(k));
  if (!kind) throw new Error("This browser cannot write WebM. Save the frames as PNG instead.");
  timeline.pause();
  const back = timeline.at;
  const canvas = document.createElement("canvas");
  await timeline.go(0);
  compose(views, settings, canvas);
  const stream = canvas.captureStream(30);
  const recorder = new MediaRecorder(stream, { mimeType: kind, videoBitsPerSecond: 8e6 });
  const parts: Blob[] = [];
  recorder.ondataavailable = (event) => parts.push(event.data);
  const stopped = new Promise((done) => (recorder.onstop = done));
  recorder.start();
  recorder.pause();
  const count = timeline.moments.length;
  let whole = true;
  for (let k = 0; k < count && whole; k++) {
    await timeline.go(k);
    // Time counts only while a finished picture stands: frames that take long do not stutter.
    recorder.resume();
    compose(views, settings, canvas);
    await new Promise((done) => setTimeout(done, 1000 / settings.speed));
    recorder.pause();
    whole = progress((k + 1) / count);
  }
  recorder.stop();
  await stopped;
  for (const track of stream.getTracks()) track.stop();
  await timeline.go(back);
  if (whole) save(new Blob(parts, { type: "video/webm" }), `${nameOf(views)}.webm`);
}
