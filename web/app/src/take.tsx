import { useState } from "preact/hooks";
import { result, text } from "./case";
import { Message } from "./edit";
import { linked, toFragment } from "./link";
import { caseOf, Stale } from "./results";
import { png, save } from "./save";
import type { Histories, Overview, Result } from "./solver";
import { isStill } from "./still";
import { ownRecord, stale, take, takeHistories, type Told } from "./state";
import { say } from "./texts";

function historiesCsv({ histories, overview }: { histories: Histories; overview: Overview }): string {
  const quoted = (value: string) => `"${value.replaceAll('"', '""')}"`;
  const { length } = overview.units;
  const heads = ["time [s]", ...histories.ground.map((_, k) => `ground_acceleration${overview.plan ? ` ${k + 1}` : ""} [${length}/s2]`)];
  const columns: Float64Array[] = [histories.time, ...histories.ground];
  const told = overview.plan ? { displacement_x: length, displacement_y: length, rotation: "rad" } : { displacement: length };
  histories.buildings.forEach((building, b) => Object.entries(told).forEach(([what, unit]) => building[what].forEach((values, floor) => {
    heads.push(quoted(`${what} ${overview.buildings[b].name} at ${overview.buildings[b].elevations[floor]} [${unit}]`));
    columns.push(values);
  })));
  overview.points.forEach((point, i) => {
    const where = `${overview.gaps[point.gap].name} at ${[point.elevation, point.along].filter((one) => one !== undefined).join(", ")}`;
    heads.push(quoted(`opening ${where} [${length}]`), quoted(`force ${where} [${overview.units.force}]`));
    columns.push(histories.opening[i], histories.force[i]);
  });
  const lines = [heads.join(",")];
  for (let k = 0; k < histories.time.length; ++k) lines.push(columns.map((values) => (k < values.length ? values[k] : "")).join(","));
  return `${lines.join("\n")}\n`;
}

/** Lines of at most so many characters. */
function wrapped(line: string, most: number): string[] {
  const lines = [""];
  for (const word of line.split(" ")) {
    const last = lines[lines.length - 1];
    if (last !== "" && last.length + 1 + word.length > most) lines.push(word);
    else lines[lines.length - 1] = last === "" ? word : `${last} ${word}`;
  }
  return lines;
}

/** The picture as it stands, with the styles it has on the page, and below whose it is. */
function stageSvg(now: Result): string {
  const stage = document.querySelector<SVGSVGElement>("#motion .stage")!;
  const copy = stage.cloneNode(true) as SVGSVGElement;
  const mine = [...stage.querySelectorAll<SVGElement>("*")], theirs = [...copy.querySelectorAll<SVGElement>("*")];
  mine.forEach((node, i) => {
    const style = getComputedStyle(node);
    for (const property of ["fill", "stroke", "stop-color", "stroke-width", "stroke-dasharray", "stroke-linecap", "opacity", "font-size", "font-weight", "r"]) theirs[i].style.setProperty(property, style.getPropertyValue(property));
  });
  const box = stage.viewBox.baseVal;
  const size = 13 * (Number(stage.style.getPropertyValue("--px")) || 1), { color } = getComputedStyle(stage);
  const lines = wrapped(caseOf(now.overview), Math.max(20, Math.floor(box.width / (0.6 * size))));
  lines.forEach((line, k) => {
    const text = document.createElementNS(copy.namespaceURI, "text");
    for (const [name, value] of Object.entries({ x: box.x + 0.6 * size, y: box.y + box.height + (1.4 * k + 1) * size, "font-size": size, fill: color })) text.setAttribute(name, String(value));
    text.textContent = line;
    copy.append(text);
  });
  const height = box.height + (1.4 * lines.length + 0.6) * size;
  copy.setAttribute("viewBox", `${box.x} ${box.y} ${box.width} ${height}`);
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  copy.setAttribute("width", String(Math.round(box.width)));
  copy.setAttribute("height", String(Math.round(height)));
  copy.setAttribute("font-family", "DejaVu Sans, sans-serif");
  copy.style.background = getComputedStyle(stage).backgroundColor;
  for (const name of ["class", "role", "data-part"]) copy.removeAttribute(name);
  return new XMLSerializer().serializeToString(copy);
}

export function Take() {
  const now = result.value;
  const [said, tell] = useState<Told | null>(null);
  const fetched = (what: Parameters<typeof take>[0], name: string, type: string) => () => { take(what).then((content) => save(name, content, type)).catch(tell); };
  const link = () => {
    const given = text.value;
    void toFragment(given).then((fragment) => {
      history.replaceState(null, "", fragment);
      linked.value = given;
      tell({ text: `${say("take.linked")}${ownRecord.value ? ` ${say("take.link.record")}` : ""}`, english: false });
      return navigator.clipboard?.writeText(location.href);
    }).catch(() => undefined);
  };
  return (
    <section id="take">
      <h2>{say("take")}</h2>
      <p class="controls">
        <button type="button" data-take="case" onClick={() => save("case.toml", text.value, "application/toml")}>{say("edit.text")}</button>
        <button type="button" data-take="link" onClick={link}>{say("take.link")}</button>
        {now && !now.overview.spectral && <button type="button" disabled={stale.value} data-take="summary" onClick={fetched("summary", "summary.json", "application/json")}>{say("take.summary")}</button>}
        {now && !isStill(now.overview) && <>
          <button type="button" disabled={stale.value} data-take="impacts" onClick={fetched("impacts", "impacts.csv", "text/csv")}>{say("take.impacts")}</button>
          <button type="button" disabled={stale.value} data-take="histories" onClick={() => { takeHistories().then((all) => save("histories.csv", historiesCsv(all), "text/csv")).catch((error: Told) => tell(error)); }}>{say("take.histories")}</button>
          <button type="button" disabled={stale.value} data-take="svg" onClick={() => save("buildings.svg", stageSvg(now), "image/svg+xml")}>{say("take.svg")}</button>
          <button type="button" disabled={stale.value} data-take="png" onClick={() => void png(stageSvg(now)).then((blob) => save("buildings.png", blob, "image/png"))}>{say("take.png")}</button>
        </>}
        {now && <>
          <button type="button" disabled={stale.value} data-take="gaps" onClick={fetched("gaps", "gaps.json", "application/json")}>{say("take.gaps")}</button>
          <button type="button" disabled={stale.value} data-take="modes" onClick={fetched("modes", "modes.json", "application/json")}>{say("take.modes")}</button>
          <button type="button" disabled={stale.value} data-take="report" onClick={fetched("report", "report.html", "text/html")}>{say("take.report")}</button>
        </>}
      </p>
      <Stale word="take.stale" />
      <p role="status">{said && <Message one={said} />}</p>
      <p class="note">{say("take.note")}</p>
    </section>
  );
}
