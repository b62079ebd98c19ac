// The closing line that `cargo xtask test` adds up.

import type { Reporter, TestCase, TestResult } from "@playwright/test/reporter";

export default class Tally implements Reporter {
  private readonly last = new Map<string, string>();

  onTestEnd(test: TestCase, result: TestResult): void {
    this.last.set(test.id, result.status);
  }

  onEnd(): void {
    const all = [...this.last.values()];
    const passed = all.filter((s) => s === "passed").length;
    const skipped = all.filter((s) => s === "skipped").length;
    process.stdout.write(`${passed} passed, ${all.length - passed - skipped} failed, ${skipped} skipped\n`);
  }
}
