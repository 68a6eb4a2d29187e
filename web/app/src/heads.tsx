// What heads a verdict: the badges of statements, of a whole run and of one gap.
import type { Overview, Said } from "./solver";

const grave = ["danger", "warning"];
const isGrave = (one: Said) => grave.includes(one.severity);
export const toneOf = (one: Said) => one.open ? " open" : isGrave(one) ? " grave" : " fine";
/** Where a statement stands among others, the gravest first: by severity, and of those alike what heads a verdict. */
const gravity = (one: Said) => 2 * (isGrave(one) ? grave.indexOf(one.severity) : grave.length) + (one.shown === "sentence" ? 0 : 1);

/** Badges with their tone, each once. */
export function badgesOf({ statements, gaps }: Overview, gap: number | null): Map<string, string> {
  const badged = statements.filter((one) => one.badge);
  if (gap !== null) return new Map(badged.filter((one) => one.gap === gap).map((one) => [one.badge, toneOf(one)]));
  // Of a whole run of several gaps the gravest, whatever gap it is of, and what fails.
  const all = badged.sort((a, b) => gravity(a) - gravity(b));
  return new Map(all.filter((one, i) => i === 0 || one.gap === null || one.severity === "danger" || gaps.length === 1).map((one) => [one.badge, toneOf(one)]));
}

export const Badges = ({ all }: { all: Map<string, string> }) =>
  <>{[...all].map(([badge, tone]) => <span key={badge} class={`badge${tone}`} aria-hidden="true">{badge}</span>)}</>;
