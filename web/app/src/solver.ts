// The page's side of the worker: the newest request counts, and one that takes too long is given up with its worker.
import SolverWorker from "./worker?worker&inline";

export interface CaseError { file: string; line: number; column: number; key: string; message: string }
export interface Histories {
  time: Float64Array;
  ground: Float64Array;
  opening: Float64Array[];
  force: Float64Array[];
  buildings: { displacement: Float64Array[]; drift: Float64Array[]; shear: Float64Array[] }[];
}
export interface GapOverview {
  name: string; impacts: number; touched: number; points: number; width: number; needed: number; elevation: number;
  hardest?: { force: number; elevation: number; time: number };
  unmodelled: string | null;
  rules: { abs?: number; srss?: number; ddc?: number };
}
export interface BuildingOverview {
  name: string; rigid: boolean; period: number | null; yields: boolean; elevations: number[]; heights: number[];
  displacement: (number | null)[]; alone: (number | null)[]; drift: (number | null)[]; acceleration: (number | null)[];
  shear: (number | null)[]; ductility: (number | null)[];
}
/** [left building, elevation, start, end, peak force, closing speed, penetration, restitution] */
export type ImpactRow = [number, number, number, number, number, number, number, number | null];
export interface Overview {
  title: string; version: string; duration: number; units: { length: string; force: string }; gaps: GapOverview[];
  buildings: BuildingOverview[]; points: { gap: number; elevation: number; width: number }[]; impacts: ImpactRow[];
  impactCount: number; force: number; amplification: number; remarks: string[]; milliseconds: number;
  collapse?: { building: string; time: number };
}
export interface CurvePoint { width: number; force: number; amplification: number; impacts: number }
export type Take = "summary" | "impacts" | "gaps" | "modes" | "report";
export type Files = [string, Uint8Array][];
interface Common { id: number; text: string; language: string; files?: Files }
export type Request = Common & (
  | { kind: "run"; step: number | null }
  | { kind: "take"; what: Take }
  | { kind: "units"; length: string; force: string }
  | { kind: "curve"; gap: number; widths: number[] });
export type Result = { overview: Overview; units: Record<string, string>; motion: string; histories: Histories; milliseconds: number; fine: boolean };
export type Answer = { id: number } & (
  | { kind: "refused"; errors: CaseError[] }
  | { kind: "progress"; done: number }
  | ({ kind: "result" } & Result)
  | { kind: "text"; text: string }
  | { kind: "curve"; curve: CurvePoint[]; done: number });

type Wanted = Omit<Request, "id" | "files"> & { [key: string]: unknown };
const LIMIT = 20000; // [ms] that anything may take

export class Solver {
  private worker: Worker | null = null; // only when there is something to do: it has all of WebAssembly to compile
  private last = 0;
  private running: { id: number; hear: (answer: Answer) => void } | null = null;
  private waiting: { request: Wanted; hear: (answer: Answer) => void } | null = null;
  private sent = 0;
  private timer = 0;
  /** Every file that cases may name. */
  files: Files = [];

  private get awake(): Worker {
    if (this.worker) return this.worker;
    this.worker = new SolverWorker();
    this.worker.onmessage = ({ data }: MessageEvent<Answer>) => {
      if (!this.running || data.id !== this.running.id) return;
      const { hear } = this.running;
      const over = data.kind !== "progress" && !(data.kind === "curve" && data.done < 1);
      if (over) this.rest();
      hear(data);
      if (over) this.next();
    };
    this.worker.onerror = () => this.giveUp("worker");
    return this.worker;
  }

  private rest() {
    clearTimeout(this.timer);
    this.running = null;
  }

  private next() {
    if (this.running || !this.waiting) return;
    const { request, hear } = this.waiting;
    this.waiting = null;
    this.running = { id: ++this.last, hear };
    const files = this.sent < this.files.length ? this.files.slice(this.sent) : undefined;
    this.sent = this.files.length;
    this.timer = window.setTimeout(() => this.giveUp("limit"), LIMIT);
    this.awake.postMessage({ ...request, id: this.last, files });
  }

  /** Asks for something; what waits already is forgotten. A curve under way ends for it. */
  ask(request: Wanted, hear: (answer: Answer) => void) {
    this.waiting = { request, hear };
    if (this.running && request.kind === "curve") {
      clearTimeout(this.timer);
      this.running = null; // its worker hears of the new one and stops
    }
    this.next();
  }

  get busy() { return this.running !== null; }

  /** Ends what is under way, whatever it is: its worker goes, another one comes. */
  giveUp(message: "cancelled" | "limit" | "worker") {
    const { running } = this;
    this.rest();
    this.worker?.terminate();
    this.worker = null;
    this.sent = 0;
    running?.hear({ id: running.id, kind: "refused", errors: [{ file: "", line: 0, column: 0, key: "", message }] });
    this.next();
  }
}
