// Speed on a large run, asked for by RIPRAP_LARGE=FOLDER: not part of every test. Medians are told, since other work on the
// machine disturbs single ones.

import { expect, frame, shoot, stage, test } from "./serve";

const large = process.env.RIPRAP_LARGE;
/** Times that the page is opened, and spells of playing. */
const TIMES = 5;
/** Seconds of a spell. */
const SPELL = 4;

function median(values: number[]): number {
  return [...values].sort((a, b) => a - b)[values.length >> 1] ?? NaN;
}

test("a large run opens and plays", async ({ view, page }) => {
  test.skip(!large, "RIPRAP_LARGE names no run");
  test.setTimeout(300_000);
  const bytes = new Map<string, number>();
  page.on("response", async (response) => {
    const question = new URL(response.url()).pathname.split("/")[4] ?? "page";
    const length = (await response.body().catch(() => Buffer.alloc(0))).length;
    bytes.set(question, Math.max(bytes.get(question) ?? 0, length));
  });
  const [shown, ready]: [number[], number[]] = [[], []];
  await view(large!);
  for (let n = 0; n < TIMES; n++) {
    const begun = Date.now();
    await page.reload({ waitUntil: "commit" });
    await page.waitForSelector("html[data-shown]");
    shown.push((Date.now() - begun) / 1000);
    await page.waitForSelector("html[data-ready]");
    ready.push((Date.now() - begun) / 1000);
  }
  await page.getByLabel("frames per second").selectOption("30");
  /** Frames per second, the median of some spells. */
  const played = async () => {
    const rates: number[] = [];
    for (let n = 0; n < TIMES; n++) {
      const frames = await stage(page).evaluate(
        (canvas, ms) =>
          new Promise<number>((done) => {
            let count = 0;
            const watch = new MutationObserver(() => count++);
            watch.observe(canvas, { attributes: true, attributeFilter: ["data-frame"] });
            setTimeout(() => {
              watch.disconnect();
              done(count);
            }, ms);
          }),
        1000 * SPELL,
      );
      rates.push(frames / SPELL);
    }
    return median(rates);
  };
  await page.keyboard.press(" ");
  const plain = await played();
  // And with a point at each contact.
  await page.keyboard.press("c");
  await page.getByLabel("touching", { exact: true }).check();
  const dotted = await played();
  await page.keyboard.press(" ");
  await page.keyboard.press("End");
  await expect.poll(() => frame(page)).toBeGreaterThan(2);
  const between = (await page.locator(".legend").textContent()) ?? "";
  const contacts = [...between.matchAll(/(?:touching|sliding) (\d+)/g)].reduce((sum, m) => sum + Number(m[1]), 0);
  await shoot(page, "large");
  const data = (await stage(page).evaluate((c) => ({ ...(c as HTMLElement).dataset }))) as Record<string, string>;
  const perFrame = ((bytes.get("frame") ?? 0) + (bytes.get("field") ?? 0)) / 1e6;
  process.stdout.write(
    `${data.blocks} blocks, ${data.faces} faces drawn: first picture in ${median(shown).toFixed(2)} s, colours of the whole run in ${median(ready).toFixed(2)} s, ` +
      `shape ${((bytes.get("shape") ?? 0) / 1e6).toFixed(1)} MB, ${perFrame.toFixed(2)} MB a frame, ` +
      `${plain.toFixed(1)} frames/s, ${dotted.toFixed(1)} with contacts (${contacts} touch in the last frame)\n`,
  );
  expect(perFrame).toBeLessThan(2.5);
});
