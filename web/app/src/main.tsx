import { effect, useSignal } from "@preact/signals";
import { render } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { chosen, result, text } from "./case";
import { cases } from "./cases";
import { beginDrawing } from "./drawing";
import { Editor, Errors, FilePicker, Form, GapNotesBelow, GapSlider, goTo, listenToKeys, openFiles, Units } from "./edit";
import { Figures } from "./figures";
import { fromFragment, linked } from "./link";
import { MotionView } from "./animation";
import type { Overview, Said } from "./solver";
import { Brief, caseOf, Comparison, Facts, Impacts, Stale, Verdict } from "./results";
import { nameOf } from "./schema";
import { isStill } from "./still";
import { begin, complain, curveDone, hardest, hardestRuns, isOwn, load, pinned, rough, stale, standing, startAnew } from "./state";
import "./style.css";
import { Tables } from "./tables";
import { Take } from "./take";
import { language, languages, say, type Word } from "./texts";
import { choice, onTelephone } from "./theme";

function Head() {
  return (
    <header>
      <a class="skip" href="#results" onClick={(event) => { event.preventDefault(); document.getElementById("results")?.focus(); }}>{say("skip")}</a>
      <div class="top"><h1>bentur studio</h1><p class="lead">{say("lead")}</p>
        <p class="controls">
          <Units />
          <label class="choice"><span>{say("language")} </span><select id="language" value={language.value} onChange={(event) => { language.value = event.currentTarget.value as keyof typeof languages; }}>
            {Object.entries(languages).map(([tag, name]) => <option key={tag} value={tag} lang={tag} selected={tag === language.value}>{name}</option>)}</select></label>
          <label class="choice"><span>{say("theme")} </span><select id="theme" value={choice.value} onChange={(event) => { choice.value = event.currentTarget.value as "auto"; }}>
            {(["auto", "light", "dark"] as const).map((one) => <option key={one} value={one} selected={one === choice.value}>{say(`theme.${one}`)}</option>)}</select></label>
        </p></div>
      <nav aria-label={say("cases")} class="cases"><FilePicker label={say("open")} />{cases.map((one) => <button type="button" key={one.id} data-case={one.id} aria-pressed={text.value === one.text} onClick={() => load(one.text)}>{say(`case.${one.id}` as Word)}</button>)}
        {isOwn.value && <button type="button" onClick={startAnew}>{say("anew")}</button>}</nav>
    </header>
  );
}

/** What stays in sight: the slider that everything starts with, and what has become of the case. */
function Bar() {
  const bar = useRef<HTMLDivElement>(null);
  useEffect(() => { // what is gone to stands below it, the buildings have the rest of the first screen
    const watched = new ResizeObserver(([{ target }]) => document.documentElement.style.setProperty("--bar", `${(target as HTMLElement).offsetHeight}px`));
    watched.observe(bar.current!);
    return () => watched.disconnect();
  }, []);
  return <><div class="bar" ref={bar}><GapSlider><Brief /></GapSlider><Stale /></div><GapNotesBelow /></>;
}

const fileOf = (record: string) => record.split("/").pop()!;

/** All records of a suite in short, or one of them in full. */
function RecordChoice({ suite }: Pick<Overview, "suite">) {
  if (!suite) return null;
  return (
    <p class="controls"><label class="choice"><span>{nameOf("excitation", "file")} </span><select id="record" value={chosen.value} onChange={(event) => { chosen.value = Number(event.currentTarget.value); }}>
      {[say("suite.all", { n: suite.records.length }), ...suite.records.map((one, i) => `${i + 1}: ${fileOf(one)}`)].map((one, i) => <option key={i} value={i} selected={i === chosen.value}>{one}</option>)}
    </select></label></p>
  );
}

/** As everywhere they are the last of what is said; how many there are is in sight. */
function Remarks({ all }: { all: Said[] }) {
  if (all.length === 0) return null;
  return (
    <details><summary>{say("verdict.remark")}: {all.length}</summary>
      <ul data-remarks>{all.map((one, i) => <li key={one.text}>{i > 0 ? " " : ""}{one.text}</li>)}</ul>
    </details>
  );
}

