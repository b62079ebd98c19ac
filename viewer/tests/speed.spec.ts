// Speed on a large run, asked for by RIPRAP_LARGE=FOLDER: not part of every test.

import { expect, frame, shoot, stage, test } from "./serve";

const large = process.env.RIPRAP_LARGE;

test("a large run opens and plays", async ({ view, page }) => {
  test.skip(!large, "RIPRAP_LARGE names no run");
  const bytes = new Map<string, number>();
  page.on("response", async (response) => {
    const question = new URL(response.url()).pathname.split("/")[4] ?? "page";
    const length = (await response.body().catch(() => Buffer.alloc(0))).length;
    bytes.set(question, Math.max(bytes.get(question) ?? 0, length));
  });
  const begun = Date.now();
  await view(large!);
  const opened = (Date.now() - begun) / 1000;
  await page.getByLabel("frames per second").selectOption("30");
  const played = async (seconds: number) => {
    const shown = await stage(page).evaluate(
      (canvas, ms) =>
        new Promise<number>((done) => {
          let frames = 0;
          const watch = new MutationObserver(() => frames++);
          watch.observe(canvas, { attributes: true, attributeFilter: ["data-frame"] });
          setTimeout(() => {
            watch.disconnect();
            done(frames);
          }, ms);
        }),
      1000 * seconds,
    );
    return shown / seconds;
  };
  await page.keyboard.press(" ");
  const first = await played(5);
  const again = await played(10);
  // And with a point at each contact.
  await page.keyboard.press("c");
  await page.getByLabel("touching", { exact: true }).check();
  const dotted = await played(5);
  const between = (await page.locator(".legend").textContent()) ?? "";
  const contacts = [...between.matchAll(/(?:touching|sliding) (\d+)/g)].reduce((sum, m) => sum + Number(m[1]), 0);
  await page.keyboard.press("c");
  await page.keyboard.press(" ");
  await page.keyboard.press("End");
  await expect.poll(() => frame(page)).toBeGreaterThan(2);
  await shoot(page, "large");
  const data = (await stage(page).evaluate((c) => ({ ...(c as HTMLElement).dataset }))) as Record<string, string>;
  const perFrame = ((bytes.get("frame") ?? 0) + (bytes.get("field") ?? 0)) / 1e6;
  process.stdout.write(
    `${data.blocks} blocks, ${data.faces} faces drawn: opened in ${opened.toFixed(2)} s, shape ${((bytes.get("shape") ?? 0) / 1e6).toFixed(1)} MB, ` +
      `${perFrame.toFixed(2)} MB a frame, ${first.toFixed(1)} then ${again.toFixed(1)} frames/s, ${dotted.toFixed(1)} with contacts (${contacts} touch)\n`,
  );
  expect(perFrame).toBeLessThan(2.5);
});
