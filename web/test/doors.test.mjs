// The third door: what stands in the page's text is solved there to the command line's numbers, for examples, all of them
// in ./dev soak, and for the first own case of docs/start.md. tests/python/doors_test.py has the second. Environment as page.test.mjs.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, copyFileSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { after, before } from "node:test";
import { pathToFileURL } from "node:url";
import { launch, open, solved, taken, test } from "./browser.mjs";
import { difference, examples, isLoose, lineOf, spaced, terminal, tolerance } from "./core.mjs";

const source = process.env.BENTUR_SOURCE;
const editor = "textarea[aria-label]";
let browser;
before(async () => { browser = await launch(); });
after(async () => { await browser.close(); });

/** The page as it opens, its first case solved. */
async function opened() {
  const started = performance.now();
  const found = await open(browser, pathToFileURL(process.env.BENTUR_PAGE).href);
  await solved(found.page);
  return { ...found, took: performance.now() - started };
}

/** Puts a text over what stands there and takes the summary of what it gives. */
async function summary(page, text) {
  await page.locator(editor).evaluate((area, all) => { area.value = all; area.dispatchEvent(new Event("input", { bubbles: true })); }, text);
  await solved(page);
  return JSON.parse(await taken(page, '[data-take="summary"]'));
}

function same(mine, file, name) {
  const theirs = JSON.parse(execFileSync(process.env.BENTUR, ["run", "--json", file]));
  assert.equal(mine.title, theirs.title, name);
  // Not compared: where the case and its record lie, how long it took, energy not accounted for, which is round-off.
  const unlike = (path) => /^\/case|\/wall_time$|\/energy_residual$|^\/excitation\/file$/.test(path);
  const values = difference(mine, theirs, "", (path) => unlike(path) || isLoose(path));
  assert.ok(values.size <= tolerance(name), `${name} ${values.path} ${values.size}`);
  const all = difference(mine, theirs, "", unlike);
  assert.ok(all.size < 1e-9, `${name} ${all.path} ${all.size}`);
}

/** What the page shows of a run: its statements, each with its gap, its badge and whether it is in sight, and its remarks. */
const shown = (page) => page.evaluate(() => {
  const statements = [];
  const badges = new Map();
  for (const one of document.querySelectorAll(".verdict [data-kind]")) {
    const folder = one.closest("details"), list = folder ?? document;
    const badge = one.querySelector(".badge") ?? (badges.has(list) ? null : [...folder?.querySelectorAll("summary .badge") ?? []].at(-1)); // behind that of rules
    if (badge) badges.set(list, badge.textContent);
    const text = one.querySelector("p:not(.badge)");
    statements.push({ kind: one.dataset.kind, isSentence: one.dataset.shown === "sentence", gap: folder?.dataset.gap ?? null, badge: text.className === "lead" ? badges.get(list) ?? "" : "", text: text.textContent, inSight: text.checkVisibility() });
  }
  const table = [...document.querySelectorAll(".facts")].at(-1), rows = [...table?.querySelectorAll("tbody tr") ?? []];
  return { statements, remarks: document.querySelector("[data-remarks]").textContent, known: rows.map((row) => row.cells[0].textContent) };
});

test("every example is told of as in a terminal, in both languages", async () => {
  const { page, complaints, requests, close } = await opened();
  for (const language of ["en", "id"]) {
    await page.selectOption("#language", language);
    for (const name of examples(source, 2, ["row-of-three.toml"])) {
      const { statements: theirs, gaps } = await summary(page, readFileSync(`${source}/examples/${name}`, "utf8"));
      const { statements, remarks, known } = await shown(page);
      const said = terminal(`${source}/examples/${name}`, language);
      // Of a row what each gap has is under its name, in the terminal's order there too.
      const lines = statements.filter((one) => one.isSentence).map((one) => lineOf({ ...one, severity: "" }, gaps.length > 1));
      const gapNames = gaps.length > 1 ? gaps.map(({ between }) => `${between.join(" | ")}: `) : [];
      for (const begins of [...gapNames.map((gap) => (line) => line.startsWith(gap)), (line) => !gapNames.some((gap) => line.startsWith(gap))]) {
        assert.deepEqual(lines.filter(begins), said.verdict.filter(begins), `${name} ${language}`);
      }
      // Then tables: what else is known, row by row.
      assert.equal(spaced(known.join(" ")), said.known.join(" "), `${name} ${language}`);
      assert.equal(spaced(remarks), said.remarks.map((line) => line.replace(/^remark: /, "")).join(" "));
      // What fails is in sight, and of every gap that is not folded away with the others whether it collides.
      const grades = new Map(theirs.map(({ kind, severity }) => [kind, severity]));
      for (const { kind, gap, inSight, isSentence } of statements) assert.ok(inSight || gap !== null || !isSentence || grades.get(kind) === "finding", kind);
      for (const gap of await page.$$(".verdict > details > summary .badge")) assert.ok(await gap.isVisible());
      // The gravest comes first, under a badge or, of a column that breaks, without one; rules may head what is not known.
      const firsts = [statements[0], statements.find(({ badge }) => badge)].map((one) => one?.kind);
      assert.ok(firsts.includes(theirs[0].kind), `${name}: ${firsts} ${theirs[0].kind}`);
      if (name === "struck-column.toml") {
        assert.ok(lines[0].includes(language === "en" ? "column of Office at level 19.4 m" : "kolom Office di elevasi 19.4 m") && lines[0].includes("2.416"), lines[0]);
        assert.ok(statements[0].inSight);
      }
    }
  }
  assert.deepEqual([...requests, ...complaints], []);
  await close();
});

test("every example, written into the page, gives the command line's numbers", async () => {
  const { page, complaints, requests, close } = await opened();
  for (const name of examples(source, 0)) {
    same(await summary(page, readFileSync(`${source}/examples/${name}`, "utf8")), `${source}/examples/${name}`, name);
  }
  assert.deepEqual([...requests, ...complaints], []);
  await close();
});

test("the first own case of the start page", async () => {
  const text = /^```toml\n(.*?)^```$/ms.exec(readFileSync(`${source}/docs/start.md`, "utf8"))[1];
  const { page, took, close } = await opened();
  const started = performance.now();
  const mine = await summary(page, text);
  console.log(`# first case after ${(took / 1e3).toFixed(1)} s, first own case ${((performance.now() - started) / 1e3).toFixed(1)} s after it was pasted`);
  const folder = mkdtempSync(`${tmpdir()}/bentur-doors-`);
  copyFileSync(`${source}/data/el-centro-1940-ns.csv`, `${folder}/el-centro-1940-ns.csv`);
  writeFileSync(`${folder}/own.toml`, text);
  same(mine, `${folder}/own.toml`, "own.toml");
  rmSync(folder, { recursive: true });
  await close();
});
