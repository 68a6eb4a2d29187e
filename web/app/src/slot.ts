// A gap as the case has it, and the text of the same case with another width of it: of a row the numbers of the gap, in
// plan, where a gap is as wide as footprints stand apart, the corners of the buildings that move.
import type { GapOverview } from "./solver";
import { apply, type Leaf, leaf, type Outline, put, widths } from "./toml";

/** `put` gives the text with another width, `most` is the widest that it can be, where `met` is in the way of those that
 *  move, `moves` says who moves of many, `clearance` beyond which width that of the plan grows with it. */
export interface Slot { width: number; most: number; met: string; moves: string[]; clearance: number; put: (text: string, width: number) => string }

/** The text with a gap's narrowest point this wide, the others wider by as much as they were. */
function inRow(found: Outline | null, gap: number): Slot | null {
  const places = widths(found, gap);
  if (places.length === 0) return null;
  const least = Math.min(...places.map((one) => one.value as number));
  return {
    width: least, most: Infinity, met: "", moves: [], clearance: Infinity,
    put: (text, width) => [...places].reverse().reduce((all, one) => put(all, one, Math.max(0, width + ((one.value as number) - least))), text),
  };
}

/** Numbers without the round-off of a sum, which would fill a text with digits. */
const plain = (value: number) => Number(value.toPrecision(12));

const STILL = 0.998; // part of a clearance up to which two are a pair, round-off and all

/** The clearance that was widened last, and what was written before, which comes back with the gap. */
let widened = { to: NaN, from: { value: NaN, text: "" } };

const clearanceBefore = ({ value, text }: Leaf) => (widened.to === value ? widened.from : { value: value as number, text });

/** The clearance with which two so far apart are a pair, as it is written: the one there was, or the next number of four digits. */
function clearanceFor(now: Leaf, width: number): string {
  const from = clearanceBefore(now);
  if (width <= STILL * from.value) return from.text;
  const grain = 10 ** (Math.floor(Math.log10(width / STILL)) - 3);
  widened = { to: plain(grain * Math.ceil(width / STILL / grain)), from };
  return decimalOf(widened.to);
}

function betweenFootprints(found: Outline | null, overview: GapOverview, names: string[]): Slot | null {
  const { all, by, until } = overview.movers!;
  const axes = [0, 1].filter((axis) => Math.abs(by[axis]) > 1e-9);
  const places = all.flatMap(({ building }) => axes.map((axis) => ({ axis, at: leaf(found, ["building", building, "plan", "corner", axis]) })));
  if (places.some(({ at }) => typeof at?.value !== "number")) return null; // counted from the plan's own zero
  const first = all[0];
  // What was run has this width; since then its first building has moved so far.
  const width = axes.reduce((sum, axis) => sum + by[axis] * ((leaf(found, ["building", first.building, "plan", "corner", axis])!.value as number) - first.corner[axis]), overview.width);
  const pair = overview.name.split(" | "), clearance = leaf(found, ["plan", "clearance"]);
  const isNamed = found!.tables.some(({ path }) => path[0] === "gap" && path.length === 2 && [0, 1].every((k) => pair.includes(String(leaf(found, [...path, "between", k])?.value))));
  const growing = typeof clearance?.value === "number" && !isNamed ? clearance : undefined;
  return {
    width: plain(Math.max(0, width)), most: until ? overview.width + STILL * until.way : Infinity, met: until ? names[until.building] : "",
    moves: all.length > 1 ? all.map(({ building }) => names[building]) : [], clearance: growing ? clearanceBefore(growing).value : Infinity,
    put: (text, next) => {
      const grain = 10 ** (Math.floor(Math.log10(Math.max(next, 1e-9))) - 3), way = grain * Math.round(next / grain) - width;
      const edits = places.map(({ axis, at }) => ({ range: at!.range, made: decimalOf(plain((at!.value as number) + by[axis] * way)) }));
      if (growing) edits.push({ range: growing.range, made: clearanceFor(growing, width + way) });
      return apply(text, edits);
    },
  };
}

const decimalOf = (value: number) => (Number.isInteger(value) ? value.toFixed(1) : String(value));

/** Nothing where no number of the text is the width. */
export const slotOf = (found: Outline | null, gap: number, overview: GapOverview | undefined, names: string[]): Slot | null =>
  overview?.movers ? betweenFootprints(found, overview, names) : inRow(found, gap);
