// The buildings in motion: of a report and of the studio alike. It plays what animation.cpp or plan_animation.cpp wrote,
// into elements that the page gives it, and listens to them; what moves is drawn by row.js or plan.js. Text
// reaches the page by textContent, never as markup.

/**
 * @param parts elements: stage and timeline (SVG), scrub, clock, event, live (tbody), play, previous, next, hardest, speed,
 *   slow, magnify, magnified; where there are such, level (select, of pictures of one level) and levelChoice around it,
 *   timeAxis (the times below the time line) and buildingKey (what numbers stand for, where there are some in place of names); `steady`:
 *   the stage keeps its height; `shown`, where there is one, is told of every time that is shown [s], as show() is.
 * @param data what animation_json() or plan_animation_json() gives
 * @returns {impacts, html(name, text, parent), number, update(data), show(time, since, fading), showImpact(impact), start(), pause(), isPlaying(), watch(gap, go)}
 */
function benturMotion(parts, data) {
  "use strict";
  let words = data.words;
  const SVG = "http://www.w3.org/2000/svg";

  function svg(name, attributes, parent) {
    const node = document.createElementNS(SVG, name);
    for (const key of Object.keys(attributes)) node.setAttribute(key, attributes[key]);
    if (parent) parent.appendChild(node);
    return node;
  }

  function html(name, text, parent) {
    const node = document.createElement(name);
    if (text !== undefined) node.textContent = text;
    if (parent) parent.appendChild(node);
    return node;
  }

  /** Four significant digits, as everywhere in the report. */
  function number(value) {
    const size = Math.abs(value);
    if (size === 0) return "0";
    if (size < 1e-4 || size >= 1e7) return signed(value.toExponential(3));
    const decimals = Math.min(7, Math.max(0, 3 - Math.floor(Math.log10(size))));
    return signed(String(Number(value.toFixed(decimals))));
  }

  /** With the sign for minus, which nothing but zeros has none of. */
  function signed(text) {
    return text.replace(/^-/, Number(text) === 0 ? "" : "\u2212");
  }

  // ---------------------------------------------------------------- what it is of

  let samples, buildings, scene, picture, impacts, strongest, duration;

  function read() {
    scene = data.scene;
    samples = benturSamples(data);
    buildings = samples.buildings;
    // [point, start, end, peak force, time of it, closing speed, number, whether it slips off], by start
    impacts = data.impacts.map(([point, start, end, force, peak, speed, number, slips]) =>
      ({ point, start, end, force, peak, speed, number, slips }));
    strongest = impacts.length === 0 ? null : impacts.reduce((most, impact) =>
      (impact.force > most.force || (impact.force === most.force && impact.speed > most.speed) ? impact : most));
    duration = data.duration;
    const before = picture;
    picture = (scene.outlines ? benturPlan : benturRow)(data, buildings, svg, number);
    if (!before) return;
    if (before.levels.join() !== picture.levels.join()) { // of other buildings, or from another side
      usual = undefined;
      parts.magnify.value = 0;
    } else if (picture.levels.length > 0) picture.choose(before.level);
  }

  /** Impacts under way at some time of [from, to], but for rounding. */
  function underWay(from, to) {
    const tiny = 1e-12 * duration;
    return impacts.filter((impact) => impact.start <= to + tiny && impact.end >= from - tiny);
  }

  // ---------------------------------------------------------------- the picture

  const { stage } = parts;
  let framed = 0; // width of the page that the height of the drawing is for
  let decimals, magnification, usual, drawn, glow;

  /** Everything that the picture takes from the response. */
  function measure() {
    // As many for all: the largest movement has four digits.
    const largest = Math.max(scene.largest, 1e-300, ...scene.gaps);
    decimals = Math.min(9, Math.max(0, 3 - Math.floor(Math.log10(largest))));
    const before = usual, wanted = scene.magnification;
    // What is drawn again while a gap is changed keeps its magnification unless that no longer fits.
    if (usual === undefined || wanted < usual / 2.4 || wanted > usual * 2.4) usual = wanted;
    magnification = before === undefined ? usual : magnification * usual / before;
    drawn = { marks: [], arrows: [], cells: [], lines: [] };
    glow = data.points.map(() => 0);
  }

  function build() {
    stage.replaceChildren();
    stage.classList.add("bentur");
    const gradient = svg("radialGradient", { id: "glow" }, svg("defs", {}, stage));
    svg("stop", { offset: "0%", "stop-color": "var(--red)", "stop-opacity": "1" }, gradient);
    svg("stop", { offset: "45%", "stop-color": "var(--red)", "stop-opacity": "0.75" }, gradient);
    svg("stop", { offset: "100%", "stop-color": "var(--red)", "stop-opacity": "0" }, gradient);
    picture.build(stage);
    drawn.caption = [["ink"], ["red", "red"]].map((tones) => tones.map((tone) => svg("text", { class: `caption fill-${tone}` }, stage)));
    drawn.key = picture.key.map((marks) => {
      const line = svg("text", { class: "caption fill-ink" }, stage);
      marks.forEach(({ tone, mark, text }, k) => {
        svg("tspan", { class: `fill-${tone}` }, line).textContent = `${k > 0 ? "\u2003" : ""}${mark}`;
        svg("tspan", {}, line).textContent = ` ${text}`;
      });
      return line;
    });
    data.points.forEach((point, i) => {
      drawn.marks.push(svg("circle", { class: "hit", fill: "url(#glow)", opacity: 0, "data-point": i,
        "data-contact": 0 }, stage));
      drawn.arrows.push(svg("path", { class: "force stroke-red", opacity: 0 }, stage));
    });
    frame();
  }

  /** Everything that depends on the magnification but not on time. */
  function frame() {
    const { left, right, top, bottom } = picture.frame(magnification), wide = right - left;
    const isNarrow = stage.clientWidth < 400; // what happens has two lines there
    const lines = [...drawn.caption[0], ...drawn.caption[1].slice(0, isNarrow ? 2 : 1), ...drawn.key];
    const below = picture.below + 36 + 17 * lines.length; // of names, caption and what marks mean
    // Lines and names keep their size on a narrow page, and most of it on a low one.
    const low = 0.7 * (bottom - top) / Math.max(parseFloat(getComputedStyle(stage).maxHeight) - 0.7 * below, below);
    const pixel = Math.max(1, wide / Math.max(stage.clientWidth, 1), low || 0);
    const grain = picture.grain / pixel, tall = bottom - top + below * pixel;
    drawn.pixel = pixel;
    drawn.isNarrow = isNarrow;
    stage.style.setProperty("--px", pixel.toFixed(3));
    stage.style.setProperty("--slab", `${Math.min(5, 0.35 * grain).toFixed(2)}px`);
    stage.style.setProperty("--dot", `${Math.min(4.5, Math.max(1.8, 0.11 * grain)).toFixed(2)}px`);
    stage.style.setProperty("--flash", `${Math.min(24, Math.max(10, 1.2 * grain)).toFixed(2)}px`);
    stage.setAttribute("viewBox", `${left} ${top - 24 * pixel} ${wide} ${tall}`);
    const called = picture.name(pixel);
    if (parts.buildingKey) { // where a number stands for a name, in the picture or in the table of openings
      const { names } = data, inTable = !names.parts && buildings.length > 2;
      parts.buildingKey.textContent = names.key;
      parts.buildingKey.hidden = names.key === "" || !(inTable || called === "number" || (called === "short" && !names.parts));
    }
    if (parts.steady && stage.clientWidth !== framed) { // the page does not jump when the magnification changes
      framed = stage.clientWidth;
      stage.style.height = `${Math.round(Math.min(framed * tall / wide, 454))}px`;
    }
    drawn.wide = Math.max(wide, tall * stage.clientWidth / stage.clientHeight || 0); // as the page has room, for what is written
    const from = left - (drawn.wide - wide) / 2;
    stage.setAttribute("viewBox", `${from} ${top - 24 * pixel} ${drawn.wide} ${tall}`);
    lines.forEach((line, k) => {
      line.setAttribute("x", from + 8 * pixel);
      line.setAttribute("y", bottom + (picture.below + 20 + 17 * k) * pixel);
    });
  }

  // ---------------------------------------------------------------- the time line

  const line = parts.timeline;
  const WIDTH = 1000, HEIGHT = 130, MIDDLE = 52, SPAN = 44;

  function buildTimeline() {
    line.replaceChildren();
    line.setAttribute("viewBox", `0 0 ${WIDTH} ${HEIGHT}`);
    line.setAttribute("preserveAspectRatio", "none");
    line.classList.add("bentur");
    svg("path", { class: "axis", d: `M0 ${MIDDLE}H${WIDTH}` }, line);
    buildings.filter(({ rows }) => rows > 0).forEach((building) => {
      const frames = data.frames, bins = Math.min(WIDTH, frames);
      let path = "";
      for (let bin = 0; bin < bins; ++bin) { // smallest and largest of each bin, so that no peak is lost
        let low = Infinity, high = -Infinity;
        const end = Math.max(Math.floor((bin + 1) * frames / bins), Math.floor(bin * frames / bins) + 1);
        for (let k = Math.floor(bin * frames / bins); k < end; ++k) {
          const value = building.samples[k * building.rows + building.roof] * building.scale / Math.max(scene.largest, 1e-300);
          low = Math.min(low, value);
          high = Math.max(high, value);
        }
        const x = (bin + 0.5) * WIDTH / bins;
        path += `${bin ? "L" : "M"}${x.toFixed(1)} ${(MIDDLE - SPAN * low).toFixed(1)}` +
          `L${x.toFixed(1)} ${(MIDDLE - SPAN * high).toFixed(1)}`;
      }
      svg("path", { class: `roof stroke-${building.tone}`, d: path }, line);
    });
    let ticks = "";
    for (const impact of impacts) {
      const share = impact.force > 0 ? impact.force / strongest.force : 1;
      ticks += `M${(WIDTH * impact.start / duration).toFixed(2)} ${HEIGHT}v${(-4 - 24 * share).toFixed(1)}`;
    }
    svg("path", { class: "tick", d: ticks }, line);
    buildAxis();
    drawn.head = svg("path", { class: "head", d: `M0 0V${HEIGHT}` }, line);
  }

  /** Times below the time line, 1, 2 or 5 times a power of ten apart. */
  function buildAxis() {
    const axis = parts.timeAxis;
    if (!axis) return;
    axis.replaceChildren();
    const power = Math.pow(10, Math.floor(Math.log10(duration / 5)));
    const step = [1, 2, 5, 10].map((digit) => digit * power).find((one) => duration / one <= 6);
    for (let k = 0; k * step <= duration * (1 + 1e-9); ++k) {
      const share = k * step / duration;
      const label = html("span", `${number(k * step)}${k === 0 ? " s" : ""}`, axis);
      label.style.left = `${(100 * share).toFixed(2)}%`;
      if (share > 0.97) label.className = "last";
    }
  }

  function listenToTimeline() {
    const seek = (event) => {
      const box = line.getBoundingClientRect();
      pause();
      show(duration * Math.min(Math.max((event.clientX - box.left) / box.width, 0), 1));
    };
    line.addEventListener("pointerdown", (event) => {
      line.setPointerCapture(event.pointerId);
      seek(event);
    });
    line.addEventListener("pointermove", (event) => {
      if (event.buttons & 1) seek(event);
    });
  }

  // ---------------------------------------------------------------- showing an instant

  const { scrub, clock, event: event_, live } = parts;
  let now = 0, watched; // watched: a gap
  const isOf = (gap) => ({ point }) => gapOf(point) === gap;

  /** Shows time t; contacts that were under way since `since` flash, and what is left of flashes before fades to this part. */
  function show(t, since, fading = 1) {
    now = Math.min(Math.max(t, 0), duration);
    glow = glow.map((value) => value * fading);
    const motion = samples.motionAt(now);
    picture.show(motion, now, drawn.pixel);
    const current = underWay(since === undefined ? now : Math.min(since, now), now), tiny = 1e-12 * duration;
    data.points.forEach((point, i) => {
      const those = current.filter((impact) => impact.point === i), hit = those.length > 0;
      const parted = hit && those.every((impact) => impact.end < now - tiny);
      glow[i] = hit ? (parted ? 0.5 : 1) : since === undefined ? 0 : Math.min(glow[i], 0.5 * fading); // what has parted is seen less
      const at = picture.contact(i);
      const mark = drawn.marks[i];
      mark.setAttribute("cx", at.x.toFixed(2));
      mark.setAttribute("cy", at.y.toFixed(2));
      mark.setAttribute("opacity", glow[i].toFixed(3));
      mark.setAttribute("data-contact", hit ? 1 : 0);
      if (hit) drawn.arrows[i].setAttribute("d", arrows(at, current, i));
      drawn.arrows[i].setAttribute("opacity", hit && !parted ? 1 : 0); // no force is left
    });
    const named = underWay(now, now).sort((a, b) => b.force - a.force); // what has ended flashes, and is not named
    const touching = new Set(named.map((impact) => impact.point)), touches = (point) => touching.has(point);
    const struck = new Set(named.filter(({ force }) => !(force > 0)).map((impact) => impact.point)); // at one instant, where the gap is just closed
    drawn.cells.forEach(({ cell, points }) => {
      const open = picture.opening(points[0], motion), told = signed(open.toFixed(decimals));
      cell.textContent = told;
      const inside = told.startsWith("\u2212") && (points[0] >= data.points.length || [...points, ...picture.together[points[0]]].some(touches));
      cell.className = inside || points.some((i) => struck.has(i)) ? "marked" : "";
    });
    orderLive(touching, motion);
    drawn.head.setAttribute("transform", `translate(${(WIDTH * now / duration).toFixed(2)} 0)`);
    scrub.value = now;
    clock.textContent = `t = ${now.toFixed(4)} s`;
    stage.setAttribute("data-time", now);
    const happens = [...named.map(describe), ...picture.inside(motion)];
    const more = happens.length > 3 ? `; + ${happens.length - 3}` : "";
    event_.textContent = happens.slice(0, 3).join("; ") + more;
    const level = picture.levels.length > 0 ? `, ${words.level} ${picture.levels[picture.level]}` : "";
    told(drawn.caption[0], `${clock.textContent}, ${words.magnified.replace("{}", factor())}${level}`);
    told(drawn.isNarrow ? drawn.caption[1] : drawn.caption[1].slice(0, 1), happens.length > 0 ? happens[0] + (happens.length > 1 ? `; + ${happens.length - 1}` : "") : "");
    if (parts.shown) parts.shown(now, since, fading);
  }

  /** Lines below the picture, without the last parts of a text where they have no room for them; beside the picture it is whole. */
  function told(lines, text) {
    const room = drawn.wide - 16 * drawn.pixel, of = `${text} ${room} ${lines.length}`;
    if (lines[0].bentur === of) return;
    lines[0].bentur = of;
    let rest = text.split(", ");
    lines.forEach((line, k) => {
      let count = rest.length;
      const write = () => { line.textContent = rest.slice(0, count).join(", ") + (count === rest.length ? "" : k + 1 < lines.length ? "," : ", …"); };
      for (write(); count > 1 && line.getComputedTextLength() > room; write()) count -= 1;
      rest = rest.slice(count);
    });
  }

  const factor = () => number(Number(magnification.toPrecision(2)));

  /** What the two floors push one another with, as long as the impact's peak force is beside the largest of all, along
   * the normal of the contact. */
  function arrows({ x, y, normal: [across, up] }, current, i) {
    const force = Math.max(0, ...current.filter((impact) => impact.point === i).map((impact) => impact.force));
    if (!(force > 0)) return "";
    const length = (14 + 34 * force / strongest.force) * drawn.pixel, tip = 5 * drawn.pixel;
    const by = (along, beside) => [along * across + beside * up, beside * across - along * up].map((one) => one.toFixed(2)).join(" ");
    return [-1, 1].map((side) => `M${x.toFixed(2)} ${y.toFixed(2)}l${by(side * length, 0)}` +
      `m${by(-side * tip, -tip)}l${by(side * tip, tip)}l${by(-side * tip, tip)}`).join("");
  }

  function describe(impact) {
    const what = impact.force > 0 ? words.peak.replace("{}", `${number(impact.force)} ${data.units.force}`)
      : words.closing_at.replace("{}", `${number(impact.speed)} ${data.units.length}/s`);
    return `${words.impact} ${impact.number}: ${what}, ${picture.where(impact.point)}${impact.slips ? `, ${words.slips}` : ""}`;
  }

  function buildLive() {
    live.replaceChildren();
    drawn.cells = [];
    const { head, rows, many } = picture.live(Boolean(parts.buildingKey));
    drawn.lines = [];
    stage.parentNode.classList.toggle("stacked", head.length > 0);
    stage.parentNode.classList.toggle("many", Boolean(many));
    const line = head.length > 0 ? html("tr", undefined, live) : undefined;
    for (const text of head) html("th", text, line).scope = "col";
    for (const { name, points } of rows) {
      const row = html("tr", undefined, live);
      html("th", name, row).scope = "row";
      for (const those of points) {
        const cell = html("td", "", row);
        if (those.length > 0) drawn.cells.push({ cell, points: those });
      }
      if (many) drawn.lines.push({ row, points: points.flat() });
    }
  }

  const gapOf = (point) => (data.points[point] ? data.points[point].gap ?? data.points[point].left : data.watched[point - data.points.length].left);

  /** Of many pairs those of the gap that is watched come first, then those that touch; what is least open is before
   * others, but that those that are apart keep their places while it plays. */
  function orderLive(touching, motion) {
    const places = drawn.lines.map(({ row, points }) => {
      const rank = points.some((i) => gapOf(i) === watched) ? 0 : points.some((i) => touching.has(i)) ? 1 : 2;
      return { row, rank, open: rank === 2 && playing ? 0 : Math.min(...points.map((i) => picture.opening(i, motion))) };
    });
    places.sort((a, b) => a.rank - b.rank || a.open - b.open).forEach(({ row }, i) => {
      if (live.rows[i] !== row) live.insertBefore(row, live.rows[i]);
    });
  }

  /** The level that is seen at one: its number among the picture's. */
  function choose(level) {
    if (picture.levels.length === 0 || level === picture.level) return;
    picture.choose(level);
    if (parts.level) parts.level.value = level;
    buildLive();
  }

  // ---------------------------------------------------------------- playing

  const { play, speed, slow, magnify, magnified, previous, next, hardest } = parts;
  const SLOW = 1 / 100;
  let playing = false, started = false;
  let until = Infinity; // end of a single impact that is being shown
  let rate = null; // its speed
  let wall = 0;

  /** Model seconds to a second of the clock. */
  function pace() {
    if (rate !== null) return rate;
    const chosen = Number(speed.value);
    if (!slow.checked || chosen <= SLOW) return chosen;
    const near = impacts.some((impact) => {
      const pad = Math.max(2 * (impact.end - impact.start), 2 * data.step);
      return now >= impact.start - pad && now <= impact.end + pad;
    });
    return near ? SLOW : chosen;
  }

  /** The start of the slow motion that comes next, so that no fast step jumps over it. */
  function nextSlow() {
    if (!slow.checked || rate !== null) return Infinity;
    let next = Infinity;
    for (const impact of impacts) {
      const start = impact.start - Math.max(2 * (impact.end - impact.start), 2 * data.step);
      if (start > now && start < next) next = start;
    }
    return next;
  }

  function step(time) {
    if (!playing) return;
    const passed = Math.min((time - wall) / 1000, 0.1); // a page that was out of sight goes on where it was
    wall = time;
    const before = now;
    show(Math.min(now + passed * pace(), nextSlow(), until), before, Math.exp(-passed / 0.15));
    if (now >= duration || now >= until) {
      pause();
      show(now);
      return;
    }
    requestAnimationFrame(step);
  }

  function start() {
    if (playing) return;
    if (!started || now >= duration) show(0);
    started = true;
    playing = true;
    play.textContent = words.pause;
    play.setAttribute("aria-pressed", "true");
    wall = performance.now();
    requestAnimationFrame(step);
  }

  function pause() {
    playing = false;
    until = Infinity;
    rate = null;
    play.textContent = words.play;
    play.setAttribute("aria-pressed", "false");
  }

  /** One impact in slow motion: about four seconds from before it to after it. */
  function showImpact(impact) {
    pause();
    started = true;
    choose(data.points[impact.point].level);
    const length = Math.max(impact.end - impact.start, 4 * data.step);
    show(impact.start - 1.5 * length);
    until = Math.min(impact.end + 1.5 * length, duration);
    rate = length;
    start();
  }

  function jump(direction) {
    pause();
    started = true;
    const tiny = 1e-9 * duration;
    const others = impacts.filter((impact) => direction > 0 ? impact.start > now + tiny : impact.start < now - tiny);
    if (others.length === 0) return;
    const impact = direction > 0 ? others[0] : others[others.length - 1];
    choose(data.points[impact.point].level);
    show(impact.start);
  }

  function buildControls() {
    magnified.textContent = `× ${factor()}`;
    scrub.max = duration;
    scrub.step = data.step;
    for (const button of [hardest, previous, next]) button.disabled = impacts.length === 0;
    if (!parts.level) return;
    parts.level.replaceChildren(...picture.levels.map((name, k) => {
      const option = html("option", name);
      option.value = k;
      return option;
    }));
    parts.level.value = picture.level;
    if (parts.levelChoice) parts.levelChoice.hidden = picture.levels.length < 2;
  }

  function listen() {
    magnify.min = -1.5;
    magnify.max = 1.5;
    magnify.step = 0.01;
    magnify.value = 0;
    magnify.addEventListener("input", () => {
      magnification = usual * Math.pow(10, Number(magnify.value));
      magnified.textContent = `× ${factor()}`;
      frame();
      show(now);
    });
    scrub.addEventListener("input", () => {
      pause();
      started = true;
      show(Number(scrub.value));
    });
    if (parts.level) parts.level.addEventListener("change", () => {
      choose(Number(parts.level.value));
      show(now);
    });
    play.addEventListener("click", () => {
      if (!playing) return start();
      pause();
      show(now); // without flashes of what has ended
    });
    previous.addEventListener("click", () => jump(-1));
    next.addEventListener("click", () => jump(1));
    hardest.addEventListener("click", () => showImpact(strongest));
    listenToTimeline();
    new ResizeObserver(() => { frame(); show(now); }).observe(stage);
  }

  // ---------------------------------------------------------------- for the page

  function build_() {
    read();
    measure();
    build();
    buildTimeline();
    buildLive();
    buildControls();
  }

  build_();
  listen();
  show(data.shown); // what stands still, and is printed

  return {
    get impacts() { return impacts; },
    html,
    number,
    show,
    showImpact,
    start,
    pause,
    isPlaying: () => playing,
    /** What is told of openings begins with that gap; `go`: where nothing plays, its hardest impact is shown. */
    watch(gap, go = false) {
      watched = gap;
      const hardest = impacts.filter(isOf(gap)).sort((a, b) => b.force - a.force || b.speed - a.speed)[0];
      if (go && !playing && hardest) {
        choose(data.points[hardest.point].level);
        show(hardest.force > 0 ? hardest.peak : hardest.start);
      } else show(now);
    },
    /** Another response; the time that is shown stays, and what plays goes on. */
    update(other) {
      data = other;
      words = data.words;
      play.textContent = playing ? words.pause : words.play;
      build_();
      if (until > duration) until = Infinity;
      show(now);
    },
  };
}
