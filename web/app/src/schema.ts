// What the schema of a case says of its keys, which is said nowhere in the page: what they are
// called, take and mean.
import { found } from "./case";
import { type Key, type Node, schema } from "./solver";
import { language } from "./texts";
import { leaf, type Path } from "./toml";

/** The keys of a table, by name; of a list those of the tables in it. */
export const keysOf = (node: Node): Record<string, Node> => node.properties
  ?? Object.assign({}, ...[node.items ?? [], node.anyOf ?? []].flat().map(keysOf));

/** The key at each step of a path that has one: of several of a name that of the words beside it. */
function keysAt(path: Path): (Key & { description: string } | undefined)[] {
  let node: Node | undefined = schema.value?.case;
  return path.map((step, i) => {
    if (typeof step === "number" || !node) return undefined;
    const beside = keysOf(node);
    node = beside[step];
    if (!node) return undefined;
    const word = (by: string) => String(leaf(found.value, [...path.slice(0, i), by])?.value
      ?? beside[by]["x-bentur"][0].words?.[0] ?? false);
    const all = node["x-bentur"];
    const key = all.find((one) => Object.entries(one.when ?? {})
      .every(([by, words]) => words.includes(word(by)))) ?? all[0];
    return { ...key, description: node.description };
  });
}

/** What is said of the key of a value, which may be in a list. */
export const keyOf = (path: Path) => keysAt(path)[path.length - 1];
export const keyAt = (...path: string[]) => keyOf(path);

/** What people call a key. */
export const nameOf = (...path: string[]) =>
  keyAt(...path)?.label[language.value] ?? path[path.length - 1];

/** The key of a number and what it is called, from a step of its path on; what a word says again is said once. */
export function fieldOf(path: Path, from: number) {
  const keys = keysAt(path), words: string[] = [];
  path.forEach((step, i) => {
    const key = keys[i];
    if (i < from || key?.group === "structure") return;
    const word = key?.label[language.value] ?? String(step), last = words.length - 1;
    if (typeof step === "number") words[Math.max(last, 0)] = `${words[last] ?? ""} ${step + 1}`;
    else if (word.toLowerCase().includes(words[last]?.toLowerCase())) words[last] = word;
    else words.push(word);
  });
  const key = keys.filter((one) => one !== undefined).pop();
  return { label: words.join(": "), key: key?.kind === "table" ? undefined : key };
}

/** A slider's ends: a part of one has all of its range, another number what lies below a multiple of
 *  what it `was`, neither any value that is refused. */
export function slide(value: number, was: number, key?: Key) {
  const { minimum, maximum, not, ...takes } = key?.number ?? {};
  const least = minimum ?? (not && value > 0 ? 0 : -Infinity);
  const most = maximum ?? (not && value < 0 ? 0 : Infinity);
  const whole = takes.type === "integer";
  const far = least === 0 && most <= 1 ? most
    : was === 0 ? 1 : whole ? Math.max(12, 2 * Math.abs(was)) : 3 * Math.abs(was);
  const end = Math.max(far, Math.abs(value));
  const step = whole ? 1 : end / 300;
  const from = Math.max(value < 0 ? -end : 0, least), to = Math.min(end, most);
  const aboveLeast = takes.exclusiveMinimum || not || least > 0; // lengths end next to nothing
  const belowMost = takes.exclusiveMaximum || not;
  return {
    min: from === least && aboveLeast && !whole ? from + step : from,
    max: to === most && belowMost ? to - step : to,
    step,
  };
}
