// The case that stands there, and the run of it that is shown: what all of the page reads. Only state.ts writes it.
import { computed, signal } from "@preact/signals";
import { cases } from "./cases";
import { kept } from "./kept";
import { type CurvePoint, type Files, type Result, Solver } from "./solver";
import { outline } from "./toml";

export const before = kept();
export const text = signal<string>(before?.text ?? cases[0].text);
/** Records that were added, each name once: the same text with another file is another case. */
export const files = signal<Files>(before?.files ?? []);
export const found = computed(() => outline(text.value));
/** Whether the buildings stand in plan: by any key that says so, as the library does it. */
export const inPlan = computed(() => (found.value?.leaves ?? []).some(({ path }) => path[0] === "plan" || (path[0] === "building" && path[2] === "plan")));

export const result = signal<Result | null>(null);
export const solvedText = signal("");
/** Which record of a suite is shown in full, from 1; 0: all of them, in short. */
export const chosen = signal(0);
export const gap = signal(0); // the one that the slider is of
export const curve = signal<CurvePoint[]>([]);

export const slow = signal(false); // the solver has been at it for longer than a moment
export const progress = signal(0);
export const live = new Solver((yes) => {
  slow.value = yes;
  if (!yes) progress.value = 0;
});
