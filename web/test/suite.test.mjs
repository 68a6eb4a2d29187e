// The studio with a suite of records, as its user meets it. Environment as page.test.mjs.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { readFileSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { after, before } from "node:test";
import { pathToFileURL } from "node:url";
import { launch, open, solved, taken, test } from "./browser.mjs";
import { difference, spaced } from "./core.mjs";
import { makeSuite } from "./suites.mjs";

const suite = makeSuite();
const editor = "textarea[aria-label]", opener = ".cases input[type=file]";
const bentur = (...options) => execFileSync(process.env.BENTUR, options, { encoding: "utf8" });
const unlike = (path) => /^\/case|\/wall_time$|\/energy_residual$|\/file$/.test(path);
let browser, common;
before(async () => {
  browser = await launch();
  common = await open(browser, pathToFileURL(process.env.BENTUR_PAGE).href);
  await solved(common.page);
});
after(async () => {
  await browser.close();
  rmSync(suite.folder, { recursive: true });
});

/** Does something in the page where the case was opened with these records, and looks whether it complained or asked for
 *  anything. */
async function withSuite(records, work) {
  const { page, complaints, requests } = common;
  await give(page, "case.toml", ...records);
  await page.waitForFunction(([at, wanted]) => document.querySelector(at).value === wanted, [editor, suite.text]);
  await solved(page, records.length > 0 ? "fine" : "errors");
  await work(page);
  assert.deepEqual(requests, []);
  assert.deepEqual(complaints, []);
  await page.selectOption("#language", "en");
}

const give = async (page, ...names) => {
  await page.setInputFiles(opener, names.map((name) => `${suite.folder}/${name}`));
};

/** What the program says of a case that is wrong, without where. */
function refused(file, language) {
  const { status, stderr } = spawnSync(process.env.BENTUR, ["run", file, "--lang", language], { encoding: "utf8" });
  assert.equal(status, 2);
  return stderr.trim().split("\n").map((line) => line.replace(/^.*?: (error|kesalahan): /, ""));
}

const told = (page) => page.$$eval(".errors li", (all) => all.map((one) => one.textContent));

test("records that are not there are named in the program's words, and found by their names when they are given", async () => {
  await withSuite([], async (page) => {
    const bare = makeSuite();
    for (const name of bare.records) rmSync(`${bare.folder}/${name}`);
    rmSync(`${bare.folder}/records`, { recursive: true });
    for (const language of ["en", "id"]) {
      await page.selectOption("#language", language);
      await solved(page, "errors");
      const mine = await told(page), theirs = refused(bare.file, language);
      assert.equal(mine.length, theirs.length);
      theirs.forEach((line, i) => assert.ok(mine[i].includes(line), `${mine[i]}\nis without\n${line}`));
    }
    rmSync(bare.folder, { recursive: true });
    await page.selectOption("#language", "en");
    await give(page, "records/a.AT2", "records/b.AT2");
    await page.waitForFunction(() => document.querySelectorAll(".errors li").length === 1);
    assert.match((await told(page))[0], /"c\.txt", there is no such file/);
    await give(page, "c.txt");
    await solved(page);
    assert.equal(await page.inputValue(editor), suite.text); // they went to their places, and the case is what it was
    const mine = JSON.parse(await taken(page, '[data-take="summary"]')), theirs = JSON.parse(bentur("run", "--json", suite.file));
    const values = difference(mine, theirs, "", unlike);
    assert.ok(values.size < 1e-12, `${values.path} ${values.size}`);
    const gaps = difference(JSON.parse(await taken(page, '[data-take="gaps"]')), JSON.parse(bentur("gap", "--json", suite.file)), "", unlike);
    assert.ok(gaps.size < 1e-12, `${gaps.path} ${gaps.size}`);
    // A reload keeps those that only a pattern names.
    await page.reload();
    await solved(page);
    assert.deepEqual(await told(page), []);
    assert.equal(await page.locator("#record option").count(), 4);
  });
});

