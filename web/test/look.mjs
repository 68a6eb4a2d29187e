// Pictures of every view, to be looked at: look.mjs PAGE FOLDER
import { mkdirSync, rmSync } from "node:fs";
import { pathToFileURL } from "node:url";
import { curveDone, launch, open, solved } from "./browser.mjs";
import { makeSuite } from "./suites.mjs";

const [file, folder] = process.argv.slice(2);
mkdirSync(folder, { recursive: true });
const browser = await launch();
const suite = makeSuite();
const only = process.argv[4];
for (const width of [1280, 390]) {
  for (const theme of ["light", "dark"]) {
    for (const name of ["frames", "monograph", "columns", "row", "moat", "yielding", "plan", "suite", "record"]) {
      if (only && !`${name}-${width}-${theme}`.includes(only)) continue;
      const { page, complaints, close } = await open(browser, pathToFileURL(file).href, { viewport: { width, height: 900 }, colorScheme: theme });
      await solved(page);
      if (name === "suite" || name === "record") {
        await page.setInputFiles(".cases input[type=file]", [suite.file, ...suite.records.map((one) => `${suite.folder}/${one}`)]);
        await page.waitForSelector("#record");
        if (name === "record") await page.selectOption("#record", "2");
      } else await page.click(`[data-case="${name}"]`);
      await solved(page);
      if (name !== "plan" && name !== "suite") await curveDone(page);
      if (name === "monograph") {
        await page.click("#compare button");
        await page.evaluate(() => document.querySelectorAll("details")[1].setAttribute("open", ""));
      }
      await page.screenshot({ path: `${folder}/${name}-${width}-${theme}.png`, fullPage: true });
      const wide = await page.evaluate(() => document.documentElement.scrollWidth);
      if (wide > width) console.log(name, width, theme, `is ${wide} wide`);
      if (complaints.length > 0) console.log(name, width, theme, complaints.slice(0, 3));
      await close();
    }
  }
}
await browser.close();
rmSync(suite.folder, { recursive: true });
