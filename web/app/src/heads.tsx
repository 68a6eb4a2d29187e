// What heads a verdict: the badges of statements, of a whole run and of one gap.
import type { Overview, Said } from "./solver";
import { say } from "./texts";

const grave = ["danger", "warning"];
export const isGrave = (one: Said) => grave.includes(one.severity);
export const toneOf = (one: Said) => one.open ? " open" : isGrave(one) ? " grave" : " fine";
const rules = "rules_short";
/** Where a statement stands among others, the gravest first: by severity, and of those alike what heads a verdict. */
const gravity = (one: Said) => 2 * (isGrave(one) ? grave.indexOf(one.severity) : grave.length) + (one.shown === "sentence" || one.kind === rules ? 0 : 1);

/** Statements with what is known of a gap before what is not: rules that ask for more than is given head what is not known
 *  of its motion. Nothing else is another order or another head. */
export function headed(all: Said[]): Said[] {
  const isOpen = (one: Said) => one.open && one.badge !== "";
  const heads = (one: Said) => one.kind === rules && isGrave(one) && all.some((other) => isOpen(other) && other.gap === one.gap);
  const rest = all.filter((one) => !heads(one));
  return rest.flatMap((one) => [...isOpen(one) ? all.filter((other) => heads(other) && other.gap === one.gap).map((other) => ({ ...other, badge: say("verdict.rules") })) : [], one]);
}

/** Badges with their tone, each once. */
export function badgesOf({ statements, gaps }: Overview, gap: number | null): Map<string, string> {
  const badged = headed(statements).filter((one) => one.badge);
  if (gap !== null) return new Map(badged.filter((one) => one.gap === gap).map((one) => [one.badge, toneOf(one)]));
  // Of a whole run of several gaps the gravest, whatever gap it is of, and what fails.
  const all = badged.sort((a, b) => gravity(a) - gravity(b));
  return new Map(all.filter((one, i) => i === 0 || one.gap === null || one.severity === "danger" || gaps.length === 1).map((one) => [one.badge, toneOf(one)]));
}

export const Badges = ({ all }: { all: Map<string, string> }) =>
  <>{[...all].map(([badge, tone]) => <span key={badge} class={`badge${tone}`} aria-hidden="true">{badge}</span>)}</>;
