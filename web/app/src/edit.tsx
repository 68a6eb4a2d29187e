import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { addFile, change, errors, found, gap, inUnits, load, loads, problem, result, text, told, tooLong, typing, width } from "./state";
import { recordName } from "./cases";
import { keyName, number, say } from "./texts";
import { decimal, type Leaf, leaf, type Outline, type Path, put, same, under, withKey, withTable, withWidth } from "./toml";

export function Errors({ goTo }: { goTo: (line: number, column: number) => void }) {
  const list = errors.value;
  return (
    <div class="errors" role="alert">
      {problem.value && <p class="error">{problem.value()}</p>}
      {list.length > 0 && <>
        <h2>{say("errors")}: {list.length}</h2>
        <ul>{list.slice(0, 30).map((one, i) => (
          <li key={i}>{one.line > 0 && one.file === "" ? <button type="button" onClick={() => goTo(one.line, one.column)}>{say("errors.at", { line: one.line, column: one.column })}</button>
            : one.file !== "" && <strong>{one.file}{one.line > 0 && `:${one.line}:${one.column}`}</strong>} {told(one)}</li>))}</ul>
      </>}
    </div>
  );
}

/** The case file with line numbers; lines with an error are marked. Only numbers that are in sight are there. */
export function Editor({ area }: { area: { current: HTMLTextAreaElement | null } }) {
  const later = useRef(0);
  const [shown, show] = useState(text.value);
  const [top, scrolled] = useState(0);
  useEffect(() => { show(text.value); }, [text.value]);
  const lines = useMemo(() => shown.split("\n").length, [shown]);
  const wrong = new Set(errors.value.filter((one) => one.file === "").map((one) => one.line));
  const height = area.current ? parseFloat(getComputedStyle(area.current).lineHeight) || 19 : 19;
  const first = Math.floor(top / height), last = Math.min(lines, first + 60);
  return (
    <div class="editor">
      <div class="gutter" aria-hidden="true" style={{ minWidth: `${String(lines).length + 1.5}ch` }}>
        <div style={{ transform: `translateY(${first * height - top}px)` }}>{Array.from({ length: last - first }, (_, i) => <div key={i} class={wrong.has(first + i + 1) ? "wrong" : ""}>{first + i + 1}</div>)}</div>
      </div>
      <textarea ref={area} spellcheck={false} autocapitalize="off" autocomplete="off" wrap="off" aria-label={say("edit.label")} aria-invalid={wrong.size > 0} value={shown}
        maxLength={2 ** 20} onPaste={(event) => { if (tooLong(event.clipboardData?.getData("text") ?? "")) event.preventDefault(); }}
        onScroll={(event) => scrolled(event.currentTarget.scrollTop)}
        onInput={(event) => {
          const { value } = event.currentTarget;
          const base = text.value; // what has come in its place by then stays
          show(value);
          clearTimeout(later.current);
          typing.value = true;
          later.current = window.setTimeout(() => {
            typing.value = false;
            if (text.value === base) change(value);
          }, 150);
        }} />
    </div>
  );
}

export function goTo(area: HTMLTextAreaElement | null, line: number, column: number) {
  if (!area) return;
  const before = text.value.split("\n").slice(0, line - 1).reduce((sum, one) => sum + one.length + 1, 0);
  area.focus();
  area.setSelectionRange(before + column - 1, before + column - 1);
  const height = parseFloat(getComputedStyle(area).lineHeight);
  area.scrollTop = Math.max(0, (line - 4) * height);
}

