import { main } from "./animation";
import { gap, progress, result, slow } from "./case";
import { nameOf } from "./schema";
import { type GapOverview, type Overview, type Result, type Said, schema } from "./solver";
import { cancel, pinned, rough, stale } from "./state";
import { number, say } from "./texts";

const unitOf = (overview: Overview) => overview.units.length;
const with_ = (value: number | null | undefined, unit: string) => `${number(value)}\u00a0${unit}`;

/** "Gap 0.05 | 0.04 m". */
export const widthsOf = (overview: Overview) => `${nameOf("gap", "width")} ${overview.gaps.map((one) => number(one.width)).join(" | ")} ${unitOf(overview)}`;

/** Of which case results are. */
export const caseOf = (overview: Overview) => `${overview.title || "–"}, ${widthsOf(overview)}`;

/** Where results are shown that are not of the case that stands there, or that are sampled coarsely. */
export function Stale({ word = "stale" }: { word?: "stale" | "take.stale" }) {
  if (!result.value || !(stale.value || rough.value)) return null;
  return <p class="stale-note">{stale.value ? say(word, { name: caseOf(result.value.overview) }) : say("rough")}</p>;
}

const grave = ["danger", "warning"];
/** Where a statement stands among others, the gravest first: by severity, and of those alike what the verdict says in a sentence. */
const gravity = (one: Said) => 2 * (grave.includes(one.severity) ? grave.indexOf(one.severity) : grave.length) + (one.shown === "sentence" ? 0 : 1);
const isGrave = (one: Said) => grave.includes(one.severity);
const toneOf = (one: Said) => one.open ? " open" : isGrave(one) ? " grave" : " fine";

const namesBoth = (gap: string, text: string) => gap.split(" | ").every((building) => text.includes(building));

/** Statements one below the other; a badge stands once above those that have it, `under` one already. In a row each that is
 *  of one gap begins with its name, where `gaps` are given. */
function Sentences({ all, gaps = [], under = "" }: { all: Said[]; gaps?: GapOverview[]; under?: string }) {
  let badge = under;
  return <>{all.map((one, i) => {
    const shown = one.badge && one.badge !== badge ? (badge = one.badge) : "";
    return <div key={i} data-kind={one.kind} data-shown={one.shown}>
      {shown && <p class={`badge${toneOf(one)}`}>{shown}</p>}
      <p class={one.lead ? "lead" : ""}>{gaps.length > 1 && one.gap !== null && !namesBoth(gaps[one.gap].name, one.text) ? `${gaps[one.gap].name}: ` : ""}{one.lead && <strong>{one.lead}</strong>}{one.text.slice(one.lead.length)}</p>
    </div>;
  })}</>;
}

const mostInSight = 10; // gaps, as a report's table has the worst of them

/** What is to be said of the run, as every other door says it: the gravest first. What fails or collides is in sight; of a
 *  row, what is of one gap under its name and badge, those below the worst ten folded; what else was found is folded away,
 *  unless nothing else is to be told. */
function Statements({ overview }: { overview: Overview }) {
  const row = overview.gaps.length > 1;
  const told = overview.statements.filter((one) => one.severity !== "remark");
  const ofGap = (one: Said) => row && one.gap !== null && one.severity !== "danger";
  const isFolded = (one: Said) => one.shown !== "sentence" || (one.severity === "finding" && !one.badge);
  const rank = (i: number) => told.find((one) => one.gap === i)?.rank ?? i;
  const pounds = told.some(isGrave), isOpen = pounds && !told.some((one) => toneOf(one) === " grave");
  const folded = told.filter((one) => !ofGap(one) && isFolded(one));
  const ranked = overview.gaps.map((_, i) => i).filter((i) => told.some((one) => ofGap(one) && one.gap === i)).sort((a, b) => rank(a) - rank(b));
  const isInSight = (i: number) => ranked.indexOf(i) < mostInSight || (!overview.plan && i === gap.value);
  const inSight = ranked.filter(isInSight), others = ranked.filter((i) => !isInSight(i));
  const one = (i: number) => {
    const each = overview.gaps[i], mine = told.filter((said) => ofGap(said) && said.gap === i);
    const badge = mine.find((said) => said.badge);
    return <details key={i} data-gap={each.name} open={overview.plan ? i === ranked[0] : i === gap.value}>
      <summary>{each.name}{badge && <>: <span class={`badge${toneOf(badge)}`}>{badge.badge}</span></>}</summary>
      <Sentences all={mine} under={badge?.badge} />
    </details>;
  };
  return (
    <div class={`verdict${isOpen ? " open" : pounds ? " pounds" : ""}`}>
      <Sentences all={told.filter((one) => !ofGap(one) && !isFolded(one))} gaps={overview.gaps} />
      {inSight.map(one)}
      {others.length > 0 && <details data-others={others.length}>
        <summary>{say("verdict.gaps", { n: others.length })}</summary>
        {others.map(one)}
      </details>}
      {folded.length > 0 && <details open={!pounds}><summary>{say("verdict.more")}</summary><Sentences all={folded} gaps={overview.gaps} /></details>}
    </div>
  );
}

