// The core as a module for node; where it was built is the environment variable BENTUR_WASM.
import { execFileSync } from "node:child_process";
import { readdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

// emscripten 3.1.6 makes modules that ask node for what only scripts have there.
globalThis.require = createRequire(import.meta.url);
globalThis.__dirname = import.meta.dirname;

/** A studio with the examples' ground motions in it. */
export async function studio(source) {
  const { default: createBentur } = await import(pathToFileURL(process.env.BENTUR_WASM));
  const module = await createBentur();
  const one = new module.Studio();
  for (const name of readdirSync(`${source}/data`).filter((file) => file.endsWith(".csv"))) {
    for (const to of ["../data", "../../data"]) one.putFile(`${to}/${name}`, readFileSync(`${source}/data/${name}`));
  }
  return one;
}

/** Every eighth of the examples, from number `first` on, with those in `also`; all of them where BENTUR_PART is `all`,
 *  as in ./dev soak. */
export function examples(source, first, also = []) {
  const all = readdirSync(`${source}/examples`).filter((name) => name.endsWith(".toml"));
  return all.filter((name, k) => process.env.BENTUR_PART === "all" || k % 8 === first || also.includes(name));
}

/** The largest relative difference of two JSON values, numbers within; Infinity where anything else differs. */
export function difference(a, b, path = "", ignored = () => false) {
  if (ignored(path)) return { size: 0, path };
  if (typeof a === "number" && typeof b === "number") {
    const size = a === b ? 0 : Math.abs(a - b) / Math.max(Math.abs(a), Math.abs(b));
    return { size, path };
  }
  if (a !== null && b !== null && typeof a === "object" && typeof b === "object") {
    const keys = Object.keys(a);
    if (keys.join() !== Object.keys(b).join()) return { size: Infinity, path };
    let worst = { size: 0, path };
    for (const key of keys) {
      const found = difference(a[key], b[key], `${path}/${key}`, ignored);
      if (found.size > worst.size) worst = found;
    }
    return worst;
  }
  return { size: a === b ? 0 : Infinity, path };
}

/**
 * Known to fewer digits. The time of a maximum is where a slope is zero: it is known to half the digits that the maximum
 * itself is known to. A restitution is one speed over another, which of a soft touch are small differences of large ones.
 */
export const isLoose = (path) => /_time$|\/values\/time\/value$|\/restitution\//.test(path);

/* How far an example's numbers may be from the command line's, as a part of them. */
// Where storeys yield, a difference in the last digit of when one does moves all that comes after it. Columns that are
// struck have light nodes: round-off is that of the fastest mode, and the slow ones lose digits to it, 1.2e-12 of the free
// displacements already, the more in small impacts. Of three buildings in plan that hold one another impacts of 2 % of the
// largest force lose digits to those before them.
const tolerances = { "yielding-pair.toml": 1e-11, "struck-column.toml": 5e-11, "crossroads.toml": 1e-11 };
export const tolerance = (name) => tolerances[name] ?? 1e-12;

/** With ordinary spaces. */
export const spaced = (text) => text.replaceAll("\u00a0", " ");

/** A statement as a terminal has it: "Gap: BADGE: text", behind the gap's name in a row of several unless it names both buildings. */
export const lineOf = ({ gap, badge, text, severity, kind }, row) =>
  `${row && gap !== null && severity !== "remark" && !gap.split(" | ").every((name) => text.includes(name)) ? `${gap}: ` : ""}${badge ? `${badge.toUpperCase()}: ` : ""}${kind.startsWith("remark.") && !badge ? "remark: " : ""}${spaced(text)}`;

/** What `bentur run` says in a language: the lines of its verdict and of its remarks, wrapped ones joined, and what names
 *  the rows of what else is known. */
export function terminal(file, language) {
  const all = execFileSync(process.env.BENTUR, ["run", file, "--lang", language], { encoding: "utf8" }).split("\n\n");
  const parts = all.map((part) => part.trimEnd().replaceAll("\n  ", " ").split("\n"));
  const after = parts.findIndex((lines) => lines.length === 1 && /^(Drift and storey shear|Simpangan dan gaya geser)/.test(lines[0]));
  const table = all[all.findIndex((part) => /^(What else is known|Yang juga diketahui)$/.test(part)) + 1];
  const known = table.split("\n").slice(2).filter((line) => /^ {2}\S/.test(line)).map((line) => line.trim().split(/ {2,}/)[0]);
  return { verdict: parts[1], known, remarks: parts[after + 1].map((line) => line.replace(/^catatan: /, "remark: ")) };
}
