// A page of Debian's Chromium that keeps what it says, throws or asks of the network.
import { chromium } from "playwright-core";
import { execFileSync } from "node:child_process";

export const program = () => execFileSync("sh", ["-c", "command -v chromium || command -v chromium-browser"], { encoding: "utf8" }).trim();

export const launch = () => chromium.launch({
  executablePath: program(),
  args: ["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking", "--disable-dev-shm-usage"],
});

export async function open(browser, address, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, locale: "en-GB", acceptDownloads: true, ...options });
  const page = await context.newPage();
  const complaints = [], requests = [];
  page.on("console", (message) => { if (["error", "warning"].includes(message.type())) complaints.push(message.text()); });
  page.on("pageerror", (error) => complaints.push(String(error)));
  page.on("request", (request) => { if (!/^(file|blob|data):/.test(request.url())) requests.push(request.url()); });
  await page.goto(address);
  return { page, complaints, requests, close: () => context.close() };
}

/** Until the case that stands there is solved, finely, or has errors. */
export const solved = (page, state = "fine") => page.waitForSelector(`main[data-solved="${state}"]`, { timeout: 60000 });
