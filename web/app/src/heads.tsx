// What heads a verdict: the badges of statements, of a whole run and of one gap.
import type { Overview, Said } from "./solver";
import { say } from "./texts";

const grave = ["danger", "warning"];
export const isGrave = (one: Said) => grave.includes(one.severity);
export const toneOf = (one: Said) => one.open ? " open" : isGrave(one) ? " grave" : " fine";
/** Where a statement stands among others, the gravest first: by severity, and of those alike what the verdict says in a sentence. */
const gravity = (one: Said) => 2 * (isGrave(one) ? grave.indexOf(one.severity) : grave.length) + (one.shown === "sentence" ? 0 : 1);

/** Statements with what is known of a gap before what is not: rules that ask for more than is given head what is not known
 *  of its motion. Nothing else is another order or another head. */
export function headed(all: Said[]): Said[] {
  const isOpen = (one: Said) => one.open && one.badge !== "";
  const heads = (one: Said) => one.kind === "rules_short" && isGrave(one) && all.some((other) => isOpen(other) && other.gap === one.gap);
  const rest = all.filter((one) => !heads(one));
  return rest.flatMap((one) => [...isOpen(one) ? all.filter((other) => heads(other) && other.gap === one.gap).map((other) => ({ ...other, badge: say("verdict.rules") })) : [], one]);
}

/** Badges with their tone, each once. */
export function badgesOf({ statements }: Overview, gap: number | null): Map<string, string> {
  const badged = headed(statements).filter((one) => one.badge);
  if (gap !== null) return new Map(badged.filter((one) => one.gap === gap).map((one) => [one.badge, toneOf(one)]));
  // Of the whole run the gravest, whatever gap it is of, what stands before it, and what fails.
  const all = badged.map((one, i) => ({ one, i })).sort((a, b) => gravity(a.one) - gravity(b.one) || a.i - b.i).map(({ one }) => one);
  return new Map(all.filter((one, i) => i === 0 || one.gap === null || one.severity === "danger").map((one) => [one.badge, toneOf(one)]));
}

export const Badges = ({ all }: { all: Map<string, string> }) =>
  <>{[...all].map(([badge, tone]) => <span key={badge} class={`badge${tone}`} aria-hidden="true">{badge}</span>)}</>;
