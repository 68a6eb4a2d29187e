declare module "*?worker&inline" {
  const create: new () => Worker;
  export default create;
}
declare module "*?raw" {
  const text: string;
  export default text;
}
declare module "*.css";
declare module "*/bentur_web.mjs" {
  export interface Studio {
    putFile(path: string, bytes: Uint8Array | string): void;
    removeFile(path: string): void;
    open(text: string, file: string): string;
    chooseRecord(number: number): string;
    schema(): string;
    inUnits(text: string, length: string, force: string): string;
    solve(outputStep: number | null, progress: ((done: number) => boolean) | null): string;
    summary(): string;
    impacts(): string;
    gaps(): string;
    modes(): string;
    motion(language: string): string;
    report(language: string): string;
    overview(language: string): string;
    tables(language: string): string;
    contacts(): string;
    histories(): import("./solver").Histories;
    draw(kind: string, language: string, wanted: import("./solver").Wanted): import("./solver").Drawn;
    figureFile(kind: string, language: string, wanted: import("./solver").Wanted): string;
    atWidth(gap: number, width: number): string;
  }
  export const deflated: string; // the solver, in base64: vite.config.ts
  export default function createBentur(module: { wasmBinary: ArrayBuffer }): Promise<{ Studio: new () => Studio }>;
}
declare module "*/report/html/motion/motion.js" {
  export interface Motion {
    readonly impacts: { number: number; point: number; start: number; end: number }[];
    number(value: number): string;
    show(time: number, since?: number, fading?: number): void;
    showImpact(impact: unknown): void;
    start(): void;
    pause(): void;
    isPlaying(): boolean;
    /** The gap whose openings come first in the list. */
    watch(gap: number, go?: boolean): void;
    update(data: unknown): void;
  }
  export function benturMotion(parts: Record<string, unknown>, data: unknown): Motion;
}
