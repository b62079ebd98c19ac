// What the page keeps of a run that is asked for news. Needs no page.

import { expect, test } from "@playwright/test";
import { Run, type Summary } from "../src/run";
import type { Source } from "../src/source";

test("a summary with a problem does not replace a good one", async () => {
  const manifest = { started: "today", input_hash: "a" };
  const good = (frames: number) => ({ name: "a", manifest, times: Array.from({ length: frames }, (_, k) => k), live: true });
  const cut = { name: "a", problem: { what: "run.pvd is damaged", hint: "Ask again." } };
  const answers: unknown[] = [good(1), cut, good(2)];
  const source = { json: async () => answers.shift() as Summary } as unknown as Source;
  const run = await Run.open(source);
  await expect(run.refresh()).rejects.toThrow("damaged");
  expect(run.summary.live).toBe(true);
  expect(run.frames).toBe(1);
  expect(await run.refresh()).toBe(false);
  expect(run.frames).toBe(2);
});
