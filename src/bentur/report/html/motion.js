// The buildings in motion: of a report and of the studio alike. It draws what animation.cpp wrote, into elements that the
// page gives it, and listens to them. Text reaches the page by textContent, never as markup.

/**
 * Where the points of a scene (report/scene/scene.h) are at a magnification: a function of a point that gives its x. A
 * point is [height, then of each of its movers: building, row or -1, weight, offset, apart].
 * @param motion displacements by building and row
 */
function benturPlaces(scene, magnification, motion) {
  "use strict";
  const faces = [0];
  scene.gaps.forEach((gap, b) => faces.push(faces[b] + scene.breadths[b] + magnification * gap));
  return (point) => {
    let x = 0;
    for (let k = 1; k < point.length; k += 5) {
      const [b, row] = [point[k], point[k + 1]];
      x += point[k + 2] * (faces[b] + point[k + 3] + magnification * (point[k + 4] + (row < 0 ? 0 : motion[b][row])));
    }
    return x;
  };
}

/**
 * @param parts elements: stage and timeline (SVG), scrub, clock, event, live (tbody), play, previous, next, hardest, speed,
 *   slow, magnify, magnified; where there are such, timeAxis (the times below the time line) and buildingKey (shown where the
 *   drawing has numbers for names); `steady`: the stage keeps its height; `shown`, where there is one, is told of every
 *   time that is shown [s], as show() is.
 * @param data what animation_json() gives
 * @returns {impacts, html(name, text, parent), number, update(data), show(time, since, fading), showImpact(impact), start(), pause(), isPlaying()}
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

  // ---------------------------------------------------------------- samples

  /** int16 samples, little endian in base64, floors and then struck columns of one instant side by side. */
  function decode(text) {
    const bytes = atob(text);
    const view = new DataView(new ArrayBuffer(bytes.length));
    for (let i = 0; i < bytes.length; ++i) view.setUint8(i, bytes.charCodeAt(i));
    const values = new Int16Array(bytes.length / 2);
    for (let i = 0; i < values.length; ++i) values[i] = view.getInt16(2 * i, true);
    return values;
  }

  let buildings, scene, impacts, strongest, duration, frames;

  function read() {
    scene = data.scene;
    buildings = data.buildings.map((given) => ({ ...given, samples: decode(given.samples), keys: decode(given.keys) }));
    // [point, start, end, peak force, time of it, closing speed], by start
    impacts = data.impacts.map(([point, start, end, force, peak, speed, number]) =>
      ({ point, start, end, force, peak, speed, number }));
    strongest = impacts.length === 0 ? null : impacts.reduce((most, impact) =>
      (impact.force > most.force || (impact.force === most.force && impact.speed > most.speed) ? impact : most));
    duration = data.duration;
    join();
  }

  /** Joins even samples and the exact starts, peaks and ends of impacts (data.keys) into one row of instants. */
  function join() {
    const keys = data.keys;
    const count = buildings[0].samples.length / buildings[0].rows;
    frames = [];
    let key = 0;
    for (let k = 0; k < count; ++k) {
      const time = k * data.step;
      for (; key < keys.length && keys[key] < time - 1e-9 * duration; ++key) frames.push({ time: keys[key], key });
      if (key < keys.length && Math.abs(keys[key] - time) <= 1e-9 * duration) ++key;
      frames.push({ time, sample: k });
    }
    for (; key < keys.length; ++key) frames.push({ time: keys[key], key });
    for (const building of buildings) {
      const rows = building.rows;
      building.values = new Int16Array(frames.length * rows);
      frames.forEach((one, k) => {
        const from = one.key === undefined ? building.samples : building.keys;
        const place = (one.key === undefined ? one.sample : one.key) * rows;
        for (let row = 0; row < rows; ++row) building.values[k * rows + row] = from[place + row];
      });
    }
  }

  /** Number of the last frame at or before t. */
  function frameAt(t) {
    let low = 0, high = frames.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (frames[middle].time <= t) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  /** Displacement of a floor or of a struck column at time t: cubic between frames, with slopes from their neighbours. */
  function displacement(building, floor, t) {
    const rows = building.rows;
    const last = frames.length - 1;
    const frame = Math.min(frameAt(t), Math.max(last - 1, 0));
    const place = (k) => Math.min(Math.max(k, 0), last);
    const value = (k) => building.values[place(k) * rows + floor];
    const time = (k) => frames[place(k)].time;
    const length = time(frame + 1) - time(frame);
    const s = length > 0 ? Math.min(Math.max((t - time(frame)) / length, 0), 1) : 0;
    const before = value(frame - 1), here = value(frame), next = value(frame + 1), after = value(frame + 2);
    const rate = (a, b, change) => (b > a ? change * length / (b - a) : 0);
    const slope = rate(time(frame - 1), time(frame + 1), next - before);
    const turn = rate(time(frame), time(frame + 2), after - here);
    const change = next - here;
    return building.scale *
      (here + s * (slope + s * (3 * change - 2 * slope - turn + s * (slope + turn - 2 * change))));
  }

  /** Displacements of all buildings at time t. */
  function motionAt(t) {
    return buildings.map((building) => Array.from({ length: building.rows }, (_, row) => displacement(building, row, t)));
  }

  function opening(point, motion) {
    return point.width + motion[point.left + 1][point.rightFloor] - motion[point.left][point.leftFloor];
  }

  /** Impacts under way at some time of [from, to], but for rounding. */
  function underWay(from, to) {
    const tiny = 1e-12 * duration;
    return impacts.filter((impact) => impact.start <= to + tiny && impact.end >= from - tiny);
  }

  // ---------------------------------------------------------------- the picture

  const { stage } = parts;
  let framed = 0; // width of the page that the height of the drawing is for
  let decimals, unit, magnification, usual, drawn, glow;

  /** Everything that the picture takes from the response. */
  function measure() {
    // As many for all: the largest movement has four digits.
    const largest = Math.max(scene.largest, 1e-300, ...scene.gaps);
    decimals = Math.min(9, Math.max(0, 3 - Math.floor(Math.log10(largest))));
    const breadth = scene.breadths.reduce((sum, one) => sum + one, 0);
    unit = Math.min(320 / (scene.top - scene.bottom), 620 / breadth); // picture units per length
    const before = usual, wanted = scene.magnification;
    // What is drawn again while a gap is changed keeps its magnification unless that no longer fits.
    if (usual === undefined || wanted < usual / 2.4 || wanted > usual * 2.4) usual = wanted;
    magnification = before === undefined ? usual : magnification * usual / before;
    drawn = { marks: [], arrows: [], cells: [] };
    glow = data.points.map(() => 0);
  }

  const y = (height) => unit * (scene.top - height);

  /** Lines of a shape as the data of a path. */
  function path(lines, place) {
    return lines.map((line) =>
      "M" + line.map((point) => `${(unit * place(point)).toFixed(2)} ${y(point[0]).toFixed(2)}`).join("L")).join("");
  }

  function build() {
    stage.replaceChildren();
    stage.classList.add("bentur");
    const gradient = svg("radialGradient", { id: "glow" }, svg("defs", {}, stage));
    svg("stop", { offset: "0%", "stop-color": "var(--red)", "stop-opacity": "1" }, gradient);
    svg("stop", { offset: "45%", "stop-color": "var(--red)", "stop-opacity": "0.75" }, gradient);
    svg("stop", { offset: "100%", "stop-color": "var(--red)", "stop-opacity": "0" }, gradient);
    drawn.ghost = svg("path", { class: "ghost" }, stage);
    drawn.shapes = scene.shapes.map(({ role, tone }) => svg("path", { class: `${role} stroke-${tone}` }, stage));
    drawn.names = buildings.map(({ tone }) => svg("text", { class: `name fill-${tone}`, "text-anchor": "middle" }, stage));
    drawn.caption = ["ink", "red"].map((tone) => svg("text", { class: `caption fill-${tone}` }, stage));
    drawn.dots = data.hinges.dots.map(({ name }) => {
      const dot = svg("circle", { class: "hinge", opacity: 0 }, stage);
      svg("title", {}, dot).textContent = name;
      return dot;
    });
    drawn.key = data.hinges.levels.map(({ tone, text }, level) => {
      const line = svg("text", { class: "caption fill-ink" }, stage);
      svg("tspan", { class: `fill-${tone}` }, line).textContent = level === 0 ? "\u25cb" : "\u25cf";
      svg("tspan", {}, line).textContent = ` ${text}`;
      return line;
    });
    drawn.crosses = data.breaks.crosses.map(() => svg("path", { class: "break stroke-red", opacity: 0 }, stage));
    if (drawn.crosses.length > 0) {
      const line = svg("text", { class: "caption fill-ink" }, stage);
      svg("tspan", { class: "fill-red" }, line).textContent = "\u00d7";
      svg("tspan", {}, line).textContent = ` ${data.breaks.text}`;
      drawn.key.push(line);
    }
    data.points.forEach((point, i) => {
      drawn.marks.push(svg("circle", { class: "hit", fill: "url(#glow)", opacity: 0, "data-point": i,
        "data-contact": 0 }, stage));
      drawn.arrows.push(svg("path", { class: "force stroke-red", opacity: 0 }, stage));
    });
    frame();
  }

  /** Everything that depends on the magnification but not on time. */
  function frame() {
    const place = benturPlaces(scene, magnification, buildings.map(({ rows }) => new Array(rows).fill(0)));
    const ground = scene.shapes[0].lines[0]; // as wide as all may move
    const left = unit * place(ground[0]), right = unit * place(ground[ground.length - 1]), wide = right - left;
    const base = y(scene.bottom), below = 92 + 17 * drawn.key.length; // of names, caption and what dots mean
    // Lines and names keep their size on a narrow page, and most of it on a low one.
    const low = 0.7 * base / Math.max(parseFloat(getComputedStyle(stage).maxHeight) - 0.7 * below, below);
    const pixel = Math.max(1, wide / Math.max(stage.clientWidth, 1), low || 0);
    const storey = unit * scene.storey / pixel, tall = base + below * pixel;
    drawn.pixel = pixel;
    stage.style.setProperty("--px", pixel.toFixed(3));
    stage.style.setProperty("--slab", `${Math.min(5, 0.35 * storey).toFixed(2)}px`);
    stage.style.setProperty("--dot", `${Math.min(4.5, Math.max(1.8, 0.11 * storey)).toFixed(2)}px`);
    stage.style.setProperty("--flash", `${Math.min(24, Math.max(10, 1.2 * storey)).toFixed(2)}px`);
    stage.setAttribute("viewBox", `${left} ${-24 * pixel} ${wide} ${tall}`);
    drawn.ghost.setAttribute("d", scene.shapes.filter(({ role }) => role !== "ground" && role !== "soil")
      .map(({ lines }) => path(lines, place)).join(""));
    drawn.names.forEach((name, b) => {
      name.setAttribute("x", unit * (place([0, b, -1, 1, 0, 0]) + scene.breadths[b] / 2));
      name.setAttribute("y", base + 20 * pixel);
    });
    drawn.caption.forEach((line, k) => {
      line.setAttribute("x", left + 8 * pixel);
      line.setAttribute("y", base + (42 + 17 * k) * pixel);
    });
    drawn.key.forEach((line, k) => {
      line.setAttribute("x", left + 8 * pixel);
      line.setAttribute("y", base + (76 + 17 * k) * pixel);
    });
    nameBuildings(left, right);
    if (parts.steady && stage.clientWidth !== framed) { // the page does not jump when the magnification changes
      framed = stage.clientWidth;
      stage.style.height = `${Math.round(Math.min(framed * tall / wide, 454))}px`;
    }
  }

  /** Names below the buildings, or their numbers where names do not fit; the key below the drawing tells them. */
  function nameBuildings(left, right) {
    let end = left;
    let fit = true;
    drawn.names.forEach((name, b) => {
      name.textContent = buildings[b].name;
      const half = name.getComputedTextLength() / 2;
      const middle = Number(name.getAttribute("x"));
      fit = fit && middle - half >= end && middle + half <= right;
      end = middle + half + 4;
    });
    if (!fit) drawn.names.forEach((name, b) => { name.textContent = String(b + 1); });
    if (parts.buildingKey) parts.buildingKey.hidden = fit && buildings.length < 3;
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
    buildings.forEach((building) => {
      const frames = building.samples.length / building.rows;
      const bins = Math.min(WIDTH, frames);
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
  let now = 0;

  /** Shows time t; contacts that were under way since `since` flash, and what is left of flashes before fades to this part. */
  function show(t, since, fading = 1) {
    now = Math.min(Math.max(t, 0), duration);
    glow = glow.map((value) => value * fading);
    const motion = motionAt(now), place = benturPlaces(scene, magnification, motion);
    scene.shapes.forEach(({ lines }, k) => drawn.shapes[k].setAttribute("d", path(lines, place)));
    data.hinges.dots.forEach(({ at, reached }, k) => {
      const level = reached.filter((time) => time !== null && time <= now).length;
      const dot = drawn.dots[k];
      dot.setAttribute("cx", (unit * place(at)).toFixed(2));
      dot.setAttribute("cy", y(at[0]).toFixed(2));
      dot.setAttribute("opacity", level > 0 ? 1 : 0);
      if (dot.getAttribute("data-level") === String(level)) return;
      dot.setAttribute("data-level", level);
      const tone = level > 0 ? data.hinges.levels[level - 1].tone : "ink";
      dot.setAttribute("class", level > 1 ? `hinge fill-${tone} stroke-paper` : `hinge fill-paper stroke-${tone}`);
    });
    data.breaks.crosses.forEach(({ at, time }, k) => {
      const arm = 5 * drawn.pixel, left = (unit * place(at) - arm).toFixed(2), top = (y(at[0]) - arm).toFixed(2);
      const across = (2 * arm).toFixed(2);
      drawn.crosses[k].setAttribute("d", `M${left} ${top}l${across} ${across}m0 -${across}l-${across} ${across}`);
      drawn.crosses[k].setAttribute("opacity", time <= now ? 1 : 0);
    });
    const current = underWay(since === undefined ? now : Math.min(since, now), now);
    data.points.forEach((point, i) => {
      const hit = current.some((impact) => impact.point === i);
      glow[i] = hit ? 1 : since === undefined ? 0 : glow[i];
      const x = unit * place(scene.contacts[i]);
      const mark = drawn.marks[i];
      mark.setAttribute("cx", x.toFixed(2));
      mark.setAttribute("cy", y(point.elevation).toFixed(2));
      mark.setAttribute("opacity", glow[i].toFixed(3));
      mark.setAttribute("data-contact", hit ? 1 : 0);
      if (hit) drawn.arrows[i].setAttribute("d", arrows(x, y(point.elevation), current, i));
      drawn.arrows[i].setAttribute("opacity", glow[i].toFixed(3));
      drawn.cells[i].textContent = signed(opening(point, motion).toFixed(decimals));
      drawn.cells[i].className = hit ? "marked" : "";
    });
    drawn.head.setAttribute("transform", `translate(${(WIDTH * now / duration).toFixed(2)} 0)`);
    scrub.value = now;
    clock.textContent = `t = ${now.toFixed(4)} s`;
    stage.setAttribute("data-time", now);
    current.sort((a, b) => b.force - a.force);
    const more = current.length > 3 ? `; + ${current.length - 3}` : "";
    event_.textContent = current.slice(0, 3).map(describe).join("; ") + more;
    drawn.caption[0].textContent = `${clock.textContent}, ${words.magnified.replace("{}", factor())}`;
    drawn.caption[1].textContent = current.length > 0 ? describe(current[0]) + (current.length > 1 ? `; + ${current.length - 1}` : "") : "";
    if (parts.shown) parts.shown(now, since, fading);
  }

  const factor = () => number(Number(magnification.toPrecision(2)));

  /** What the two floors push one another with, as long as the impact's peak force is beside the largest of all. */
  function arrows(x, height_, current, i) {
    const force = Math.max(0, ...current.filter((impact) => impact.point === i).map((impact) => impact.force));
    if (!(force > 0)) return "";
    const length = (14 + 34 * force / strongest.force) * drawn.pixel, tip = 5 * drawn.pixel;
    return [-1, 1].map((side) => `M${x.toFixed(2)} ${height_.toFixed(2)}h${(side * length).toFixed(2)}` +
      `m${(-side * tip).toFixed(2)} ${(-tip).toFixed(2)}l${(side * tip).toFixed(2)} ${tip.toFixed(2)}` +
      `l${(-side * tip).toFixed(2)} ${tip.toFixed(2)}`).join("");
  }

  function describe(impact) {
    const what = impact.force > 0 ? `${number(impact.force)} ${data.units.force}`
      : `${number(impact.speed)} ${data.units.length}/s`;
    return `${words.impact} ${impact.number}: ${what}, ${words.level} ` +
      `${number(data.points[impact.point].elevation)} ${data.units.length}`;
  }

  function buildLive() {
    live.replaceChildren();
    stage.parentNode.classList.toggle("stacked", scene.gaps.length > 1);
    if (scene.gaps.length > 1) {
      const head = html("tr", undefined, live);
      html("th", words.level, head).scope = "col";
      scene.gaps.forEach((_, gap) => {
        const names = `${buildings[gap].name} | ${buildings[gap + 1].name}`;
        html("th", parts.buildingKey ? `${gap + 1} | ${gap + 2}` : names, head).scope = "col";
      });
    }
    const levels = Array.from(new Set(data.points.map((point) => point.elevation))).sort((a, b) => b - a);
    for (const level of levels) {
      const row = html("tr", undefined, live);
      html("th", `${number(level)} ${data.units.length}`, row).scope = "row";
      scene.gaps.forEach((_, gap) => {
        const cell = html("td", "", row);
        const point = data.points.findIndex((p) => p.left === gap && p.elevation === level);
        if (point >= 0) drawn.cells[point] = cell;
      });
    }
  }

  // ---------------------------------------------------------------- playing

  const { play, speed, slow, magnify, magnified, previous, next, hardest } = parts;
  const SLOW = 1 / 100;
  let playing = false;
  let started = false;
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
    if (others.length > 0) show((direction > 0 ? others[0] : others[others.length - 1]).start);
  }

  function buildControls() {
    magnified.textContent = `× ${factor()}`;
    scrub.max = duration;
    scrub.step = data.step;
    for (const button of [hardest, previous, next]) button.disabled = impacts.length === 0;
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
    play.addEventListener("click", () => (playing ? pause() : start()));
    previous.addEventListener("click", () => jump(-1));
    next.addEventListener("click", () => jump(1));
    hardest.addEventListener("click", () => showImpact(strongest));
    listenToTimeline();
    new ResizeObserver(frame).observe(stage);
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
