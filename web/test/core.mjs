// The core as a module for node; where it was built is the environment variable BENTUR_WASM.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

// emscripten 3.1.6 makes modules that ask node for what only scripts have there.
globalThis.require = createRequire(import.meta.url);
globalThis.__dirname = import.meta.dirname;

/** A studio with the examples' ground motion in it. */
export async function studio(source) {
  const { default: createBentur } = await import(pathToFileURL(process.env.BENTUR_WASM));
  const module = await createBentur();
  const one = new module.Studio();
  one.putFile("../data/el-centro-1940-ns.csv", readFileSync(`${source}/data/el-centro-1940-ns.csv`));
  return one;
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

/* How far an example's numbers may be from the command line's, as a part of them. */
// Where storeys yield, a difference in the last digit of when one does moves all that comes after it. Columns that are
// struck have light nodes: round-off is that of the fastest mode, and the slow ones lose digits to it, 1.2e-12 of the free
// displacements already, the more in small impacts.
const tolerances = { "yielding-pair.toml": 1e-11, "struck-column.toml": 5e-11 };
export const tolerance = (name) => tolerances[name] ?? 1e-12;
