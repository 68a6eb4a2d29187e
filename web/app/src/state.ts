// What becomes of the case that stands there: it is changed, run, kept, and given away.
import { batch, computed, effect, signal, untracked } from "@preact/signals";
import { before, chosen, curve, files, found, gap, live, progress, result, slow, solvedText, text } from "./case";
import { cases, records } from "./cases";
import { take as takeDrawn, wanted, wantedNow } from "./drawing";
import { forget, keep } from "./kept";
import { type Answer, type CaseError, type Files, type Overview, type Placed, type Result, Solver, type Take } from "./solver";
import { record, step } from "./steps";
import { isStill } from "./still";
import { grown, type Part, withoutPoints, withPoints } from "./storeys";
import { isSuite, named, uses } from "./suite";
import { hasWord, language, number, say, type Word } from "./texts";
import { type Slot, slotOf } from "./slot";
import { leaf, outline } from "./toml";

export const errors = signal<CaseError[]>([]);
/** Which part of the curve over gaps is there; all of it where the case has none. */
export const curveDone = signal(0);
export const pinned = signal<Result | null>(null);
/** Of all records of a suite the one that hits hardest, in full: its file, and of which run of all it is. */
export const hardest = signal<{ file: string; of: Result; run: Result } | null>(null);
export const hardestRuns = signal(false);
export const time = signal(0);
/** What is wrong with what was dropped, opened, pasted or linked, in the language that there is then. */
export const problem = signal<(() => Told) | null>(null);
if (before?.lost.length) complain("error.unkept", { name: before.lost.join(", ") });
/** Says that in the page's own words. */
export function complain(word: Word, values: Record<string, string | number> = {}) {
  problem.value = () => ({ text: say(word, values), english: false });
}
/** How many cases were loaded: sliders then start anew. */
export const loads = signal(0);
const solvedWith = signal<Files>([]);

/** Whether the results that are shown are of another case than the one that stands there, which is wrong or takes its time. */
export const stale = computed(() => result.value !== null && (errors.value.length > 0 || slow.value) &&
  (text.value !== solvedText.value || files.value !== solvedWith.value || (result.value.overview.suite?.record ?? 0) !== chosen.value));

/** Whether they are of that case, but as it was sampled at once, since it could not be run as it asks to be. */
export const rough = computed(() => result.value !== null && !stale.value && !result.value.fine && errors.value.length > 0);

/** What is being typed in place of a text, and which run was asked for and answered last. */
const typed = signal<{ base: string; next: string; timer: number } | null>(null);
const asked = signal(0), answered = signal(0);

/** What has become of the case that stands there. */
export const standing = computed(() => {
  if (typed.value || asked.value !== answered.value) return "pending";
  return errors.value.length > 0 ? "errors" : result.value === null ? "" : result.value.fine ? "fine" : "rough";
});

/** What went wrong in words; some of the library are English alone. */
export interface Told { text: string; english: boolean }

/** In the page's words where it is the page that says so. */
export function told(one: CaseError): Told {
  const word = `error.${one.message}`, values = Object.entries(one.values ?? {});
  return hasWord(word) ? { text: say(word, Object.fromEntries(values.map(([name, value]) => [name, typeof value === "number" ? number(value) : value]))), english: false }
    : { text: one.told?.[language.value] ?? one.message, english: one.told?.[language.value] === undefined };
}

/** The record that the case names and a link has no room for. */
export const ownRecord = computed(() => {
  const name = leaf(found.value, ["excitation", "file"])?.value;
  return files.value.some(([one]) => one === name || uses(found.value, one));
});
/** Whether what stands there is not what the page begins with. */
export const isOwn = computed(() => text.value !== cases[0].text || files.value.length > 0);
/** The gap that the slider is of, in the text. */
export const slot = computed((): Slot | null => {
  const overview = result.value?.overview;
  return slotOf(found.value, gap.value, overview?.gaps[gap.value], overview?.buildings.map(({ name }) => name) ?? []);
});
export const width = computed(() => slot.value?.width ?? result.value?.overview.gaps[gap.value]?.width ?? 0);

const behind = new Solver(); // curves and files, so that nothing waits for them
const give = (more: Placed) => { for (const solver of [live, behind]) solver.files = [...solver.files, ...more]; };
const builtIn = records.flatMap(([name, bytes]): Files => [[name, bytes], [`../data/${name}`, bytes], [`../../data/${name}`, bytes]]);
let stand = new Map<string, Uint8Array>();

/** Puts the files of the case that stands there where it may name them, and takes away those that are no longer its own. No
 *  pattern of a suite finds the page's records. */
function place() {
  const next = new Map([...builtIn.filter(([name]) => !isSuite(found.value) || named(found.value).includes(name)), ...files.value]);
  const gone = [...stand.keys()].filter((name) => !next.has(name)).map((name): Placed[number] => [name, null]);
  const come = [...next].filter(([name, bytes]) => stand.get(name) !== bytes);
  if (gone.length + come.length > 0) give([...gone, ...come]);
  stand = next;
}

