// Storeys and bays, one more or fewer: in every list that the schema says has one value for each of them.
import { keyOf } from "./schema";
import { apply, type Edit, leaf, type List, type Outline, outline, type Path, same, under } from "./toml";

export type Part = "storey" | "bay";

const listOf = (found: Outline, building: number, name: string) =>
  found.lists.find(({ path }) => path.length === 4 && under(path, ["building", building]) && path[3] === name);
const storeysOf = (found: Outline, building: number) => leaf(found, ["building", building, "generic", "storeys"]);

/** How many there are; nothing where a building has none that can be counted. */
export function count(found: Outline, building: number, part: Part): number | undefined {
  if (part === "bay") return listOf(found, building, "bay_widths")?.items.length;
  const known = storeysOf(found, building);
  return known ? Number(known.value) : listOf(found, building, "storey_heights")?.items.length;
}

/** A list with its last entry so many times more, or without so many entries at its end. */
function resized(text: string, { items }: List, by: number): Edit {
  const last = items[items.length - 1];
  if (by < 0) return { range: [items[items.length - 1 + by][1], last[1]], made: "" };
  const between = items.length > 1 ? text.slice(items[items.length - 2][1], last[0]) : ", ";
  return { range: [last[1], last[1]], made: `${between.includes("#") ? ", " : between}${text.slice(...last)}`.repeat(by) };
}

const eachOf = (path: Path) => keyOf(path)?.each ?? "";

/** The text with one part more (1) or fewer (-1) of a building. */
export function grown(text: string, building: number, part: Part, by: 1 | -1): string {
  const found = outline(text);
  const n = found && count(found, building, part);
  if (!found || !n || n + by < 1) return text;
  const bays = count(found, building, "bay") ?? 0;
  const rotates = leaf(found, ["building", building, "frame", "condensation"])?.value === "none"; // joints have modes too
  const modes = part === "storey" ? (rotates ? bays + 2 : 1) : rotates ? count(found, building, "storey")! : 0;
  const main = listOf(found, building, part === "storey" ? "storey_heights" : "bay_widths");
  const edits = found.lists.filter(({ path }) => under(path, ["building", building])).flatMap((list) => {
    const each = eachOf(list.path);
    const isOne = list === main || (part === "storey" && /one per (storey|floor)$/.test(each) && list.items.length === n && !(n === 1 && each.startsWith("one for all")));
    const isLine = part === "bay" && list.path[3] === "columns" && /one per column line/.test(each) && list.items.length === n + 1;
    if (isOne || isLine) return [resized(text, list, by)];
    return /one per mode$/.test(each) && modes > 0 ? [resized(text, list, by * modes)] : [];
  });
  const name = leaf(found, ["building", building, "name"])?.value;
  if (part === "storey") { // by name, with a slab below them or not
    edits.push(...found.lists.filter(({ path, items }) => path[path.length - 1] === name && items.length >= n && keyOf(path.slice(0, -1))?.kind === "by_building")
      .map((list) => resized(text, list, by)));
  }
  const known = part === "storey" ? storeysOf(found, building) : undefined;
  if (known) edits.push({ range: known.range, made: String(n + by) });
  return apply(text, edits);
}

const ofPoints = (found: Outline | null) => (found?.lists ?? []).filter(({ path, items }) => path[0] === "gap" && items.length > 0 && eachOf(path) === "one per contact point");

/** The same with one number for all contact points of a gap where there was a list. */
export function withoutPoints(text: string): string {
  return apply(text, ofPoints(outline(text)).map((list) => ({ range: list.range, made: text.slice(...list.items[0]) })));
}

/** Lists of contact points as long as `counts` says, by the building to the left of a gap. */
export function withPoints(text: string, counts: number[]): string {
  const found = outline(text);
  const names = (found?.leaves ?? []).filter(({ path }) => same(path, ["building", path[1], "name"])).map(({ value }) => value);
  return apply(text, ofPoints(found).map((list) => {
    const wanted = counts[names.indexOf(leaf(found, ["gap", list.path[1], "between", 0])?.value)] ?? list.items.length;
    return wanted === 0 ? { range: list.range, made: text.slice(...list.items[0]) } : resized(text, list, wanted - list.items.length);
  }));
}
