import { Fragment } from "preact";
import { useMemo, useState } from "preact/hooks";
import { main } from "./animation";
import { gap, progress, result, slow } from "./case";
import { Badges, badgesOf, toneOf } from "./heads";
import { nameOf } from "./schema";
import { type Column, type Fact, type GapOverview, type Overview, type Result, type Said, schema } from "./solver";
import { cancel, errors, pinned, rough, stale } from "./state";
import { number, say, valueOf } from "./texts";
import { onTelephone } from "./theme";

const unitOf = (overview: Overview) => overview.units.length;
const with_ = (value: number | null | undefined, unit: string) => `${number(value)}\u00a0${unit}`;

/** "Gap 0.05 | 0.04 m". */
export const widthsOf = (overview: Overview) => `${nameOf("gap", "width")} ${overview.gaps.map((one) => number(one.width)).join(" | ")} ${unitOf(overview)}`;

/** Of which case results are. */
export const caseOf = (overview: Overview) => `${overview.title || "–"}, ${widthsOf(overview)}`;

/** Where results are shown that are not of the case that stands there, or that are sampled coarsely. */
export function Stale({ word = "stale" }: { word?: "stale" | "take.stale" }) {
  if (!result.value || !(stale.value || rough.value)) return null;
  const count = errors.value.length;
  return <p class="stale-note">{stale.value ? say(word, { name: caseOf(result.value.overview) }) : say("rough")}
    {word === "stale" && count > 0 && <> <button type="button" class="small" onClick={() => document.querySelector(".errors")?.scrollIntoView({ block: "center" })}>{say("errors.see", { n: count })}</button></>}</p>;
}

const namesBoth = (gap: string, text: string) => gap.split(" | ").every((building) => text.includes(building));

/** Statements one below the other; a badge stands once above those that have it, unless they are `under` it already. In a
 *  row each that is of one gap begins with its name, where `gaps` are given. */
function Sentences({ all, gaps = [], under = [] }: { all: Said[]; gaps?: GapOverview[]; under?: string[] }) {
  let badge = "";
  return <>{all.map((one, i) => {
    const shown = one.badge && one.badge !== badge && !under.includes(one.badge) ? (badge = one.badge) : "";
    return <div key={i} data-kind={one.kind} data-shown={one.shown}>
      {shown && <p class={`badge${toneOf(one)}`}>{shown}</p>}
      <p class={one.lead ? "lead" : ""}>{gaps.length > 1 && one.gap !== null && !namesBoth(gaps[one.gap].name, one.text) ? `${gaps[one.gap].name}: ` : ""}{one.lead && <strong>{one.lead}</strong>}{one.text.slice(one.lead.length)}</p>
    </div>;
  })}</>;
}

const mostInSight = 3; // gaps: of many that pound more would be a wall of the same badge

/** What is to be said of the run, as every other door says it: its sentences, the gravest first; of a row, what else is of
 *  one gap under its name and badge, those below the worst three folded. Tables have the rest. */
function Statements({ overview }: { overview: Overview }) {
  const row = overview.gaps.length > 1;
  const isTop = (one: Said) => one.shown === "sentence" || one.severity === "danger";
  const told = overview.statements.filter((one) => one.severity !== "remark");
  const ofGap = (one: Said) => row && one.gap !== null && one.shown === "table" && !isTop(one);
  const rank = (i: number) => told.find((one) => one.gap === i)?.rank ?? i;
  const ranked = overview.gaps.map((_, i) => i).filter((i) => told.some((one) => ofGap(one) && one.gap === i)).sort((a, b) => rank(a) - rank(b));
  const isInSight = (i: number) => ranked.indexOf(i) < mostInSight || i === gap.value;
  const inSight = ranked.filter(isInSight), others = ranked.filter((i) => !isInSight(i));
  const one = (i: number) => {
    const each = overview.gaps[i], mine = told.filter((said) => ofGap(said) && said.gap === i);
    const badges = badgesOf(overview, i);
    return <details key={i} data-gap={each.name} open={i === gap.value} onToggle={(event) => { if (event.currentTarget.open) gap.value = i; }}>
      <summary>{each.name}{badges.size > 0 && ":"}{[...badges].map(([badge, tone]) => <Fragment key={badge}> <span class={`badge${tone}`}>{badge}</span></Fragment>)}</summary>
      <Sentences all={mine} under={[...badges.keys()]} />
    </details>;
  };
  return (
    <div class={`verdict ${overview.tone}`}>
      <Sentences all={told.filter(isTop)} gaps={overview.gaps} />
      {inSight.map(one)}
      {others.length > 0 && <details data-others={others.length}>
        <summary>{others.length === 1 ? say("verdict.gap") : say("verdict.gaps", { n: others.length })}</summary>
        {others.map(one)}
      </details>}
    </div>
  );
}

