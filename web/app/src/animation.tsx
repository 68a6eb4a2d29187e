import { type Motion, benturMotion } from "@repo/src/bentur/report/html/motion/motion.js";
import type { ComponentChildren } from "preact";
import { useEffect, useMemo, useRef } from "preact/hooks";
import { chosen, gap } from "./case";
import type { Overview } from "./solver";
import { loads, time } from "./state";
import { language, say } from "./texts";

const speeds: [string, string][] = [["2", "2 ×"], ["1", "1 ×"], ["0.5", "1/2 ×"], ["0.1", "1/10 ×"], ["0.01", "1/100 ×"], ["0.001", "1/1000 ×"]];

/** The one that the charts and the impact list move. */
export let main: Motion | null = null;

/** What is shown beside the main one, of the same instants. */
const followers = new Set<Motion>();

const caseOf = () => `${loads.value} ${chosen.value}`;

/** The buildings in motion, by the report's own script; those that are not the primary ones follow its time. Children stand
 *  below the picture. */
export function MotionView({ data, overview, play, primary, children }: { data: string; overview: Overview; play: boolean; primary: boolean; children?: ComponentChildren }) {
  const root = useRef<HTMLDivElement>(null);
  const motion = useRef<Motion | null>(null), loaded = useRef(caseOf());
  const read = useMemo(() => JSON.parse(data), [data]);
  const opening = `${say("history.opening")} [${overview.units.length}]`;
  useEffect(() => {
    if (motion.current) {
      motion.current.update(read);
      if (caseOf() !== loaded.current) { // another case or record: what happens in it
        loaded.current = caseOf();
        motion.current.pause();
        motion.current.show(read.shown);
      }
      return;
    }
    const parts: Record<string, unknown> = {};
    for (const one of root.current!.querySelectorAll<HTMLElement>("[data-part]")) parts[one.dataset.part!] = one;
    if (primary) parts.shown = (now: number, since?: number, fading?: number) => {
      for (const one of followers) one.show(now, since, fading);
      time.value = now;
    };
    const made = benturMotion(parts, read);
    motion.current = made;
    if (primary) main = made;
    else {
      followers.add(made);
      made.show(time.value);
    }
    if (play && !matchMedia("(prefers-reduced-motion: reduce)").matches) {
      (parts.speed as HTMLSelectElement).value = "1";
      made.start();
    }
  }, [read]);
  const before = useRef<unknown>(null); // of what the gap was watched
  useEffect(() => {
    motion.current?.watch(gap.value, before.current === read); // another gap of the same run is gone to
    before.current = read;
  }, [read, gap.value]);
  useEffect(() => () => {
    motion.current?.pause();
    if (motion.current) followers.delete(motion.current);
    if (primary) main = null;
  }, []);
  void language.value;
  return (
    <div class="motion" ref={root}>
      <div class="player">
        <svg data-part="stage" class="stage" role="img" aria-label={say("motion.picture")} />
        {children}
        <div class="readout">
          <p><output data-part="clock" class="clock" aria-live="off" /><br /><span data-part="event" class="event" /></p>
          <div class="wide" tabIndex={0} role="group" aria-label={opening}>
            <table class="live"><caption>{opening}</caption><tbody data-part="live" /></table>
          </div>
        </div>
      </div>
      <p data-part="buildingKey" class="note" />
      <svg data-part="timeline" class="timeline" role="img" aria-label={say("motion.timeline")} />
      <div data-part="timeAxis" class="time-axis" aria-hidden="true" />
      <input data-part="scrub" class="scrub" type="range" min="0" aria-label={say("time")} />
      <p class="controls" hidden={!primary}>
        <button type="button" data-part="play" class="play" aria-pressed="false">{say("motion.play")}</button>
        <button type="button" data-part="previous" aria-label={say("motion.previous")}>«</button>
        <button type="button" data-part="next" aria-label={say("motion.next")}>»</button>
        <button type="button" data-part="hardest">{say("motion.hardest")}</button>
        <label>{say("motion.speed")} <select data-part="speed">{speeds.map(([value, shown]) => <option key={value} value={value} selected={value === "1"}>{shown}</option>)}</select></label>
        <label><input type="checkbox" data-part="slow" /> {say("motion.slow")}</label>
        <label>{say("motion.magnify")} <input type="range" data-part="magnify" /><output data-part="magnified" /></label>
        <label data-part="levelChoice" hidden>{say("history.point")} <select data-part="level" /></label>
      </p>
    </div>
  );
}
