// Numbers and units as text.

const PREFIXES: [number, string][] = [
  [1e9, "G"],
  [1e6, "M"],
  [1e3, "k"],
  [1, ""],
  [1e-3, "m"],
  [1e-6, "µ"],
  [1e-9, "n"],
];
/** Units that take prefixes. Others (rad, m2, kg/m3) stay as they are. */
const PREFIXED = new Set(["m", "m/s", "m/s2", "Pa", "N", "N/m", "J", "J/m", "s", "W"]);

/** A factor and a unit in which values up to `size` read well. */
export function scaleFor(size: number, unit: string): { factor: number; unit: string } {
  if (unit === "-" || unit === "") return { factor: 1, unit: "" };
  if (!PREFIXED.has(unit) || !(size > 0) || !Number.isFinite(size)) return { factor: 1, unit };
  // What would be rounded to 1000 has the next prefix already.
  const found = PREFIXES.find(([limit]) => size >= limit * 0.9995) ?? PREFIXES.at(-1)!;
  // Kilometres of displacement are metres here.
  if (unit.startsWith("m") && found[0] > 1) return { factor: 1, unit };
  return { factor: 1 / found[0], unit: found[1] + unit };
}

/** A number with few digits. */
export function short(value: number, digits = 4): string {
  if (Number.isNaN(value)) return "no number";
  if (!Number.isFinite(value)) return value > 0 ? "∞" : "-∞";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e5 || size < 1e-4) {
    const [mantissa, exponent] = value.toExponential(Math.max(0, digits - 2)).split("e");
    return `${Number(mantissa)}e${Number(exponent)}`;
  }
  return String(Number(value.toPrecision(digits)));
}

/** A value with a unit that suits its size. */
export function quantity(value: number, unit: string, digits = 4): string {
  const scale = scaleFor(Math.abs(value), unit);
  return scale.unit ? `${short(value * scale.factor, digits)} ${scale.unit}` : short(value * scale.factor, digits);
}

/** Round numbers between two values, about `count` of them. */
export function ticks(low: number, high: number, count = 5): number[] {
  if (!(high > low)) return [low];
  const raw = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((k) => k * power).find((s) => s >= raw * 0.999) ?? 10 * power;
  const out: number[] = [];
  // Multiples of the step, since a sum of steps would drift away from round numbers.
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++) out.push(k * step);
  return out;
}