/** In one line where it is short, else in lines that end between the names of two buildings. */
const parted = (name: string) => (name.length <= 24 ? name.replaceAll(" ", "\u00a0") : name.includes(" | ") ? name.split(" | ").map((one) => one.replaceAll(" ", "\u00a0")).join("\u00a0| ") : name);

const heading = ({ head, unit }: Column) => (unit ? `${head} [${unit}]` : head);

/** The tables of the first screen; of several gaps a press on one's name chooses it. */
export function Facts({ all, gaps }: { all: Fact[]; gaps: GapOverview[] }) {
  const named = (name: string) => {
    const i = gaps.length > 1 ? gaps.findIndex((one) => one.name === name) : -1;
    return i < 0 ? parted(name) : <button type="button" aria-pressed={i === gap.value} onClick={() => { gap.value = i; }}>{parted(name)}</button>;
  };
  return <>{all.map(({ heading: title, columns, marked, note }) => <div key={title} class="facts">
    <h3>{title}</h3>
    <div class="wide" tabIndex={0} role="region" aria-label={title}><table class="cards">
      <thead><tr>{columns.map(({ head, unit, numbers }) => <th key={head} scope="col" class={numbers ? "" : "t"}>{head}{unit && <> <small>{unit}</small></>}</th>)}</tr></thead>
      <tbody>{columns[0].cells.map((name, row) => <tr key={row} class={marked.includes(row) ? "marked" : ""}>
        <th scope="row" class="t long">{named(name)}</th>{columns.slice(1).map((column) => <td key={column.head} class={column.numbers ? "" : "t"} data-head={heading(column)}>{column.cells[row]}</td>)}</tr>)}</tbody>
    </table></div>
    {note && <p class="note">{note}</p>}
  </div>)}</>;
}

/** The badges of the whole run in one line, the gravest first; of several gaps it says so, as each has its own. */
export function Brief() {
  const overview = result.value?.overview;
  if (!overview) return <p class="brief" />;
  return <p class="brief" aria-hidden="true">{overview.gaps.length > 1 && <span>{say("verdict.all", { n: overview.gaps.length })}</span>}<Badges all={badgesOf(overview, null)} /></p>;
}

export function Verdict() {
  const now = result.value;
  return (
    <div class="verdicts" role="status" aria-live="polite" aria-atomic="false">
      {slow.value && <p class="busy">{say(now && !stale.value ? "solving.figures" : "solving")} {progress.value > 0 && progress.value < 1 && `${Math.floor(100 * progress.value)} %`} <button type="button" onClick={cancel}>{say("cancel")}</button></p>}
      <div class="unseen"><Stale /></div>
      {now && <Statements overview={now.overview} />}
    </div>
  );
}

const LISTED = 200;

/** What stands in a column, the hardest impact first where that is equal, but of times the first; what is no number is the
 *  least. */
function order({ cells, numbers, unit }: Column, descends: boolean): number[] {
  const values = cells.map((cell) => (numbers ? valueOf(cell) : NaN)).map((value) => (Number.isNaN(value) ? -Infinity : value));
  const compare = (a: number, b: number) => (numbers ? Number(values[a] > values[b]) - Number(values[a] < values[b]) : cells[a].localeCompare(cells[b], undefined, { numeric: true }));
  return cells.map((_, i) => i).sort((a, b) => (descends ? -1 : 1) * compare(a, b) || (unit === "s" ? 0 : a - b));
}

