// The core as WebAssembly against the command line, and what a page may be given: node --test core.test.mjs
// BENTUR_WASM is the module, BENTUR the program, BENTUR_SOURCE the repository.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { test } from "node:test";
import { difference, isLoose, lineOf, spaced, studio, terminal, tolerance } from "./core.mjs";
import { makeSuite } from "./suites.mjs";

const source = process.env.BENTUR_SOURCE;
const examples = readdirSync(`${source}/examples`).filter((name) => name.endsWith(".toml"));
const read = (name) => readFileSync(`${source}/examples/${name}`, "utf8");
const one = await studio(source);

function solved(text, name) {
  const opened = JSON.parse(one.open(text, name));
  assert.deepEqual(opened.errors, []);
  const done = JSON.parse(one.solve(0, null));
  assert.deepEqual(done.errors, []);
  return JSON.parse(one.summary());
}

// Where the numbers agree to the bit. Elsewhere the last digits differ: the sines of musl are not those of glibc, and
// native code adds the terms of long sums two by two.
const exact = new Set(["free-impact.toml", "m12-el-centro.toml", "m12-runge-kutta.toml"]);

// Buildings in plan too; and of tests/doors, cases in which a door once stood alone.
const plans = readdirSync(`${source}/examples/plan`).filter((name) => name.endsWith(".toml")).map((name) => `${source}/examples/plan/${name}`);
const files = [...examples.map((name) => `${source}/examples/${name}`), ...plans,
  ...readdirSync(`${source}/tests/doors`).filter((name) => name.endsWith(".toml")).map((name) => `${source}/tests/doors/${name}`)];

for (const file of files) {
  const name = file.slice(file.lastIndexOf("/") + 1);
  test(`${name} gives the command line's numbers`, () => {
    const mine = solved(readFileSync(file, "utf8"), name);
    const theirs = JSON.parse(execFileSync(process.env.BENTUR, ["run", "--json", file]));
    // Not compared: how long it took, and the energy that is not accounted for, which is round-off and nothing else.
    // In plan the linear law's losses, which are that too.
    const isLinear = plans.includes(file) && readFileSync(file, "utf8").includes('law = "linear"');
    const isLoss = (path) => isLinear && /\/energy_lost$/.test(path);
    const unlike = (path) => /\/wall_time$|\/energy_residual$/.test(path) || isLoss(path);
    if (isLinear) for (const impact of mine.impacts) assert.ok(Math.abs(impact.energy_lost) < 1e-20);
    if (exact.has(name)) {
      assert.deepEqual(difference(mine, theirs, "", unlike), { size: 0, path: "" });
    } else {
      // In plan a loss is a small difference of what went in and what came back.
      const isSmall = (path) => plans.includes(file) && /\/energy_lost$/.test(path);
      const values = difference(mine, theirs, "", (path) => unlike(path) || isLoose(path) || isSmall(path));
      assert.ok(values.size < tolerance(name), `${values.path} ${values.size}`);
      const all = difference(mine, theirs, "", unlike);
      assert.ok(all.size < 1e-9, `${all.path} ${all.size}`);
    }
    assert.ok(mine.solver.energy_residual === null || Math.abs(mine.solver.energy_residual) < 1e-9);
  });
}

for (const file of files) {
  const name = file.slice(file.lastIndexOf("/") + 1);
  test(`${name} is told of as in a terminal`, () => {
    const mine = solved(readFileSync(file, "utf8"), name).statements ?? [];
    const theirs = JSON.parse(execFileSync(process.env.BENTUR, ["run", "--json", file])).statements ?? [];
    assert.ok(theirs.length > 0);
    for (const language of ["en", "id"]) {
      const { statements, gaps } = JSON.parse(one.overview(language));
      for (const other of [mine, theirs]) assert.deepEqual(statements.map(({ kind, severity }) => [kind, severity]), other.map(({ kind, severity }) => [kind, severity]));
      const values = difference(mine, theirs, "/statements", isLoose);
      assert.ok(values.size < tolerance(name), `${values.path} ${values.size}`);
      statements.forEach((told, i) => {
        const { left, right } = theirs[i]?.values ?? {};
        if (left !== undefined && told.kind.startsWith("row_")) assert.equal(told.gap, null); // of all gaps, with the hardest impact
        else if (left !== undefined) assert.equal(told.gap, `${left} | ${right}`);
      });
      const lines = (grade) => statements.filter(({ severity, shown }) => shown === "sentence" && (severity === "remark") === grade).map((told) => lineOf(told, gaps.length > 1));
      const said = terminal(file, language);
      assert.deepEqual(lines(false), said.verdict, language);
      assert.deepEqual(lines(true), said.remarks, language);
    }
  });
}

