// A page on a served run, with everything that must not happen watched.

import { test as base, expect, type Locator, type Page } from "@playwright/test";
import { spawn, type ChildProcess } from "node:child_process";
import { createHash } from "node:crypto";
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { BINARY, ROOT, run } from "./runs";

/** Pictures to be looked at. */
export const PICTURES = process.env.RIPRAP_PICTURES ?? join(ROOT, "target/xtask/browser/pictures");

async function start(names: string[]): Promise<{ server: ChildProcess; url: string }> {
  const server = spawn(BINARY, ["view", "--no-open", ...names.map((n) => (n.includes("/") ? n : run(n)))]);
  const url = await new Promise<string>((found, failed) => {
    let said = "";
    server.stdout.on("data", (data: Buffer) => {
      said += data.toString();
      const address = /http:\/\/\S+/.exec(said);
      if (address) found(address[0]);
    });
    server.on("exit", (code) => failed(new Error(`riprap view ended with ${code}: ${said}`)));
  });
  return { server, url };
}

interface Tools {
  /** Opens the page on runs and waits until the first frame stands. */
  view: (...runs: string[]) => Promise<Page>;
  /** Allows complaints of the browser that match: those that a broken folder must cause. */
  allow: (what: RegExp) => void;
}

export const test = base.extend<Tools>({
  allow: async ({ page }, use) => {
    const complaints: string[] = [];
    const allowed: RegExp[] = [];
    page.on("console", (message) => {
      if (["error", "warning"].includes(message.type())) complaints.push(message.text());
    });
    page.on("pageerror", (error) => complaints.push(String(error)));
    await use((what) => allowed.push(what));
    // Reading back pixels is slow in software; that is said of every picture.
    allowed.push(/GPU stall due to ReadPixels|swiftshader|software WebGL|too-old/i);
    expect(complaints.filter((c) => !allowed.some((a) => a.test(c)))).toEqual([]);
  },
  view: async ({ page, allow }, use) => {
    void allow; // Watches every page.
    const servers: ChildProcess[] = [];
    await use(async (...names) => {
      const { server, url } = await start(names);
      servers.push(server);
      await page.goto(url);
      await page.waitForSelector("html[data-ready]");
      return page;
    });
    for (const server of servers) server.kill();
  },
});

export { expect };

export async function shoot(page: Page, name: string): Promise<void> {
  mkdirSync(PICTURES, { recursive: true });
  await page.screenshot({ path: join(PICTURES, `${name}.png`) });
}

export function stage(page: Page, n = 0): Locator {
  return page.locator(".stage > canvas").nth(n);
}

export async function frame(page: Page, n = 0): Promise<number> {
  return Number(await stage(page, n).getAttribute("data-frame"));
}

/** A fingerprint of the pixels of a stage, to be compared with another. */
export async function pixels(page: Page, n = 0): Promise<string> {
  const picture = await stage(page, n).evaluate((canvas) => (canvas as HTMLCanvasElement).toDataURL());
  return createHash("sha256").update(picture).digest("hex");
}

/** The fingerprint of a stage once nothing is left to be drawn: after two pictures that the browser has shown. */
export async function settled(page: Page, n = 0): Promise<string> {
  await page.evaluate(() => new Promise((shown) => requestAnimationFrame(() => requestAnimationFrame(() => shown(null)))));
  return pixels(page, n);
}

/** Clicks places of the stage until a block is picked. */
export async function pickSome(page: Page): Promise<void> {
  const box = (await stage(page).boundingBox())!;
  for (const [x, y] of [[0.5, 0.5], [0.45, 0.6], [0.55, 0.55], [0.4, 0.7], [0.6, 0.7], [0.5, 0.8]] as const) {
    await page.mouse.click(box.x + x * box.width, box.y + y * box.height);
    const found = page.locator(".pickhead b").waitFor({ timeout: 5000 });
    if (await found.then(() => true, () => false)) return;
  }
  throw new Error("no block under any of the places tried");
}