let settle = 0, curveText = "", curveFiles: Files = [];
let seen = -1; // the number of the case whose results are there
let came = 0, looked = -1; // `loads` as a case came in last, and as the gap to look at was found for it

/** The gap that its story has as the worst, or that the gravest that is said is of. */
function worstOf({ statements }: Overview): number {
  const ofGap = statements.filter((one) => one.gap !== null);
  return (ofGap.find((one) => one.rank === 1) ?? ofGap[0])?.gap ?? 0;
}

/** Which gap of a run is looked at: of a case that has just come the worst, else the one that was, by its name, as another
 *  width may bring another order. */
function gapOf(next: Overview, loaded: number): number {
  const name = result.value?.overview.gaps[gap.value]?.name;
  if (looked < came && loaded >= came) {
    looked = loaded;
    return worstOf(next);
  }
  if (next.gaps[gap.value]?.name === name) return gap.value;
  const same = next.gaps.findIndex((one) => one.name === name);
  return same >= 0 ? same : gap.value < next.gaps.length && next.gaps.length === result.value?.overview.gaps.length ? gap.value : worstOf(next);
}

/** Runs the text: roughly sampled at once, finely when nothing has changed for a moment. */
function run(fine: boolean) {
  const wanted = text.value, used = files.value, record = chosen.value;
  clearTimeout(settle);
  place();
  const duration = result.value?.overview.duration ?? 20;
  const number = asked.value += 1, loaded = loads.value, first = loaded !== seen;
  // Of a case that has just come the verdict is there before its figures.
  live.ask({ kind: "run", first, text: wanted, record, language: language.value, step: fine ? null : Math.max(duration / 1000, 0.002), draw: first ? [] : wantedNow() }, (answer) => {
    if (answer.kind === "progress") progress.value = answer.done;
    if (answer.kind === "refused") batch(() => { errors.value = answer.errors; answered.value = number; });
    if (answer.kind === "result") {
      batch(() => {
        answered.value = number;
        errors.value = [];
        gap.value = gapOf(answer.overview, loaded);
        result.value = answer;
        solvedText.value = wanted;
        takeDrawn(answer.drawn, first);
        seen = loaded;
        solvedWith.value = used;
        if (chosen.value === record) chosen.value = answer.overview.suite?.record ?? 0; // a suite may have fewer than before
      });
      if (text.value === wanted && files.value === used && chosen.value === record) {
        if (!answer.fine) settle = window.setTimeout(() => run(true), 250);
        else {
          drawCurve(wanted);
          runHardest(answer, wanted);
        }
      }
    }
  });
}

/** Of a suite the record to look at, once all of them are there. */
function runHardest(of: Result, wanted: string) {
  const { records = [], hardest: record = 0 } = of.overview.suite ?? {};
  hardestRuns.value = record > 0;
  if (record === 0) return;
  behind.ask({ kind: "run", text: wanted, record, language: language.value, step: null, draw: [] }, (answer) => {
    if (result.value !== of || answer.kind === "progress") return;
    hardestRuns.value = false;
    if (answer.kind === "result") hardest.value = { file: records[record - 1], of, run: answer };
  });
}

/** The curve belongs to the case without its gap's width: a drag of the slider does not make it anew. */
function drawCurve(wanted: string) {
  const overview = result.value?.overview;
  const row = overview && !overview.plan ? slotOf(outline(wanted), gap.value, undefined, []) : null;
  if (!overview || isStill(overview) || !row) {
    curveDone.value = 1;
    return;
  }
  const key = `${chosen.value}|${gap.value}|${row.put(wanted, 0)}`;
  if (key === curveText && files.value === curveFiles) return;
  [curveText, curveFiles] = [key, files.value];
  const needed = overview.gaps[gap.value]?.needed ?? 0;
  const most = Math.max(1.25 * needed, 1e-9);
  const list = Array.from({ length: 41 }, (_, k) => (most * k) / 40);
  batch(() => { curve.value = []; curveDone.value = 0; });
  behind.ask({ kind: "curve", text: wanted, record: chosen.value, language: language.value, gap: gap.value, widths: list }, (answer) => {
    if (key !== curveText) return; // of a case that is no longer there
    if (answer.kind === "curve") batch(() => { curve.value = answer.curve; curveDone.value = answer.done; });
    else if (answer.kind === "refused") { curveDone.value = 1; curveText = ""; }
  });
}

let hand = "";

/** Another text; changes `by` the same hand are undone together, steps.ts. */
export function change(next: string, by = "") {
  batch(() => {
    hand = by;
    text.value = next;
    problem.value = null;
  });
}

