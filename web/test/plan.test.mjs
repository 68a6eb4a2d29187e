// The studio with buildings in plan, as its user meets it. Environment as page.test.mjs.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { after, before } from "node:test";
import { pathToFileURL } from "node:url";
import { curveDone, launch, open, openForm, solved, taken, test } from "./browser.mjs";
import { difference, lineOf, spaced, terminal } from "./core.mjs";

const file = `${process.env.BENTUR_SOURCE}/examples/plan/twisting-pair.toml`;
const text = readFileSync(file, "utf8");
const editor = "textarea[aria-label]";
let browser;
before(async () => { browser = await launch(); });
after(async () => { await browser.close(); });

/** Does something in a page that stands at the case, opened as a file, and looks whether it complained or asked for anything. */
async function inPlan(work, options = {}) {
  const { page, complaints, requests, close } = await open(browser, pathToFileURL(process.env.BENTUR_PAGE).href, options);
  try {
    await solved(page);
    await curveDone(page); // which is of a row, and must not stand beside buildings in plan
    await page.setInputFiles(".cases input[type=file]", file);
    await page.waitForFunction(([at, wanted]) => document.querySelector(at).value === wanted, [editor, text]);
    await solved(page);
    await work(page);
    assert.deepEqual(requests, []);
    assert.deepEqual(complaints, []);
  } finally {
    await close();
  }
}

const put = async (page, given, state = "fine") => {
  await page.locator(editor).evaluate((area, all) => { area.value = all; area.dispatchEvent(new Event("input", { bubbles: true })); }, given);
  await solved(page, state);
};

test("a case in plan that is opened gives the command line's words and numbers", async () => {
  await inPlan(async (page) => {
    const mine = JSON.parse(await taken(page, '[data-take="summary"]'));
    const theirs = JSON.parse(execFileSync(process.env.BENTUR, ["run", "--json", file]));
    // Losses of a linear law are round-off.
    const unlike = (path) => /^\/case|\/wall_time$|\/energy_residual$|\/excitation.*\/file$|\/energy_lost$/.test(path);
    const found = difference(mine, theirs, "", unlike);
    assert.ok(found.size < 1e-12, `${found.path} ${found.size}`);
    for (const language of ["en", "id"]) {
      await page.selectOption("#language", language);
      await solved(page);
      const lines = await page.evaluate(() => [...document.querySelectorAll('.verdict [data-shown="sentence"]')].map((one) => ({ badge: one.querySelector(".badge")?.textContent ?? "", text: one.querySelector("p:not(.badge)").textContent })));
      const said = terminal(file, language);
      assert.deepEqual(lines.map((one) => lineOf({ gap: null, severity: "", kind: "", ...one })), said.verdict);
      assert.deepEqual(spaced(await page.textContent("[data-remarks]")), said.remarks.join(" ").replaceAll("remark: ", ""));
    }
    assert.equal(await taken(page, '[data-take="impacts"]').then((csv) => csv.trim().split("\n").length), 1 + 7);
    const report = await taken(page, '[data-take="report"]');
    assert.match(report, /id="motion"/);
    assert.match(report, /lang="id"/);
  });
});

test("on a telephone what stays in sight leaves the screen to what it is of", async () => {
  await inPlan(async (page) => {
    await page.setViewportSize({ width: 390, height: 844 });
    await page.waitForSelector(".bar [data-tick]");
    const high = await page.locator(".bar").evaluate((one) => one.offsetHeight);
    assert.ok(high < 844 / 7, `${high}`);
    await page.setViewportSize({ width: 1280, height: 900 });
    await page.waitForSelector(".bar [data-tick]");
  });
});

