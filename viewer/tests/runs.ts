// Real runs for the tests, made once by the binary that is tested.

import { execFileSync } from "node:child_process";
import { cpSync, mkdirSync, readFileSync, readdirSync, rmSync, truncateSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

export const ROOT = fileURLToPath(new URL("../..", import.meta.url));
export const BINARY = process.env.RIPRAP_BIN ?? join(ROOT, "target/release/riprap");
export const RUNS = process.env.RIPRAP_RUNS ?? join(ROOT, "target/xtask/browser");

/** Name of the folder, scene, and what is changed in it. */
const SCENES: [string, string, string[]][] = [
  ["topple", "scenes/planar/topple.toml", ["phases.1.until.time=0.8 s", "outputs.0.frames.every=40 ms"]],
  ["steep", "scenes/planar/topple.toml", ["phases.1.until.time=0.6 s", "outputs.0.frames.every=50 ms", "interfaces.default.friction_angle=45 deg"]],
  ["beam", "scenes/spatial/beam.toml", []],
  ["blast", "scenes/spatial/blast.toml", ["outputs.0.frames.every=0.4 ms"]],
  ["hybrid", "scenes/spatial/hybrid.toml", []],
  ["soft", "scenes/spatial/beam.toml", ["interfaces.default.brittle_bond.cohesive={ mode_1 = \"3 kJ/m2\", mode_2 = \"3 kJ/m2\" }", "outputs.0.frames.tetrahedra=true"]],
  ["bolts", "scenes/verify/engineering/bolt_roof_block.toml", []],
  ["joints", "scenes/planar/voronoi.toml", []],
  ["buttress", "scenes/spatial/buttress.toml", []],
];

export function run(name: string): string {
  return join(RUNS, `${name}.run`);
}

export default function makeRuns(): void {
  mkdirSync(RUNS, { recursive: true });
  for (const [name, scene, changes] of SCENES) {
    const words = ["run", join(ROOT, scene), "--quiet", "--force", "--out", run(name), ...changes.flatMap((c) => ["--set", c])];
    try {
      execFileSync(BINARY, words, { stdio: ["ignore", "ignore", "pipe"] });
    } catch (error) {
      // Checks of a changed scene may fail; what matters is that it ran.
      if ((error as { status?: number }).status !== 1) throw error;
    }
  }
  breakThings();
}

/** Folders in the states that a full disk, a lost cable or a power cut leave. */
function breakThings(): void {
  const whole = run("topple");
  const copy = (name: string) => {
    rmSync(run(name), { recursive: true, force: true });
    cpSync(whole, run(name), { recursive: true });
    return run(name);
  };
  rmSync(run("empty"), { recursive: true, force: true });
  mkdirSync(run("empty"));
  const cut = join(copy("cut"), "frames");
  const third = readdirSync(cut).filter((f) => f.startsWith("frame_")).sort()[2]!;
  truncateSync(join(cut, third), Math.floor(statSync(join(cut, third)).size / 2));
  const garbled = join(copy("garbled"), "manifest.json");
  writeFileSync(garbled, readFileSync(garbled, "utf8").slice(0, 200));
  const died = copy("unfinished");
  const manifest = JSON.parse(readFileSync(join(died, "manifest.json"), "utf8")) as Record<string, unknown>;
  writeFileSync(join(died, "manifest.json"), JSON.stringify({ ...manifest, ended: "running" }));
  const histories = join(died, "histories.csv");
  truncateSync(histories, statSync(histories).size - 7);
  const bare = copy("frameless");
  writeFileSync(
    join(bare, "run.pvd"),
    '<?xml version="1.0"?>\n<VTKFile type="Collection" version="0.1" byte_order="LittleEndian">\n<Collection>\n</Collection>\n</VTKFile>\n',
  );
}