/** A number to type, and to slide between a fraction of what it was and a multiple. */
function NumberField({ at, label, unit, names }: { at: Leaf; label: string; unit?: string; names: string }) {
  const value = at.value as number;
  const anchor = useRef(value);
  if (!(Math.abs(value) <= 4 * Math.abs(anchor.current)) || (anchor.current === 0 && value !== 0)) anchor.current = value;
  const share = /damping|restitution|hardening|ratio/.test(names);
  const whole = /^[+-]?\d+$/.test(at.text) && /storeys$/.test(names);
  const most = share ? Math.max(1, value) : anchor.current === 0 ? 1 : whole ? Math.max(12, 2 * Math.abs(anchor.current)) : Math.max(3 * Math.abs(anchor.current), Math.abs(value));
  const set = (next: number) => { if (Number.isFinite(next)) change(put(text.value, at, whole ? Math.round(next) : next)); };
  return (
    <div class="field">
      <label><span>{label}{unit && <small> {unit}</small>}</span>
        <input type="number" step="any" value={String(Number(value.toPrecision(6)))} onChange={(event) => set(event.currentTarget.valueAsNumber)} /></label>
      <input type="range" aria-label={`${label}: ${names}`} min={value < 0 ? -most : 0} max={most} step={whole ? 1 : most / 300} value={value} onInput={(event) => set(event.currentTarget.valueAsNumber)} />
    </div>
  );
}

const MOST = 96; // fields of one group

function label(path: Path): string {
  return path.filter((key) => !["frame", "stick", "generic", "modal", "matrices"].includes(String(key)))
    .map((key) => (typeof key === "number" ? String(key + 1) : keyName(key))).join(" ");
}

function Group({ path, title, without = [] }: { path: Path; title: string; without?: string[] }) {
  const all = (found.value?.leaves ?? []).filter((one) => under(one.path, path) && !without.includes(String(one.path[path.length])));
  const numbers = all.filter((one) => typeof one.value === "number" && Number.isFinite(one.value));
  const name = leaf(found.value, [...path, "name"]);
  return (
    <fieldset>
      <legend>{title}</legend>
      {name && <div class="field"><label><span>{keyName("name")}</span><input type="text" maxLength={80} value={String(name.value)} onChange={(event) => {
        const next = event.currentTarget.value;
        let made = text.value;
        const old = String(name.value);
        // Wherever the building is named: from the end on, so that places before stay where they are.
        const places = (found.value?.leaves ?? []).filter((one) => one.value === old && (same(one.path, name.path) || one.path.includes("between"))).reverse();
        for (const one of places) made = put(made, one, next);
        change(made);
      }} /></label></div>}
      {numbers.slice(0, MOST).map((one) => <NumberField key={`${loads.value} ${one.path.join(".")}`} at={one} label={label(one.path.slice(path.length))} unit={result.value?.units[JSON.stringify(one.path)]} names={[title, ...one.path.slice(path.length)].join(" ")} />)}
      {numbers.length > MOST && <p class="note">{say("form.more", { n: numbers.length - MOST })}</p>}
    </fieldset>
  );
}

const lengths = ["m", "cm", "mm", "in", "ft"], forces = ["N", "kN", "MN", "kgf", "tf", "lbf", "kip"], accelerations = ["g", "cm/s2", "m/s2", "mm/s2", "in/s2", "ft/s2"];

function Choice({ name, options, value, set }: { name: string; options: string[]; value: string; set: (value: string) => void }) {
  return <label class="choice">{name} <select value={value} onChange={(event) => set(event.currentTarget.value)}>{options.map((one) => <option key={one} value={one} selected={one === value}>{one}</option>)}</select></label>;
}

const unitsOf = (now: Outline) => ({ length: String(leaf(now, ["units", "length"])?.value ?? "m"), force: String(leaf(now, ["units", "force"])?.value ?? "N") });

/** The units of all numbers; another choice converts them, in the case file and everywhere. */
export function Units() {
  const now = found.value;
  if (!now) return null;
  const { length, force } = unitsOf(now);
  return <>
    <Choice name={say("units.length")} options={lengths} value={length} set={(value) => inUnits(value, force)} />
    <Choice name={say("units.force")} options={forces} value={force} set={(value) => inUnits(length, value)} />
  </>;
}

