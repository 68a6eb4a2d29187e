// The page's side of the worker: of each kind the newest request counts, and one that takes too long is given up with
// its worker.
import { signal } from "@preact/signals";
import SolverWorker from "./worker?worker&inline";

export interface CaseError { file: string; line: number; column: number; key: string; message: string; told?: Record<string, string>; values?: Record<string, number | string> }
export interface AxisPlace { label: string; from: number; to: number; logarithmic: boolean }
/** A frame of a figure [px of its SVG], and what is drawn there. */
export interface PanelPlace {
  left: number; top: number; width: number; height: number; x: AxisPlace; y: AxisPlace;
  curves: { label: string; x: Float64Array; y: Float64Array }[];
}
/** `width` in cm. */
export interface Drawn { svg: string; caption: string; width: number; panels: PanelPlace[]; error?: string }
export interface Wanted {
  width: number; narrow: boolean; from?: number; to?: number; gap?: number; elevation?: number;
  curve?: { gap: number; widths: number[]; forces: number[]; amplifications: number[] };
}
export type Draw = [kind: string, wanted: Wanted][];
export interface Histories {
  time: Float64Array;
  ground: Float64Array[];
  opening: Float64Array[];
  force: Float64Array[];
  /** By what is told of floors, of a row displacement, drift and shear. */
  buildings: Record<string, Float64Array[]>[];
}
/** `needed`: the larger of both directions of the motion, or the largest of records, called `needed_name`. `marks`: widths
 *  beside it, of the other direction, of rules and what a code takes of records. `movers`: in plan the buildings that move where
 *  it becomes wider, with the corners that they were run with, along which direction, and whom they meet after how much. */
export interface GapOverview {
  name: string; width: number; needed: number | null; needed_name: string; marks?: { at: number; name: string }[];
  movers?: { all: { building: number; corner: [number, number] }[]; by: [number, number]; until: { building: number; way: number } | null };
}
export interface Said { kind: string; severity: "danger" | "warning" | "finding" | "remark"; gap: number | null; rank: number | null; badge: string; open: boolean; lead: string; shown: "sentence" | "row" | "table"; text: string }
export interface BuildingOverview {
  name: string; rigid: boolean; yields: boolean; elevations: number[]; heights: number[];
  displacement: (number | null)[]; alone: (number | null)[]; drift: (number | null)[];
}
/** What does not tell something of the run is there as a file alone. */
export interface FigureOverview { kind: string; caption: string; tells: boolean; overTime: boolean }
/** [gap, elevation, start, end, peak force, closing speed, restitution, which of all it is from 1, in plan where along the
 *  stretch] */
export type ImpactRow = [number, number, number, number, number, number, number | null, number, string?];
/** A column of a table as a report has it. */
export interface Column { head: string; unit: string; cells: string[]; numbers: boolean }
/** A table of a first screen, as other doors have it: of the gaps, and what else is known. */
export interface Fact { heading: string; columns: Column[]; marked: number[]; note: string }
/** Forces are in `forceUnit`, in which all people are told of the run; `units` are those of the case and of its files. */
export interface Overview {
  title: string; version: string; duration: number; spectral: boolean; plan: boolean; units: { length: string; force: string }; forceUnit: string; gaps: GapOverview[];
  /** Of the verdict's frame, as in a report. */
  tone: "pounds" | "open" | "clear";
  buildings: BuildingOverview[]; points: { gap: number; elevation: number; along?: string }[]; impacts: ImpactRow[];
  impactColumns: Column[]; impactCount: number; force: number; amplification: number; statements: Said[]; facts: Fact[];
  figures: FigureOverview[];
  /** Of a case with a suite its records by their files, and which one this is of, from 1; 0: all, with the one that hits
   *  hardest, else comes closest. */
  suite: { records: string[]; record: number; hardest?: number } | null;
}
/** A section of the report. */
export interface PagePart { id: string; heading: string; markup: string }
/** What `bentur schema` says of a key in one of its meanings: `unit` in words, "force/length". */
export interface Key {
  kind: string; form: string; label: { en: string; id: string }; group?: string; with?: string;
  unit?: string; each?: string; words?: string[]; when?: Record<string, string[]>;
  number?: {
    type?: string; minimum?: number; exclusiveMinimum?: boolean;
    maximum?: number; exclusiveMaximum?: boolean; not?: object;
  };
}
export interface Node {
  description: string; properties?: Record<string, Node>; items?: Node; anyOf?: Node[];
  "x-bentur": Key[];
}
export interface Schema { case: Node; units: Record<"length" | "force", Record<string, number>> }
export interface CurvePoint { width: number; force: number; amplification: number }
export type Take = "summary" | "impacts" | "gaps" | "modes" | "report" | "figure" | "histories";
export type Files = [string, Uint8Array][];
/** Files that come to stand somewhere, or no longer do. */
export type Placed = [string, Uint8Array | null][];
interface Common { id: number; text: string; record?: number; language: string; files?: Placed }
export type Request = Common & (
  | { kind: "run"; step: number | null; draw: Draw }
  | { kind: "draw"; draw: Draw }
  | { kind: "take"; what: Take; draw?: Draw }
  | { kind: "contacts" }
  | { kind: "units"; length: string; force: string }
  | { kind: "curve"; gap: number; widths: number[] });
