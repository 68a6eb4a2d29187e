import { useState } from "preact/hooks";
import { buildingColour, buildingVariable, Chart, type Curve, curvesSvg } from "./charts";
import { main } from "./motion";
import { nameOf } from "./schema";
import { type BuildingOverview, type GapOverview, type Overview, type Result, type Said, schema } from "./solver";
import { cancel, curve, curveDone, gap, pinned, progress, result, slow, stale, time, width } from "./state";
import { language, number, say } from "./texts";
import { theme } from "./theme";

const unitOf = (overview: Overview) => overview.units.length;
const colour = (index: number) => `var(${buildingVariable(index)})`; // in styles, where a theme is followed
const with_ = (value: number | null | undefined, unit: string) => `${number(value)}\u00a0${unit}`;

/** "Gap 0.05 | 0.04 m". */
export const widthsOf = (overview: Overview) => `${nameOf("gap", "width")} ${overview.gaps.map((one) => number(one.width)).join(" | ")} ${unitOf(overview)}`;

/** Of which case results are. */
export const caseOf = (overview: Overview) => `${overview.title || "–"}, ${widthsOf(overview)}`;

/** Where results are shown that are not of the case that stands there. */
export function Stale({ word = "stale" }: { word?: "stale" | "take.stale" }) {
  return stale.value && result.value ? <p class="stale-note">{say(word, { name: caseOf(result.value.overview) })}</p> : null;
}

const isGrave = (one: Said) => one.severity === "danger" || one.severity === "warning";

/** Statements one below the other; a badge stands once above those that have it, `under` one already. In a row each that is
 *  of one gap begins with its name, where `gaps` are given. */
function Sentences({ all, gaps = [], under = "" }: { all: Said[]; gaps?: GapOverview[]; under?: string }) {
  let badge = under;
  return <>{all.map((one, i) => {
    const shown = one.badge && one.badge !== badge ? (badge = one.badge) : "";
    return <div key={i} data-kind={one.kind}>
      {shown && <p class={`badge${isGrave(one) ? "" : " fine"}`}>{shown}</p>}
      <p class={one.badge || one.severity === "danger" ? "lead" : ""}>{gaps.length > 1 && one.gap !== null ? `${gaps[one.gap].name}: ` : ""}{one.text}</p>
    </div>;
  })}</>;
}

/** What is to be said of the run, as every other door says it: the gravest first. What fails or collides is in sight; of a
 *  row, what is of one gap under its name and badge; what else was found is folded away, unless nothing else is to be told. */
function Statements({ overview }: { overview: Overview }) {
  const row = overview.gaps.length > 1;
  const told = overview.statements.filter((one) => one.severity !== "remark");
  const ofGap = (one: Said) => row && one.gap !== null && one.severity !== "danger";
  const isFolded = (one: Said) => one.severity === "finding" && !one.badge;
  const grave = told.some(isGrave);
  const folded = told.filter((one) => !ofGap(one) && isFolded(one));
  return (
    <div class={`verdict${grave ? " pounds" : ""}`}>
      <Sentences all={told.filter((one) => !ofGap(one) && !isFolded(one))} gaps={overview.gaps} />
      {row && overview.gaps.map((each, i) => {
        const mine = told.filter((one) => ofGap(one) && one.gap === i);
        const badge = mine.find((one) => one.badge);
        return mine.length > 0 && <details key={i} data-gap={each.name} open={i === gap.value}>
          <summary>{each.name}{badge && <>: <span class={`badge${isGrave(badge) ? "" : " fine"}`}>{badge.badge}</span></>}</summary>
          <Sentences all={mine} under={badge?.badge} />
        </details>;
      })}
      {folded.length > 0 && <details open={!grave}><summary>{say("verdict.more")}</summary><Sentences all={folded} gaps={overview.gaps} /></details>}
    </div>
  );
}

