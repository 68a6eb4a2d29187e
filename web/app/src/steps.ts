// What stood there before each change, to go back to.
import { computed, signal } from "@preact/signals";
import type { Work } from "./kept";

const MOST = 200, MOST_TEXT = 2e7; // steps, characters of all of them
const MOMENT = 1000; // [ms] within which changes of one number, or what is typed, are one step

const steps = signal<Work[]>([]);
const at = signal(-1);
let gesture = "", last = 0, held = false;
for (const [event, down] of [["pointerdown", true], ["pointerup", false], ["pointercancel", false]] as const) {
  addEventListener(event, () => {
    held = down;
    gesture = ""; // a drag is one step, however long it takes, and the next one another
  }, true);
}

export const canUndo = computed(() => at.value > 0);
export const canRedo = computed(() => at.value + 1 < steps.value.length);

/** A change; those that follow one another `by` the same hand are one step. */
export function record(now: Work, by: string) {
  const before = steps.value[at.value];
  if (now.text === before?.text && now.files === before.files) return;
  const time = performance.now();
  const goesOn = by !== "" && by === gesture && (held || time - last < MOMENT) && !canRedo.value;
  [gesture, last] = [by, time];
  const all = [...steps.value.slice(0, at.value + (goesOn ? 0 : 1)), now];
  let size = all.reduce((sum, one) => sum + one.text.length, 0);
  while (all.length > 2 && (all.length > MOST || size > MOST_TEXT)) size -= all.shift()!.text.length;
  steps.value = all;
  at.value = all.length - 1;
}

/** The step before (-1) or after (1) the one that stands there, which it then is. */
export function step(by: -1 | 1): Work | undefined {
  const next = steps.value[at.value + by];
  if (next) at.value += by;
  gesture = "";
  return next;
}
