// Which figures are to be drawn, and what came back: the solver draws them, each of the run that is shown.
import { batch, effect, signal, untracked } from "@preact/signals";
import { chosen, curve, gap, live, result, solvedText, text } from "./case";
import { type Drawn, type Wanted } from "./solver";
import { language } from "./texts";

export const drawn = signal<Record<string, Drawn>>({});
/** The part of the time that histories show [s]; all of it where there is none. */
export const span = signal<[number, number] | null>(null);
/** The contact point that histories are of, by its number; the one of the gap that is hit hardest where there is none. */
export const point = signal<number | null>(null);

/** The time that is pointed at in one of the histories [s], for a line through all of them. */
export const pointed = signal<number | null>(null);

/** Width on the page of each kind [px], and which are in sight. */
const placed = new Map<string, number>(), inSight = new Set<string>();
/** Which are of the run that is shown, and of what is chosen; others are of what was before until they are drawn. */
export const fresh = signal<ReadonlySet<string>>(new Set());
const isFresh = (kind: string) => fresh.peek().has(kind);

const LETTERS = 1.15; // larger than on paper
const TELEPHONE = 600; // [px] up to which panels stand one below another
/** Beside histories what is of one place: where a run has several gaps, of the one that is chosen. */
const ofPlace = ["impact", "loop", "scene", "friction-cone"];
const CENTIMETRE = 96 / 2.54; // [px]

/** What a kind is drawn by; nothing where it cannot be. */
export function wanted(kind: string, pixels: number): Wanted | null {
  const width = Math.max(6, pixels / CENTIMETRE / LETTERS), narrow = pixels > 0 && pixels <= TELEPHONE;
  if (kind === "gap-curve") {
    const all = curve.value;
    if (all.length < 2) return null;
    return { width, narrow, curve: { gap: gap.value, widths: all.map((one) => one.width), forces: all.map((one) => one.force), amplifications: all.map((one) => one.amplification) } };
  }
  const now = result.value;
  const figure = now?.overview.figures.find((one) => one.kind === kind);
  const [from, to] = (figure?.overTime && span.value) || [];
  const place = point.value === null ? undefined : now?.overview.points[point.value];
  const isOfGap = now && now.overview.gaps.length > 1 && (figure?.overTime || ofPlace.includes(kind)) && now.overview.points.some((one) => one.gap === gap.value);
  return { width, narrow, from, to, gap: place?.gap ?? (isOfGap ? gap.value : undefined), elevation: place?.elevation };
}

function wantedOf(kinds: Iterable<string>): [string, Wanted][] {
  return [...kinds].flatMap((kind): [string, Wanted][] => {
    const one = wanted(kind, placed.get(kind)!);
    return one ? [[kind, one]] : [];
  });
}

/** Every kind in sight, for a run to be drawn by at once. */
export const wantedNow = () => wantedOf(inSight);

let speaks = "";
/** Takes the figures of a run that has just been solved; those out of sight are of the run before, if in the same language.
 *  `later`: of a case that has just come all are yet to be drawn, and none of the one before stays. */
export function take(made: Record<string, Drawn>, later = false) {
  fresh.value = new Set(Object.keys(made));
  if (later) drawInSight();
  drawOthers(QUIET);
  drawn.value = { ...(speaks === language.value && !later ? drawn.value : {}), ...made };
  speaks = language.value;
}

function draw(kinds: [string, Wanted][]) {
  if (kinds.length === 0 || solvedText.value !== text.value) return; // a run that is under way brings its own
  live.ask({ kind: "draw", text: text.value, record: chosen.value, language: language.value, draw: kinds }, (answer) => {
    if (answer.kind !== "drawn") return;
    batch(() => {
      fresh.value = new Set([...fresh.value, ...Object.keys(answer.drawn)]);
      drawn.value = { ...drawn.value, ...answer.drawn };
    });
    if (answer.more === 0 && Object.keys(answer.drawn).length > 0) drawOthers(0);
  });
}

/** A figure stands on the page, so wide, in sight or not; or, without a width, no longer does. */
export function see(kind: string, pixels: number | null, isInSight = false) {
  const before = placed.get(kind);
  if (pixels === null || !isInSight) inSight.delete(kind);
  if (pixels === null) {
    placed.delete(kind);
    return;
  }
  placed.set(kind, pixels);
  if (before !== undefined && Math.abs(before - pixels) > 1) outdate(kind);
  if (isInSight) inSight.add(kind);
  if (isFresh(kind)) return;
  if (isInSight) drawInSight();
  else drawOthers(QUIET);
}

function outdate(kind: string) {
  if (isFresh(kind)) fresh.value = new Set([...fresh.peek()].filter((one) => one !== kind));
}

let due = 0;
/** Draws what is in sight and of before, once for all that is asked for in a moment. */
function drawInSight() {
  clearTimeout(due);
  due = window.setTimeout(() => draw(wantedNow().filter(isOld)), 0);
}

const isOld = ([kind]: [string, Wanted]) => !isFresh(kind);

const QUIET = 400; // [ms] without a run or a choice, after which figures out of sight are drawn too
let later = 0;
/** Draws the figures out of sight one after the other, as long as nothing else is asked for, so that no part of the page
 *  is blank where it is printed. */
function drawOthers(quiet: number) {
  clearTimeout(later);
  later = window.setTimeout(() => {
    const seen = wantedNow().filter(isOld);
    draw(seen.length > 0 ? seen : wantedOf(placed.keys()).filter(isOld).slice(0, 1));
  }, quiet);
}
addEventListener("beforeprint", () => draw(wantedOf(placed.keys()).filter(isOld)));

/** From now on what is chosen is drawn. */
export function beginDrawing() {
  effect(() => {
    void span.value;
    void point.value;
    void gap.value;
    fresh.value = new Set(); // all was drawn by what was chosen before
    untracked(() => { drawInSight(); drawOthers(QUIET); });
  });
  effect(() => {
    void curve.value;
    outdate("gap-curve");
    untracked(() => { drawInSight(); drawOthers(QUIET); });
  });
  let shown = ""; // another case has other times and points
  effect(() => {
    const now = result.value?.overview;
    const key = now ? JSON.stringify([now.duration, now.points]) : "";
    if (key !== shown) batch(() => { span.value = null; point.value = null; });
    shown = key;
  });
}
