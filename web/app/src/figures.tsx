import { useSignalEffect } from "@preact/signals";
import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import { curve, gap } from "./case";
import { drawn, fresh, point, pointed, see, span } from "./drawing";
import { main } from "./animation";
import { png, save } from "./save";
import type { AxisPlace, Drawn, FigureOverview, PanelPlace, Result } from "./solver";
import { curveDone, errors, rough, stale, takeFigure, time } from "./state";
import { isStill } from "./still";
import { number, say } from "./texts";

const ofAxis = (axis: AxisPlace, value: number) => (axis.logarithmic
  ? Math.log(value / axis.from) / Math.log(axis.to / axis.from) : (value - axis.from) / (axis.to - axis.from));
const onAxis = (axis: AxisPlace, part: number) => (axis.logarithmic
  ? axis.from * (axis.to / axis.from) ** part : axis.from + part * (axis.to - axis.from));

/** Where a curve is at x, between its points; nothing where x goes to and fro or lies beside it. */
function valueAt(x: Float64Array, y: Float64Array, at: number): number | null {
  let low = 0, high = x.length - 1;
  if (high < 1 || !(at >= x[0] && at <= x[high])) return null;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (x[middle] <= at) low = middle;
    else high = middle;
  }
  const length = x[high] - x[low];
  return length > 0 ? y[low] + ((at - x[low]) / length) * (y[high] - y[low]) : y[high];
}

interface Place { panel: PanelPlace; x: number; y: number; scale: number }

/** The panel that is pointed at, and the values there. */
function placeOf(event: PointerEvent | MouseEvent, shown: Drawn): Place | null {
  const svg = (event.currentTarget as HTMLElement).querySelector("svg")!.getBoundingClientRect();
  const scale = svg.width / ((shown.width / 2.54) * 96);
  const [px, py] = [(event.clientX - svg.left) / scale, (event.clientY - svg.top) / scale];
  const panel = shown.panels.find((one) => px >= one.left && px <= one.left + one.width && py >= one.top && py <= one.top + one.height);
  if (!panel) return null;
  return { panel, scale, x: onAxis(panel.x, (px - panel.left) / panel.width), y: onAxis(panel.y, 1 - (py - panel.top) / panel.height) };
}

/** A value with the unit that an axis says, "m" of "Opening g [m]"; of a panel without a label that of its neighbour. */
function withUnit(value: number, { label }: AxisPlace, others: AxisPlace[]): string {
  const unit = /\[([^\]–]+)\]\s*$/.exec(label || others.find((one) => one.label)?.label || "")?.[1];
  return unit ? `${number(value)}\u00a0${unit}` : number(value);
}

/** The x axes of panels that stand in one column, the lowest first, which all may share its label. */
const columnOf = (panel: PanelPlace, shown: Drawn) => shown.panels.filter((one) => one.left === panel.left).map((one) => one.x).reverse();

/** Of histories not every panel is over time: paths have displacements along both axes. */
const isOverTime = (panel: PanelPlace, shown: Drawn) => withUnit(0, panel.x, columnOf(panel, shown)).endsWith("\u00a0s");

/** The values under a place, a line each: of each history at its time, else of the nearest point. */
function told({ panel, x, y }: Place, shown: Drawn, overTime: boolean, times: string): string[] {
  const name = (label: string) => (label ? `${label}: ` : "");
  const beside = shown.panels.filter((one) => one.top === panel.top).map((one) => one.y);
  const below = columnOf(panel, shown);
  if (overTime && isOverTime(panel, shown)) {
    const values = panel.curves.flatMap((one) => { const value = valueAt(one.x, one.y, x); return value === null ? [] : [`${name(one.label)}${withUnit(value, panel.y, beside)}`]; });
    return [`${times} ${number(x)}\u00a0s`, ...values];
  }
  let best: string[] = [], least = (12 / panel.width) ** 2; // nothing that is further than some pixels
  for (const one of panel.curves) {
    for (let i = 0; i < one.x.length; ++i) {
      const [dx, dy] = [ofAxis(panel.x, one.x[i]) - ofAxis(panel.x, x), (ofAxis(panel.y, one.y[i]) - ofAxis(panel.y, y)) * (panel.height / panel.width)];
      const size = dx * dx + dy * dy;
      if (size < least) [least, best] = [size, [`${name(one.label)}${withUnit(one.x[i], panel.x, below)}, ${withUnit(one.y[i], panel.y, beside)}`]];
    }
  }
  return best;
}

/** Where values are told of a place, from the upper left of the figure [px]: beside it, on the side on which the fewest
 *  points of curves would be covered. */
