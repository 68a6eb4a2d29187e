// The cases that the page starts from: examples of the repository, the first under the whole of its record.
import moat from "@repo/examples/isolated-moat.toml?raw";
import monograph from "@repo/examples/m12-el-centro.toml?raw";
import plan from "@repo/examples/plan/twisting-pair.toml?raw";
import row from "@repo/examples/row-of-three.toml?raw";
import frames from "@repo/examples/two-frames-si.toml?raw";
import yielding from "@repo/examples/yielding-pair.toml?raw";
import record from "@repo/data/el-centro-1940-ns.csv?raw";
import lobes from "@repo/data/four-lobes.csv?raw";
import columns from "../cases/eight-and-five.toml?raw";

const bare = (text: string) => text.replace(/"(\.\.\/)+data\//g, '"');
/** Without a duration the run goes on until nothing more can come, so that there is a gap that is known to be enough. */
const whole = (text: string) => text.replace(/^duration = /m, "# $&");

export const cases = [
  { id: "frames", text: whole(bare(frames)) },
  { id: "monograph", text: bare(monograph) },
  { id: "columns", text: bare(columns) },
  { id: "row", text: bare(row) },
  { id: "moat", text: bare(moat) },
  { id: "yielding", text: bare(yielding) },
  { id: "plan", text: bare(plan) },
] as const;

export const recordName = "el-centro-1940-ns.csv";
/** The ground motions of the examples, by name. */
export const records: [string, Uint8Array][] = [[recordName, new TextEncoder().encode(record)], ["four-lobes.csv", new TextEncoder().encode(lobes)]];
