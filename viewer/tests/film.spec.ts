// Films and saved views: what the files hold, and that views come back.

import { cpSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "@playwright/test";
import { run } from "./runs";
import { expect, settled, shoot, stage, test } from "./serve";

async function saved(page: Page, button: string): Promise<{ name: string; bytes: Buffer }> {
  const waiting = page.waitForEvent("download", { timeout: 120_000 });
  await page.getByRole("button", { name: button, exact: true }).click();
  const download = await waiting;
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

/** Share of the pixels of the stage that differ from a picture: a camera that comes back is off by rounding. */
function different(page: Page, picture: string): Promise<number> {
  return stage(page).evaluate(async (canvas, url) => {
    const drawn = document.createElement("canvas");
    const { width, height } = canvas as HTMLCanvasElement;
    [drawn.width, drawn.height] = [width, height];
    const ctx = drawn.getContext("2d", { willReadFrequently: true })!;
    const bytes = (image: CanvasImageSource) => {
      ctx.clearRect(0, 0, width, height);
      ctx.drawImage(image, 0, 0);
      return ctx.getImageData(0, 0, width, height).data;
    };
    const image = new Image();
    image.src = url;
    await image.decode();
    const [a, b] = [bytes(image), bytes(canvas as HTMLCanvasElement)];
    return a.reduce((sum, v, i) => sum + (Math.abs(v - b[i]!) > 30 ? 1 : 0), 0) / a.length;
  }, picture);
}

/** Elements of Matroska whose content is elements. */
const FOLDERS = ["1a45dfa3", "18538067", "1654ae6b", "ae", "e0", "1f43b675", "1549a966", "1c53bb6b", "bb", "b7"];

/** Elements by their numbers in hexadecimal, and where each begins. */
function elements(bytes: Buffer, from = 0, to = bytes.length, out: [id: string, content: Buffer, at: number][] = []): typeof out {
  let at = from;
  while (at < to) {
    const start = at;
    const wide = Math.clz32(bytes[at]!) - 23;
    const id = bytes.subarray(at, at + wide).toString("hex");
    at += wide;
    const long = Math.clz32(bytes[at]!) - 23;
    const size = bytes.subarray(at, at + long).reduce((sum, b, i) => 256 * sum + (i === 0 ? b & (0xff >> long) : b), 0);
    at += long;
    out.push([id, bytes.subarray(at, at + size), start]);
    if (FOLDERS.includes(id)) elements(bytes, at, at + size, out);
    at += size;
  }
  return out;
}

test("a film has every frame once, at its time, in the size of the picture", async ({ view }) => {
  const page = await view("steep");
  const frames = Number(await page.locator(".scrub").getAttribute("max")) + 1;
  await page.getByLabel("frames per second").selectOption("20");
  await page.getByText("Save", { exact: true }).click();
  const film = await saved(page, "Film");
  expect(film.name).toBe("steep.webm");
  const all = elements(film.bytes);
  const of = (id: string) => all.filter((e) => e[0] === id).map((e) => e[1]);
  const number = (id: string) => Number(`0x${of(id)[0]!.toString("hex")}`);
  expect(of("4282")[0]!.toString()).toBe("webm");
  expect(["V_VP9", "V_VP8"]).toContain(of("86")[0]!.toString());
  const size = await stage(page).evaluate((c) => [(c as HTMLCanvasElement).width, (c as HTMLCanvasElement).height]);
  expect(number("b0")).toBe(size[0]! & ~1);
  expect(number("ba")).toBe((size[1]! + 26) & ~1);
  const blocks = of("a3");
  expect(blocks.length).toBe(frames);
  expect(blocks.map((b) => b.readInt16BE(1))).toEqual(blocks.map((_, k) => 50 * k));
  expect(blocks[0]![3]).toBe(0x80);
  expect(of("4489")[0]!.readDoubleBE()).toBe(50 * frames);
  // The table of places leads to clusters.
  const inside = film.bytes.indexOf(of("18538067")[0]!);
  const clusters = all.filter((e) => e[0] === "1f43b675").map((e) => e[2]);
  expect(of("f1").map((c) => inside + Number(c.readBigUInt64BE()))).toEqual(clusters);

  // The browser plays it: to its end, in its size.
  const played = await page.evaluate(async (data) => {
    const video = document.createElement("video");
    video.src = URL.createObjectURL(new Blob([Uint8Array.from(atob(data), (c) => c.charCodeAt(0))], { type: "video/webm" }));
    await new Promise((done, failed) => {
      video.onloadeddata = done;
      video.onerror = () => failed(new Error(video.error?.message));
    });
    video.currentTime = video.duration - 0.01;
    await new Promise((done) => (video.onseeked = done));
    const canvas = document.createElement("canvas");
    canvas.width = video.videoWidth;
    canvas.height = video.videoHeight;
    canvas.getContext("2d")!.drawImage(video, 0, 0);
    return { wide: video.videoWidth, high: video.videoHeight, seconds: video.duration, last: canvas.toDataURL() };
  }, film.bytes.toString("base64"));
  expect([played.wide, played.high]).toEqual([number("b0"), number("ba")]);
  expect(played.seconds).toBeCloseTo(0.05 * frames, 2);
  const pictures = mkdtempSync(join(tmpdir(), "riprap-film-"));
  writeFileSync(join(pictures, "last.png"), Buffer.from(played.last.split(",")[1]!, "base64"));
  writeFileSync(join(pictures, "steep.webm"), film.bytes);
});

/** Boxes of MP4 by their names; those that hold others are opened. */
function boxes(bytes: Buffer, from = 0, to = bytes.length, out: [name: string, content: Buffer][] = []): typeof out {
  for (let at = from; at < to; ) {
    const [size, name] = [bytes.readUInt32BE(at), bytes.toString("latin1", at + 4, at + 8)];
    out.push([name, bytes.subarray(at + 8, at + size)]);
    if (["moov", "trak", "mdia", "minf", "stbl"].includes(name)) boxes(bytes, at + 8, at + size, out);
    at += size;
  }
  return out;
}

test("a film is an MP4, too, where the browser can encode one", async ({ view }) => {
  const page = await view("steep");
  const frames = Number(await page.locator(".scrub").getAttribute("max")) + 1;
  await page.getByLabel("frames per second").selectOption("20");
  await page.getByText("Save", { exact: true }).click();
  const button = page.getByRole("button", { name: /^MP4 \((H\.264|VP9|AV1)\)$/ });
  await expect(button).toBeVisible();
  const name = (await button.textContent())!;
  const film = await saved(page, name);
  expect(film.name).toBe("steep.mp4");
  const all = boxes(film.bytes);
  const of = (box: string) => all.find(([other]) => other === box)![1];
  // Players find the table before the frames.
  const outer = all.map(([box]) => box).filter((box) => ["ftyp", "moov", "mdat"].includes(box));
  expect(outer).toEqual(["ftyp", "moov", "mdat"]);
  expect(of("stsd").toString("latin1")).toContain({ "H.264": "avc1", VP9: "vp09", AV1: "av01" }[/\((.*)\)/.exec(name)![1]!]!);
  expect(of("stsz").readUInt32BE(8)).toBe(frames);
  const played = await page.evaluate(async (data) => {
    const video = document.createElement("video");
    video.src = URL.createObjectURL(new Blob([Uint8Array.from(atob(data), (c) => c.charCodeAt(0))], { type: "video/mp4" }));
    await new Promise((done, failed) => {
      video.onloadeddata = done;
      video.onerror = () => failed(new Error(video.error?.message));
    });
    return { wide: video.videoWidth, high: video.videoHeight, seconds: video.duration };
  }, film.bytes.toString("base64"));
  const size = await stage(page).evaluate((c) => [(c as HTMLCanvasElement).width, (c as HTMLCanvasElement).height]);
  expect([played.wide, played.high]).toEqual([size[0]! & ~1, (size[1]! + 26) & ~1]);
  expect(played.seconds).toBeCloseTo(0.05 * frames, 2);
  if (process.env.RIPRAP_FILM) writeFileSync(process.env.RIPRAP_FILM, film.bytes);
});

test("without an encoder the page says what to do", async ({ view }) => {
  const page = await view("steep");
  await page.evaluate(() => Object.defineProperty(window, "VideoEncoder", { value: undefined }));
  await page.getByText("Save", { exact: true }).click();
  await page.getByRole("button", { name: "Film", exact: true }).click();
  await expect(page.locator(".exportstate")).toContainText("no video encoder");
  await expect(page.locator(".exportstate")).toContainText("riprap shot RUN --all -o film.apng");
});

test("saved views come back, go into a file and lead the camera of a film", async ({ view }) => {
  const page = await view("beam");
  await page.getByText("Views", { exact: true }).click();
  const name = page.getByLabel("name of the view");
  const field = page.getByLabel("field", { exact: true });
  await name.fill("whole");
  await page.getByRole("button", { name: "save view" }).click();
  await settled(page);
  const whole = await stage(page).evaluate((canvas) => (canvas as HTMLCanvasElement).toDataURL());
  await field.selectOption("velocity");
  await page.getByLabel("clipping plane").selectOption("x");
  await page.getByRole("button", { name: "y", exact: true }).click();
  await name.fill("section");
  await page.keyboard.press("Enter");
  await expect.poll(() => different(page, whole)).toBeGreaterThan(0.02);
  await page.getByRole("button", { name: "whole", exact: true }).click();
  await expect(field).toHaveValue("material");
  await expect.poll(() => different(page, whole)).toBeLessThan(0.001);
  await shoot(page, "saved-views");

  const file = await saved(page, "views.json");
  const { views } = JSON.parse(file.bytes.toString()) as { views: { name: string; eye: number[]; angle: number; cut: { normal: number[] } | null; field: string }[] };
  expect(views.map((v) => v.name)).toEqual(["whole", "section"]);
  expect(views[0]!.cut).toBeNull();
  expect(views[1]!.field).toBe("velocity");
  expect(Math.abs(views[1]!.cut!.normal[0]!)).toBe(1);
  expect(views[1]!.angle).toBe(32);

  await page.getByText("Save", { exact: true }).click();
  await page.getByLabel("camera of a film").selectOption("views");
  const film = await saved(page, "Film");
  const frames = Number(await page.locator(".scrub").getAttribute("max")) + 1;
  expect(elements(film.bytes).filter((e) => e[0] === "a3").length).toBe(frames > 1 ? frames : 120);
  // The camera stands where it stood.
  await expect.poll(() => different(page, whole)).toBeLessThan(0.001);

  // Another page finds them in the run folder.
  const copy = join(mkdtempSync(join(tmpdir(), "riprap-views-")), "copy.run");
  cpSync(run("beam"), copy, { recursive: true });
  writeFileSync(join(copy, "views.json"), file.bytes);
  const other = await view(copy);
  await other.getByText("Views", { exact: true }).click();
  await other.getByRole("button", { name: "section", exact: true }).click();
  await expect(other.getByLabel("field", { exact: true })).toHaveValue("velocity");
  await expect(other.getByLabel("clipping plane")).toHaveValue("x");
});
