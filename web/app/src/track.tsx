import type { ComponentChildren } from "preact";
import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import { say } from "./texts";

/** A width beside the slider: where its tick is, as part of the track, and what it says. */
interface Mark { at: number; text: string }
interface Label { left: number; width: number; row: number }

const SPACE = 10; // [px] between labels
const GROOVE = 5; // [px] between their rows, in which lines go aside

/** Where labels in one row begin, none over another, each as near to the middle of its tick as it can be. */
function spread(middles: number[], widths: number[], room: number): number[] {
  const fromLeft = (wanted: number[]) => {
    let end = 0;
    return wanted.map((left, i) => { const at = Math.max(left, end); end = at + widths[i] + SPACE; return at; });
  };
  const fromRight = (wanted: number[]) => {
    let end = room;
    return [...wanted.keys()].reverse().map((i) => { const at = Math.min(wanted[i], end - widths[i]); end = at - SPACE; return at; }).reverse();
  };
  const centred = middles.map((middle, i) => middle - widths[i] / 2), pushed = [fromLeft(centred), fromRight(centred)];
  return fromRight(fromLeft(centred.map((_, i) => (pushed[0][i] + pushed[1][i]) / 2)));
}

/** The first label and those that have room beside it stand below their ticks, the others in rows below these. */
function labelsOf(ticks: number[], widths: number[], room: number): Label[] {
  const labels: Label[] = [], rest: number[] = []; // sparse until all are placed
  const byTick = ticks.map((_, i) => i).slice(1).sort((a, b) => ticks[a] - ticks[b]);
  for (const i of [0, ...byTick]) {
    const left = Math.max(0, Math.min(ticks[i] - widths[i] / 2, room - widths[i]));
    const hasRoom = labels.every((one) => left >= one.left + one.width + SPACE || left + widths[i] + SPACE <= one.left);
    if (hasRoom) labels[i] = { left, width: widths[i], row: 0 };
    else rest.push(i);
  }
  const rows = Math.ceil(rest.reduce((sum, i) => sum + widths[i] + SPACE, 0) / room);
  for (let row = 0; row < rows; ++row) {
    const those = rest.filter((_, k) => k % rows === row);
    spread(those.map((i) => ticks[i]), those.map((i) => widths[i]), room).forEach((left, k) => { labels[those[k]] = { left, width: widths[those[k]], row: row + 1 }; });
  }
  return labels;
}

/** The slider with the width given above its thumb, and below it ticks, each with its name and width. */
export function Track({ at, given, marks, children }: { at: number; given: string; marks: Mark[]; children: ComponentChildren }) {
  const root = useRef<HTMLDivElement>(null);
  const [room, resize] = useState(0);
  const [{ ticks, labels, high }, measured] = useState<{ ticks: number[]; labels: Label[]; high: number }>({ ticks: [], labels: [], high: 0 });
  useEffect(() => {
    const watched = new ResizeObserver(() => resize(root.current?.clientWidth ?? 0));
    watched.observe(root.current!);
    return () => watched.disconnect();
  }, []);
  const all = <Kind extends HTMLElement>(selector: string) => [...root.current!.querySelectorAll<Kind>(selector)];
  useLayoutEffect(() => {
    if (room === 0) return;
    const names = all("[data-tick]"), places = all("i").map((tick) => tick.offsetLeft + tick.offsetWidth / 2);
    measured({ ticks: places, labels: labelsOf(places, names.map((name) => name.offsetWidth), room), high: names[0].offsetHeight + GROOVE });
  }, [room, JSON.stringify(marks)]);
  useLayoutEffect(() => {
    const [label] = all(".given"), [thumb] = all("u"), half = label.offsetWidth / 2;
    label.style.left = `${Math.max(half, Math.min(thumb.offsetLeft, room - half))}px`;
  }, [room, at, given]);
  const rows = 1 + Math.max(0, ...labels.map(({ row }) => row));
  return (
    <div class="slide" ref={root} style={{ "--now": at }}>
      <p class="given"><span>{say("gap.given")}</span> <output>{given}</output></p>
      {children}
      <div class="ticks" style={{ height: `${rows * high}px` }}>
        <u />{marks.map((one, i) => <i key={i} data-row={labels[i]?.row} style={{ "--at": one.at }} />)}
        <svg aria-hidden="true" width={room} height={rows * high}>{labels.map(({ left, width, row }, i) => row > 0 && <path key={i} data-row={row}
          d={`M${ticks[i]} 0V${row * high - GROOVE}L${Math.max(left + 6, Math.min(ticks[i], left + width - 6))} ${row * high + 2}`} />)}</svg>
        {marks.map(({ text }, i) => <span key={i} data-tick={text} data-row={labels[i]?.row} style={{ left: `${labels[i]?.left ?? 0}px`, top: `${(labels[i]?.row ?? 0) * high}px` }}>{text}</span>)}
      </div>
    </div>
  );
}
