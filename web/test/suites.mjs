// A case with a suite of three records, in a folder of its own, for the tests: two beside one another, one in other columns.
import { mkdirSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";

const text = `title = "Two frames of sticks"

[units]
length = "m"
force = "kN"

[[building]]
name = "West"
damping = 0.05
stick = { storey_heights = [3.5, 3.0, 3.0, 3.0], masses = [60, 55, 55, 50], stiffnesses = [16e3, 15e3, 14e3, 12e3] }

[[building]]
name = "East"
damping = 0.05
stick = { storey_heights = [3.5, 3.0, 3.0, 3.0], masses = [80, 75, 75, 60], stiffnesses = [40e3, 38e3, 35e3, 30e3] }

[[gap]]
between = ["West", "East"]
width = 0.05
contact = { law = "linear", stiffness = 3e5 }

[excitation]
kind = "suite"
files = ["records/*.AT2", { file = "c.txt", unit = "g" }]
scale = "en-1998-1"
target = { shape = "en-1998-1", ground_acceleration = "0.1 g", ground_type = "D", spectrum_type = 1 }
`;

/** A burst of two waves [g]. */
function burst(period, step, count) {
  const wave = (t, size, length, middle) => size * Math.sin((2 * Math.PI * t) / length + middle) * Math.exp(-(((t - middle) / 2) ** 2));
  return Array.from({ length: count }, (_, i) => wave(i * step, 0.3, period, 4) + wave(i * step, 0.1, 0.31, 5));
}

/** As PEER's databases write one. */
function at2(values, step) {
  const lines = values.reduce((all, value, i) => `${all}${value.toExponential(7).padStart(16)}${i % 5 === 4 ? "\n" : ""}`, "");
  return `PEER STRONG MOTION DATABASE RECORD\nNOWHERE 01/02/03, SOMEWHERE\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= ${values.length}, DT= ${step.toFixed(4)} SEC\n${lines}`;
}

/** The folder, the case file, its text, and the records' places beside it. */
export function makeSuite() {
  const folder = mkdtempSync(`${tmpdir()}/bentur-suite-`), file = `${folder}/case.toml`;
  mkdirSync(`${folder}/records`);
  writeFileSync(file, text);
  writeFileSync(`${folder}/records/a.AT2`, at2(burst(0.9, 0.02, 500), 0.02));
  writeFileSync(`${folder}/records/b.AT2`, at2(burst(0.5, 0.02, 500), 0.02));
  writeFileSync(`${folder}/c.txt`, burst(0.7, 0.01, 900).map((value, i) => `${(0.01 * i).toFixed(2)} ${value.toFixed(7)}`).join("\n"));
  const records = ["records/a.AT2", "records/b.AT2", "c.txt"];
  return { folder, file, text, records, bytes: (name) => readFileSync(`${folder}/${name}`) };
}
