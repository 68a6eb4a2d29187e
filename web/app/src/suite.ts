// The records that a case names: which of the files at hand are among them, and where they are to stand.
import { apply, leaf, type Outline, same } from "./toml";

const FILES = ["excitation", "files"];

/** Whether many records stand in place of one ground motion. */
export const isSuite = (found: Outline | null) => leaf(found, ["excitation", "kind"])?.value === "suite";

/** The files of a suite as the case has them, patterns too. */
export const named = (found: Outline | null) => (isSuite(found) ? found!.leaves : [])
  .filter(({ path: [first, second, , third] }) => first === FILES[0] && second === FILES[1] && (third === undefined || third === "file"))
  .map((one) => String(one.value));

/** As the library's patterns: no star goes beyond a folder. */
function fits(pattern: string, name: string): boolean {
  const rule = pattern.replace(/[.+^${}()|\\]/g, "\\$&").replace(/\*/g, "[^/]*").replace(/\?/g, "[^/]").replace(/\[!/g, "[^");
  try {
    return pattern === name || new RegExp(`^${rule}$`, "u").test(name);
  } catch {
    return false;
  }
}

/** Whether a suite has use for a file at that place. */
export const uses = (found: Outline | null, place: string) => named(found).some((one) => fits(one, place));

/** Where a file of that name is to stand for the case to find it; nothing where it names none such. */
export function placeOf(found: Outline | null, name: string): string | undefined {
  const alone = leaf(found, ["excitation", "kind"])?.value === "record" ? String(leaf(found, ["excitation", "file"])?.value ?? "") : "";
  if (alone.slice(alone.lastIndexOf("/") + 1) === name) return alone;
  const all = named(found).map((one) => one.slice(0, one.lastIndexOf("/") + 1) + name);
  return all.find((one, i) => one === named(found)[i]) ?? all.find((one, i) => fits(named(found)[i], one));
}

/** The text with one more file in its suite, behind the others. */
export function withFile(text: string, found: Outline | null, entry: string): string {
  const list = found?.lists.find((one) => same(one.path, FILES));
  if (!list) return text;
  const last = list.items[list.items.length - 1], at = last ? last[1] : list.range[0] + 1;
  return apply(text, [{ range: [at, at], made: last ? `, ${entry}` : entry }]);
}
