import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { deflateRawSync } from "node:zlib";
import { defineConfig, type Plugin } from "vite";
import { viteSingleFile } from "vite-plugin-singlefile";

const root = fileURLToPath(new URL("../..", import.meta.url));

/** The report's moving buildings are classic scripts there, one after the other, and a module here. */
const motion: Plugin = {
  name: "bentur-motion",
  transform(code, id) {
    if (!id.endsWith("/report/html/motion/motion.js")) return undefined;
    const drawn = ["samples.js", "row.js", "plan.js"].map((name) => readFileSync(id.replace(/motion\.js$/, name), "utf8"));
    return { code: `${drawn.join("")}${code}\nexport { benturMotion };\n`, map: null };
  },
};

/** Colours of the page and its figures: the palette of figures, dark where the page is. */
const colours: Plugin = {
  name: "bentur-colours",
  transform(code, id) {
    if (!id.endsWith("/style.css")) return undefined;
    const palette = readFileSync(`${root}/src/bentur/report/figures/internal/colours.h`, "utf8");
    const all = [...palette.matchAll(/\{"([\w-]+)", "(#\w{6})", "(#\w{6})"\}/g)];
    const variables = (scheme: number) => all.map((colour) => `--${colour[1]}: ${colour[scheme]};`).join(" ");
    const rules = all.map(([, name]) => ["fill", "stroke"].map((what) => `.bentur .${what}-${name} { ${what}: var(--${name}); }`).join(" "));
    return { code: `:root { ${variables(2)} }\n@media screen { :root[data-theme="dark"] { ${variables(3)} } }\n${rules.join("\n")}\n${code}`, map: null };
  },
};

/** The solver, which emscripten puts into its module as it is, is taken out of it and deflated. */
const core: Plugin = {
  name: "bentur-core",
  transform(code, id) {
    if (!id.endsWith("/bentur_web.mjs")) return undefined;
    const [whole, , solver] = /(["'])data:application\/octet-stream;base64,([^"']+)\1/.exec(code)!;
    const small = deflateRawSync(Buffer.from(solver, "base64"), { level: 9 }).toString("base64");
    return { code: `${code.replace(whole, '"bentur.wasm"')}\nexport const deflated = "${small}";\n`, map: null };
  },
};

/** The page may have its own script and style, which are named by their hashes, and no others; and ask for nothing. */
const policy: Plugin = {
  name: "bentur-policy",
  closeBundle() {
    const file = `${root}/build/web/page/index.html`, page = readFileSync(file, "utf8");
    const hashes = (tag: string) => [...page.matchAll(new RegExp(`<${tag}\\b[^>]*>([^]*?)</${tag}>`, "g"))]
      .map(([, text]) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`).join(" ");
    const allowed = `default-src 'none'; script-src ${hashes("script")} 'wasm-unsafe-eval'; worker-src blob:; style-src ${hashes("style")}; img-src data: blob:; base-uri 'none'; form-action 'none'`;
    writeFileSync(file, page.replace("<!-- policy -->", `<meta http-equiv="Content-Security-Policy" content="${allowed}">`));
  },
};

export default defineConfig({
  base: "./",
  plugins: [motion, colours, viteSingleFile({ removeViteModuleLoader: true }), policy],
  oxc: { jsx: { runtime: "automatic", importSource: "preact" } },
  // What emscripten's module would ask node for; there is none in a page.
  resolve: { alias: { "@repo": root, ...Object.fromEntries(["fs", "path", "crypto"].map((name) => [name, `${root}/web/app/src/nothing.ts`])) } },
  server: { fs: { allow: [root] } },
  // A classic worker from a blob: what works from file://.
  worker: { format: "iife", plugins: () => [core], rolldownOptions: { checks: { pluginTimings: false } } },
  build: {
    outDir: `${root}/build/web/page`,
    emptyOutDir: true,
    target: "es2022",
    assetsInlineLimit: 1e8,
    chunkSizeWarningLimit: 8000,
    modulePreload: false,
    rolldownOptions: { checks: { pluginTimings: false } },
    reportCompressedSize: false,
  },
});
