// The solver, away from the page: one request at a time, each answered once, with progress on the way.
import createBentur, { deflated, type Studio } from "@repo/build/web/bentur_web.mjs";
import { isStill } from "./still";
import type { Answer, CaseError, CurvePoint, Draw, Drawn, Overview, Request, Schema } from "./solver";

const post = (answer: Answer, transfer: Transferable[] = []) => self.postMessage(answer, { transfer });

function inflated(): Promise<ArrayBuffer> {
  const bytes = Uint8Array.from(atob(deflated), (letter) => letter.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"))).arrayBuffer();
}

const ready: Promise<Studio> = inflated().then((wasmBinary) => createBentur({ wasmBinary })).then((module) => {
  const studio = new module.Studio();
  const schema: Schema = JSON.parse(studio.schema());
  post({ id: 0, kind: "schema", schema });
  return studio;
});
/** What a case has not that is not run. */
const still = { plan: false, figures: [], buildings: [], points: [], impacts: [], impactColumns: [], impactCount: 0, force: 0, forceUnit: "", amplification: 0, suite: null };
let opened = "";
const keyOf = (record: number | undefined, text: string) => `${record ?? 0}|${text}`;
let stop = 0; // curves up to this number are no longer wanted

function buffers(value: unknown, found: Transferable[] = []): Transferable[] {
  if (value instanceof Float64Array) found.push(value.buffer);
  else if (value && typeof value === "object") for (const one of Object.values(value)) buffers(one, found);
  return found;
}

async function answer(request: Request): Promise<void> {
  const studio = await ready;
  const { id } = request;
  for (const [path, bytes] of request.files ?? []) {
    if (bytes) studio.putFile(path, bytes);
    else studio.removeFile(path);
    opened = "";
  }
  const refused = ({ errors }: { errors: CaseError[] }) => post({ id, kind: "refused", errors });
  if (request.kind === "units") {
    const result = JSON.parse(studio.inUnits(request.text, request.length, request.force));
    return result.ok ? post({ id, kind: "text", text: result.text }) : refused(result);
  }
  // Nothing is made of a run that was refused after a coarse one.
  const drawn = (draw: Draw): Record<string, Drawn> => Object.fromEntries(draw.map(([kind, wanted]): [string, Drawn] => [kind, studio.draw(kind, request.language, wanted)])
    .filter(([, { svg, error }]) => svg !== undefined || error !== undefined));
  if (request.kind === "draw") {
    const asked = opened === keyOf(request.record, request.text) ? request.draw : [];
    if (asked.length === 0) return post({ id, kind: "drawn", drawn: {}, more: 0 });
    for (const [k, one] of asked.entries()) { // each is there as soon as it is drawn
      const made = drawn([one]);
      post({ id, kind: "drawn", drawn: made, more: asked.length - 1 - k }, buffers(made));
    }
    return;
  }
  const started = performance.now();
  let parts = 1; // of a suite the runs of its records, and then their gaps
  if (request.kind !== "curve" || opened !== keyOf(request.record, request.text)) {
    let result = JSON.parse(studio.open(request.text, "case.toml"));
    if (result.ok) result = JSON.parse(studio.chooseRecord(request.record ?? 0));
    opened = result.ok ? keyOf(result.record, request.text) : "";
    if (!result.ok) return refused(result);
    if (result.record === 0) parts = Math.max(1, 2 * result.records);
  }
  let heard = started, part = 0;
  const progress = (done: number) => {
    const now = performance.now(), reached = Math.floor(done * parts);
    if (now - heard > 200 || reached !== part) {
      post({ id, kind: "progress", done, part: reached });
      [heard, part] = [now, reached];
    }
    return true;
  };
  if (request.kind === "contacts") {
    const found = JSON.parse(studio.contacts());
    return found.ok ? post({ id, kind: "contacts", counts: found.counts }) : refused(found);
  }
  if (request.kind === "run") {
    const solved = JSON.parse(studio.solve(request.step, progress));
    if (!solved.ok) return refused(solved);
    const told = JSON.parse(studio.overview(request.language));
    if (!told.ok) return refused(told);
    const overview: Overview & { statements: { gap: unknown }[] } = { ...still, ...told };
    // A name may be as long as a case allows; what is shown of it is not.
    const clip = (name: string) => (name.length > 80 ? `${name.slice(0, 79)}…` : name);
    overview.title = clip(overview.title);
    const gaps = overview.gaps.map((one) => one.name);
    for (const one of overview.statements) one.gap = one.gap === null ? null : gaps.indexOf(String(one.gap));
    for (const one of [...overview.gaps, ...overview.buildings]) one.name = clip(one.name);
    const has = (kind: string) => kind === "gap-curve" ? !isStill(overview) : overview.figures.some((one) => one.kind === kind);
    const made = drawn(request.draw.filter(([kind]) => has(kind))); // what is in sight may be of another case
    const { tables } = JSON.parse(studio.tables(request.language));
    return post({ id, kind: "result", overview, motion: studio.motion(request.language), drawn: made, tables,
      milliseconds: performance.now() - started, fine: isStill(overview) || request.step === null }, buffers(made));
  }
  if (request.kind === "take") {
    const isDrawn = request.what === "report" || request.what === "figure" || request.what === "histories";
    const solved = JSON.parse(studio.solve(isDrawn ? null : 0, progress));
    if (!solved.ok) return refused(solved);
    if (request.what === "histories") {
      const histories = studio.histories();
      return post({ id, kind: "histories", histories, overview: JSON.parse(studio.overview(request.language)) }, buffers(histories));
    }
    const [kind, wanted] = request.draw?.[0] ?? [];
    const text = request.what === "summary" ? studio.summary() : request.what === "impacts" ? studio.impacts()
      : request.what === "gaps" ? studio.gaps() : request.what === "modes" ? studio.modes()
      : kind && wanted ? studio.figureFile(kind, request.language, wanted) : studio.report(request.language);
    return post({ id, kind: "text", text });
  }
  // A curve over gap widths; in between, requests that come in are heard.
  const curve: CurvePoint[] = [];
  for (const [k, width] of request.widths.entries()) {
    if (id <= stop) return;
    const one = JSON.parse(studio.atWidth(request.gap, width));
    if (!one.ok) return refused(one);
    curve.push({ width, force: one.force, amplification: one.amplification });
    if (k % 4 === 3 || k + 1 === request.widths.length) {
      post({ id, kind: "curve", curve: [...curve], done: (k + 1) / request.widths.length });
      await new Promise((resolve) => setTimeout(resolve, 0));
    }
  }
}

let queue = Promise.resolve();
self.addEventListener("message", (event: MessageEvent<Request>) => {
  const request = event.data;
  stop = request.id - 1; // it is sent when the one before is over or given up
  queue = queue.then(() => answer(request)).catch((error: unknown) => {
    opened = "";
    post({ id: request.id, kind: "refused", errors: [{ file: "", line: 0, column: 0, key: "",
      message: error instanceof Error ? error.message : String(error) }] });
  });
});