const ofEveryMotion = ["delays", "wave_velocity", "kinematics"], ofRecords = ["pga", "scale", "polarity"];

/** Another ground motion; when it comes to which building stays, and of records how strong it is made and which way round. */
function excite(kind: "record" | "harmonic", lines: string[]) {
  const was = leaf(found.value, ["excitation", "kind"])?.value;
  const kept = kind === "record" && was === "record" ? [...ofEveryMotion, ...ofRecords] : ofEveryMotion;
  change(withTable(text.value, "excitation", [`kind = "${kind}"`, ...lines], kept));
}

/** A neighbour of which four numbers are known, to the right of the last building. */
function withNeighbour(now: string, scale: number, mass: number): string {
  const all = found.value!.tables.filter((one) => same(one.path, ["building", one.path[1]]));
  const names = found.value!.leaves.filter((one) => one.path[0] === "building" && one.path[2] === "name").map((one) => String(one.value));
  let n = all.length + 1;
  while (names.includes(`Building ${n}`)) ++n;
  const building = `[[building]]\nname = "Building ${n}"\ndamping = 0.05\n\n[building.generic]\nstoreys = 5\nstorey_height = ${decimal(3.2 * scale)}\nfloor_mass = ${decimal(mass)}\nperiod = 0.6\nsystem = "frame"\n`;
  const joint = `[[gap]]\nbetween = [${JSON.stringify(names[names.length - 1])}, "Building ${n}"]\nwidth = ${decimal(0.04 * scale)}\nlevel_tolerance = ${decimal(1.6 * scale)}\ncontact = { law = "linear", stiffness = ${decimal(mass * 4000)} }\n`;
  // New tables stand before [excitation]; lists that have one entry a building get one more.
  const at = found.value!.tables.find((one) => same(one.path, ["excitation"]))?.range[0] ?? now.length;
  const delays = found.value!.lists.find((one) => same(one.path, ["excitation", "delays"]));
  const grown = delays && delays.range[0] > at ? `${now.slice(0, delays.range[1] - 1)}, 0.0${now.slice(delays.range[1] - 1)}` : now;
  return `${grown.slice(0, at)}${building}\n${joint}\n${grown.slice(at)}`;
}

export function Form() {
  const now = found.value;
  if (!now) return <p>{say("form.none")}</p>;
  const buildings = now.tables.filter((one) => one.path.length === 2 && one.path[0] === "building");
  const gaps = now.tables.filter((one) => one.path.length === 2 && one.path[0] === "gap");
  const units = unitsOf(now);
  const kind = String(leaf(now, ["excitation", "kind"])?.value ?? "");
  const scale = { m: 1, cm: 100, mm: 1000, in: 39.37, ft: 3.281 }[units.length] ?? 1;
  const newton = { N: 1, kN: 1e3, MN: 1e6, kgf: 9.807, tf: 9807, lbf: 4.448, kip: 4448 }[units.force] ?? 1;
  return (
    <div class="form">
      {buildings.slice(0, 12).map((one, i) => <Group key={i} path={one.path} title={String(leaf(now, [...one.path, "name"])?.value ?? `${i + 1}`)} />)}
      <p><button type="button" onClick={() => change(withNeighbour(text.value, scale, 250e3 / newton / scale))}>{say("form.add")}</button></p>
      {gaps.slice(0, 12).map((one, i) => <Group key={i} path={one.path} title={say("form.gap", { name: result.value?.overview.gaps[i]?.name ?? i + 1 })} without={["between"]} />)}
      {now.tables.filter((one) => one.path.length === 2 && one.path[0] === "link").slice(0, 12).map((one, i) => <Group key={i} path={one.path} title={say("form.link", { n: i + 1 })} without={["between"]} />)}
      <Group path={["excitation"]} title={say("form.excitation")} />
      <p class="controls">
        <button type="button" aria-pressed={kind === "harmonic"} onClick={() => excite("harmonic", ["period = 0.6", `displacement_amplitude = ${decimal(0.03 * scale)}`])}>{say("form.harmonic")}</button>
        <button type="button" aria-pressed={kind === "record" && leaf(now, ["excitation", "file"])?.value === recordName} onClick={() => excite("record", [`file = "${recordName}"`, 'unit = "g"'])}>{say("form.elcentro")}</button>
        <FilePicker label={say("form.record")} />
        {kind === "record" && <Choice name={say("form.unit")} options={["–", ...accelerations]} value={String(leaf(now, ["excitation", "unit"])?.value ?? "–")} set={(value) => { if (value !== "–") change(withKey(text.value, "excitation", "unit", JSON.stringify(value))); }} />}
      </p>
      {now.leaves.some((one) => one.path[0] === "initial") && <Group path={["initial"]} title={say("form.initial")} />}
      <Group path={["analysis"]} title={say("form.analysis")} />
    </div>
  );
}

