import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import type { PagePart, Result } from "./solver";
import { isStill } from "./still";
import { say } from "./texts";

const HALF = 21; // letters that half a telephone's screen has

/** Gives the cells of tables their headings, for screens on which a row is a card. */
function giveHeads(part: HTMLElement | null) {
  for (const table of part?.querySelectorAll("table") ?? []) {
    const heads = [...table.querySelectorAll("thead tr:last-child > *")];
    const rows = [...table.querySelectorAll("tbody tr")];
    if (heads.length < 3 || rows.some((row) => row.children.length !== heads.length)) continue; // a list, or cells that span
    table.classList.add("cards");
    for (const row of rows) {
      heads.forEach((head, k) => {
        const cell = row.children[k] as HTMLElement, unit = head.querySelector("small")?.textContent?.trim();
        cell.dataset.head = (head.firstChild?.textContent ?? "").trim();
        cell.classList.toggle("long", cell.classList.contains("t") && cell.dataset.head.length + cell.textContent!.length > HALF);
        if (unit) cell.dataset.unit = unit;
      });
    }
  }
}

/** A section of the report, whose markup is the library's: no text of a case is markup in it. What is closed costs nothing. */
function Part({ one, isOpen }: { one: PagePart; isOpen: boolean }) {
  const open = useSignal(isOpen);
  const part = useRef<HTMLDivElement>(null);
  useEffect(() => giveHeads(part.current), [one.markup, open.value]);
  return (
    <details data-table={one.id} open={open.value} onToggle={(event) => { open.value = event.currentTarget.open; }}>
      <summary>{one.heading}</summary>
      {open.value && <div class="part" ref={part} dangerouslySetInnerHTML={{ __html: one.markup }} />}
    </details>
  );
}

/** The report's tables: in sight where there is nothing else to be seen. */
export function Tables({ now }: { now: Result }) {
  return (
    <section id="tables">
      <h2>{say("tables")}</h2>
      {now.tables.map((one) => <Part key={`${one.id} ${isStill(now.overview)}`} one={one} isOpen={isStill(now.overview)} />)}
    </section>
  );
}
