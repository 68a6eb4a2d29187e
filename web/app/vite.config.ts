import { fileURLToPath } from "node:url";
import { defineConfig, type Plugin } from "vite";
import { viteSingleFile } from "vite-plugin-singlefile";

const root = fileURLToPath(new URL("../..", import.meta.url));

/** The report's moving buildings are a classic script there and a module here. */
const motion: Plugin = {
  name: "bentur-motion",
  transform(code, id) {
    return id.endsWith("/report/html/motion.js") ? { code: `${code}\nexport { benturMotion };\n`, map: null } : undefined;
  },
};

export default defineConfig({
  base: "./",
  plugins: [motion, viteSingleFile({ removeViteModuleLoader: true })],
  oxc: { jsx: { runtime: "automatic", importSource: "preact" } },
  // What emscripten's module would ask node for; there is none in a page.
  resolve: { alias: { "@repo": root, ...Object.fromEntries(["fs", "path", "crypto"].map((name) => [name, `${root}/web/app/src/nothing.ts`])) } },
  server: { fs: { allow: [root] } },
  // A classic worker from a blob: what works from file://.
  worker: { format: "iife" },
  build: {
    outDir: `${root}/build/web/page`,
    emptyOutDir: true,
    target: "es2022",
    assetsInlineLimit: 1e8,
    chunkSizeWarningLimit: 8000,
    modulePreload: false,
    reportCompressedSize: false,
  },
});
