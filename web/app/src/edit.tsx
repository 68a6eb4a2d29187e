import type { ComponentChildren } from "preact";
import { batch } from "@preact/signals";
import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { found, gap, inPlan, result, text } from "./case";
import { recordName } from "./cases";
import { point } from "./drawing";
import { Badges, badgesOf } from "./heads";
import { fieldOf, keyAt, keysOf, nameOf, slide } from "./schema";
import type { Slot } from "./slot";
import { type CaseError, type Files, type GapOverview, type Key, type Node, type Overview, schema } from "./solver";
import { addFiles, change, complain, errors, grow, inUnits, load, loads, problem, type Told, told, tooLong, slot, travel, type, width } from "./state";
import { canRedo, canUndo } from "./steps";
import { count, type Part } from "./storeys";
import { isSuite, placeOf, withFile } from "./suite";
import { number, say } from "./texts";
import { onTelephone } from "./theme";
import { decimal, type Leaf, leaf, type Path, put, same, under, withKey, withTable } from "./toml";
import { Track } from "./track";

/** What went wrong; what is said in English only is marked so. */
export const Message = ({ one: { text: said, english } }: { one: Told }) => (english ? <span lang="en">{said}</span> : <>{said}</>);

/** What people call the key that an error is of, `gap[0].contact.stiffness`; nothing where there is no such key. */
function keyName(key: string) {
  const path = key.replace(/\[(?:"(?:[^"\\]|\\.)*"|\d+)\]/g, "").split(".");
  return keyAt(...path) && nameOf(...path);
}

function ErrorLine({ one, goTo }: { one: CaseError; goTo: (line: number, column: number) => void }) {
  const name = one.key && keyName(one.key);
  return (
    <li>
      {one.line > 0 && one.file === "" && <button type="button" onClick={() => goTo(one.line, one.column)}>{say("errors.at", { line: one.line, column: one.column })}</button>}
      {one.file !== "" && <strong>{one.file}{one.line > 0 && `, ${say("errors.at", { line: one.line, column: one.column })}`}</strong>}
      {name && <> <strong>{name}</strong>:</>} <Message one={told(one)} />
    </li>
  );
}

export function Errors({ goTo }: { goTo: (line: number, column: number) => void }) {
  const list = errors.value;
  return (
    <div class="errors" role="alert">
      {problem.value && <p class="error"><Message one={problem.value()} /></p>}
      {list.length > 0 && <>
        <h2>{say("errors")}: {list.length}</h2>
        <ul>{list.slice(0, 30).map((one, i) => <ErrorLine key={i} one={one} goTo={goTo} />)}</ul>
      </>}
    </div>
  );
}

const lineHeight = (area: HTMLTextAreaElement) => parseFloat(getComputedStyle(area).lineHeight);

/** The case file with line numbers; lines with an error are marked. Only numbers that are in sight are there. */
export function Editor({ area }: { area: { current: HTMLTextAreaElement | null } }) {
  const [shown, show] = useState(text.value);
  const [{ top, height }, scrolled] = useState({ top: 0, height: 19 }); // of a line there
  useEffect(() => {
    show(text.value);
    const field = area.current;
    if (!field || field !== document.activeElement || field.value === text.value) return;
    let same = 0; // what comes in its place while one is in the field is looked at where it differs
    while (same < text.value.length && text.value[same] === field.value[same]) ++same;
    field.value = text.value;
    field.setSelectionRange(same, same);
  }, [text.value]);
  const lines = useMemo(() => shown.split("\n").length, [shown]);
  const wrong = new Set(errors.value.filter((one) => one.file === "").map((one) => one.line));
  const first = Math.min(Math.floor(top / height), lines - 1), last = Math.min(lines, first + 60); // a text may end above what was in sight
  return (
    <div class="editor">
      <div class="gutter" aria-hidden="true" style={{ minWidth: `${String(lines).length + 1.5}ch` }}>
        <div style={{ transform: `translateY(${first * height - top}px)` }}>{Array.from({ length: last - first }, (_, i) => <div key={i} class={wrong.has(first + i + 1) ? "wrong" : ""}>{first + i + 1}</div>)}</div>
      </div>
      <textarea ref={area} spellcheck={false} autocapitalize="off" autocomplete="off" wrap="off" aria-label={say("edit.label")} aria-invalid={wrong.size > 0} value={shown}
        maxLength={2 ** 20} onPaste={(event) => { if (tooLong(event.clipboardData?.getData("text") ?? "")) event.preventDefault(); }}
        onScroll={({ currentTarget }) => scrolled({ top: currentTarget.scrollTop, height: lineHeight(currentTarget) })}
        onInput={(event) => {
          show(event.currentTarget.value);
          type(event.currentTarget.value);
        }} />
    </div>
  );
}

export function goTo(area: HTMLTextAreaElement | null, line: number, column: number) {
  if (!area) return;
  const before = text.value.split("\n").slice(0, line - 1).reduce((sum, one) => sum + one.length + 1, 0);
  area.focus();
  area.setSelectionRange(before + column - 1, before + column - 1);
  area.scrollTop = Math.max(0, (line - 4) * lineHeight(area));
}

/** A number to type, and to slide. */
function NumberField({ at, from, title }: { at: Leaf; from: number; title: string }) {
  const value = at.value as number;
  const anchor = useRef(value);
  if (!(Math.abs(value) <= 4 * Math.abs(anchor.current)) || (anchor.current === 0 && value !== 0)) anchor.current = value;
  const { label, key } = fieldOf(at.path, from);
  const unit = key?.unit?.replace(/length|force/g, (what) => unitOf(what as "length").unit);
  const set = (next: number) => {
    const made = key?.number?.type === "integer" ? Math.round(next) : next;
    if (Number.isFinite(made)) change(put(text.value, at, made), at.path.join("."));
  };
  return (
    <div class="field" title={key?.description}>
      <label><span>{label}{unit && <small> {unit}</small>}</span>
        <input type="number" step="any" value={String(Number(value.toPrecision(6)))} onChange={(event) => set(event.currentTarget.valueAsNumber)} /></label>
      <input type="range" aria-label={`${label}: ${title}`} {...slide(value, anchor.current, key)}
        value={value} onInput={(event) => set(event.currentTarget.valueAsNumber)} />
    </div>
  );
}

/** How many storeys or bays a building has, and one more or fewer. */
function Count({ building, part, title }: { building: number; part: Part; title: string }) {
  const n = count(found.value!, building, part);
  if (n === undefined) return null;
  const name = part === "bay" ? say("form.bays") : nameOf("building", "generic", "storeys");
  const button = (by: 1 | -1) => <button type="button" disabled={n + by < 1 || errors.value.length > 0} aria-label={say(by > 0 ? "form.more.of" : "form.fewer.of", { what: name, name: title })} onClick={() => grow(building, part, by)}>{by > 0 ? "+" : "−"}</button>;
  return <p class="count"><span>{name}: <output>{n}</output></span> {button(-1)}{button(1)}</p>;
}

const MOST = 96; // fields of one group

function Group({ path, title }: { path: Path; title: string }) {
  const numbers = (found.value?.leaves ?? []).filter((one) =>
    under(one.path, path) && typeof one.value === "number" && Number.isFinite(one.value) && !same(one.path, [...path, "generic", "storeys"])); // those are counted
  const name = leaf(found.value, [...path, "name"]);
  return (
    <fieldset>
      <legend>{title}</legend>
      {name && <div class="field" title={keyAt("building", "name")?.description}><label><span>{nameOf("building", "name")}</span><input type="text" maxLength={80} value={String(name.value)} onChange={(event) => {
        const next = event.currentTarget.value;
        let made = text.value;
        const old = String(name.value);
        // Wherever the building is named: from the end on, so that places before stay where they are.
        const places = (found.value?.leaves ?? []).filter((one) => one.value === old && (same(one.path, name.path) || one.path.includes("between"))).reverse();
        for (const one of places) made = put(made, one, next);
        change(made);
      }} /></label></div>}
      {path[0] === "building" && !inPlan.value && <>{(["storey", "bay"] as const).map((part) => <Count key={part} building={path[1] as number} part={part} title={title} />)}</>}
      {numbers.slice(0, MOST).map((one) =>
        <NumberField key={`${loads.value} ${one.path.join(".")}`} at={one} from={path.length} title={title} />)}
      {numbers.length > MOST && <p class="note">{say("form.more", { n: numbers.length - MOST })}</p>}
    </fieldset>
  );
}

function Choice({ name, options, value, set }: { name: string; options: string[]; value: string; set: (value: string) => void }) {
  return <label class="choice"><span>{name} </span><select value={value} onChange={(event) => set(event.currentTarget.value)}>{options.map((one) => <option key={one} value={one} selected={one === value}>{one}</option>)}</select></label>;
}

/** The unit that a case has, and all there are with what they are in metres or newtons. */
function unitOf(what: "length" | "force") {
  const all = schema.value?.units[what] ?? {}, names = Object.keys(all);
  const unit = String(leaf(found.value, ["units", what])?.value ?? names[0]);
  return { unit, names, size: all[unit] ?? 1 };
}

/** The units of all numbers; another choice converts them, in the case file and everywhere. */
export function Units() {
  if (!found.value) return null;
  const length = unitOf("length"), force = unitOf("force");
  return <>
    <Choice name={nameOf("units", "length")} options={length.names} value={length.unit} set={(unit) => inUnits(unit, force.unit)} />
    <Choice name={nameOf("units", "force")} options={force.names} value={force.unit} set={(unit) => inUnits(length.unit, unit)} />
  </>;
}

/** What says what the samples of a record are, in a file or in the case: of another record it says nothing. */
const ofSamples = ["values", "time_step", "unit"];

/** Another ground motion. What every kind has stays, and of records what is not of their samples: how strong one is
 *  made, and in which direction. */
function excite(kind: "record" | "harmonic", given: Record<string, string>) {
  const was = leaf(found.value, ["excitation", "kind"])?.value;
  const lines = { kind: JSON.stringify(kind), ...given };
  const stays = (key: Key) => key.with !== "file" &&
    (!key.when || (kind === "record" && was === kind && key.when.kind.includes(kind)));
  const kept = Object.entries(keysOf(schema.value!.case.properties!.excitation))
    .filter(([name, node]) => !(name in lines) && !ofSamples.includes(name) && node["x-bentur"].some(stays)).map(([name]) => name);
  const written = Object.entries(lines).map(([key, value]) => `${key} = ${value}`);
  change(withTable(text.value, "excitation", written, kept));
}

/** A neighbour of which four numbers are known, to the right of the last building. */
function withNeighbour(now: string, metre: number, newton: number): string {
  const mass = (250e3 * metre) / newton;
  const all = found.value!.tables.filter((one) => same(one.path, ["building", one.path[1]]));
  const names = found.value!.leaves.filter((one) => one.path[0] === "building" && one.path[2] === "name").map((one) => String(one.value));
  let n = all.length + 1;
  while (names.includes(`Building ${n}`)) ++n;
  const building = `[[building]]\nname = "Building ${n}"\ndamping = 0.05\n\n[building.generic]\nstoreys = 5\nstorey_height = ${decimal(3.2 / metre)}\nfloor_mass = ${decimal(mass)}\nperiod = 0.6\nsystem = "frame"\n`;
  const joint = `[[gap]]\nbetween = [${JSON.stringify(names[names.length - 1])}, "Building ${n}"]\nwidth = ${decimal(0.04 / metre)}\nlevel_tolerance = ${decimal(1.6 / metre)}\ncontact = { law = "linear", stiffness = ${decimal(mass * 4000)} }\n`;
  // New tables stand before [excitation]; lists that have one entry a building get one more.
  const at = found.value!.tables.find((one) => same(one.path, ["excitation"]))?.range[0] ?? now.length;
  const delays = found.value!.lists.find((one) => same(one.path, ["excitation", "delays"]));
  const grown = delays && delays.range[0] > at ? `${now.slice(0, delays.range[1] - 1)}, 0.0${now.slice(delays.range[1] - 1)}` : now;
  return `${grown.slice(0, at)}${building}\n${joint}\n${grown.slice(at)}`;
}

export function Form() {
  const now = found.value;
  if (!now || !schema.value) return <p>{say("form.none")}</p>;
  const groups = (table: string) => now.tables.map((one) => one.path)
    .filter((path) => path.length === 2 && path[0] === table).slice(0, 12);
  const excitation = (key: string) => leaf(now, ["excitation", key])?.value;
  const kind = excitation("kind"), metre = unitOf("length").size;
  const isTable = ({ "x-bentur": [key] }: Node) => key.kind === "table" && key.form === "one";
  const others = Object.entries(schema.value.case.properties!).filter(([name, node]) => isTable(node) && name !== "excitation" &&
    now.leaves.some((one) => one.path[0] === name && typeof one.value === "number")).map(([name]) => name);
  return (
    <div class="form">
      {groups("building").map((path, i) => <Group key={i} path={path} title={String(leaf(now, [...path, "name"])?.value ?? `${i + 1}`)} />)}
      {!inPlan.value && <p><button type="button" onClick={() => change(withNeighbour(text.value, metre, unitOf("force").size))}>{say("form.add")}</button></p>}
      {groups("gap").map((path, i) => <Group key={i} path={path} title={say("gap.of", { name: result.value?.overview.gaps[i]?.name ?? i + 1 })} />)}
      {groups("link").map((path, i) => <Group key={i} path={path} title={say("form.link", { n: i + 1 })} />)}
      <Group path={["excitation"]} title={nameOf("excitation")} />
      <p class="controls">
        <button type="button" aria-pressed={kind === "harmonic"} onClick={() => excite("harmonic", { period: "0.6", displacement_amplitude: decimal(0.03 / metre) })}>{say("form.harmonic")}</button>
        <button type="button" aria-pressed={kind === "record" && excitation("file") === recordName} onClick={() => excite("record", { file: JSON.stringify(recordName), unit: '"g"' })}>{say("form.elcentro")}</button>
        <FilePicker label={say("form.record")} />
        {kind === "record" && <Choice name={nameOf("excitation", "unit")}
          options={["–", ...keyAt("excitation", "unit")?.words ?? []]} value={String(excitation("unit") ?? "–")}
          set={(value) => { if (value !== "–") change(withKey(text.value, "excitation", "unit", JSON.stringify(value))); }} />}
      </p>
      {others.map((name) => <Group key={name} path={[name]} title={nameOf(name)} />)}
    </div>
  );
}

const RECORD = 64, CASE = 1; // MiB

const isCaseFile = (file: File) => /\.toml$/i.test(file.name);

async function bytesOf(file: File): Promise<Uint8Array | null> {
  const most = isCaseFile(file) ? CASE : RECORD;
  if (file.size <= most * 2 ** 20) return new Uint8Array(await file.arrayBuffer());
  complain("error.file", { name: file.name.slice(0, 60), size: most });
  return null;
}

/** A record that no case names yet: it becomes the ground motion of the case, of a suite one more. The unit is a key of the
 *  file: one that does not say its own asks for it (an error tells where). */
function addRecord(file: File, bytes: Uint8Array) {
  const name = file.name.replace(/[^\w.+ -]/g, "_").slice(0, 80), quoted = JSON.stringify(name);
  batch(() => {
    addFiles([[name, bytes]]);
    if (isSuite(found.value)) change(withFile(text.value, found.value, quoted));
    else excite("record", { file: quoted });
  });
}

/** A case is opened; anything else is a record: one that the case names goes to its place, and nothing changes. */
export async function openFiles(given: File[]) {
  problem.value = null;
  const opened = given.find(isCaseFile), bytes = opened && await bytesOf(opened);
  if (bytes) load(new TextDecoder().decode(bytes));
  const placed: Files = [], others: [File, Uint8Array][] = [];
  for (const file of given.filter((one) => !isCaseFile(one))) {
    const record = await bytesOf(file), place = placeOf(found.value, file.name);
    if (record && place) placed.push([place, record]);
    else if (record) others.push([file, record]);
  }
  if (placed.length > 0) addFiles(placed);
  for (const [file, record] of isSuite(found.value) ? others : others.slice(0, 1)) addRecord(file, record);
}

export function FilePicker({ label: shown }: { label: string }) {
  return <label class="file button">{shown}<input type="file" multiple onChange={(event) => {
    void openFiles([...event.currentTarget.files ?? []]);
    event.currentTarget.value = "";
  }} /></label>;
}

/** Back and forth between what stood there. */
function Travel() {
  const button = (by: -1 | 1, can: boolean, word: "undo" | "redo", keys: string, sign: string) =>
    <button type="button" class="travel" disabled={!can} aria-label={say(word)} title={`${say(word)} (${keys})`} onClick={() => travel(by)}>{sign}</button>;
  return <>{button(-1, canUndo.value, "undo", "Ctrl+Z", "↶")}{button(1, canRedo.value, "redo", "Ctrl+Shift+Z", "↷")}</>;
}

/** Ctrl-Z and Ctrl-Shift-Z wherever one is, but in a field that is being filled in, which has its own. */
export function listenToKeys() {
  let filled: EventTarget | null = null;
  addEventListener("input", ({ target }) => { filled = target instanceof HTMLInputElement && ["number", "text"].includes(target.type) ? target : null; });
  addEventListener("change", () => { filled = null; });
  addEventListener("keydown", (event) => {
    const key = event.key.toLowerCase();
    if (!(event.ctrlKey || event.metaKey) || event.altKey || (key !== "z" && key !== "y") || (filled !== null && event.target === filled)) return;
    event.preventDefault();
    travel(key === "y" || event.shiftKey ? 1 : -1);
  });
}

/** Which gap the slider and the figures are of. */
function GapChoice({ gaps }: { gaps: GapOverview[] }) {
  return <select aria-label={say("gap.which")} value={gap.value} onChange={(event) => batch(() => { gap.value = Number(event.currentTarget.value); point.value = null; })}>
    {gaps.map((each, i) => <option key={i} value={i} selected={i === gap.value}>{each.name}</option>)}</select>;
}

/** Who moves with a gap in plan, what grows, and where that ends. */
function Moves({ place, span, unit }: { place: Slot; span: number; unit: string }) {
  const said = [
    place.moves.length > 6 ? say("gap.moves.many", { n: place.moves.length }) : place.moves.length > 0 && say("gap.moves", { names: place.moves.join(", ") }),
    span > place.clearance && say("gap.clearance", { width: `${number(place.clearance)} ${unit}` }),
    span >= place.most && say("gap.met", { width: `${number(place.most)} ${unit}`, name: place.met }),
  ].filter(Boolean);
  return said.length > 0 ? <p class="note" data-moves>{said.join(" ")}</p> : null;
}

let longest = { key: "", value: 0 };
/** What the slider ends at, which does not shrink while one is at the same gap. */
function trackOf(overview: Overview, one: GapOverview): number {
  const key = `${one.name}|${loads.value}|${overview.units.length}`;
  const furthest = Math.max(width.value, one.needed ?? 0, ...(one.marks ?? []).map(({ at }) => at));
  if (longest.key !== key || furthest > longest.value) longest = { key, value: Number((1.1 * Math.max(furthest, 1e-9)).toPrecision(2)) };
  return longest.value;
}

/** What moves with the slider; on a telephone below what stays in sight. */
function GapNotes() {
  const overview = result.value?.overview, one = overview?.gaps[gap.value], place = slot.value;
  if (!overview || !one || !place || one.needed === null) return null;
  return <Moves place={place} span={trackOf(overview, one)} unit={overview.units.length} />;
}

export const GapNotesBelow = () => (onTelephone.value ? <div class="below"><GapNotes /></div> : null);

/** The slider that everything starts with; beside what it is of stand the children. */
export function GapSlider({ children }: { children: ComponentChildren }) {
  const overview = result.value?.overview;
  const one = overview?.gaps[gap.value];
  const place = slot.value;
  const several = overview !== undefined && overview.gaps.length > 1, ofOne = several && <Badges all={badgesOf(overview, gap.value)} />;
  if (!overview || !one || !place || one.needed === null) {
    return <div class="head"><p>{several && <>{nameOf("gap", "width")} <GapChoice gaps={overview.gaps} />{ofOne}</>}</p>{children}<p><Travel /></p></div>;
  }
  const { marks = [] } = one, span = Math.min(trackOf(overview, one), place.most), step = 10 ** Math.floor(Math.log10(span / 60)), share = (at: number) => Math.min(1, at / span);
  const inUnit = (value: number) => `${number(value)}\u00a0${overview.units.length}`;
  const others = new Map<string, { at: number; names: string[] }>(); // those that say the same width are one
  for (const { at, name } of marks.filter((mark) => mark.at <= span)) others.set(number(at), { at, names: [...others.get(number(at))?.names ?? [], name] });
  const all = [{ at: one.needed, names: [one.needed_name] }, ...others.values()]
    .map(({ at, names }) => ({ at: share(at), text: `${names.join(", ")} ${inUnit(at)}` }));
  return (
    <div class="gap-slider">
      <div class="head">
        <p><label for="gap">{several ? nameOf("gap", "width") : say("gap.of", { name: one.name })}</label>
          {several && <GapChoice gaps={overview.gaps} />}{ofOne}</p>
        {children}
        {onTelephone.value && <p><Travel /></p>}
      </div>
      <div class="track">{!onTelephone.value && <Travel />}
        <Track at={share(width.value)} given={`${number(width.value)} ${overview.units.length}`} marks={all}>
          <input id="gap" type="range" min="0" max={span} step={step} value={width.value} aria-valuetext={`${number(width.value)} ${overview.units.length}`} onInput={(event) => change(place.put(text.value, event.currentTarget.valueAsNumber), "gap")} />
        </Track></div>
      {!onTelephone.value && <GapNotes />}
    </div>
  );
}
