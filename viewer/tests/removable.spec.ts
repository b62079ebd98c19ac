// Pictures that `riprap removable --picture` writes. That of the book: docs/src/img/removable-type.png.

import { execFileSync } from "node:child_process";
import { mkdtempSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { BINARY, ROOT } from "./runs";
import { expect, pixels, settled, shoot, test } from "./serve";

test("removable blocks are coloured by type, motion and factor of safety, with a legend", async ({ view }) => {
  const folder = join(mkdtempSync(join(tmpdir(), "riprap-removable-")), "wedge.blocks");
  execFileSync(BINARY, ["removable", join(ROOT, "scenes/spatial/wedge.toml"), "--picture", folder], { stdio: "ignore" });
  const page = await view(folder);
  await expect(page.locator(".badge")).toHaveText("not run");
  const field = page.getByLabel("field", { exact: true });
  await expect(field).toHaveValue("removable_type");
  const legend = page.locator(".legend");
  await expect(legend).toContainText("held by strength");
  await expect(legend).toContainText("held by weight");
  await expect(legend).toContainText("inside, or ground");
  await expect(legend).not.toContainText("key block");
  await settled(page);
  await shoot(page, "removable-type");
  const types = await pixels(page);

  await field.selectOption("removable_mode");
  await expect(legend).toContainText("slides on two planes");
  await expect(legend).toContainText("stays");
  await settled(page);
  await shoot(page, "removable-mode");
  expect(await pixels(page)).not.toBe(types);

  // One block is driven: its factor is tan(39.47 deg)/tan(38.47 deg).
  await field.selectOption("removable_factor");
  await expect(page.locator(".legend .title")).toHaveText(/^removable_factor/);
  await settled(page);
  await shoot(page, "removable-factor");
});