/** A text that is being typed becomes the case when one stops for a moment; what has come in its place by then stays. */
export function type(next: string) {
  clearTimeout(typed.value?.timer);
  typed.value = { base: text.value, next, timer: window.setTimeout(settleTyping, 150) };
}

function settleTyping() {
  const given = typed.value;
  if (!given) return;
  clearTimeout(given.timer);
  batch(() => {
    typed.value = null;
    if (text.value === given.base) change(given.next, "typing");
  });
}

/** Back to what stood there before a change (-1), or forth again (1). */
export function travel(by: -1 | 1) {
  settleTyping();
  const then = step(by);
  if (!then) return;
  batch(() => {
    text.value = then.text;
    files.value = then.files;
    problem.value = null;
  });
}

/** As the page is when it is opened for the first time; what stood there is one step back. */
export function startAnew() {
  batch(() => {
    files.value = [];
    pinned.value = null;
    load(cases[0].text);
  });
}

export const cancel = () => live.giveUp("cancelled");

const MOST_LINES = 50000; // browsers lay out all lines of a text field at once: a million take them ten seconds

/** Whether a text has more lines than an editor takes, which is said then. */
export function tooLong(next: string): boolean {
  let lines = 0;
  for (let at = next.indexOf("\n"); at >= 0 && lines <= MOST_LINES; at = next.indexOf("\n", at + 1)) ++lines;
  if (lines > MOST_LINES) complain("error.lines", { n: MOST_LINES });
  return lines > MOST_LINES;
}

export function load(given: string) {
  settleTyping();
  const next = given.replace(/\r\n?/g, "\n"); // as a text field has it: places in the one are places in the other
  if (tooLong(next)) return;
  if (next === text.value) return;
  batch(() => {
    text.value = next;
    came = loads.value += 1;
    chosen.value = 0;
    hardest.value = null;
    curve.value = [];
    curveDone.value = 0;
    problem.value = null;
  });
  curveText = "";
}

/** The same case in other units: every number of its text, once and for all. */
export function inUnits(length: string, force: string) {
  const was = text.value;
  curveText = "";
  behind.ask({ kind: "units", text: was, language: language.value, length, force }, (answer) => {
    if (answer.kind === "refused") problem.value = () => told(answer.errors[0]);
    if (answer.kind !== "text" || text.value !== was) return;
    batch(() => {
      text.value = answer.text;
      loads.value += 1;
      curve.value = [];
      curveDone.value = 0;
      problem.value = null;
    });
  });
}

/** Files that the case names already. */
export function addFiles(added: Files) {
  files.value = [...files.value.filter(([one]) => !added.some(([name]) => name === one)), ...added];
}

let growing = Promise.resolve();

/** One storey or bay more or fewer, one after the other; where that is no case, why. */
export function grow(building: number, part: Part, by: 1 | -1) {
  growing = growing.then(() => new Promise((done) => {
    const was = text.value, next = grown(was, building, part, by);
    behind.ask({ kind: "contacts", text: withoutPoints(next), language: language.value }, (answer) => batch(() => {
      done();
      if (answer.kind === "refused") problem.value = () => told(answer.errors[0]);
      if (answer.kind !== "contacts" || text.value !== was) return;
      change(withPoints(next, answer.counts));
    }));
  }));
}

function answerTo<Kind extends Answer["kind"]>(kind: Kind, request: object): Promise<Extract<Answer, { kind: Kind }>> {
  return new Promise((resolve, reject) => {
    behind.ask({ kind: "take", text: text.value, record: chosen.value, language: language.value, ...request }, (answer) => {
      if (answer.kind === kind) resolve(answer as Extract<Answer, { kind: Kind }>);
      if (answer.kind === "refused") reject(told(answer.errors[0]));
    });
  });
}

export const take = (what: Take) => answerTo("text", { what }).then((answer) => answer.text);

/** The histories of the case, finely. */
export const takeHistories = () => answerTo("histories", { what: "histories" });

/** A figure as a file of its own, as wide as a journal's column. */
export const takeFigure = (kind: string) => answerTo("text", { what: "figure", draw: [[kind, { ...wanted(kind, 0), width: 8.8 }]] }).then((answer) => answer.text);

const work = computed(() => ({ text: text.value, files: files.value }));
let saving = 0;
function save() {
  clearTimeout(saving);
  if (isOwn.value) keep(work.value);
  else forget();
}
effect(() => {
  const now = work.value;
  untracked(() => record(now, hand));
  hand = "";
  clearTimeout(saving);
  saving = window.setTimeout(save, 500);
});
addEventListener("pagehide", save);

/** From now on what changes is run. */
export function begin() {
  effect(() => {
    void text.value;
    void files.value;
    void chosen.value;
    void language.value;
    untracked(() => run(false));
  });
  effect(() => {
    void gap.value;
    untracked(() => { if (result.value && solvedText.value === text.value) drawCurve(text.value); });
  });
}
