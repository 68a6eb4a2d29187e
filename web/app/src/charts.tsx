import { useSignalEffect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { number } from "./texts";

export interface Curve { label: string; colour: string; values: ArrayLike<number>; axis?: "left" | "right"; dash?: number[] }

const style = (name: string) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
/** The same building has one colour everywhere. */
export const buildingVariable = (index: number) => `--building-${(index % 6) + 1}`;
export const buildingColour = (index: number) => style(buildingVariable(index));

/** Curves over one axis, zoomed and pointed at together with others of the same `group`. */
export function Chart({ title, x, xLabel, yLabel, curves, group, mark, onPick, height = 150, right, theme }: {
  title: string; x: ArrayLike<number>; xLabel: string; yLabel: string; curves: Curve[]; group?: string;
  mark?: { readonly value: number }; onPick?: (x: number) => void; height?: number; right?: string; theme: string;
}) {
  const root = useRef<HTMLDivElement>(null);
  const plot = useRef<uPlot | null>(null);
  const head = useRef<HTMLDivElement | null>(null);
  const pick = useRef(onPick);
  pick.current = onPick;
  const key = JSON.stringify([title, xLabel, yLabel, curves.map((one) => [one.label, one.colour, one.axis]), height, right, theme]);
  const data = [x, ...curves.map((one) => one.values)] as unknown as uPlot.AlignedData;

  const place = () => {
    const u = plot.current;
    if (!u || !mark || !head.current) return;
    const at = u.valToPos(mark.value, "x");
    head.current.style.transform = `translateX(${at}px)`;
    head.current.hidden = !(at >= 0 && at <= u.bbox.width / devicePixelRatio);
  };
  useEffect(() => {
    const ink = style("--ink"), grid = style("--rule");
    // The decimal point in every language, as everywhere.
    const values = (_: uPlot, all: (number | null)[]) => all.map((one) => (one === null ? "" : number(one)));
    const value = (_: uPlot, one: number | null) => number(one);
    const axis = { values, stroke: ink, grid: { stroke: grid, width: 1 }, ticks: { stroke: grid, width: 1 }, font: "12px system-ui, sans-serif", labelFont: "12px system-ui, sans-serif" };
    const made = new uPlot({
      width: Math.max(root.current!.clientWidth, 200), height,
      scales: { x: { time: false } },
      cursor: { drag: { x: true, y: false }, points: { size: 5 }, ...(group ? { sync: { key: group, setSeries: false } } : {}) },
      legend: { live: true },
      series: [{ label: xLabel, value }, ...curves.map((one) => ({ label: one.label, value, stroke: one.colour, width: 1.25, scale: one.axis === "right" ? "right" : "y", points: { show: false }, ...(one.dash ? { dash: one.dash } : {}) }))],
      axes: [{ ...axis, label: xLabel, labelSize: 18, size: 30 }, { ...axis, label: yLabel, labelSize: 18, size: 66, space: 22 },
        ...(right ? [{ ...axis, label: right, labelSize: 18, size: 50, side: 1 as const, scale: "right", grid: { show: false } }] : [])],
      hooks: {
        init: [(u) => {
          const line = document.createElement("div");
          line.className = "chart-head";
          line.hidden = true;
          u.over.appendChild(line);
          head.current = line;
          let down = 0;
          u.over.addEventListener("pointerdown", (event) => { down = event.clientX; });
          u.over.addEventListener("click", (event) => {
            if (Math.abs(event.clientX - down) < 3) pick.current?.(u.posToVal(u.cursor.left ?? 0, "x"));
          });
        }],
        setScale: [(u, scale) => { if (scale === "x") { plot.current = u; place(); } }],
      },
    }, data, root.current!);
    plot.current = made;
    place();
    const watch = new ResizeObserver(() => {
      const width = root.current?.clientWidth ?? 0;
      if (width > 0 && width !== made.width) made.setSize({ width, height });
      place();
    });
    watch.observe(root.current!);
    return () => { watch.disconnect(); made.destroy(); plot.current = null; };
  }, [key]);
  useEffect(() => {
    const u = plot.current;
    if (!u || u.data === data) return;
    const before = u.data[0], { min, max } = u.scales.x;
    const zoomed = before.length > 1 && min !== undefined && max !== undefined && (min > before[0] || max < before[before.length - 1]);
    u.setData(data, !zoomed);
    if (zoomed) u.redraw();
    place();
  }, [x, ...curves.map((one) => one.values)]);
  useSignalEffect(() => {
    void mark?.value;
    place();
  });
  return <figure class="chart"><figcaption>{title}</figcaption><div ref={root} role="img" aria-label={`${title}: ${curves.map((one) => one.label).join(", ")}`} /></figure>;
}

/** Curves as an SVG of its own, for papers: as many points as can be seen, none of the extremes lost. */
export function curvesSvg(parts: { title: string; x: ArrayLike<number>; yLabel: string; curves: Curve[] }[], xLabel: string): string {
  const width = 720, high = 170, left = 70, safe = (text: string) => text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);
  let body = "";
  parts.forEach((part, k) => {
    const top = 26 + k * (high + 46), n = part.x.length;
    let low = Infinity, up = -Infinity;
    for (const one of part.curves) for (let i = 0; i < n; ++i) { low = Math.min(low, one.values[i]); up = Math.max(up, one.values[i]); }
    if (!(up > low)) { up = low + 1; }
    const px = (i: number) => left + ((part.x[i] - part.x[0]) / (part.x[n - 1] - part.x[0])) * (width - left - 10);
    const py = (v: number) => top + high * (1 - (v - low) / (up - low));
    body += `<text x="${left}" y="${top - 8}" font-weight="bold">${safe(part.title)}</text><rect x="${left}" y="${top}" width="${width - left - 10}" height="${high}" fill="none" stroke="#888"/>`;
    for (const v of [low, up]) body += `<text x="${left - 6}" y="${py(v) + 4}" text-anchor="end">${Number(v.toPrecision(3))}</text>`;
    body += `<text transform="translate(14 ${top + high / 2}) rotate(-90)" text-anchor="middle">${safe(part.yLabel)}</text>`;
    for (const v of [part.x[0], part.x[n - 1]]) body += `<text x="${v === part.x[0] ? left : width - 10}" y="${top + high + 14}" text-anchor="${v === part.x[0] ? "start" : "end"}">${Number(v.toPrecision(4))}</text>`;
    part.curves.forEach((one, c) => {
      const bins = Math.min(1400, n);
      let path = "";
      for (let bin = 0; bin < bins; ++bin) {
        const from = Math.floor((bin * n) / bins), to = Math.max(from + 1, Math.floor(((bin + 1) * n) / bins));
        let least = from, most = from;
        for (let i = from; i < to; ++i) { if (one.values[i] < one.values[least]) least = i; if (one.values[i] > one.values[most]) most = i; }
        for (const i of least <= most ? [least, most] : [most, least]) path += `${path ? "L" : "M"}${px(i).toFixed(1)} ${py(one.values[i]).toFixed(1)}`;
      }
      body += `<path d="${path}" fill="none" stroke="${one.colour}" stroke-width="1"/><text x="${width - 14}" y="${top + 14 + 14 * c}" text-anchor="end" fill="${one.colour}">${safe(one.label)}</text>`;
    });
  });
  const height = 26 + parts.length * (high + 46);
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}" font-family="DejaVu Sans, sans-serif" font-size="11"><rect width="100%" height="100%" fill="#fff"/>${body}<text x="${width - 10}" y="${height - 6}" text-anchor="end">${safe(xLabel)}</text></svg>`;
}