/** The list of impacts as a report has it; a heading sorts by its own column, and once more the other way. */
export function Impacts({ now }: { now: Result }) {
  const { impactColumns: columns, impactCount, force, points } = now.overview;
  const [chosen, sort] = useState<{ head: string; descends: boolean } | null>(null);
  const [whole, setWhole] = useState(false);
  const hardness = columns.findIndex(({ numbers }, k) => k > 0 && numbers); // by which they come
  const found = columns.findIndex(({ head }) => head === chosen?.head), by = found < 0 ? hardness : found, descends = found < 0 || chosen!.descends;
  const sorted = useMemo(() => (columns.length > 0 ? order(columns[by], descends) : []), [columns, by, descends]);
  if (impactCount === 0) return <section id="impacts"><h2>{say("impacts")}</h2><p>{say("impact.none")}</p></section>;
  const listed = columns[0].cells.length;
  const choose = (k: number) => sort({ head: columns[k].head, descends: k === by ? !descends : k !== 0 && columns[k].numbers && columns[k].unit !== "s" });
  const show = (number: number) => {
    const impact = main?.impacts.find((one) => one.number === number);
    if (!impact) return;
    main!.showImpact(impact);
    gap.value = points[impact.point].gap;
    document.getElementById("motion")?.scrollIntoView();
  };
  const most = onTelephone.value ? 8 : 15, isShort = !whole && Math.min(listed, LISTED) > most;
  return (
    <section id="impacts">
      <h2>{say("impacts")}</h2>
      {isShort && <p class="controls"><span>{say(by === hardness && descends ? "impact.hardest" : "impact.first", { n: most, all: impactCount })}</span>
        <button type="button" onClick={() => setWhole(true)}>{say("impact.whole", { n: Math.min(listed, LISTED) })}</button></p>}
      <div class="wide scroll" tabIndex={0} role="region" aria-label={say("impacts")}>
        <table class={isShort ? "cards short" : "cards"}>
          <thead><tr>{columns.map(({ head, unit, numbers }, k) => <th scope="col" key={k} class={numbers ? "" : "t"} aria-sort={k === by ? (descends ? "descending" : "ascending") : undefined}>
            <button type="button" onClick={() => choose(k)}>{head}{k === by && <span aria-hidden="true">{`\u00a0${descends ? "▼" : "▲"}`}</span>}</button>{unit && <> <small>{unit}</small></>}</th>)}</tr></thead>
          <tbody>{sorted.slice(0, LISTED).map((row) => (
            <tr key={columns[0].cells[row]} class={row === 0 && force > 0 ? "marked" : ""}>{columns.map((column, k) =>
              <td key={k} class={column.numbers ? "" : "t long"} data-head={heading(column)}>{k === 0
                ? <button type="button" aria-label={say("impact.show", { n: column.cells[row] })} onClick={() => show(Number(column.cells[row]))}>{column.cells[row]}</button>
                : column.cells[row]}</td>)}</tr>))}</tbody>
        </table>
      </div>
      {impactCount > LISTED && !isShort && <p class="note">{say("impact.more", { n: LISTED, all: impactCount })}{impactCount > listed && ` ${say("impact.cut", { n: listed })}`}</p>}
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
    <tr><th scope="row" class="t long">{say(what)}: {one.overview.title || "–"}</th>{compared(one, now.overview).map((cell, i) => <td key={i} data-head={heads[i]}>{cell}</td>)}</tr>;
  return (
    <section id="compare">
      <h2>{say("compare")}</h2>
      <p class="controls">
        <button type="button" disabled={stale.value} onClick={() => { pinned.value = now; }}>{say("pin")}</button>
        {other && <button type="button" onClick={() => { pinned.value = null; }}>{say("unpin")}</button>}
      </p>
      {other && <>
        <div class="wide" tabIndex={0} role="region" aria-label={say("compare")}><table class="cards"><thead><tr><th scope="col" class="t">{say("variant")}</th>{heads.map((head) => <th scope="col" key={head}>{head}</th>)}</tr></thead>
          <tbody>{row("now", now)}{row("pinned", other)}</tbody></table></div>
      </>}
    </section>
  );
}