test("figures, tables and impacts are those of buildings in plan, without what only a row has", async () => {
  await inPlan(async (page) => {
    const kinds = await page.$$eval("[data-figure]", (all) => all.map((one) => one.dataset.figure));
    assert.deepEqual(kinds, ["displacement", "opening", "orbit", "force", "friction-cone", "floor-spectrum"]); // no gap-curve
    for (const kind of kinds) {
      await page.locator(`[data-figure="${kind}"]`).evaluate((one) => one.scrollIntoView());
      await page.waitForSelector(`[data-figure="${kind}"] .sheet svg`);
    }
    const lines = (kind) => page.locator(`[data-figure="${kind}"] .instant:not([hidden])`).count();
    assert.ok(await lines("displacement") > 0);
    assert.equal(await lines("orbit"), 0); // a path has no axis of time
    const levels = await page.$$eval("#figures select option", (all) => all.map((one) => one.textContent));
    assert.deepEqual(levels, ["hit hardest", "Walled | Frame, 3.5 m", "Walled | Frame, 6.7 m"]);
    await page.selectOption("#figures select", { label: "Walled | Frame, 3.5 m" });
    await page.locator('[data-figure="opening"]').evaluate((one) => one.scrollIntoView()); // what is not in sight waits
    await page.waitForFunction(() => document.querySelector('[data-figure="opening"]').textContent.includes("level 3.5 m"));
    await page.click('[data-table="peaks"] summary');
    await page.waitForSelector('[data-table="peaks"] table'); // which is only made once it is open
    assert.match(await page.textContent('[data-table="peaks"]'), /north frame/);
    const columns = await page.$$eval("#impacts thead th", (all) => all.map((one) => one.textContent));
    const rows = await page.$$eval("#impacts tbody tr", (all) => all.map((row) => [...row.cells].slice(3, 6).map((cell) => cell.textContent)));
    assert.deepEqual(columns.slice(1, 6), ["Peak force\u00a0▼ kN", "Peak at s", "Level m", "x m", "y m"]); // as a report has them
    assert.equal(rows.length, 7);
    assert.deepEqual(rows[0], ["6.7", "12.02", "18"]);
    assert.equal((await page.$$("#impacts .marked")).length, 1);
    const heads = (await taken(page, '[data-take="histories"]')).split("\n")[0];
    for (const head of ["ground_acceleration 1 [m/s2]", "displacement_y Walled at 6.7 [m]", "rotation Frame at 3.5 [rad]", "force Walled | Frame at 6.7, y = 18 m [kN]"]) {
      assert.ok(heads.includes(head), `${head} in ${heads}`);
    }
    assert.ok((await taken(page, '[data-file="orbit.svg"]')).match(/<path/g).length > 4);
    await page.click("#compare button");
    await put(page, text.replace("corner = [12.04, 0.0]", "corner = [12.08, 0.0]"));
    assert.deepEqual(await page.$$eval("#compare tbody tr", (all) => all.map((row) => row.cells[1].textContent)), ["0.08\u00a0m", "0.04\u00a0m"]);
  });
});

