// A page of Debian's Chromium that keeps what it says, throws or asks of the network.
import { chromium } from "playwright-core";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { test as one } from "node:test";

const PATIENCE = 300000; // [ms] after which something hangs; no test is about how long anything takes

export const program = () => execFileSync("sh", ["-c", "command -v chromium || command -v chromium-browser"], { encoding: "utf8" }).trim();

export const launch = () => chromium.launch({
  executablePath: program(),
  args: ["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking", "--disable-dev-shm-usage"],
});

/** In the page before it begins: while window.held is set the worker's answers wait, as those of work that takes long do;
 * window.asked counts what workers were asked for, and window.unanswered what they have still to answer. */
function holdWork() {
  const Real = window.Worker, kept = [];
  window.held = false;
  window.kept = kept;
  window.asked = 0;
  window.unanswered = 0;
  window.Worker = class extends Real {
    set onmessage(hear) {
      super.onmessage = (event) => {
        const { kind, done, more } = event.data;
        if (!["schema", "progress"].includes(kind) && !(kind === "curve" && done < 1) && !(more > 0)) window.unanswered -= 1;
        if (window.held) kept.push(() => hear.call(this, event));
        else hear.call(this, event);
      };
    }
    postMessage(...message) {
      window.asked += 1;
      window.unanswered += 1;
      super.postMessage(...message);
    }
  };
}

/** @param options of Playwright's context; `slow`: answers of the solver can be held back, and the page's clock is the test's */
export async function open(browser, address, { slow = false, ...options } = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, locale: "en-GB", acceptDownloads: true, ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(PATIENCE);
  if (slow) {
    await page.clock.install();
    await page.addInitScript(holdWork);
  }
  const complaints = [], requests = [];
  page.on("console", (message) => { if (["error", "warning"].includes(message.type())) complaints.push(message.text()); });
  page.on("pageerror", (error) => complaints.push(String(error.stack ?? error)));
  page.on("request", (request) => { if (!/^(file|blob|data):/.test(request.url())) requests.push(request.url()); });
  await page.goto(address);
  return { page, complaints, requests, close: () => context.close() };
}

/** Until the case that stands there, what is being typed included, is solved, finely, or has errors. */
export const solved = (page, state = "fine") => page.waitForSelector(`main[data-solved="${state}"]`);

const step = process.env.BENTUR_PART === "all" ? 1 : 30;
let told = 0;
/** Every thirtieth test of a file, the first among them; every one where BENTUR_PART is `all`. */
export const test = (name, work) => { if (told++ % step === 0) one(name, work); };

/** What is folded is only made once it is open. */
export async function openForm(page) {
  await page.click("text=Form");
  await page.waitForSelector(".form fieldset");
}

/** Until the curve over gaps is whole, so that no worker has anything to do. */
export const curveDone = (page) => page.waitForFunction(() => document.querySelector("#figures")?.dataset.curve === "1");

/**
 * What a button gives to be kept, as a text. It is pressed again where nothing comes: two presses of some 200 were lost
 * on a machine with four others at work, why is not known.
 */
export async function taken(page, button) {
  const patience = [20e3, 20e3, PATIENCE]; // [ms] of each press
  for (const [n, timeout] of patience.entries()) {
    try {
      const [given] = await Promise.all([page.waitForEvent("download", { timeout }), page.click(button)]);
      return readFileSync(await given.path(), "utf8");
    } catch (error) {
      if (error.name !== "TimeoutError" || n + 1 === patience.length) throw error;
    }
  }
}
