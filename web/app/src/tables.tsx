import { useSignal } from "@preact/signals";
import type { PagePart, Result } from "./solver";
import { isStill } from "./still";
import { say } from "./texts";

/** A section of the report, whose markup is the library's: no text of a case is markup in it. What is closed costs nothing. */
function Part({ one, isOpen }: { one: PagePart; isOpen: boolean }) {
  const open = useSignal(isOpen);
  return (
    <details data-table={one.id} open={open.value} onToggle={(event) => { open.value = event.currentTarget.open; }}>
      <summary>{one.heading}</summary>
      {open.value && <div class="part" dangerouslySetInnerHTML={{ __html: one.markup }} />}
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