/** The same pair without friction and under a motion of its own, its first building known by so many of its modes, as the command line tells them. */
function byModes(count) {
  const { periods, shapes } = JSON.parse(execFileSync(process.env.BENTUR, ["modes", "--json", file])).buildings[0];
  const planes = text.indexOf("[[building.plane]]"), next = text.indexOf("[[building]]", planes);
  const modal = `[building.modal]\nperiods = ${JSON.stringify(periods.slice(0, count))}\nshapes = ${JSON.stringify(shapes.slice(0, count))}\n\n`;
  return (text.slice(0, planes) + modal + text.slice(next))
    .replace(/\[excitation\][^[]*/, '[excitation]\nkind = "harmonic"\nperiod = 0.5\ndisplacement_amplitude = 0.03\nangle = 30.0\n\n')
    .replace("duration = 15.0", "duration = 4.0");
}

test("a building that is known by its modes stands in plan as on the command line, and what its modes leave out is said", async () => {
  const folder = mkdtempSync(`${tmpdir()}/bentur-modes-`);
  try {
    await inPlan(async (page) => {
      for (const count of [6, 3]) {
        const given = byModes(count), own = `${folder}/case.toml`;
        writeFileSync(own, given);
        await put(page, given);
        const mine = JSON.parse(await taken(page, '[data-take="summary"]'));
        const theirs = JSON.parse(execFileSync(process.env.BENTUR, ["run", "--json", own]));
        assert.equal(mine.buildings[0].modal.modes, count);
        const unlike = (path) => /^\/case|\/wall_time$|\/energy_residual$|\/energy_lost$/.test(path);
        const found = difference(mine, theirs, "", unlike);
        assert.ok(found.size < 1e-12, `${found.path} ${found.size}`);
        for (const language of ["en", "id"]) {
          await page.selectOption("#language", language);
          await solved(page);
          const remarks = spaced(await page.textContent("[data-remarks]"));
          assert.deepEqual(remarks, terminal(own, language).remarks.join(" ").replaceAll("remark: ", ""));
          assert.equal(/modes|ragam|moda/.test(remarks), count === 3, remarks);
        }
        await page.selectOption("#language", "en");
      }
    });
  } finally {
    rmSync(folder, { recursive: true });
  }
});

/** Thirty houses, five rows of six, each a little unlike its neighbours. */
function block() {
  const houses = Array.from({ length: 30 }, (_, n) => {
    const storeys = 1 + ((n * 5) % 4), each = (value) => Array(storeys).fill(value).join(", "), stiffness = 15000 + 4000 * ((n * 7) % 9);
    return `[[building]]\nname = "H${n + 1}"\ndamping = 0.05\n[building.plan]\ncorner = [${(10.03 * (n % 6)).toFixed(2)}, ${(12.03 * Math.floor(n / 6)).toFixed(2)}]\n`
      + `size = [10.0, 12.0]\nstorey_heights = [${each("3.0")}]\nmasses = [${each("120.0")}]\n`
      + `[building.rigidity]\ncentre = [4.0, 6.0]\nx = ${stiffness * storeys}\ny = ${stiffness * storeys}\ntorsion = ${40 * stiffness * storeys}\n`;
  });
  return `title = "A block"\n[units]\nlength = "m"\nforce = "kN"\n[plan]\nclearance = 0.1\ncontact = { law = "linear", stiffness = 4e5, friction = 0.3 }\n`
    + houses.join("") + '[excitation]\nkind = "harmonic"\nperiod = 0.9\ndisplacement_amplitude = 0.04\nangle = 30.0\n[analysis]\nduration = 8.0\n';
}

test("a block of thirty houses runs with all that a page shows, the worst of its gaps in sight", async () => {
  await inPlan(async (page) => {
    await put(page, block());
    assert.doesNotMatch(await page.textContent("main"), /coarse samples/);
    const gaps = JSON.parse(await taken(page, '[data-take="gaps"]')).gaps.length;
    assert.ok(gaps > 50);
    const inSight = await page.$$eval(".verdict > details[data-gap]", (all) => all.length);
    const others = await page.$$eval(".verdict > details[data-others] > details[data-gap]", (all) => all.length);
    assert.equal(inSight, 3);
    assert.ok(others > 0 && inSight + others <= gaps);
    assert.equal(await page.isVisible(".verdict > details[data-others] > details[data-gap]"), false);
    assert.match(await page.textContent(".verdict > details[data-others] > summary"), new RegExp(`^${others} gaps more$`));
    // It is looked at where its story has it as the worst, as far as that needs.
    const worst = await page.locator(".verdict > details[data-gap]").first().getAttribute("data-gap");
    assert.equal(await page.locator(".gap-slider select option:checked").textContent(), worst);
    assert.match(await page.textContent(".brief"), new RegExp(`^All ${gaps} gaps:`));
    await page.click('[data-table="gaps"] > summary'); // a row for each, at the level that governs it
    assert.equal(await page.locator('[data-table="gaps"] .joined tbody tr').count(), gaps);
    const forces = await page.$$eval('#impacts tbody td[data-head^="Peak force"]', (all) => all.map((one) => Number(one.textContent)));
    assert.ok(forces.length > 20 && forces.every((one, i) => i === 0 || one <= forces[i - 1]));
  }, { slow: true });
});

test("they move as seen from above, at the level that is chosen, magnified as is said", async () => {
  await inPlan(async (page) => {
    await page.click('[data-part="play"]'); // which was playing
    const stage = page.locator('[data-part="stage"]').first();
    assert.equal(await stage.locator(".footprint").count(), 2);
    assert.match(await stage.textContent(), /magnified 20 times, level 6\.7 m/);
    assert.deepEqual(await page.$$eval('[data-part="level"] option', (all) => all.map((one) => one.textContent)), ["6.7 m", "3.5 m"]);
    await page.selectOption('[data-part="level"]', "1");
    assert.match(await stage.textContent(), /level 3\.5 m/);
    await page.locator("#impacts button", { hasText: "4" }).first().click();
    await page.waitForFunction(() => document.querySelector('#motion .hit[data-contact="1"]'));
    assert.match(await stage.textContent(), /level 6\.7 m/); // an impact shows its level
    await page.waitForFunction(() => document.querySelector('[data-part="play"]').getAttribute("aria-pressed") === "false");
    // Another text moves otherwise; the level that was chosen stays.
    await page.selectOption('[data-part="level"]', "1");
    await put(page, text.replace("pga = 3.4", "pga = 1.0"));
    assert.match(await page.textContent(".verdict"), /do not touch|goes on after the end/);
    assert.match(await stage.textContent(), /level 3\.5 m/);
    // And a row after it is seen from the side again.
    await page.click('[data-case="row"]');
    await solved(page);
    assert.equal(await stage.locator(".footprint").count(), 0);
    assert.ok(await stage.locator(".column").count() > 2);
    assert.equal(await page.locator('[data-part="levelChoice"]').first().isVisible(), false);
    await page.waitForSelector("#gap");
  });
});

test("the still that is given away looks as the picture does", async () => {
  await inPlan(async (page) => {
    const still = await taken(page, '[data-take="svg"]');
    assert.match(still, /A building with a wall along one side/);
    const style = (selector) => page.locator(`#motion ${selector}`).first().evaluate((one) => { const { stroke, opacity, strokeLinecap } = getComputedStyle(one); return { stroke, opacity, strokeLinecap }; });
    const shown = { floor: await style(".floor"), mass: await style(".mass") };
    const kept = (name) => {
      const path = still.match(new RegExp(`<path [^>]*class="${name} [^>]*>`))[0];
      const value = (key) => path.match(new RegExp(`[ ";]${key}: ([^;"]+)`))[1];
      return { stroke: value("stroke"), opacity: value("opacity"), strokeLinecap: value("stroke-linecap") };
    };
    assert.deepEqual({ floor: kept("floor"), mass: kept("mass") }, shown);
    assert.equal(shown.mass.strokeLinecap, "round");
  });
});

/** A house that stands round another, 20 mm and 30 mm from it: wider than both together that gap cannot become. */
const court = `title = "A court"
[units]
length = "m"
force = "kN"
[plan]
clearance = 0.025
contact = { law = "linear", stiffness = 4e5 }
[[building]]
name = "Round"
damping = 0.05
plan = { polygon = [[0.0, 0.0], [30.0, 0.0], [30.0, 20.0], [20.05, 20.0], [20.05, 5.0], [10.0, 5.0], [10.0, 20.0], [0.0, 20.0]], storey_heights = [3.0], masses = [400.0] }
rigidity = { centre = [15.0, 8.0], x = 8e4, y = 8e4, torsion = 8e6 }
[[building]]
name = "Inner"
damping = 0.05
plan = { corner = [10.02, 6.0], size = [10.0, 12.0], storey_heights = [3.0], masses = [100.0] }
rigidity = { centre = [5.0, 6.0], x = 2e4, y = 2e4, torsion = 1e6 }
[excitation]
kind = "harmonic"
period = 0.5
displacement_amplitude = 0.03
[analysis]
duration = 2.0
`;

test("the slider of a gap moves the building beyond it, as far as anything is needed, and the clearance with it", async () => {
  await inPlan(async (page) => {
    const slide = async (width) => {
      await page.locator("#gap").evaluate((range, value) => { range.value = value; range.dispatchEvent(new Event("input", { bubbles: true })); }, width);
      await solved(page);
    };
    const shown = () => page.textContent(".gap-slider output");
    assert.match(await shown(), /^0\.04 m$/);
    const marks = () => page.$$eval("[data-tick]", (all) => all.map((one) => one.textContent).join(", "));
    assert.match(await marks(), /reversed|as given/i);
    await slide(0.07); // or the step of the slider beside it
    const moved = await page.inputValue(editor), corner = Number(moved.match(/corner = \[(12\.\d+), 0\.0\]/)[1]);
    assert.ok(Math.abs(corner - 12.07) < 1e-3, moved);
    assert.equal(moved, text.replace("corner = [12.04, 0.0]", `corner = [${corner}, 0.0]`));
    assert.ok(Math.abs(Number((await shown()).split(" ")[0]) - (corner - 12)) < 1e-6);
    const clearance = /clearance = ([\d.]+)/, least = Number(text.match(clearance)[1]);
    await page.locator("#gap").press("End");
    await solved(page);
    const wide = Number((await shown()).split(" ")[0]), asked = [...(await marks()).matchAll(/[\d.]+(?=\sm)/g)].map((one) => Number(one[0]));
    assert.ok(wide > least && asked.every((one) => wide >= one), `${wide} ${asked}`);
    assert.match(await page.textContent("[data-moves]"), new RegExp(`Beyond ${least} m the clearance`));
    const grown = Number((await page.inputValue(editor)).match(clearance)[1]);
    assert.ok(grown >= wide && grown < 1.01 * wide, `${grown} ${wide}`);
    assert.equal(await page.locator(".verdict").count(), 1); // they are a pair still
    assert.equal((await page.$$(".errors li")).length, 0);
    await slide(0.07);
    assert.equal(await page.inputValue(editor), moved);
    for (let k = 0; k < 4 && await page.inputValue(editor) !== text; ++k) {
      await page.click(".travel");
      await solved(page);
    }
    assert.equal(await page.inputValue(editor), text);
    await put(page, court);
    assert.match(await page.textContent("[data-moves]"), /It ends at 0\.0499\d* m: there they would meet Round, which stays\./);
    assert.ok(Number(await page.getAttribute("#gap", "max")) < 0.05);
  });
});

test("the form changes the text, and has nothing that plans cannot have", async () => {
  await inPlan(async (page) => {
    await openForm(page);
    assert.equal(await page.locator(".form .count").count(), 0);
    assert.equal(await page.locator("text=Add a neighbour known by little").count(), 0);
    const stiffness = page.locator(".form fieldset").first().locator(".field", { hasText: "Stiffnesses 1" }).first().locator("input[type=number]");
    await stiffness.fill("50000");
    await stiffness.press("Tab");
    await solved(page);
    assert.notEqual(await page.inputValue(editor), text);
    assert.match(await page.inputValue(editor), /stiffnesses = \[(5e4|50000(\.0)?), 9e4\]/);
    await page.click(".travel");
    await solved(page);
    assert.equal(await page.inputValue(editor), text);
  });
});

test("what is wrong is said at its line, in both languages", async () => {
  await inPlan(async (page) => {
    await put(page, text.replace("damping = 0.05", "dampnig = 0.05"), "errors");
    assert.match(await page.textContent(".errors"), /dampnig/);
    assert.match(await page.textContent(".errors"), /Line 16/);
    await page.selectOption("#language", "id");
    assert.match(await page.textContent(".errors"), /Baris 16/);
    await put(page, text);
    assert.equal((await page.$$(".errors li")).length, 0);
  });
});

test("nothing is wider than a telephone or too dark to be seen there, and axe-core finds no violation", async () => {
  await inPlan(async (page) => {
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= 390);
    await page.evaluate(readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8"));
    const { violations } = await page.evaluate(() => window.axe.run(document));
    assert.deepEqual(violations.map(({ id, nodes }) => [id, nodes.map(({ html }) => html)]), []);
    const stroke = await page.locator("#motion .footprint").first().evaluate((one) => getComputedStyle(one).stroke);
    assert.ok(stroke.match(/\d+/g).slice(0, 3).map(Number).reduce((a, b) => a + b) > 300, stroke);
  }, { viewport: { width: 390, height: 844 }, colorScheme: "dark" });
});