/** The verdict's badges in one line: the gravest of the whole run first, then those of the gap that is looked at. */
export function Brief() {
  const badged = (result.value?.overview.statements ?? []).filter((one) => one.badge).sort((a, b) => gravity(a) - gravity(b));
  const all = badged.filter((one, i) => i === 0 || one.gap === null || one.gap === gap.value || one.severity === "danger");
  const badges = new Map(all.map((one) => [one.badge, toneOf(one)]));
  return <p class="brief" aria-hidden="true">{[...badges].map(([badge, tone]) => <span key={badge} class={`badge${tone}`}>{badge}</span>)}</p>;
}

export function Verdict() {
  const now = result.value;
  return (
    <div class="verdicts" role="status" aria-live="polite" aria-atomic="false">
      {slow.value && <p class="busy">{say("solving")} {progress.value > 0 && `${Math.round(100 * progress.value)} %`} <button type="button" onClick={cancel}>{say("cancel")}</button></p>}
      <Stale />
      {now && <Statements overview={now.overview} />}
    </div>
  );
}

const LISTED = 200;

export function Impacts({ now }: { now: Result }) {
  const { impacts, units, forceUnit, gaps, impactCount } = now.overview;
  if (impactCount === 0) return <section id="impacts"><h2>{say("impacts")}</h2><p>{say("impact.none")}</p></section>;
  return (
    <section id="impacts">
      <h2>{say("impacts")}</h2>
      <div class="wide scroll" tabIndex={0} role="region" aria-label={say("impacts")}>
        <table>
          <thead><tr>
            <th scope="col">{say("impact.number")}</th><th scope="col" class="t">{nameOf("gap", "width")}</th><th scope="col">{say("curve.force")} <small>{forceUnit}</small></th><th scope="col">{say("history.point")} <small>{units.length}</small></th>
            <th scope="col">{say("impact.start")} <small>s</small></th><th scope="col">{say("impact.duration")} <small>ms</small></th><th scope="col">{say("impact.speed")} <small>{units.length}/s</small></th><th scope="col">{say("impact.ratio")}</th>
          </tr></thead>
          <tbody>{impacts.slice(0, LISTED).map((one, k) => (
            <tr key={k} class={Math.abs(one[4] - now.overview.force) === 0 && one[4] > 0 ? "marked" : ""}>
              <td><button type="button" aria-label={say("impact.show", { n: k + 1 })} onClick={() => { main?.showImpact(main.impacts[k]); document.getElementById("motion")?.scrollIntoView(); }}>{k + 1}</button></td>
              <td class="t">{[gaps[one[0]]?.name, one[7]].filter(Boolean).join(", ")}</td><td>{number(one[4])}</td><td>{number(one[1])}</td><td>{number(one[2])}</td><td>{number(1000 * (one[3] - one[2]))}</td><td>{number(one[5])}</td><td>{number(one[6])}</td>
            </tr>))}</tbody>
        </table>
      </div>
      {impactCount > LISTED && <p class="note">{say("impact.more", { n: LISTED, all: impactCount })}</p>}
    </section>
  );
}

/** The numbers of a run, in the units of another. */
function compared({ overview }: Result, { units, forceUnit }: Overview): (string | number)[] {
  const by = (sizes: Record<string, number> = {}, mine: string, theirs: string) => (sizes[mine] ?? NaN) / (sizes[theirs] ?? NaN);
  const length = by(schema.value?.units.length, overview.units.length, units.length), force = by(schema.value?.units.force, overview.forceUnit, forceUnit);
  const each = (value: (one: GapOverview) => number | null) => overview.gaps.map((one) => with_(length * (value(one) ?? NaN), units.length)).join(" | ");
  return [each((one) => one.width), overview.impactCount, with_(force * overview.force, forceUnit), each((one) => one.needed), number(overview.amplification)];
}

export function Comparison({ now }: { now: Result }) {
  const other = pinned.value;
  const heads = [nameOf("gap", "width"), say("impacts"), say("curve.force"), say("compare.needed"), say("curve.amplification")];
  const row = (what: "now" | "pinned", one: Result) =>
    <tr><th scope="row" class="t">{say(what)}: {one.overview.title || "–"}</th>{compared(one, now.overview).map((cell, i) => <td key={i}>{cell}</td>)}</tr>;
  return (
    <section id="compare">
      <h2>{say("compare")}</h2>
      <p class="controls">
        <button type="button" disabled={stale.value} onClick={() => { pinned.value = now; }}>{say("pin")}</button>
        {other && <button type="button" onClick={() => { pinned.value = null; }}>{say("unpin")}</button>}
      </p>
      {other && <>
        <div class="wide" tabIndex={0} role="region" aria-label={say("compare")}><table><thead><tr><th scope="col" class="t">{say("variant")}</th>{heads.map((head) => <th scope="col" key={head}>{head}</th>)}</tr></thead>
          <tbody>{row("now", now)}{row("pinned", other)}</tbody></table></div>
      </>}
    </section>
  );
}
