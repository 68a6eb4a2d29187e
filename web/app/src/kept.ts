// The case over a reload, where the browser lets a page keep anything: a page from disk may be refused.
import type { Files } from "./solver";
import { uses } from "./suite";
import { outline } from "./toml";

/** What one works on: a text, and the files that were added to it. */
export interface Work { text: string; files: Files }

const KEY = "bentur-studio";
const MOST = 2 ** 21; // bytes of files: browsers keep some five million characters, and bytes take four thirds of one

const letters = (bytes: Uint8Array) => {
  let all = "";
  for (const byte of bytes) all += String.fromCharCode(byte);
  return btoa(all);
};

export function keep({ text, files }: Work) {
  let left = MOST;
  const all = files.filter(([name]) => text.includes(name) || uses(outline(text), name)).map(([name, bytes]) => [name, (left -= bytes.length) >= 0 ? letters(bytes) : null]);
  try {
    localStorage.setItem(KEY, JSON.stringify({ text, files: all }));
  } catch { /* it is not kept */ }
}

export function forget() {
  try {
    localStorage.removeItem(KEY);
  } catch { /* nothing was kept */ }
}

/** What was kept, and the names of files that were too large to be. */
export function kept(): Work & { lost: string[] } | null {
  try {
    const { text, files } = JSON.parse(localStorage.getItem(KEY)!) as { text: unknown; files: [string, string | null][] };
    if (typeof text !== "string") return null;
    const whole: Files = [], lost: string[] = [];
    for (const [name, all] of files) {
      if (all === null) lost.push(name);
      else whole.push([name, Uint8Array.from(atob(all), (letter) => letter.charCodeAt(0))]);
    }
    return { text, files: whole, lost };
  } catch {
    return null;
  }
}