/** Figures of a page, each as what is written and drawn in it, element by element. */
const figuresOf = (html) => [...html.matchAll(/<figure[^>]*>(?:<div class="wide"[^>]*>)?(<svg[\s\S]*?<\/svg>)/g)].map(([, svg]) => svg.split("\n"));
const numbers = (text) => (text.match(/-?\d+(?:\.\d+)?/g) ?? []).map(Number);

/** Farthest that a point of one line through points lies from the other [px]. */
function apart(one, other) {
  let farthest = 0;
  for (let i = 0; i + 1 < one.length; i += 2) {
    let nearest = Math.hypot(one[i] - other[0], one[i + 1] - other[1]);
    for (let k = 0; k + 3 < other.length && nearest > 0; k += 2) {
      const [x, y, dx, dy] = [other[k], other[k + 1], other[k + 2] - other[k], other[k + 3] - other[k + 1]];
      const part = Math.min(1, Math.max(0, ((one[i] - x) * dx + (one[i + 1] - y) * dy) / (dx * dx + dy * dy || 1)));
      nearest = Math.min(nearest, Math.hypot(one[i] - x - part * dx, one[i + 1] - y - part * dy));
    }
    farthest = Math.max(farthest, nearest);
  }
  return farthest;
}

/** Of the same picture, each as its elements: to the byte where numbers are the same to the bit, else every place to a hundredth. */
function isDrawnAs(mine, theirs, isExact) {
  if (isExact) return assert.deepEqual(mine, theirs);
  assert.equal(mine.length, theirs.length, theirs[0]);
  theirs.forEach((element, k) => {
    const data = (text) => /^<path d="(M[-\d. L]*L[-\d. L]*)"/.exec(text)?.[1];
    const [a, b] = [numbers(data(mine[k]) ?? mine[k]), numbers(data(element) ?? element)];
    // Of equal extremes of a curve either may be drawn: a line is where the other is, to a hundredth rounded either way.
    const worst = data(element) ? Math.max(apart(a, b), apart(b, a)) : Math.max(0, ...a.map((value, n) => Math.abs(value - b[n])));
    assert.ok(worst < 0.0142, `${theirs[0].slice(0, 90)}: ${worst} ${element.slice(0, 200)}`);
  });
}

// Pictures of every fourth case, plans among them (BENTUR_PART=all: of all): they are drawn by what draws those of the others.
const drawn = files.filter((file, k) => process.env.BENTUR_PART === "all" || k % 4 === 2);
test("pictures of rows and of plans are compared", () => {
  assert.ok(drawn.some((file) => plans.includes(file)) && drawn.some((file) => !plans.includes(file)));
});
for (const file of drawn) {
  const name = file.slice(file.lastIndexOf("/") + 1);
  test(`${name}: a report made in the page has the command line's figures`, () => {
    JSON.parse(one.open(readFileSync(file, "utf8"), name));
    assert.ok(JSON.parse(one.solve(null, null)).ok);
    const mine = figuresOf(one.report("en"));
    const theirs = figuresOf(execFileSync(process.env.BENTUR, ["report", file, "-o", "-"], { maxBuffer: 1e8 }).toString());
    assert.equal(mine.length, theirs.length);
    assert.ok(theirs.length > 1);
    theirs.forEach((elements, i) => {
      if (name === "crossroads.toml" && elements[0].includes("Spectra of what stands on a floor")) return; // see below
      isDrawnAs(mine[i], elements, exact.has(name));
    });
  });

  test(`${name}: every figure of the page is the command line's`, () => {
    const folder = mkdtempSync(`${tmpdir()}/bentur-figures-`);
    try {
      // Of buildings in plan the command line draws its own samples, so that those have to be as fine.
      const text = plans.includes(file) ? readFileSync(file, "utf8").replace("[analysis]", "[analysis]\noutput_step = 0.001") : readFileSync(file, "utf8");
      const drawnFrom = plans.includes(file) ? `${folder}/${name}` : file;
      if (plans.includes(file)) writeFileSync(drawnFrom, text.replace("../../data", `${source}/data`));
      execFileSync(process.env.BENTUR, ["run", "-q", "--figures", "svg", "-o", `${folder}/results`, drawnFrom]);
      JSON.parse(one.open(text, name));
      assert.ok(JSON.parse(one.solve(null, null)).ok);
      const figures = readdirSync(`${folder}/results/figures`).filter((one) => one.endsWith(".svg"));
      assert.ok(figures.length > 4);
      for (const figure of figures) {
        if (figure === "energy.svg") continue; // the page keeps other samples of it
        // Dense runs of many have coarser samples in the page, whose spectra of floors so begin at longer periods.
        if (figure === "floor-spectrum.svg" && name === "crossroads.toml") continue;
        const mine = one.figureFile(figure.slice(0, -4), "en", {});
        isDrawnAs(mine.split("\n"), readFileSync(`${folder}/results/figures/${figure}`, "utf8").split("\n"), exact.has(name));
      }
    } finally {
      rmSync(folder, { recursive: true });
    }
  });
}

