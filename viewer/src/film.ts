// Pictures for elsewhere: a PNG of the present frame, all frames as PNG in a zip, a film as WebM or MP4.

import { zipSync } from "fflate";
import { save } from "./dom";
import { legendOf, paintLegend } from "./legend";
import { paintLabels } from "./notes";
import type { Settings } from "./settings";
import type { Standpoint } from "./stage";
import type { Timeline } from "./timeline";
import type { View } from "./view";
import { mp4, type Mp4Film } from "./mp4";
import { webm, type EncodedFrame, type Film } from "./webm";

/** Frames of a zip at most: it is put together in memory. */
const FRAMES = 2000;

/** The views side by side with title, time and legend. */
export function compose(views: View[], settings: Settings, canvas = document.createElement("canvas")): HTMLCanvasElement {
  const ratio = views[0]!.stage.renderer.getPixelRatio();
  const style = getComputedStyle(document.documentElement);
  const ink = style.getPropertyValue("--ink").trim();
  const paper = style.getPropertyValue("--paper").trim();
  const head = Math.round(26 * ratio);
  for (const { stage } of views) {
    stage.stand();
    stage.draw();
  }
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
    paintLegend(ctx, legendOf(view, settings), view.scale, [x + 14 * ratio, head + 8 * ratio, sizes[i]![0] - 28 * ratio], ratio, ink);
    paintLabels(ctx, view.labels(), [x, head, ...sizes[i]!], ratio, [ink, paper]);
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

/** Pictures of a film whose camera moves while there is one frame only. */
const TURNS = 120;

/** Puts every picture on a canvas in turn, the camera on its way; false: it was stopped. Time and camera go back afterwards. */
async function play(
  [views, settings, timeline, move]: Playing,
  progress: Progress,
  each: (canvas: HTMLCanvasElement, k: number, count: number) => Promise<void>,
): Promise<boolean> {
  timeline.pause();
  const back = timeline.at;
  const stood = views[0]!.stage.standpoint();
  const stand = (at: Standpoint) => views.forEach((view) => view.stage.follow(at));
  const canvas = document.createElement("canvas");
  const moments = timeline.moments.length;
  const count = move && moments === 1 ? TURNS : moments;
  try {
    for (let k = 0; k < count; k++) {
      if (!progress(k / count)) return false;
      if (k < moments) await timeline.go(k);
      if (move) stand(move(k / Math.max(1, count - 1)));
      await each(compose(views, settings, canvas), k, count);
    }
  } finally {
    if (move) stand(stood);
    await timeline.go(back);
  }
  return true;
}

/** What a film is made of: the views side by side, and the way of their cameras where they do not stay. */
export type Playing = [views: View[], settings: Settings, timeline: Timeline, move: ((share: number) => Standpoint) | null];

export async function sequence(playing: Playing, progress: Progress): Promise<void> {
  const files: Record<string, [Uint8Array, { level: 0 }]> = {};
  const whole = await play(playing, progress, async (canvas, k, count) => {
    if (count > FRAMES) throw new Error(`${count} frames are too many for one zip, which has at most ${FRAMES}: riprap shot RUN --all -o FILE.png writes them to a folder.`);
    const blob = await blobOf(canvas);
    // Stored as they are: a PNG is packed already.
    files[`frame_${String(k + 1).padStart(6, "0")}.png`] = [new Uint8Array(await blob.arrayBuffer()), { level: 0 }];
  });
  if (whole) save(new Blob([zipSync(files) as Uint8Array<ArrayBuffer>], { type: "application/zip" }), `${nameOf(playing[0])}_frames.zip`);
}

/** Files of a film. */
export type Container = "webm" | "mp4";

interface Codec<Id> {
  /** As the encoder names it. */
  codec: string;
  /** As the file does. */
  id: Id;
  /** As people do. */
  name: string;
}

/** Codecs of a film, those that more players show first. H.264 is not in every browser: its makers ask for a licence. */
const CODECS: { webm: Codec<Film["codec"]>[]; mp4: Codec<Mp4Film["codec"]>[] } = {
  webm: [
    { codec: "vp09.00.51.08", id: "V_VP9", name: "VP9" },
    { codec: "vp8", id: "V_VP8", name: "VP8" },
  ],
  mp4: [
    { codec: "avc1.640034", id: "avc", name: "H.264" },
    { codec: "avc1.420034", id: "avc", name: "H.264" },
    { codec: "vp09.00.51.08", id: "vp9", name: "VP9" },
    { codec: "av01.0.12M.08", id: "av1", name: "AV1" },
  ],
};
/** Every so many frames one stands alone: players begin there when somebody goes to a place. */
const KEY_EVERY = 50;
/** Pictures that wait for the encoder at most. */
const WAITING = 4;

/** The codec that MP4 films of this browser would have, by its name; null: it can write none. */
export async function mp4Codec(): Promise<string | null> {
  if (typeof VideoEncoder === "undefined") return null;
  for (const { codec, name } of CODECS.mp4) {
    const answer = await VideoEncoder.isConfigSupported({ codec, width: 1280, height: 720 }).catch(() => null);
    if (answer?.supported) return name;
  }
  return null;
}

/** How the encoder is to be set, and the codec as the file names it; it must not drop frames that take long. */
async function encoderConfig<C extends Container>(container: C, width: number, height: number, framerate: number): Promise<[VideoEncoderConfig, (typeof CODECS)[C][number]]> {
  if (typeof VideoEncoder === "undefined") {
    const why = window.isSecureContext ? "This browser has no video encoder (WebCodecs)." : "Browsers encode video only on pages of this machine (127.0.0.1) or served by https.";
    throw new Error(`${why} Save all frames as PNG instead, or write the film without a browser: riprap shot RUN --all -o film.apng`);
  }
  // Drawings have sharp edges, and smooth shades that show bands where bits are few.
  const bitrate = Math.max(2e6, Math.round(0.35 * width * height * framerate));
  for (const one of CODECS[container]) {
    const config: VideoEncoderConfig = { codec: one.codec, width, height, framerate, bitrate, latencyMode: "quality" };
    const answer = await VideoEncoder.isConfigSupported(config);
    if (answer.supported) return [config, one];
  }
  const names = [...new Set(CODECS[container].map(({ name }) => name))].join(" or ");
  throw new Error(`This browser cannot encode ${names} at ${width} x ${height} pixels. Make the window smaller, or save all frames as PNG instead.`);
}

/** Encodes every picture once, as fast as the machine can: a slow machine leaves the film as it is. */
export async function film(playing: Playing, progress: Progress, container: Container): Promise<void> {
  const rate = playing[1].speed;
  const frames: EncodedFrame[] = [];
  const made: { size?: { width: number; height: number }; file?: () => Uint8Array<ArrayBuffer>; encoder?: VideoEncoder; decoder?: VideoDecoderConfig; failed?: DOMException } = {};
  const broken = () => {
    if (made.failed) throw new Error(`The browser could not encode the film: ${made.failed.message}`);
  };
  const start = async ({ width, height }: HTMLCanvasElement) => {
    const film = { width, height, framesPerSecond: rate, frames };
    let config: VideoEncoderConfig;
    if (container === "webm") {
      const [set, { id }] = await encoderConfig("webm", width, height, rate);
      config = set;
      made.file = () => webm({ ...film, codec: id });
    } else {
      const [set, { id }] = await encoderConfig("mp4", width, height, rate);
      config = set;
      made.file = () => mp4({ ...film, codec: id, decoder: made.decoder ?? { codec: set.codec } });
    }
    made.size = { width, height };
    const encoder = new VideoEncoder({
      output: (chunk, about) => {
        if (about?.decoderConfig) made.decoder ??= about.decoderConfig;
        const data = new Uint8Array(chunk.byteLength);
        chunk.copyTo(data);
        frames.push({ data, key: chunk.type === "key" });
      },
      error: (error) => (made.failed = error),
    });
    encoder.configure(config);
    return (made.encoder = encoder);
  };
  let wanted = 0;
  try {
    const whole = await play(playing, progress, async (canvas, k, count) => {
      wanted = count;
      const encoder = made.encoder ?? (await start(canvas));
      if (canvas.width !== made.size!.width || canvas.height !== made.size!.height) {
        throw new Error("The window changed its size while the film was made. Make it again and leave the window as it is.");
      }
      const picture = new VideoFrame(canvas, { timestamp: Math.round((1e6 * k) / rate), duration: Math.round(1e6 / rate) });
      broken();
      encoder.encode(picture, { keyFrame: k % KEY_EVERY === 0 });
      picture.close();
      while (encoder.encodeQueueSize > WAITING && !made.failed) await new Promise((done) => setTimeout(done, 5));
    });
    broken();
    if (!whole || !made.file) return;
    await made.encoder!.flush();
    broken();
    if (frames.length !== wanted) throw new Error(`The browser encoded ${frames.length} of ${wanted} frames. Save all frames as PNG instead.`);
    save(new Blob([made.file()], { type: `video/${container}` }), `${nameOf(playing[0])}.${container}`);
  } finally {
    if (made.encoder && made.encoder.state !== "closed") made.encoder.close();
  }
}