function besides({ panel, scale }: Place, [px, py]: [number, number], lines: string[], wide: number): { left: number; top: number } {
  const letter = 7, high = 17 * lines.length + 8, broad = letter * Math.max(...lines.map((line) => line.length)) + 16, off = 14;
  const points = panel.curves.flatMap(({ x, y }) => {
    const step = Math.max(1, Math.floor(x.length / 2000));
    return Array.from({ length: Math.floor(x.length / step) }, (_, k) => [(panel.left + ofAxis(panel.x, x[k * step]) * panel.width) * scale,
      (panel.top + (1 - ofAxis(panel.y, y[k * step])) * panel.height) * scale]);
  });
  let best = { left: 0, top: 0 }, least = Infinity;
  for (const top of [py + off, py - off - high]) {
    for (const left of [px + off, px - off - broad]) {
      if (left < 0 || left + broad > wide) continue;
      const covered = points.filter(([x, y]) => x >= left && x <= left + broad && y >= top && y <= top + high).length;
      if (covered < least) [best, least] = [{ left, top }, covered];
    }
  }
  return least < Infinity ? best : { left: Math.max(0, Math.min(px, wide - broad)), top: (panel.top + panel.height) * scale + off };
}

/** Whether no figure is of the case that stands there, since that has errors. */
const isWrong = () => stale.value && errors.value.length > 0;

/** Why a figure is not there. */
const none = () => say(isWrong() ? "figures.wrong" : rough.value ? "figures.rough" : "figures.drawing");

/** A figure as files, as `bentur plot` writes it. */
function Files({ kind, caption, off = false }: Pick<FigureOverview, "kind" | "caption"> & { off?: boolean }) {
  const file = (save_: (svg: string) => void) => { void takeFigure(kind).then(save_).catch(() => undefined); };
  return (
    <span class="files">{(["svg", "png"] as const).map((format) => <button type="button" key={format} class="small" disabled={stale.value || off} data-file={`${kind}.${format}`} aria-label={`${caption}, ${format.toUpperCase()}`}
      onClick={() => file((svg) => (format === "svg" ? save(`${kind}.svg`, svg, "image/svg+xml") : void png(svg).then((blob) => save(`${kind}.png`, blob, "image/png"))))}>{format.toUpperCase()}</button>)}</span>
  );
}

/** One figure by the solver: values where one points, the time of the motion, and what is dragged over for a closer look. */
function FigureView({ kind, caption, overTime }: Omit<FigureOverview, "tells">) {
  const root = useRef<HTMLDivElement>(null), heads = useRef<(HTMLElement | null)[]>([]), hairs = useRef<(HTMLElement | null)[]>([]);
  const [tip, tell] = useState<{ lines: string[]; left: number; top: number } | null>(null);
  const [drag, pull] = useState<{ from: Place; to: Place } | null>(null);
  const made = drawn.value[kind], shown = made?.error === undefined && !isWrong() ? made : undefined, tall = useRef(0);
  useEffect(() => {
    let visible = false;
    const figure = root.current!.parentElement!;
    const look = () => see(kind, figure.clientWidth, visible);
    const sight = new IntersectionObserver(([{ isIntersecting }]) => { visible = isIntersecting; look(); }, { rootMargin: "50%" });
    const size = new ResizeObserver(look);
    sight.observe(figure);
    size.observe(figure);
    return () => { sight.disconnect(); size.disconnect(); see(kind, null); };
  }, [kind]);
  const placeLines = (lines: (HTMLElement | null)[], at: number | null) => lines.forEach((line, i) => {
    const panel = shown?.panels[i];
    if (!line || !panel) return;
    const part = at === null || !isOverTime(panel, shown) ? NaN : ofAxis(panel.x, at);
    line.hidden = !(part >= 0 && part <= 1);
    if (!line.hidden) line.style.left = `${(100 * (panel.left + part * panel.width)) / ((shown.width / 2.54) * 96)}%`;
  });
  const placeHeads = () => placeLines(heads.current, time.value), placeHairs = () => placeLines(hairs.current, pointed.value);
  useSignalEffect(() => { void time.value; placeHeads(); });
  useSignalEffect(() => { void pointed.value; placeHairs(); });
  useEffect(() => { placeHeads(); placeHairs(); }, [shown]);
  const high = /viewBox="0 0 \S+ (\S+)"/.exec(shown?.svg ?? "")?.[1];
  const percent = (value: number) => `${(100 * value) / Number(high)}%`;
  const times = say("time");
  const move = (event: PointerEvent) => {
    const at = shown && placeOf(event, shown);
    const lines = at ? told(at, shown!, overTime, times) : [];
    const sheet = root.current!.getBoundingClientRect();
    tell(at && lines.length > 0 ? { lines, ...besides(at, [event.clientX - sheet.left, event.clientY - sheet.top], lines, sheet.width) } : null);
    if (overTime) pointed.value = at && isOverTime(at.panel, shown!) ? at.x : null;
    if (drag && at && at.panel === drag.from.panel) pull({ ...drag, to: at });
  };
  const lift = () => {
    if (!drag) return;
    const ends = [drag.from.x, drag.to.x].sort((a, b) => a - b) as [number, number];
    const wide = (Math.abs(ofAxis(drag.from.panel.x, ends[1]) - ofAxis(drag.from.panel.x, ends[0]))) * drag.from.panel.width * drag.from.scale;
    if (wide > 4) span.value = ends;
    else { main?.pause(); main?.show(drag.from.x); }
    pull(null);
  };
  const left = (at: Place) => `${(100 * (at.panel.left + ofAxis(at.panel.x, at.x) * at.panel.width)) / ((shown!.width / 2.54) * 96)}%`;
  const isOld = !fresh.value.has(kind); // of the run before, or of what was chosen before
  useLayoutEffect(() => { if (shown) tall.current = root.current!.clientHeight; }); // which it keeps while it is blank
  const isBroad = (shown?.width ?? 0) > 15; // on a telephone it is moved sideways
  return (
    <figure class={`drawn${isBroad ? " broad" : ""}${shown && isOld ? " old" : ""}`} data-figure={kind} tabIndex={isBroad ? 0 : undefined}>
      <div ref={root} class="sheet" onPointerMove={move} onPointerLeave={() => { tell(null); pull(null); pointed.value = null; }}
        onPointerDown={(event) => { const at = overTime && event.button === 0 && shown ? placeOf(event, shown) : null; if (at && isOverTime(at.panel, shown!)) pull({ from: at, to: at }); }}
        onPointerUp={lift} onDblClick={() => { if (overTime) span.value = null; }}>
        {shown ? <div dangerouslySetInnerHTML={{ __html: shown.svg }} />
          : <p class="blank note" style={tall.current > 0 ? { height: `${tall.current}px` } : {}} lang={!isWrong() && made?.error !== undefined ? "en" : undefined}>{(!isWrong() && made?.error) || none()}</p>}
        {shown && isOld && <p class="redrawn note">{none()}</p>}
        {overTime && shown?.panels.map((panel, i) => <i key={i} class="instant" hidden ref={(node) => { heads.current[i] = node; }} style={{ top: percent(panel.top), height: percent(panel.height) }} />)}
        {overTime && shown?.panels.map((panel, i) => <i key={`hair${i}`} class="hair" hidden ref={(node) => { hairs.current[i] = node; }} style={{ top: percent(panel.top), height: percent(panel.height) }} />)}
        <output class="tip" hidden={!tip} aria-live="off" style={tip ? { left: `${tip.left}px`, top: `${tip.top}px` } : {}}>{tip?.lines.map((line) => <span key={line}>{line}</span>)}</output>
        {drag && <i class="pulled" style={{ top: percent(drag.from.panel.top), height: percent(drag.from.panel.height), left: drag.from.x < drag.to.x ? left(drag.from) : left(drag.to), width: `calc(${drag.from.x < drag.to.x ? left(drag.to) : left(drag.from)} - ${drag.from.x < drag.to.x ? left(drag.from) : left(drag.to)})` }} />}
      </div>
      <figcaption>{(kind !== "gap-curve" && shown?.caption) || caption} <Files kind={kind} caption={caption} off={!shown || isOld} /></figcaption>
    </figure>
  );
}