const RECORD = 64, CASE = 1; // MiB

/** A case is opened; anything else becomes the ground motion of the case. */
export async function openFile(file: File) {
  const isCase = /\.toml$/i.test(file.name);
  const most = isCase ? CASE : RECORD;
  if (file.size > most * 2 ** 20) {
    problem.value = () => say("error.file", { name: file.name.slice(0, 60), size: most });
    return;
  }
  const bytes = new Uint8Array(await file.arrayBuffer());
  problem.value = null;
  if (isCase) {
    load(new TextDecoder().decode(bytes));
    return;
  }
  const name = file.name.replace(/[^\w.+ -]/g, "_").slice(0, 80);
  addFile(name, bytes);
  const lines = [`file = ${JSON.stringify(name)}`];
  const unit = leaf(found.value, ["excitation", "unit"]);
  // Formats that say their unit refuse another one; a plain column does not say it.
  if (!/\.(at2|v1|v2|v2c|smc|ew|ns|ud|ew1|ns1|ud1|ew2|ns2|ud2|asc)$/i.test(name)) lines.push(`unit = ${unit ? unit.text : '"g"'}`);
  excite("record", lines);
}

export function FilePicker({ label: shown }: { label: string }) {
  return <label class="file button">{shown}<input type="file" onChange={(event) => {
    const file = event.currentTarget.files?.[0];
    if (file) void openFile(file);
    event.currentTarget.value = "";
  }} /></label>;
}

/** The slider that everything starts with. */
export function GapSlider() {
  const overview = result.value?.overview;
  const one = overview?.gaps[gap.value];
  const most = useRef<{ key: string; value: number }>({ key: "", value: 0 });
  if (!overview || !one) return null;
  const key = `${gap.value}|${loads.value}|${overview.title}|${overview.units.length}`;
  const wanted = Math.max(1.3 * one.needed, 1.3 * width.value, 1e-9);
  if (most.current.key !== key || Math.max(width.value, one.needed) > most.current.value) most.current = { key, value: Number(wanted.toPrecision(2)) };
  const span = most.current.value;
  return (
    <div class="gap-slider" style={{ "--at": one.needed / span, "--now": Math.min(1, width.value / span) }}>
      {overview.gaps.length > 1 && <label>{say("gap")} <select value={gap.value} onChange={(event) => { gap.value = Number(event.currentTarget.value); }}>{overview.gaps.map((each, i) => <option key={i} value={i} selected={i === gap.value}>{each.name}</option>)}</select></label>}
      <label class="slide"><span>{overview.gaps.length > 1 ? say("width") : say("gap.of", { name: one.name })}: <output>{number(width.value)} {overview.units.length}</output></span>
        <input id="gap" type="range" min="0" max={span} step={span / 400} value={width.value} onInput={(event) => change(withWidth(text.value, gap.value, event.currentTarget.valueAsNumber))} /></label>
      <div class="needed"><i /><span>{say("needed")} {number(one.needed)} {overview.units.length}</span></div>
    </div>
  );
}
