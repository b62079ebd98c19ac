// Small pictures against stored ones: light and shadow, colours of fields, cuts, trails. RIPRAP_WRITE_PICTURES=1 writes them anew; look at them then.

import type { Page } from "@playwright/test";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { expect, frame, settled, shoot, stage, test } from "./serve";

/** Width of a stored picture. */
const WIDE = 220;
/** A point of which a channel differs by more than this is another, */
const FAR = 18;
/** and so many may be: other machines draw lines otherwise. */
const SHARE = 0.005;

const file = (name: string) => fileURLToPath(new URL(`pictures/${name}.png`, import.meta.url));

/** The stage, made small: the same from any size of a line of the picture. */
async function small(page: Page): Promise<string> {
  await settled(page);
  return stage(page).evaluate((canvas, wide) => {
    const from = canvas as HTMLCanvasElement;
    const to = document.createElement("canvas");
    to.width = wide;
    to.height = Math.round((wide * from.height) / from.width);
    const ctx = to.getContext("2d")!;
    ctx.imageSmoothingQuality = "high";
    ctx.drawImage(from, 0, 0, to.width, to.height);
    return to.toDataURL("image/png");
  }, WIDE);
}

/** Share of the points of a picture that are others than in the stored one. */
async function different(page: Page, name: string, picture?: string): Promise<number> {
  const now = picture ?? (await small(page));
  const stored = `data:image/png;base64,${readFileSync(file(name)).toString("base64")}`;
  return page.evaluate(
    async ([a, b, far]) => {
      const read = async (url: string) => {
        const image = new Image();
        image.src = url;
        await image.decode();
        const canvas = document.createElement("canvas");
        [canvas.width, canvas.height] = [image.width, image.height];
        const ctx = canvas.getContext("2d")!;
        ctx.drawImage(image, 0, 0);
        return ctx.getImageData(0, 0, image.width, image.height);
      };
      const [one, other] = [await read(a), await read(b)];
      if (one.width !== other.width || one.height !== other.height) return 1;
      let count = 0;
      for (let i = 0; i < one.data.length; i += 4) {
        if ([0, 1, 2].some((k) => Math.abs(one.data[i + k]! - other.data[i + k]!) > far)) count++;
      }
      return count / (one.width * one.height);
    },
    [now, stored, FAR] as const,
  );
}

/** The stage looks as it was stored. */
async function same(page: Page, name: string): Promise<void> {
  await shoot(page, `stored-${name}`);
  if (process.env.RIPRAP_WRITE_PICTURES) writeFileSync(file(name), Buffer.from((await small(page)).split(",")[1]!, "base64"));
  expect(existsSync(file(name)), `${name}.png is missing: RIPRAP_WRITE_PICTURES=1 writes it`).toBe(true);
  await expect.poll(() => different(page, name)).toBeLessThan(SHARE);
}

test("a run opens in the colours of its materials, in light and shadow", async ({ view }) => {
  const page = await view("buttress");
  await expect(page.locator(".legend .title")).toHaveText("material");
  await same(page, "materials");
  await page.keyboard.press("y");
  await expect.poll(() => different(page, "materials")).toBeGreaterThan(SHARE);
  await page.keyboard.press("y");
  await expect.poll(() => different(page, "materials")).toBeLessThan(SHARE);
  // Another field is one click away, and so is the way back.
  await page.getByRole("button", { name: "displacement", exact: true }).click();
  await expect(page.locator(".legend .title")).toHaveText(/^displacement/);
  await expect.poll(() => different(page, "materials")).toBeGreaterThan(0.1);
  await page.getByRole("button", { name: "material", exact: true }).click();
  await expect.poll(() => different(page, "materials")).toBeLessThan(SHARE);
});