test("the page says which bentur it is, as the command line does", () => {
  const version = execFileSync(process.env.BENTUR, ["--version"], { encoding: "utf8" }).trim().replace("bentur ", "");
  const summary = solved(read("m12-el-centro.toml"), "m12-el-centro.toml");
  const told = [summary, JSON.parse(one.gaps()), JSON.parse(one.overview("en"))];
  assert.deepEqual(told.map((part) => part.version), [version, version, version]);
  assert.ok(JSON.parse(one.solve(null, null)).ok);  // a report draws histories
  assert.ok(one.report("en").includes(`Pounding analysis, bentur ${version}<`));
});

test("a column that fails is told of first", () => {
  solved(read("struck-column.toml"), "struck-column.toml");
  for (const [language, column] of [["en", "column of Office at level 19.4 m"], ["id", "kolom Office di elevasi 19.4 m"]]) {
    const { kind, severity, text } = JSON.parse(one.overview(language)).statements[0];
    assert.deepEqual([kind, severity], ["column_shear", "danger"]);
    assert.ok(spaced(text).includes(column) && text.includes("2.416"), text);
  }
});

test("impacts, gaps and modes are those of the command line", () => {
  const name = "m12-el-centro.toml";
  solved(read(name), name);
  const line = (...options) => execFileSync(process.env.BENTUR, [...options, `${source}/examples/${name}`], { encoding: "utf8" });
  // 1e-12: the square roots of sums of squares are other ones (hypot).
  assert.ok(difference(JSON.parse(one.gaps()), JSON.parse(line("gap", "--json"))).size < 1e-12);
  assert.deepEqual(difference(JSON.parse(one.modes()), JSON.parse(line("modes", "--json"))), { size: 0, path: "" });
  assert.equal(one.impacts().trim().split("\n").length, 1 + 37);
});

test("of buildings in plan the page has what the command line has", () => {
  const file = plans.find((one) => one.endsWith("twisting-pair.toml")), text = readFileSync(file, "utf8");
  solved(text, "twisting-pair.toml");
  const line = (...options) => execFileSync(process.env.BENTUR, [...options, file], { encoding: "utf8" });
  assert.ok(difference(JSON.parse(one.gaps()), JSON.parse(line("gap", "--json"))).size < 1e-12);
  const periods = (json) => JSON.parse(json).buildings.map((building) => building.periods);
  assert.ok(difference(periods(one.modes()), periods(line("modes", "--json"))).size < 1e-12);
  assert.equal(one.impacts().trim().split("\n").length, 1 + 7);
  assert.ok(JSON.parse(one.solve(null, null)).ok);
  const all = JSON.parse(one.overview("id"));
  assert.deepEqual(all.gaps.map(({ name, width }) => [name, Number(width.toFixed(9))]), [["Walled | Frame", 0.04]]);
  assert.deepEqual(all.points.map(({ elevation, along }) => [elevation, along]), [[3.5, "y = 0 m"], [3.5, "y = 18 m"], [6.7, "y = 0 m"], [6.7, "y = 18 m"]]);
  assert.deepEqual(all.impacts.map(([, elevation, , , , , , , along]) => [elevation, along]).filter(([elevation]) => elevation === 3.5), [[3.5, "y = 18 m"]]);
  assert.ok(Math.abs(all.amplification - 0.06088 / 0.05921) < 2e-4);
  assert.deepEqual(all.figures.map(({ kind }) => kind), ["overview", "scene", "displacement", "opening", "orbit", "force", "friction-cone", "floor-spectrum"]);
  assert.match(all.figures[0].caption, /dari atas/);
  const { tables } = JSON.parse(one.tables("id"));
  assert.deepEqual(tables.map(({ id }) => id), ["gaps", "peaks"]);
  assert.match(tables[1].markup, /north frame/);
  const data = JSON.parse(one.motion("id"));
  assert.equal(data.impacts.length, 7);
  assert.equal(data.words.level, "elevasi");
  assert.match(one.report("id"), /id="motion"/);
});