test("its words are those of run and gap, with the spectra, and a table of each", async () => {
  await withSuite(suite.records, async (page) => {
    for (const language of ["en", "id"]) {
      await page.selectOption("#language", language);
      await solved(page);
      const all = ["run", "gap"].map((what) => bentur(what, suite.file, "--lang", language).replace(/\s+/g, " "));
      const mine = await page.$$eval(".verdict [data-shown=sentence] p:not(.badge)", (found) => found.map((one) => one.textContent));
      assert.ok(mine.length >= 4, mine.join("\n"));
      for (const text of mine) assert.ok(all.some((one) => one.includes(spaced(text))), text);
      assert.match(mine.join(" "), /EN 1998-1, 4\.3\.3\.4\.3\(3\)/);
    }
    await page.selectOption("#language", "en");
    await solved(page);
    const kinds = await page.$$eval("[data-figure]", (found) => found.map((one) => one.dataset.figure));
    assert.deepEqual(kinds, ["gap-needed", "suite"]);
    await page.locator('[data-figure="suite"]').evaluate((one) => one.scrollIntoView());
    await page.waitForSelector('[data-figure="suite"] .sheet svg');
    assert.match(await taken(page, '[data-file="suite.svg"]'), /0\.9 of the target/);
    assert.match(await taken(page, '[data-file="gap-needed.svg"]'), /largest, by EN 1998-1/);
    for (const [id, words] of [["records", /σ|misfit|NOWHERE/], ["runs", /largest/], ["gaps", /84 %/]]) {
      assert.match(await page.textContent(`[data-table="${id}"]`), words);
    }
    assert.equal(await page.locator("#impacts, #compare, [data-take=impacts], [data-take=svg]").count(), 0);
    // The buildings stand still at the hardest impact of all, which the verdict tells, under its record.
    await page.waitForSelector("#motion .stage .column");
    const [, record, time] = /worst under (\w+): West and East collide.*? at level [\d.]+ m at ([\d.]+) s/.exec(spaced(await page.textContent(".verdict")));
    assert.match(await page.textContent("[data-hardest]"), new RegExp(`^Under record ${record}\\b`));
    assert.ok(Math.abs(await page.getAttribute("#motion .stage", "data-time") - time) < 1e-3 * time);
    assert.equal(await page.getAttribute(".play", "aria-pressed"), "false");
    assert.match(await taken(page, '[data-take="report"]'), /Pounding under a suite of records/);
    // A drag of the gap runs them all again.
    await page.locator("#gap").evaluate((one) => { one.value = one.max; one.dispatchEvent(new Event("input", { bubbles: true })); });
    await solved(page);
    assert.match(await page.textContent(".verdict"), /enough under all of 3 records/);
  });
});

test("one record is a run like any other, in motion", async () => {
  await withSuite(suite.records, async (page) => {
    await page.selectOption("#record", "3");
    await page.waitForSelector("#impacts tbody tr");
    await solved(page);
    const mine = JSON.parse(await taken(page, '[data-take="summary"]'));
    const values = difference(mine, JSON.parse(bentur("run", "--json", "--record", "3", suite.file)), "", unlike);
    assert.ok(values.size < 1e-12, `${values.path} ${values.size}`);
    assert.ok(await page.locator("[data-figure]").count() > 2);
    assert.equal(await page.locator('[data-figure="suite"]').count(), 0);
    assert.ok(await page.locator("#impacts tbody tr").count() > 0);
    assert.match(await taken(page, '[data-take="report"]'), /id="motion"/);
    // Fewer records than that: all of them again.
    await page.locator(editor).evaluate((area, all) => { area.value = all; area.dispatchEvent(new Event("input", { bubbles: true })); }, suite.text.replace('"records/*.AT2", ', ""));
    await page.waitForFunction(() => document.querySelectorAll("#record option").length === 2);
    await solved(page);
    assert.equal(await page.inputValue("#record"), "0");
    assert.equal(await page.locator("[data-figure]").count(), 2);
  });
});

test("another record is one more of the suite, a broken one is told as elsewhere, and anew they are gone", async () => {
  await withSuite(suite.records, async (page) => {
    await page.setInputFiles(opener, { name: "more.txt", mimeType: "text/plain", buffer: suite.bytes("c.txt") });
    await solved(page, "errors"); // it does not say its unit
    assert.match(await page.textContent(".errors"), /more\.txt.*unit/);
    await page.locator(editor).evaluate((area) => { area.value = area.value.replace(', "more.txt"]', ', { file = "more.txt", unit = "g" }]'); area.dispatchEvent(new Event("input", { bubbles: true })); });
    await page.waitForFunction(() => document.querySelectorAll("#record option").length === 5);
    await solved(page);
    await page.setInputFiles(opener, { name: "b.AT2", mimeType: "text/plain", buffer: suite.bytes("records/b.AT2").subarray(0, 900) });
    await solved(page, "errors");
    const broken = makeSuite();
    execFileSync("truncate", ["-s", "900", `${broken.folder}/records/b.AT2`]);
    const [mine, theirs] = [await told(page), refused(broken.file, "en")];
    rmSync(broken.folder, { recursive: true });
    assert.equal(mine.length, theirs.length);
    assert.ok(mine[0].startsWith("b.AT2") && mine[0].includes(theirs[0]), `${mine[0]}\nis without\n${theirs[0]}`);
    await page.click("text=Start anew");
    await solved(page);
    await page.setInputFiles(opener, suite.file);
    await solved(page, "errors");
    assert.match((await told(page))[0], /no file matches/);
  });
});

test("nothing is wider than a telephone, and axe-core finds no violation", async () => {
  await withSuite(suite.records, async (page) => {
    await page.setViewportSize({ width: 390, height: 844 });
    await page.emulateMedia({ colorScheme: "dark" });
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= 390);
    await page.evaluate(readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8"));
    const { violations } = await page.evaluate(() => window.axe.run(document));
    assert.deepEqual(violations.map(({ id, nodes }) => [id, nodes.map(({ html }) => html)]), []);
  });
});