export type Result = { overview: Overview; motion: string; drawn: Record<string, Drawn>; tables: PagePart[]; milliseconds: number; fine: boolean };
export type Answer = { id: number } & (
  | { kind: "schema"; schema: Schema }
  | { kind: "refused"; errors: CaseError[] }
  | { kind: "progress"; done: number; part: number }
  | ({ kind: "result" } & Result)
  | { kind: "drawn"; drawn: Record<string, Drawn>; more: number } // of those asked for at once
  | { kind: "histories"; histories: Histories; overview: Overview }
  | { kind: "text"; text: string }
  | { kind: "contacts"; counts: number[] }
  | { kind: "curve"; curve: CurvePoint[]; done: number });

type AnyRequest = Pick<Request, "kind"> & { [key: string]: unknown };
interface Asked { request: AnyRequest; hear: (answer: Answer) => void }
const LIMIT = 20000; // [ms] that anything may take, of a suite each record
const MOMENT = 700; // [ms] after which it is said that something is under way
const PATIENCE = 3 * MOMENT; // [ms] that a run sampled coarsely, which mostly is there in no time, has before a newer one ends it

/** Nothing until a solver is there. */
export const schema = signal<Schema | null>(null);

export class Solver {
  private worker: Worker | null = null; // only when there is something to do: it has all of WebAssembly to compile
  private last = 0;
  private running: (Asked & { id: number }) | null = null;
  private waiting: Asked[] = [];
  private sent = 0;
  private timer = 0;
  private part = 0;
  private moment = 0;
  private age = 0;
  private isOld = false; // a run that has had its time ends for a newer one
  /** What has become of the files that cases may name, in this order. */
  files: Placed = [];

  /** `slow` hears when something takes longer than a moment, and when it no longer runs. */
  constructor(private readonly slow: (yes: boolean) => void = () => undefined) {}

  private get awake(): Worker {
    if (this.worker) return this.worker;
    this.worker = new SolverWorker();
    this.worker.onmessage = ({ data }: MessageEvent<Answer>) => {
      if (data.kind === "schema") schema.value = data.schema;
      if (!this.running || data.id !== this.running.id) return;
      const { hear } = this.running;
      if (data.kind === "progress" && data.part !== this.part) this.limit(data.part);
      const over = data.kind !== "progress" && !(data.kind === "curve" && data.done < 1) && !(data.kind === "drawn" && data.more > 0);
      if (over) this.rest();
      hear(data);
      if (over) this.next();
    };
    this.worker.onerror = () => this.giveUp("worker");
    return this.worker;
  }

  /** From now on what is under way, or another part of it, has its time. */
  private limit(part: number) {
    clearTimeout(this.timer);
    this.part = part;
    this.timer = window.setTimeout(() => this.giveUp("limit"), LIMIT);
  }

  private rest() {
    clearTimeout(this.timer);
    clearTimeout(this.moment);
    clearTimeout(this.age);
    this.running = null;
    this.slow(false);
  }

  private next() {
    const asked = this.running ? undefined : this.waiting.shift();
    if (!asked) return;
    this.running = { ...asked, id: ++this.last };
    const files = this.sent < this.files.length ? this.files.slice(this.sent) : undefined;
    this.sent = this.files.length;
    this.limit(0);
    this.isOld = false;
    if (asked.request.kind === "run") this.age = window.setTimeout(() => this.grow(), asked.request.step === null ? MOMENT : PATIENCE);
    if (asked.request.first) this.slow(true); // nothing else is there to be seen
    else if (asked.request.kind !== "draw") this.moment = window.setTimeout(() => this.slow(true), MOMENT); // of what is there already
    this.awake.postMessage({ ...asked.request, id: this.last, files });
  }

  /** Asks for something, for which older ones of its kind that wait are forgotten; what is taken away is never. */
  ask(request: AnyRequest, hear: (answer: Answer) => void) {
    this.waiting = this.waiting.filter((one) => one.request.kind !== request.kind || request.kind === "take");
    this.waiting.push({ request, hear });
    // A curve under way ends for a newer one: its worker hears of what comes next and stops.
    if (this.running?.request.kind === "curve" && request.kind === "curve") this.rest();
    this.makeWay();
    this.next();
  }

  private grow() {
    this.isOld = true;
    this.makeWay();
  }

  /** Ends an old run where a newer one waits: its worker is busy with it and hears of nothing else. */
  private makeWay() {
    if (!this.isOld || this.running?.request.kind !== "run" || !this.waiting.some(({ request }) => request.kind === "run")) return;
    this.rest();
    this.leave();
    this.next();
    this.slow(true); // as it was
  }

  private leave() {
    this.worker?.terminate();
    this.worker = null;
    this.sent = 0;
  }

  /** Ends what is under way, whatever it is: its worker goes, another one comes. */
  giveUp(message: "cancelled" | "limit" | "worker") {
    const { running } = this;
    this.rest();
    this.leave();
    running?.hear({ id: running.id, kind: "refused", errors: [{ file: "", line: 0, column: 0, key: "", message }] });
    this.next();
  }
}