function App() {
  const area = useRef<HTMLTextAreaElement>(null);
  const dropping = useSignal(false);
  const formOpen = useSignal(false); // a closed form costs nothing
  const now = result.value, still = now && isStill(now.overview);
  const moving = !still ? now : now.overview.suite ? hardest.value?.run : null; // of a suite one of its records
  const remarks = (now?.overview.statements ?? []).filter((one) => one.severity === "remark");
  const verdict = <><Errors goTo={(line, column) => goTo(area.current, line, column)} /><Verdict /></>; // on a telephone right below the picture
  const isBelow = moving && onTelephone.value;
  const said = (
    <div class="said">
      {!isBelow && verdict}
      <Remarks all={remarks} />
      {now && <p class="note">{say("solved.in", { ms: now.milliseconds.toFixed(0) })}{curveDone.value < 1 && !stale.value && standing.value !== "errors" && ` ${say("curve.runs", { percent: Math.floor(100 * curveDone.value) })}`}</p>}
    </div>
  );
  return (
    <div class={`page${dropping.value ? " dropping" : ""}`}
      onDragOver={(event) => { event.preventDefault(); dropping.value = true; }}
      onDragLeave={(event) => { if (event.relatedTarget === null) dropping.value = false; }}
      onDrop={(event) => {
        event.preventDefault();
        dropping.value = false;
        void openFiles([...event.dataTransfer?.files ?? []]);
      }}>
      <Head />
      {dropping.value && <div class="drop">{say("drop")}</div>}
      <main id="results" class={stale.value ? "stale" : rough.value ? "rough" : ""} tabIndex={-1} data-solved={standing.value} data-ms={now?.milliseconds.toFixed(1)}>
        <Bar />
        <div class="lives">
          {now && <section id="motion"><h2>{say("motion")}: {now.overview.title || "–"}</h2>
            <RecordChoice suite={now.overview.suite} />
            {moving ? <>
              {still && <p class="note" data-hardest>{say(moving.overview.impactCount > 0 ? "suite.hardest" : "suite.closest", { name: fileOf(hardest.value!.file) })}</p>}
              <div class={`${pinned.value ? "motions" : ""}${still && hardest.value!.of !== now ? " old" : ""}`}>
                <div>{pinned.value && <h3>{say("now")}: {caseOf(moving.overview)}</h3>}
                  <MotionView data={moving.motion} overview={moving.overview} play={!still} primary={true}>{isBelow && <div class="said">{verdict}</div>}</MotionView></div>
                {pinned.value && <div><h3>{say("pinned")}: {caseOf(pinned.value.overview)}</h3>
                  <MotionView data={pinned.value.motion} overview={pinned.value.overview} play={false} primary={false} /></div>}
              </div></> : hardestRuns.value ? <p class="coming note">{say("solving")}</p> : <p class="still">{say(now.overview.spectral ? "motion.none" : "suite.still")}</p>}
          </section>}
          {said}
          {now && now.overview.facts.length > 0 && <div class="known"><Facts all={now.overview.facts} gaps={now.overview.gaps} /></div>}
          <section id="edit" class="edit">
            <h2>{say("edit")}</h2>
            <details open><summary>{say("edit.text")}</summary><Editor area={area} /></details>
            <details onToggle={(event) => { formOpen.value = event.currentTarget.open; }}><summary>{say("edit.form")}</summary>{formOpen.value && <Form />}</details>
          </section>
        </div>
        {now && <div class="found">
          {!now.overview.spectral && <Figures now={now} />}
          {!still && <>
          <Impacts now={now} />
          <Comparison now={now} />
          </>}
          <Tables now={now} />
        </div>}
        <Take />
      </main>
      <footer><p class="note">{say("footer", { version: now?.overview.version ?? "" })}</p></footer>
    </div>
  );
}

effect(() => { document.documentElement.lang = language.value; });
const fromAddress = () => fromFragment(location.hash).then((given) => {
  if (given !== null) load(given);
  linked.value = given === null ? null : text.value;
}).catch(() => complain("error.link"));
void fromAddress().then(begin).then(beginDrawing);
addEventListener("hashchange", () => void fromAddress());
effect(() => {
  if (linked.value === null || text.value === linked.value) return;
  linked.value = null;
  history.replaceState(null, "", location.pathname + location.search);
});
listenToKeys();
render(<App />, document.getElementById("app")!);