test("of buildings in plan what is wrong, too much and not asked for is said", () => {
  const text = readFileSync(plans.find((one) => one.endsWith("twisting-pair.toml")), "utf8");
  const errors = (given) => JSON.parse(one.open(given, "case.toml")).errors;
  const [wrong] = errors(text.replace("damping = 0.05", "damping = 1.5"));
  assert.equal(wrong.line, text.slice(0, text.indexOf("damping = 0.05")).split("\n").length);
  assert.ok(wrong.told.id && wrong.told.id !== wrong.message);
  const tall = (n) => text.replace("storey_heights = [3.5, 3.2]", `storey_heights = [${"3.5, ".repeat(n)}]`);
  assert.equal(errors(tall(134))[0].message, "modes");
  assert.equal(errors(text)[0], undefined);
  assert.equal(JSON.parse(one.atWidth(0, 0.1)).ok, false);
  assert.deepEqual(JSON.parse(one.contacts()).counts, []);
  // And a row after it is a row again.
  solved(read("m12-el-centro.toml"), "m12-el-centro.toml");
  assert.equal(JSON.parse(one.overview("en")).plan, undefined);
});

test("a gap's width by itself gives what the case with that width gives", () => {
  const name = "m12-el-centro.toml";
  solved(read(name), name);
  const found = JSON.parse(one.atWidth(0, 0.4));
  const summary = solved(read(name).replace("width = 0.2 ", "width = 0.4 "), name);
  assert.equal(found.force, Math.max(...summary.gaps[0].points.map((point) => point.peak_force)));
});

