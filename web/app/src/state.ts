// What the page knows: one text, from which everything else follows.
import { batch, computed, effect, signal, untracked } from "@preact/signals";
import { cases, recordBytes, recordName } from "./cases";
import { type CaseError, type CurvePoint, type Result, Solver, type Take } from "./solver";
import { language, say, type Word } from "./texts";
import { outline, widths, withWidth } from "./toml";

export const text = signal<string>(cases[0].text);
export const chosen = signal<string>(cases[0].id);
export const errors = signal<CaseError[]>([]);
export const result = signal<Result | null>(null);
export const solvedText = signal("");
export const slow = signal(false); // the solver has been at it for longer than a moment
export const progress = signal(0);
export const gap = signal(0); // the one that the slider is of
export const curve = signal<CurvePoint[]>([]);
export const curveDone = signal(1);
export const pinned = signal<Result | null>(null);
export const time = signal(0);
/** What is wrong with what was dropped, opened, pasted or linked, in the language that there is then. */
export const problem = signal<(() => string) | null>(null);
/** How many cases were loaded: sliders then start anew. */
export const loads = signal(0);
export const ownRecord = signal(false);
/** How many files were added: the same text with another file is another case. */
const added = signal(0);
const solvedWith = signal(0);

/** Whether the results that are shown are of another case than the one that stands there, which is wrong or takes its time. */
export const stale = computed(() => result.value !== null && (errors.value.length > 0 || slow.value) &&
  (text.value !== solvedText.value || added.value !== solvedWith.value));

/** Whether a text is being typed, and which run was asked for and answered last. */
export const typing = signal(false);
const asked = signal(0), answered = signal(0);

/** What has become of the case that stands there. */
export const standing = computed(() => {
  if (typing.value || asked.value !== answered.value) return "pending";
  return errors.value.length > 0 ? "errors" : result.value === null ? "" : result.value.fine ? "fine" : "rough";
});

const OWN = new Set(["cancelled", "limit", "worker"]);

/** What went wrong, in the page's words where it is the page that says so. */
export const told = (one: CaseError) => (OWN.has(one.message) ? say(`error.${one.message}` as Word) : one.message);

export const found = computed(() => outline(text.value));
export const width = computed(() => {
  const values = widths(found.value, gap.value).map((one) => one.value as number);
  return values.length > 0 ? Math.min(...values) : 0;
});

const live = new Solver((yes) => {
  slow.value = yes;
  if (!yes) progress.value = 0;
});
const behind = new Solver(); // curves and files, so that nothing waits for them
for (const solver of [live, behind]) solver.files = [[recordName, recordBytes], [`../data/${recordName}`, recordBytes]];

let settle = 0, curveText = "";

/** Runs the text: roughly sampled at once, finely when nothing has changed for a moment. */
function run(fine: boolean) {
  const wanted = text.value, files = added.value;
  clearTimeout(settle);
  const duration = result.value?.overview.duration ?? 20;
  const number = asked.value += 1;
  live.ask({ kind: "run", text: wanted, language: language.value, step: fine ? null : Math.max(duration / 1000, 0.002) }, (answer) => {
    if (answer.kind === "progress") progress.value = answer.done;
    if (answer.kind === "refused") batch(() => { errors.value = answer.errors; answered.value = number; });
    if (answer.kind === "result") {
      batch(() => {
        answered.value = number;
        errors.value = [];
        result.value = answer;
        solvedText.value = wanted;
        solvedWith.value = files;
      });
      if (text.value === wanted && added.value === files) {
        if (!fine) settle = window.setTimeout(() => run(true), 250);
        else drawCurve(wanted);
      }
    }
  });
}

/** The curve belongs to the case without its gap's width: a drag of the slider does not make it anew. */
function drawCurve(wanted: string) {
  const overview = result.value?.overview;
  if (!overview || widths(outline(wanted), gap.value).length === 0) return;
  const key = `${gap.value}|${added.value}|${withWidth(wanted, gap.value, 0)}`;
  if (key === curveText) return;
  curveText = key;
  const needed = overview.gaps[gap.value]?.needed ?? 0;
  const most = Math.max(1.25 * needed, 1e-9);
  const list = Array.from({ length: 41 }, (_, k) => (most * k) / 40);
  curve.value = [];
  behind.ask({ kind: "curve", text: wanted, language: language.value, gap: gap.value, widths: list }, (answer) => {
    if (answer.kind === "curve") batch(() => { curve.value = answer.curve; curveDone.value = answer.done; });
    else if (answer.kind === "refused") { curveDone.value = 1; curveText = ""; }
  });
}

export const change = (next: string) => { text.value = next; };

export const cancel = () => live.giveUp("cancelled");

const MOST_LINES = 50000; // browsers lay out all lines of a text field at once: a million take them ten seconds

/** Whether a text has more lines than an editor takes, which is said then. */
export function tooLong(next: string): boolean {
  let lines = 0;
  for (let at = next.indexOf("\n"); at >= 0 && lines <= MOST_LINES; at = next.indexOf("\n", at + 1)) ++lines;
  if (lines > MOST_LINES) problem.value = () => say("error.lines", { n: MOST_LINES });
  return lines > MOST_LINES;
}

export function load(given: string, id = "") {
  const next = given.replace(/\r\n?/g, "\n"); // as a text field has it: places in the one are places in the other
  if (tooLong(next)) return;
  if (next === text.value) {
    chosen.value = id;
    return;
  }
  batch(() => {
    text.value = next;
    chosen.value = id;
    loads.value += 1;
    gap.value = 0;
    curve.value = [];
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
      problem.value = null;
    });
  });
}

export function addFile(name: string, bytes: Uint8Array) {
  for (const solver of [live, behind]) solver.files = [...solver.files, [name, bytes]];
  ownRecord.value = true;
  added.value += 1;
}

/** The unit that a file says it is in; "" where it says none. */
export function recordUnit(name: string, hear: (unit: string) => void) {
  live.ask({ kind: "record", name }, (answer) => hear(answer.kind === "text" ? answer.text : ""));
}

export function take(what: Take): Promise<string> {
  return new Promise((resolve, reject) => {
    behind.ask({ kind: "take", what, text: text.value, language: language.value }, (answer) => {
      if (answer.kind === "text") resolve(answer.text);
      if (answer.kind === "refused") reject(new Error(told(answer.errors[0])));
    });
  });
}

/** From now on what changes is run. */
export function begin() {
  effect(() => {
    void text.value;
    void added.value;
    void language.value;
    untracked(() => run(false));
  });
  effect(() => {
    void gap.value;
    untracked(() => { if (result.value && solvedText.value === text.value) drawCurve(text.value); });
  });
}
