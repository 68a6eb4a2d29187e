// A case text as its values and where each stands, so that a form can change one value and leave the rest of the text,
// comments included, as it is.
import { parseTOML, type AST } from "toml-eslint-parser";

export type Path = (string | number)[];
export interface Leaf { path: Path; value: unknown; range: [number, number]; text: string }
export interface Table { path: Path; range: [number, number] }
export interface List extends Table { items: [number, number][] }
export interface Outline { leaves: Leaf[]; tables: Table[]; lists: List[]; pairs: Table[] }
export interface Edit { range: [number, number]; made: string }

const LONGEST = 200000; // characters that a form is made of

let lastText = "", last: Outline | null = null;

/** Every value with its place; nothing where the text is not TOML. What was outlined last is known still. */
export function outline(text: string): Outline | null {
  if (text !== lastText) [lastText, last] = [text, outlineOf(text)];
  return last;
}

function outlineOf(text: string): Outline | null {
  if (text.length > LONGEST) return null;
  try {
    const found: Outline = { leaves: [], tables: [], lists: [], pairs: [] };
    const value = (node: AST.TOMLContentNode, path: Path): void => {
      if (path.length > 12) return;
      if (node.type === "TOMLValue") found.leaves.push({ path, value: node.value, range: node.range, text: text.slice(...node.range) });
      else if (node.type === "TOMLArray") {
        found.lists.push({ path, range: node.range, items: node.elements.map((one) => one.range) });
        node.elements.forEach((one, i) => value(one, [...path, i]));
      } else node.body.forEach((one) => pair(one, path));
    };
    const pair = (node: AST.TOMLKeyValue, parent: Path): void => {
      const path = [...parent, ...node.key.keys.map((key) => (key.type === "TOMLBare" ? key.name : key.value))];
      found.pairs.push({ path, range: node.range });
      value(node.value, path);
    };
    for (const node of parseTOML(text).body[0].body) {
      if (node.type === "TOMLKeyValue") pair(node, []);
      else {
        found.tables.push({ path: node.resolvedKey, range: node.range });
        node.body.forEach((one) => pair(one, node.resolvedKey));
      }
    }
    return found;
  } catch {
    return null;
  }
}

export const same = (a: Path, b: Path) => a.length === b.length && a.every((key, i) => key === b[i]);
export const under = (path: Path, parent: Path) => parent.every((key, i) => key === path[i]);
export const leaf = (found: Outline | null, path: Path) => found?.leaves.find((one) => same(one.path, path));

/** The text with other words at some places. */
export const apply = (text: string, edits: Edit[]) => [...edits].sort((a, b) => b.range[0] - a.range[0])
  .reduce((all, { range, made }) => all.slice(0, range[0]) + made + all.slice(range[1]), text);

/** A number as a case has it: no more digits than mean something. */
export function decimal(value: number): string {
  if (value === 0 || !Number.isFinite(value)) return "0.0";
  const short = Number(value.toPrecision(5));
  return Math.abs(short) >= 1e6 || Math.abs(short) < 1e-4 ? short.toExponential().replace("e+", "e") : String(short);
}

function numberLike(old: string, value: number): string {
  const text = decimal(value);
  const whole = /^[+-]?[\d_]+$/.test(old);
  return whole || /[.e]/.test(text) ? text : `${text}.0`;
}

export function put(text: string, at: Leaf, value: number | string | boolean): string {
  const made = typeof value === "number" ? numberLike(at.text, value) : typeof value === "string" ? JSON.stringify(value) : String(value);
  return text.slice(0, at.range[0]) + made + text.slice(at.range[1]);
}

/** Every number of a gap's width. */
export function widths(found: Outline | null, gap: number): Leaf[] {
  return (found?.leaves ?? []).filter((one) => typeof one.value === "number" && under(one.path, ["gap", gap, "width"]));
}

/** The text with these keys in a table, in place of what it had but `kept`; the table is added where there is none. */
export function withTable(text: string, name: string, lines: string[], kept: string[] = []): string {
  const found = outline(text);
  const lineEnd = (at: number) => { const end = text.indexOf("\n", at); return end < 0 ? text.length : end; };
  const table = found?.tables.find((one) => same(one.path, [name]));
  const inline = found?.pairs.find((one) => same(one.path, [name]));
  const old = (found?.pairs ?? []).filter((one) => kept.some((key) => same(one.path, [name, key])))
    .map(({ range }) => text.slice(range[0], table ? lineEnd(range[1]) : range[1])); // what is said of it behind it stays too
  const made = `[${name}]\n${[...lines, ...old].join("\n")}`;
  if (table) return text.slice(0, table.range[0]) + made + (text.slice(lineEnd(table.range[1])) || "\n");
  const rest = inline ? text.slice(0, inline.range[0]) + text.slice(lineEnd(inline.range[1]) + 1) : text;
  return `${rest.trimEnd()}\n\n${made}\n`;
}

/** One key of a table of the first level. */
export function withKey(text: string, table: string, key: string, value: string): string {
  const found = outline(text);
  const at = leaf(found, [table, key]);
  if (at) return text.slice(0, at.range[0]) + value + text.slice(at.range[1]);
  const place = found?.tables.find((one) => same(one.path, [table]));
  if (!place) return `[${table}]\n${key} = ${value}\n\n${text}`;
  const end = text.indexOf("\n", place.range[0]);
  return `${text.slice(0, end + 1)}${key} = ${value}\n${text.slice(end + 1)}`;
}