test("in other units a case is the same buildings", () => {
  const scale = { m: 1, cm: 0.01, mm: 0.001, in: 0.0254, ft: 0.3048 };
  const weight = { N: 1, kN: 1e3, kgf: 9.80665, tf: 9806.65, kip: 453.59237 * 9.80665 };
  // What the results have of length and force; all else (ratios, times, counts) has to stay.
  const length = /^(elevations?|width|gap_needed|.*displacement|.*displacement_no_contact|peak_penetration|peak_closing_speed|.*acceleration|.*stroke)$/;
  const told = (summary) => summary.buildings.flatMap((one) => ["periods", "amplification", "peak_drift_ratio", "peak_displacement", "peak_displacement_no_contact", "peak_acceleration", "peak_storey_shear"].map((key) => [key, [one[key]].flat()]))
    .concat(summary.gaps.flatMap((gap) => gap.points.flatMap((point) => ["width", "elevation", "gap_needed", "impacts", "contact_duration", "peak_force", "peak_penetration", "peak_closing_speed"].map((key) => [key, [point[key]]]))));
  const texts = new Map(examples.map((name) => [name, read(name)]));
  texts.set("every-unit.toml", readFileSync(`${source}/web/test/every-unit.toml`, "utf8"));
  for (const [name, text] of texts) {
    const before = solved(text, name);
    for (const [l, f] of [["ft", "kip"], ["cm", "kgf"]]) {
      const { ok, text: other } = JSON.parse(one.inUnits(text, l, f));
      assert.ok(ok);
      assert.deepEqual(other.match(/#.*/g), text.match(/#.*/g)); // comments are those that were
      const after = solved(other, name);
      assert.deepEqual(after.units.length + after.units.force, l + f);
      const by = scale[before.units.length] / scale[l], push = weight[before.units.force] / weight[f];
      const now = told(after);
      for (const [k, [key, values]] of told(before).entries()) {
        const factor = length.test(key) ? by : /force|shear/.test(key) ? push : 1;
        // Of floors that hardly move, and of ratios of such, digits are lost: 1e-6 of the largest of a list is no more than
        // what the numbers' 13 digits become in 20 s of impacts.
        const most = Math.max(...values.map((value) => Math.abs(value ?? 0)));
        values.forEach((value, i) => {
          if (value === null) assert.equal(now[k][1][i], null);
          else assert.ok(Math.abs(now[k][1][i] - value * factor) <= 1e-6 * most * factor, `${name} ${l} ${f} ${key} ${now[k][1][i]} ${value * factor}`);
        });
      }
    }
    const { length: l0, force: f0 } = before.units;
    const there = JSON.parse(one.inUnits(text, "ft", "kip")).text;
    const back = JSON.parse(one.inUnits(there, l0, f0)).text;
    const numbers = (all) => (all.replace(/#.*/g, "").match(/(?<![\w"-])[-+]?\d[\d.e+-]*/g) ?? []).map(Number);
    assert.deepEqual(numbers(back), numbers(text), name);
  }
});

/** What a schema says of every key, each of its meanings by itself. */
const told = (node) => Object.entries(node).flatMap(([name, one]) =>
  (typeof one !== "object" || one === null ? [] : [...(name === "x-bentur" ? one : []), ...told(one)]));

test("the form has the schema that bentur writes, and the units that it knows", () => {
  const { case: mine, units } = JSON.parse(one.schema());
  const theirs = JSON.parse(execFileSync(process.env.BENTUR, ["schema"], { encoding: "utf8" }));
  assert.deepEqual({ ...mine, title: "" }, { ...theirs, title: "" });
  const { length, force } = mine.properties.units.properties;
  assert.deepEqual([Object.keys(units.length), Object.keys(units.force)], [length.enum, force.enum]);
  assert.equal(units.length.ft, 0.3048);
  assert.equal(units.force.kip, 453.59237 * 9.80665);
});

test("no case of the page says in its title what a slider changes", () => {
  const used = readFileSync(`${source}/web/app/src/cases.ts`, "utf8");
  const files = [...used.matchAll(/from "(?:@repo\/|\.\.\/)([\w/.-]+\.toml)\?raw"/g)].map(([, file]) => file);
  assert.ok(files.length >= 6, used);
  for (const file of files) {
    const text = readFileSync(`${source}/${file.startsWith("cases/") ? `web/app/${file}` : file}`, "utf8");
    assert.doesNotMatch(text.match(/^title = "(.*)"$/m)[1], /\d\s*(mm|cm|m|in|ft)\b/, file);
  }
});

test("the page has no text that the schema has, and none twice", () => {
  const texts = readFileSync(`${source}/web/app/src/texts.ts`, "utf8");
  const [en, id] = [...texts.matchAll(/^const (?:en|id)\b[^]*?^}/gm)].map(([block]) =>
    new Map([...block.matchAll(/(?:"([\w.]+)"|\b(\w+)): ("(?:[^"\\]|\\.)*")/g)].map((found) => [found[1] ?? found[2], JSON.parse(found[3])])));
  assert.ok(en.size > 90 && id.size === en.size, `${en.size}`);
  const seen = new Set(told(JSON.parse(one.schema()).case).map(({ label }) => `${label.en} | ${label.id}`));
  for (const [word, text] of en) {
    const both = `${text} | ${id.get(word)}`;
    assert.ok(!seen.has(both), `${word}: ${both}`);
    seen.add(both);
  }
});

test("what is too large is refused at once, with its size", () => {
  const base = read("free-impact.toml");
  const ones = (n) => `[1${",1".repeat(n - 1)}]`;
  const frame = (floors, bays, how) => `[[building]]\nname = "A"\ndamping = 0.05\n[building.frame]\nelastic_modulus = 1.0\nstorey_heights = ${ones(floors)}\nbay_widths = ${ones(bays)}\ncolumns = [{ area = 1, inertia = 1, mass = 1 }]\nbeams = [{ area = 1, inertia = 1, mass = 1 }]\ncondensation = "${how}"\n`;
  for (const [text, word, size] of [
    [base.replace(/stick = .*/, `stick = { storey_heights = ${ones(10000)}, masses = ${ones(10000)}, stiffnesses = ${ones(10000)} }`), "modes", 10001],
    [`[[building]]\nname = "A"\ndamping = 0.05\n[building.generic]\nstoreys = 1000000\nstorey_height = 3\nfloor_mass = 1\nperiod = 1\nsystem = "wall"\n`, "modes", 1000000],
    [frame(100, 5, "none"), "modes", 700],
    [frame(300, 10, "static"), "joints", 3600],
    [`[[building]]\nname = "W"\nrigid = true\nelevations = ${ones(100000)}\n`, "elevations", 100000],
    ['[[building]]\nname = "W"\nrigid = true\n'.repeat(5000), "buildings", 5000],
  ]) {
    const { ok, errors } = JSON.parse(one.open(text, "case.toml"));
    assert.equal(ok, false);
    assert.deepEqual([errors[0].message, errors[0].values.n], [word, size]);
    assert.ok(errors[0].line > 0 && errors[0].values.most < size);
  }
});

test("every mistake is told with line, column and key", () => {
  const text = read("m12-el-centro.toml").replace("width = 0.2 ", "widht = 0.2 ").replace("duration = 10.0", "duration = -1");
  const { ok, errors } = JSON.parse(one.open(text, "case.toml"));
  assert.equal(ok, false);
  const lines = text.split("\n");
  for (const error of errors) assert.ok(error.line > 0 && error.column > 0 && error.message !== "", JSON.stringify(error));
  assert.ok(errors.some((error) => lines[error.line - 1].startsWith("widht")));
  assert.ok(errors.some((error) => error.key === "analysis.duration" && lines[error.line - 1].startsWith("duration")));
});

test("every refused case of tests/bad_input is refused in the same words", () => {
  const folder = process.env.BENTUR_REFUSED;
  const keys = readFileSync(`${folder}/keys.txt`, "utf8").trim().split("\n");
  let compared = 0;
  one.putFile("good.AT2", readFileSync(`${folder}/good.AT2`)); // of the suites among them
  for (const name of readdirSync(folder).filter((file) => file.endsWith(".toml"))) {
    const text = readFileSync(`${folder}/${name}`);
    // What depends on files beside the case is told of by the record tests.
    if (/(files?|logo)\s*=/.test(text.toString().replace('files = ["good.AT2"]', ""))) continue;
    // Below 2.2e-308 a number is no number for the stream that the TOML parser reads with where there is no from_chars:
    // refused as well, in other words.
    if (name === "harmonic-period-tiny.toml") continue;
    const { ok, errors } = JSON.parse(one.open(text, name));
    assert.equal(ok, false, name);
    const expected = readFileSync(`${folder}/${name.replace(".toml", ".expected")}`, "utf8").trim().split("\n");
    const told = errors.map((e) => `${name}${e.line > 0 ? `:${e.line}:${e.column}` : ""}: error: ${e.message}`).join("\n");
    for (const line of expected) { // "..." stands for what depends on the machine
      const parts = line.replace(/^.*?error: /, "").split("...");
      assert.ok(parts.every((part) => told.includes(part)), `${name}\n${told}\nis without\n${line}`);
    }
    const keysOf = keys.filter((line) => line.startsWith(`${name}:`)).map((line) => line.slice(name.length + 2));
    assert.deepEqual(errors.map((e) => e.key), keysOf, name);
    ++compared;
  }
  assert.ok(compared > 100, `${compared}`);
});

test("hostile texts give a message", () => {
  const base = read("free-impact.toml");
  const ones = (n) => `[1${",1".repeat(n - 1)}]`;
  for (const [what, text] of Object.entries({
    "ten thousand storeys": base.replace(/stick = .*/, `stick = { storey_heights = ${ones(10000)}, masses = ${ones(10000)}, stiffnesses = ${ones(10000)} }`),
    "two megabytes": `title = "${"a".repeat(2e6)}"`,
    "a million storeys": `[[building]]\nname = "A"\ndamping = 0.05\n[building.generic]\nstoreys = 1000000\nstorey_height = 3\nfloor_mass = 1\nperiod = 1\nsystem = "wall"\n`,
    "a long list": `x = ${ones(400000)}`,
    "deep": `x = ${"[".repeat(100000)}`,
    "numbers": base.replace(/duration = \S+/, "duration = 1e300"),
    "not UTF-8": new Uint8Array([0x74, 0xff, 0xfe, 0x3d]),
    "null": "a = 1\0",
    "markup": '[[building]]\nname = "</script><img src=x onerror=alert(1)>"',
  })) {
    let answer = JSON.parse(one.open(text, "case.toml"));
    if (answer.ok) answer = JSON.parse(one.solve(0, null));
    assert.equal(answer.ok, false, what);
    assert.ok(answer.errors.length > 0 && answer.errors[0].message.length > 0, what);
  }
});

test("a run can be stopped", () => {
  JSON.parse(one.open(read("two-frames-si.toml"), "case.toml"));
  const stopped = JSON.parse(one.solve(0, () => false));
  assert.equal(stopped.ok, false);
  assert.equal(stopped.errors[0].message, "stopped");
});

/** A section of a page that `bentur report` wrote. */
const sectionOf = (page, id) => new RegExp(`<section id="${id}"><h2>[^<]*</h2>\n([^]*?)</section>\n`).exec(page)[1];
// How much energy is not accounted for is round-off, and nothing else.
const withoutResidual = (markup) => markup.replace(/\d(\.\d+)?\u00a0×\u00a010[⁻⁰¹²³⁴-⁹]+/g, "");

test("at the instant of its still a run sampled coarsely has the report's displacements", () => {
  const samplesOf = new Function("data", `${readFileSync(`${source}/src/bentur/report/html/motion/samples.js`, "utf8")} return benturSamples(data);`);
  const still = (data) => ({ at: data.shown, floors: samplesOf(data).motionAt(data.shown).flat(), grain: Math.max(...data.buildings.map((each) => each.scale)) });
  for (const name of ["row-of-three.toml", "plan/twisting-pair.toml"]) {
    assert.ok(JSON.parse(one.open(read(name), name)).ok);
    assert.ok(JSON.parse(one.solve(0.05, null)).ok);
    const mine = still(JSON.parse(one.motion("en")));
    const page = execFileSync(process.env.BENTUR, ["report", `${source}/examples/${name}`, "-o", "-"], { encoding: "utf8", maxBuffer: 2 ** 28 });
    const theirs = still(JSON.parse(/<script type="application\/json" id="data">([^]*?)<\/script>/.exec(page)[1]));
    assert.ok(Math.abs(mine.at - theirs.at) < 1e-6, name);
    assert.equal(mine.floors.length, theirs.floors.length);
    mine.floors.forEach((value, i) => assert.ok(Math.abs(value - theirs.floors[i]) <= 2 * theirs.grain, `${name}: ${value} ${theirs.floors[i]}`));
  }
});

test("the tables are those of the report", () => {
  const ids = new Set();
  const all = process.env.BENTUR_PART === "all";
  for (const name of ["struck-column.toml", "row-of-three.toml", ...all ? ["yielding-pair.toml", "isolated-moat.toml"] : []]) {
    solved(read(name), name);
    for (const language of all || name.startsWith("row") ? ["en", "id"] : ["en"]) {
      const page = execFileSync(process.env.BENTUR, ["report", `${source}/examples/${name}`, "--lang", language, "-o", "-"], { encoding: "utf8", maxBuffer: 2 ** 28 });
      const { ok, tables } = JSON.parse(one.tables(language));
      assert.ok(ok);
      for (const { id, markup } of tables) {
        assert.equal(withoutResidual(markup), withoutResidual(sectionOf(page, id)), `${name} ${id}`);
        ids.add(id);
      }
    }
  }
  assert.deepEqual([...ids].sort(), ["columns", "gaps", "peaks"]);
});

test("gaps by a spectrum are those of bentur gap", () => {
  const file = `${source}/examples/gaps/design-spectrum.toml`;
  const told = (...options) => execFileSync(process.env.BENTUR, options, { encoding: "utf8" });
  const opened = JSON.parse(one.open(readFileSync(file, "utf8"), "case.toml"));
  assert.deepEqual(opened.errors, []);
  assert.ok(JSON.parse(one.solve(null, null)).ok);
  const mine = JSON.parse(one.gaps()), theirs = JSON.parse(told("gap", "--json", file));
  const values = difference({ ...mine, case: null }, { ...theirs, case: null });
  assert.ok(values.size < 1e-12, `${values.path} ${values.size}`);
  for (const language of ["en", "id"]) {
    const { spectral, gaps, statements } = JSON.parse(one.overview(language));
    assert.ok(spectral);
    assert.ok(gaps[0].needed > gaps[0].width);
    const said = told("gap", file, "--lang", language).replace(/\s+/g, " ");
    for (const { text, shown } of statements) assert.ok(shown !== "sentence" || said.includes(spaced(text)), text);
    const pages = [told("report", file, "--lang", language, "-o", "-"), one.report(language)];
    for (const { id, markup } of JSON.parse(one.tables(language)).tables) {
      for (const page of pages) assert.equal(markup, sectionOf(page, id), id);
    }
  }
  assert.deepEqual([one.summary(), one.impacts(), one.motion("en")], ["", "", ""]);
});

test("a suite of records is told of as by run, gap and report, and each record as by --record", () => {
  const given = makeSuite();
  for (const name of given.records) one.putFile(name, given.bytes(name));
  const bentur = (...options) => execFileSync(process.env.BENTUR, options, { encoding: "utf8", maxBuffer: 2 ** 28 });
  const unlike = (path) => /^\/case$|\/wall_time$|\/energy_residual$/.test(path);
  const compare = (mine, most, ...options) => {
    const found = difference(JSON.parse(mine), JSON.parse(bentur(...options, "--json")), "", unlike);
    assert.ok(found.size < most, `${options.join(" ")} ${found.path} ${found.size}`);
  };
  // Storeys of the example yield.
  for (const [file, most] of [[given.file, 1e-12], [`${source}/examples/two-real-buildings/record.toml`, 1e-11]]) {
    compare(JSON.stringify(solved(readFileSync(file, "utf8"), file.slice(file.lastIndexOf("/") + 1))), most, "run", file);
    compare(one.gaps(), most, "gap", file);
    for (const language of ["en", "id"]) {
      const page = bentur("report", file, "--lang", language, "-o", "-");
      const { tables } = JSON.parse(one.tables(language));
      assert.deepEqual(tables.map(({ id }) => id), ["records", "runs", "gaps"]);
      for (const { id, markup } of tables) assert.equal(markup, sectionOf(page, id), `${file} ${id}`);
    }
    const { suite, gaps, statements } = JSON.parse(one.overview("en"));
    assert.equal(suite.record, 0);
    assert.ok(gaps[0].needed > 0 && statements.length > 3);
    assert.equal(JSON.parse(one.atWidth(0, 0.1)).ok, false);
    const last = suite.records.length;
    assert.equal(JSON.parse(one.chooseRecord(last + 1)).record, 0);
    assert.equal(JSON.parse(one.chooseRecord(last)).record, last);
    assert.deepEqual(JSON.parse(one.solve(0, null)).errors, []);
    compare(one.summary(), most, "run", file, "--record", `${last}`);
    assert.equal(JSON.parse(one.overview("en")).suite.record, last);
  }
  // It can be stopped, and has no more records than there are files.
  one.removeFile("records/b.AT2");
  assert.deepEqual(JSON.parse(one.open(given.text, "case.toml")).errors, []);
  for (const most of [0.2, 0.7]) assert.equal(JSON.parse(one.solve(0, (done) => done < most)).errors[0].message, "stopped");
  assert.equal(JSON.parse(one.chooseRecord(0)).records, 2);
  for (const name of given.records) one.removeFile(name);
  assert.equal(JSON.parse(one.open(given.text, "case.toml")).errors.length, 2);
  rmSync(given.folder, { recursive: true });
});

test("a gap's contact points are counted", () => {
  for (const [name, counts] of [["two-frames-si.toml", [6]], ["row-of-three.toml", [4, 4]], ["struck-column.toml", [10]]]) {
    JSON.parse(one.open(read(name), name));
    assert.deepEqual(JSON.parse(one.contacts()).counts, counts, name);
  }
});

test("the report is that of the command line, without figures", () => {
  const name = "m12-el-centro.toml";
  JSON.parse(one.open(read(name), name));
  JSON.parse(one.solve(null, null));
  const page = one.report("id");
  assert.ok(page.startsWith("<!DOCTYPE html>") && page.includes('lang="id"'));
  assert.ok(page.includes("benturMotion"));
});
