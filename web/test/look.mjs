// Pictures of every view, to be looked at: look.mjs PAGE FOLDER
import { mkdirSync } from "node:fs";
import { pathToFileURL } from "node:url";
import { curveDone, launch, open, solved } from "./browser.mjs";

const [file, folder] = process.argv.slice(2);
mkdirSync(folder, { recursive: true });
const browser = await launch();
const only = process.argv[4];
for (const width of [1280, 390]) {
  for (const theme of ["light", "dark"]) {
    for (const name of ["frames", "monograph", "columns", "row", "moat", "yielding", "plan"]) {
      if (only && !`${name}-${width}-${theme}`.includes(only)) continue;
      const { page, complaints, close } = await open(browser, pathToFileURL(file).href, { viewport: { width, height: 900 }, colorScheme: theme });
      await solved(page);
      await page.click(`[data-case="${name}"]`);
      await solved(page);
      if (name !== "plan") await curveDone(page);
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