/** The verdict's badges in one line: of what is told first, and of the gap that is looked at. */
export function Brief() {
  const all = (result.value?.overview.statements ?? []).filter((one) => one.badge && (one.gap === null || one.gap === gap.value || one.severity === "danger"));
  const badges = new Map(all.map((one) => [one.badge, isGrave(one)]));
  return <p class="brief" aria-hidden="true">{[...badges].map(([badge, grave]) => <span key={badge} class={`badge${grave ? " grave" : ""}`}>{badge}</span>)}</p>;
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

/** Roofs, openings and forces at one level, as curves. */
function historyParts(now: Result, point: number) {
  const { histories, overview } = now;
  const length = unitOf(overview);
  const roofs: Curve[] = histories.buildings.map((building, b) => ({ label: overview.buildings[b].name, colour: buildingColour(b), values: building.displacement[building.displacement.length - 1] }));
  const parts = [{ title: say("history.displacement"), x: histories.time, yLabel: length, curves: roofs }];
  if (histories.opening.length > 0) {
    const at = with_(overview.points[point].elevation, length);
    parts.push({ title: `${say("history.opening")}, ${at}`, x: histories.time, yLabel: length, curves: [{ label: say("history.opening"), colour: buildingColour(4), values: histories.opening[point] }] });
    parts.push({ title: `${say("history.force")}, ${at}`, x: histories.time, yLabel: overview.units.force, curves: [{ label: say("history.force"), colour: buildingColour(5), values: histories.force[point] }] });
  }
  return parts;
}

/** The contact point with the largest force, else the highest of the gap that is looked at. */
export function hardestPoint(now: Result): number {
  const { points, gaps } = now.overview;
  const hardest = gaps[gap.value]?.hardest;
  const mine = points.map((point, i) => ({ ...point, i })).filter((point) => point.gap === gap.value);
  return (mine.find((point) => hardest && point.elevation === hardest.elevation) ?? mine[mine.length - 1])?.i ?? 0;
}

export const historiesSvg = (now: Result) => curvesSvg(historyParts(now, hardestPoint(now)), `${say("time")} [s]`);

export function Histories({ now }: { now: Result }) {
  const [asked, ask] = useState<number | null>(null);
  const points = now.overview.points;
  const point = asked !== null && asked < points.length ? asked : hardestPoint(now);
  return (
    <section id="histories">
      <h2>{say("histories")}</h2>
      {points.length > 1 && <p class="controls"><label>{say("history.point")} <select value={point} onChange={(event) => ask(Number(event.currentTarget.value))}>
        {points.map((one, i) => <option key={i} value={i} selected={i === point}>{now.overview.gaps[one.gap].name}, {with_(one.elevation, unitOf(now.overview))}</option>)}
      </select></label></p>}
      {historyParts(now, point).map((part, i) => <Chart key={i} {...part} xLabel={`${say("time")} [s]`} group="time" mark={time} theme={`${theme.value}${language.value}`}
        onPick={(at) => { main?.pause(); main?.show(at); }} />)}
      <p class="note">{say("history.hint")}</p>
    </section>
  );
}

function Profile({ title, unit, buildings, solid, dashed }: { title: string; unit: string; buildings: BuildingOverview[]; solid: (one: BuildingOverview) => (number | null)[]; dashed?: (one: BuildingOverview) => (number | null)[] }) {
  const moving = buildings.map((one, index) => ({ one, index })).filter(({ one }) => !one.rigid);
  const top = Math.max(...moving.map(({ one }) => one.elevations[one.elevations.length - 1]), 1e-300);
  const most = Math.max(...moving.flatMap(({ one }) => [...solid(one), ...(dashed?.(one) ?? [])].map((value) => value ?? 0)), 1e-300);
  const line = (one: BuildingOverview, values: (number | null)[]) => one.elevations
    .map((level, floor) => [values[floor], level] as const).filter(([value]) => value !== null)
    .map(([value, level], i) => `${i === 0 ? "M" : "L"}${(36 + (190 * value!) / most).toFixed(1)} ${(190 - (175 * level) / top).toFixed(1)}`).join("");
  return (
    <figure class="profile">
      <figcaption>{title}</figcaption>
      <svg viewBox={`0 0 250 ${215 + 12 * Math.ceil(buildings.length / 2)}`} role="img" aria-label={title}>
        <path class="frame" d="M36 10V190H232" />
        <text x="36" y="206">0</text><text x="232" y="206" text-anchor="end">{number(most)} {unit}</text>
        <text x="32" y="20" text-anchor="end">{number(top)}</text><text x="32" y="190" text-anchor="end">0</text>
        {moving.map(({ one, index }) => <>
          <path d={line(one, solid(one))} style={{ stroke: colour(index) }} />
          {dashed && <path d={line(one, dashed(one))} stroke-dasharray="4 3" style={{ stroke: colour(index) }} />}
          <text x={40 + 90 * (index % 2)} y={221 + 12 * Math.floor(index / 2)} style={{ fill: colour(index) }}>{one.name.slice(0, 16)}</text>
        </>)}
      </svg>
    </figure>
  );
}

export function Envelopes({ now }: { now: Result }) {
  const { buildings, units } = now.overview;
  return (
    <section id="envelopes">
      <h2>{say("envelopes")}</h2>
      <div class="profiles">
        <Profile title={say("envelope.displacement")} unit={units.length} buildings={buildings} solid={(one) => one.displacement} dashed={(one) => one.alone} />
        <Profile title={say("envelope.drift")} unit="" buildings={buildings} solid={(one) => one.drift} />
      </div>
      <p class="note">{say("envelope.solid")}</p>
    </section>
  );
}

const LISTED = 200;

export function Impacts({ now }: { now: Result }) {
  const { impacts, units, gaps, impactCount } = now.overview;
  if (impactCount === 0) return <section id="impacts"><h2>{say("impacts")}</h2><p>{say("impact.none")}</p></section>;
  return (
    <section id="impacts">
      <h2>{say("impacts")}</h2>
      <div class="wide scroll" tabIndex={0} role="region" aria-label={say("impacts")}>
        <table>
          <thead><tr>
            <th scope="col">{say("impact.number")}</th><th scope="col" class="t">{nameOf("gap", "width")}</th><th scope="col">{say("history.point")} <small>{units.length}</small></th><th scope="col">{say("impact.start")} <small>s</small></th>
            <th scope="col">{say("impact.duration")} <small>ms</small></th><th scope="col">{say("curve.force")} <small>{units.force}</small></th><th scope="col">{say("impact.speed")} <small>{units.length}/s</small></th><th scope="col">{nameOf("gap", "contact", "restitution")}</th>
          </tr></thead>
          <tbody>{impacts.slice(0, LISTED).map((one, k) => (
            <tr key={k} class={Math.abs(one[4] - now.overview.force) === 0 && one[4] > 0 ? "marked" : ""}>
              <td><button type="button" aria-label={say("impact.show", { n: k + 1 })} onClick={() => { main?.showImpact(main.impacts[k]); document.getElementById("motion")?.scrollIntoView(); }}>{k + 1}</button></td>
              <td class="t">{gaps[one[0]]?.name}</td><td>{number(one[1])}</td><td>{number(one[2])}</td><td>{number(1000 * (one[3] - one[2]))}</td><td>{number(one[4])}</td><td>{number(one[5])}</td><td>{number(one[6])}</td>
            </tr>))}</tbody>
        </table>
      </div>
      {impactCount > LISTED && <p class="note">{say("impact.more", { n: LISTED, all: impactCount })}</p>}
    </section>
  );
}

export function GapCurve({ now }: { now: Result }) {
  const points = curve.value;
  if (points.length < 2) return null;
  const { units, gaps } = now.overview;
  return (
    <section id="curve">
      <h2>{say("curve")}: {gaps[gap.value]?.name}</h2>
      <Chart title={curveDone.value < 1 ? say("curve.progress", { percent: Math.round(100 * curveDone.value) }) : `${say("curve.force")}, ${say("curve.amplification").toLowerCase()}`}
        x={points.map((one) => one.width)} xLabel={`${nameOf("gap", "width")} [${units.length}]`} yLabel={units.force} right={say("curve.amplification")} height={200} mark={width} theme={`${theme.value}${language.value}`}
        curves={[{ label: say("curve.force"), colour: buildingColour(5), values: points.map((one) => one.force) },
          { label: say("curve.amplification"), colour: buildingColour(4), values: points.map((one) => one.amplification), axis: "right", dash: [5, 3] }]} />
      <p class="note">{say("curve.note")}</p>
    </section>
  );
}

/** Shear against drift, for storeys of buildings that yield. */
export function Loops({ now }: { now: Result }) {
  const yielding = now.overview.buildings.map((one, b) => ({ one, b })).filter(({ one }) => one.yields);
  if (yielding.length === 0) return null;
  return (
    <section id="loops">
      <h2>{say("loops")}</h2>
      {yielding.map(({ one, b }) => (
        <div key={b}><p class="note">{say("loop.note", { name: one.name })}</p><div class="loops">
          {now.histories.buildings[b].drift.map((drift, k) => {
            const shear = now.histories.buildings[b].shear[k];
            // A slab on bearings stands below the first storey: it has no height, and its drift is what they slide.
            const slabs = one.heights[0] === 0 ? 1 : 0, slab = k < slabs;
            const name = slab ? nameOf("building", "isolation") : say("storey", { n: k + 1 - slabs });
            const most = (values: Float64Array) => values.reduce((all, value) => Math.max(all, Math.abs(value)), 1e-300);
            const x = most(drift), y = most(shear), by = Math.max(1, Math.floor(drift.length / 4000));
            let d = "";
            for (let i = 0; i < drift.length; i += by) if (Number.isFinite(drift[i])) d += `${d ? "L" : "M"}${(80 + (70 * drift[i]) / x).toFixed(1)} ${(75 - (65 * shear[i]) / y).toFixed(1)}`;
            return d === "" ? null : <figure key={k}><svg viewBox="0 0 160 150" role="img" aria-label={`${one.name}, ${name}`}>
              <path class="frame" d="M10 75H150M80 10V140" /><path d={d} style={{ stroke: colour(b) }} /></svg>
            <figcaption>{name}: {slab ? with_(x, unitOf(now.overview)) : `${number(100 * x)} %`}, {with_(y, now.overview.units.force)}</figcaption></figure>;
          })}
        </div></div>))}
    </section>
  );
}

/** The numbers of a run, in the units of another. */
function compared({ overview }: Result, { units }: Overview): (string | number)[] {
  const by = (what: "length" | "force") => {
    const size = schema.value?.units[what] ?? {};
    return (size[overview.units[what]] ?? NaN) / (size[units[what]] ?? NaN);
  };
  const each = (value: (one: GapOverview) => number) => overview.gaps.map((one) => with_(by("length") * value(one), units.length)).join(" | ");
  return [each((one) => one.width), overview.impactCount, with_(by("force") * overview.force, units.force), each((one) => one.needed), number(overview.amplification)];
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