test("colours of a field and a cut are those of the stored picture", async ({ view }) => {
  const page = await view("blast");
  await page.getByLabel("field", { exact: true }).selectOption("velocity");
  await page.getByLabel("range of the colours").selectOption("frame");
  await page.getByLabel("clipping plane").selectOption("y");
  await expect.poll(async () => Number(await stage(page).getAttribute("data-cut"))).toBeGreaterThan(20);
  await same(page, "cut");
  await page.getByLabel("colour map").selectOption("magma");
  await expect.poll(() => different(page, "cut")).toBeGreaterThan(0.1);
  await page.getByLabel("colour map").selectOption("light");
  await page.getByText("flip").click();
  await expect.poll(() => different(page, "cut")).toBeGreaterThan(0.05);
});

test("trails go to the frame that is shown, and notes go along with their blocks", async ({ view, page }) => {
  await view("topple");
  await page.getByLabel("trails").selectOption("moving");
  await expect(page.locator(".legend")).toContainText(/trails of \d+ blocks, up to .* m\/s/);
  await same(page, "trails");
  await page.getByLabel("colour of trails").selectOption("block");
  await expect(page.locator(".legend")).not.toContainText("m/s");
  const whole = await settled(page);
  await page.keyboard.press("Home");
  await expect.poll(() => frame(page)).toBe(0);
  expect(await settled(page)).not.toBe(whole);
  await page.keyboard.press("End");
  await expect.poll(() => frame(page)).toBeGreaterThan(10);

  await page.getByText("Views", { exact: true }).click();
  await page.getByLabel("text of the note").fill("rock k");
  await page.getByRole("button", { name: "note", exact: true }).click();
  await expect(page.locator("#app")).toHaveClass(/measuring/);
  const box = (await stage(page).boundingBox())!;
  for (const [x, y] of [[0.35, 0.5], [0.3, 0.45], [0.4, 0.55], [0.25, 0.45]] as const) {
    if ((await page.locator(".note-label").count()) > 0) break;
    await page.mouse.click(box.x + x * box.width, box.y + y * box.height);
  }
  const label = page.locator(".note-label");
  await expect(label).toHaveText("rock k");
  const waiting = page.waitForEvent("download");
  await page.getByRole("button", { name: "views.json" }).click();
  const file = await (await waiting).path();
  const { notes } = JSON.parse(readFileSync(file, "utf8")) as { notes: { text: string; at: number[]; block: number | null }[] };
  expect(notes).toHaveLength(1);
  expect(notes[0]!.text).toBe("rock k");
  expect(notes[0]!.block).not.toBeNull();
  const there = await label.getAttribute("style");
  await page.keyboard.press("Home");
  await expect.poll(() => frame(page)).toBe(0);
  await expect.poll(() => label.getAttribute("style")).not.toBe(there);
  await shoot(page, "note");
  await page.getByLabel("remove note rock k").click();
  await expect(label).toHaveCount(0);
});

test("it is told what the page waits for, and what is wrong without WebGL", async ({ page, view, allow }) => {
  allow(/WebGL|context/i);
  await page.addInitScript(() => {
    const said = ((window as unknown as { said: string[] }).said = []) as string[];
    setInterval(() => {
      const sign = document.querySelector<HTMLElement>(".loading");
      if (sign && !sign.hidden && sign.textContent) said.push(sign.textContent);
    }, 20);
  });
  await page.route("**/api/0/frame/*", async (route) => {
    await new Promise((done) => setTimeout(done, 900));
    await route.continue();
  });
  await view("topple");
  const said = await page.evaluate(() => (window as unknown as { said: string[] }).said);
  expect(said.join()).toContain("Reading the places of the blocks");
  await expect(page.locator(".loading")).toBeHidden();

  await page.addInitScript(() => {
    const real = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, kind: string, ...rest: unknown[]) {
      return kind.startsWith("webgl") ? null : Reflect.apply(real, this, [kind, ...rest]);
    } as typeof real;
  });
  await page.reload();
  await expect(page.getByRole("alert").first()).toContainText("WebGL 2");
  await expect(page.getByRole("alert").first()).toContainText("riprap shot");
  await shoot(page, "no-webgl");
});