/** What other widths of the gap would give, which the slider decides, and every figure of the run, as its report has them. */
export function Figures({ now }: { now: Result }) {
  const { points, gaps, units, figures, plan } = now.overview;
  const hasCurve = (curve.value.length > 1 || curveDone.value < 1) && !plan && !isStill(now.overview); // of buildings in plan no other widths are simulated
  const levels = points.map((one, i) => ({ ...one, i })) // of the gap that is chosen; in plan there are several points of one
    .filter((one) => one.gap === gap.value && points.findIndex(({ gap, elevation }) => gap === one.gap && elevation === one.elevation) === one.i);
  return (
    <section id="figures" data-curve={hasCurve ? curveDone.value : 0}>
      <h2>{say("figures")}</h2>
      <p class="controls">
        {levels.length > 1 && <label>{say("history.point")} <select value={point.value ?? -1} onChange={(event) => { const to = Number(event.currentTarget.value); point.value = to < 0 ? null : to; }}>
          <option value={-1} selected={point.value === null}>{say("history.hardest")}</option>
          {levels.map((one) => <option key={one.i} value={one.i} selected={one.i === point.value}>{gaps[one.gap].name}, {number(one.elevation)} {units.length}</option>)}
        </select></label>}
        {span.value && <button type="button" data-span onClick={() => { span.value = null; }}>{say("history.all")}</button>}
        {!isStill(now.overview) && <span class="note">{say("history.hint")}</span>}
      </p>
      <div class="sheets">
        {hasCurve && <FigureView key="gap-curve" kind="gap-curve" overTime={false}
          caption={`${say("curve.note")}${curveDone.value < 1 ? ` ${say("curve.progress", { percent: Math.floor(100 * curveDone.value) })}` : ""}`} />}
        {figures.filter((one) => one.tells).map((one) => <FigureView key={one.kind} {...one} />)}
      </div>
      {!isStill(now.overview) && <details><summary>{say("figures.more")}</summary>
        <ul class="note">{figures.filter((one) => !one.tells).map((one) => <li key={one.kind}>{one.caption} <Files {...one} /></li>)}</ul>
      </details>}
    </section>
  );
}
