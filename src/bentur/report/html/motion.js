// The buildings in motion: of a report and of the studio alike. It draws what animation.cpp wrote, into elements that the
// page gives it, and listens to them. Text reaches the page by textContent, never as markup.

/**
 * @param parts elements: stage and timeline (SVG), scrub, clock, event, live (tbody), play, previous, next, hardest, speed,
 *   slow, magnify, magnified; where there are such, timeAxis (the times below the time line), buildingKey (shown where the
 *   drawing has numbers for names) and scaleNote (is told the magnification); `shown`, where there is one, is told of every
 *   time that is shown [s], as show() is.
 * @param data what animation_json() gives
 * @returns {impacts, html(name, text, parent), number, update(data), show(time, since, fading), showImpact(impact), start(), pause(), isPlaying()}
 */
function benturMotion(parts, data) {
  "use strict";
  let words = data.words;
  const SVG = "http://www.w3.org/2000/svg";
  const COLOURS = ["#1c2024", "#b4540a", "#1f5fa8", "#5f6b76", "#3d6b20", "#7d4a9c"]; // those of the figures

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

  let buildings, impacts, strongest, duration, frames;

  function read() {
    buildings = data.buildings.map((given) => ({
      name: given.name,
      elevations: given.elevations,
      base: given.base,
      bays: given.bays,
      rigid: given.rigid,
      nodes: given.nodes, // where columns are struck between floors, counted after the floors
      rows: given.elevations.length + given.nodes.length,
      width: given.bays.reduce((sum, bay) => sum + bay, 0),
      scale: given.scale,
      samples: decode(given.samples),
      keys: decode(given.keys),
    }));
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

  function opening(point, t) {
    const left = displacement(buildings[point.left], point.leftFloor, t);
    const right = displacement(buildings[point.left + 1], point.rightFloor, t);
    return point.width + right - left;
  }

  /** Impacts under way at some time of [from, to], but for rounding. */
  function underWay(from, to) {
    const tiny = 1e-12 * duration;
    return impacts.filter((impact) => impact.start <= to + tiny && impact.end >= from - tiny);
  }

  // ---------------------------------------------------------------- the picture

  const { stage } = parts;
  let framed = 0; // width of the page that the height of the drawing is for
  let top_, bottom, largest, gaps, decimals, height, lowest, unit, magnification, usual, drawn, glow;

  /** Everything that the picture takes from the response. */
  function measure() {
    top_ = Math.max(...buildings.map((b) => b.elevations[b.elevations.length - 1]));
    const foot = Math.min(...buildings.map((b) => b.base));
    const sunk = buildings.some((b) => b.rigid || b.base === b.elevations[0]); // walls and slabs reach below the foot
    bottom = foot - (sunk ? 0.06 * Math.max(top_ - foot, 1e-300) : 0);
    largest = Math.max(1e-300, ...buildings.map((b) => {
      let most = 0;
      for (const sample of b.samples) most = Math.max(most, Math.abs(sample));
      return b.scale * most;
    }));
    height = top_ - bottom;
    gaps = data.widths.map(drawable);
    // As many for all: the largest movement has four digits.
    decimals = Math.min(9, Math.max(0, 3 - Math.floor(Math.log10(Math.max(largest, ...gaps)))));
    const storeys = buildings.flatMap((b) => b.elevations
      .map((elevation, floor) => elevation - (floor > 0 ? b.elevations[floor - 1] : b.base))
      .filter((storey) => !b.rigid && storey > 0)); // a slab has none
    lowest = storeys.length > 0 ? Math.min(...storeys) : height;
    const breadth = buildings.reduce((sum, b) => sum + b.width, 0);
    unit = Math.min(320 / height, 620 / breadth); // picture units per length
    const gapsTogether = gaps.reduce((sum, gap) => sum + gap, 0);
    const fits = Math.min(0.09 * height / largest, gapsTogether > 0 ? 0.5 * breadth / gapsTogether : Infinity);
    const wanted = round125(Math.max(fits, 1e-6));
    const before = usual;
    // What is drawn again while a gap is changed keeps its magnification unless that no longer fits.
    if (usual === undefined || wanted < usual / 2.4 || wanted > usual * 2.4) usual = wanted;
    magnification = before === undefined ? usual : magnification * usual / before;
    drawn = { ghosts: [], columns: [], slabs: [], marks: [], arrows: [], cells: [] };
    glow = data.points.map(() => 0);
  }

  /** A magnification that people can say: 1, 2 or 5 times a power of ten. */
  function round125(value) {
    const power = Math.pow(10, Math.floor(Math.log10(value)));
    const digit = value / power;
    return power * (digit < 1.5 ? 1 : digit < 3.5 ? 2 : digit < 7.5 ? 5 : 10);
  }

  /** The same building has one colour everywhere; a page may choose others. */
  const colour = (b) => `var(--building-${b % COLOURS.length + 1}, ${COLOURS[b % COLOURS.length]})`;

  /** A gap as wide as a picture can hold: beyond a thousand heights there is no number for it in SVG sooner or later. */
  function drawable(gap) { return Math.min(gap, 1e3 * height); }

  /** Picture x of a building's left face, with gaps magnified like the motion, so that touching looks like touching. */
  function leftFace(index) {
    let x = 0;
    for (let b = 0; b < index; ++b) x += unit * (buildings[b].width + magnification * gaps[b]);
    return x;
  }

  const y = (elevation) => unit * (top_ - elevation);

  function build() {
    stage.replaceChildren();
    const defs = svg("defs", {}, stage);
    const gradient = svg("radialGradient", { id: "glow" }, defs);
    svg("stop", { offset: "0%", "stop-color": "#ff1f1f", "stop-opacity": "1" }, gradient);
    svg("stop", { offset: "45%", "stop-color": "#ff2a1f", "stop-opacity": "0.75" }, gradient);
    svg("stop", { offset: "100%", "stop-color": "#ff4b1f", "stop-opacity": "0" }, gradient);
    drawn.ground = svg("path", { class: "ground" }, stage);
    buildings.forEach((building, b) => {
      drawn.ghosts.push(svg("path", { class: "ghost" }, stage));
      drawn.columns.push(svg("path", { class: "column" }, stage));
      drawn.slabs.push(svg("path", { class: "slab" }, stage));
      drawn.columns[b].style.stroke = drawn.slabs[b].style.stroke = colour(b);
      const label = svg("text", { class: "name", "text-anchor": "middle" }, stage);
      label.style.fill = colour(b);
      label.textContent = building.name;
      building.label = label;
    });
    data.points.forEach((point, i) => {
      drawn.marks.push(svg("circle", { class: "hit", fill: "url(#glow)", opacity: 0, "data-point": i,
        "data-contact": 0 }, stage));
      drawn.arrows.push(svg("path", { class: "force", opacity: 0 }, stage));
    });
    frame();
  }

  /** Everything that depends on the magnification but not on time. */
  function frame() {
    const room = unit * magnification * largest + 30;
    const right = leftFace(buildings.length - 1) + unit * buildings[buildings.length - 1].width;
    const wide = right + 2 * room;
    const pixel = Math.max(1, wide / Math.max(stage.clientWidth, 1)); // lines and names keep their size on a narrow page
    const storey = unit * lowest / pixel;
    drawn.pixel = pixel;
    stage.style.setProperty("--px", pixel.toFixed(3));
    stage.style.setProperty("--slab", `${Math.min(5, 0.35 * storey).toFixed(2)}px`);
    stage.style.setProperty("--flash", `${Math.min(24, Math.max(10, 1.2 * storey)).toFixed(2)}px`);
    stage.setAttribute("viewBox", `${-room} ${-24 * pixel} ${wide} ${unit * height + 54 * pixel}`);
    const base = y(bottom);
    drawn.ground.setAttribute("d", `M${-room} ${base}H${right + room}`);
    buildings.forEach((building, b) => {
      building.label.setAttribute("x", leftFace(b) + unit * building.width / 2);
      building.label.setAttribute("y", base + 20 * pixel);
      const zero = new Array(building.rows).fill(0);
      const shape = outline(building, b, zero);
      drawn.ghosts[b].setAttribute("d", shape.columns + shape.slabs);
    });
    nameBuildings(-room, right + room);
    if (stage.clientWidth !== framed) { // the page does not jump when the magnification changes
      framed = stage.clientWidth;
      const ratio = (unit * height + 54 * pixel) / wide;
      if (parts.scaleNote) stage.style.height = `${Math.round(Math.min(framed * ratio, 416))}px`;
    }
    const factor = number(Number(magnification.toPrecision(2)));
    if (parts.scaleNote) parts.scaleNote.textContent = words.scale.replace("{factor}", factor);
  }

  /** Names below the buildings, or their numbers where names do not fit; the key below the drawing tells them. */
  function nameBuildings(left, right) {
    let end = left;
    let fit = true;
    buildings.forEach((building, b) => {
      building.label.textContent = building.name;
      const half = building.label.getComputedTextLength() / 2;
      const middle = Number(building.label.getAttribute("x"));
      fit = fit && middle - half >= end && middle + half <= right;
      end = middle + half + 4;
    });
    if (!fit) buildings.forEach((building, b) => { building.label.textContent = String(b + 1); });
    if (parts.buildingKey) parts.buildingKey.hidden = fit && buildings.length < 3;
  }

  /** Columns and floors of a building whose floors are displaced by `x`. */
  function outline(building, b, x) {
    const left = leftFace(b);
    const shift = x.map((value) => unit * magnification * value);
    if (building.rigid) { // from the ground up
      const right = left + unit * building.width, top = y(building.elevations[building.elevations.length - 1]);
      return { columns: `M${left.toFixed(2)} ${y(bottom).toFixed(2)}V${top.toFixed(2)}H${right.toFixed(2)}` +
        `V${y(bottom).toFixed(2)}Z`, slabs: "" };
    }
    // Bearings lean between the ground and the slab above them.
    const foot = building.base === building.elevations[0] ? bottom : building.base;
    let columns = "";
    let line = left;
    for (let bay = 0; bay <= building.bays.length; ++bay) {
      columns += `M${line.toFixed(2)} ${y(foot).toFixed(2)}`;
      const places = building.elevations.map((elevation, floor) => [elevation, shift[floor]]);
      building.nodes.forEach((node, n) => { // it bends where it is struck
        if (bay !== (node.left ? 0 : building.bays.length)) return;
        places.push([node.elevation, shift[building.elevations.length + n]]);
      });
      places.sort((a, b) => a[0] - b[0]);
      for (const [elevation, by] of places) columns += `L${(line + by).toFixed(2)} ${y(elevation).toFixed(2)}`;
      line += unit * (building.bays[bay] || 0);
    }
    let slabs = "";
    building.elevations.forEach((elevation, floor) => {
      // A level with a wider gap than the narrowest one of its joint stands back by the difference.
      const joint = data.points.find((point) => point.left === b - 1 && point.rightFloor === floor);
      const back = joint ? unit * magnification * (drawable(joint.width) - gaps[b - 1]) : 0;
      slabs += `M${(left + shift[floor] + back).toFixed(2)} ${y(elevation).toFixed(2)}` +
        `H${(left + shift[floor] + unit * building.width).toFixed(2)}`;
    });
    return { columns, slabs };
  }

  // ---------------------------------------------------------------- the time line

  const line = parts.timeline;
  const WIDTH = 1000, HEIGHT = 130, MIDDLE = 52, SPAN = 44;

  function buildTimeline() {
    line.replaceChildren();
    line.setAttribute("viewBox", `0 0 ${WIDTH} ${HEIGHT}`);
    line.setAttribute("preserveAspectRatio", "none");
    svg("path", { class: "axis", d: `M0 ${MIDDLE}H${WIDTH}` }, line);
    buildings.forEach((building, b) => {
      const floors = building.elevations.length;
      const frames = building.samples.length / building.rows;
      const bins = Math.min(WIDTH, frames);
      let path = "";
      for (let bin = 0; bin < bins; ++bin) { // smallest and largest of each bin, so that no peak is lost
        let low = Infinity, high = -Infinity;
        const end = Math.max(Math.floor((bin + 1) * frames / bins), Math.floor(bin * frames / bins) + 1);
        for (let k = Math.floor(bin * frames / bins); k < end; ++k) {
          const value = building.samples[k * building.rows + floors - 1] * building.scale / largest;
          low = Math.min(low, value);
          high = Math.max(high, value);
        }
        const x = (bin + 0.5) * WIDTH / bins;
        path += `${bin ? "L" : "M"}${x.toFixed(1)} ${(MIDDLE - SPAN * low).toFixed(1)}` +
          `L${x.toFixed(1)} ${(MIDDLE - SPAN * high).toFixed(1)}`;
      }
      svg("path", { class: "roof", d: path }, line).style.stroke = colour(b);
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
    buildings.forEach((building, b) => {
      const x = Array.from({ length: building.rows }, (_, floor) => displacement(building, floor, now));
      const shape = outline(building, b, x);
      drawn.columns[b].setAttribute("d", shape.columns);
      drawn.slabs[b].setAttribute("d", shape.slabs);
    });
    const current = underWay(since === undefined ? now : Math.min(since, now), now);
    data.points.forEach((point, i) => {
      const hit = current.some((impact) => impact.point === i);
      glow[i] = hit ? 1 : since === undefined ? 0 : glow[i];
      const left = buildings[point.left];
      const x = leftFace(point.left) + unit * left.width +
        unit * magnification * displacement(left, point.leftFloor, now);
      const mark = drawn.marks[i];
      mark.setAttribute("cx", x.toFixed(2));
      mark.setAttribute("cy", y(point.elevation).toFixed(2));
      mark.setAttribute("opacity", glow[i].toFixed(3));
      mark.setAttribute("data-contact", hit ? 1 : 0);
      if (hit) drawn.arrows[i].setAttribute("d", arrows(x, y(point.elevation), current, i));
      drawn.arrows[i].setAttribute("opacity", glow[i].toFixed(3));
      drawn.cells[i].textContent = signed(opening(point, now).toFixed(decimals));
      drawn.cells[i].className = hit ? "marked" : "";
    });
    drawn.head.setAttribute("transform", `translate(${(WIDTH * now / duration).toFixed(2)} 0)`);
    scrub.value = now;
    clock.textContent = `t = ${now.toFixed(4)} s`;
    stage.setAttribute("data-time", now);
    current.sort((a, b) => b.force - a.force);
    const more = current.length > 3 ? `; + ${current.length - 3}` : "";
    event_.textContent = current.slice(0, 3).map(describe).join("; ") + more;
    if (parts.shown) parts.shown(now, since, fading);
  }

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
    stage.parentNode.classList.toggle("stacked", gaps.length > 1);
    if (gaps.length > 1) {
      const head = html("tr", undefined, live);
      html("th", words.level, head).scope = "col";
      gaps.forEach((_, gap) => {
        const names = `${buildings[gap].name} | ${buildings[gap + 1].name}`;
        html("th", parts.buildingKey ? `${gap + 1} | ${gap + 2}` : names, head).scope = "col";
      });
    }
    const levels = Array.from(new Set(data.points.map((point) => point.elevation))).sort((a, b) => b - a);
    for (const level of levels) {
      const row = html("tr", undefined, live);
      html("th", `${number(level)} ${data.units.length}`, row).scope = "row";
      gaps.forEach((_, gap) => {
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

  function tellMagnified() {
    magnified.textContent = `× ${number(Number(magnification.toPrecision(2)))}`;
  }

  function buildControls() {
    tellMagnified();
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
      tellMagnified();
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
  // What stands still, and is printed: the hardest impact, else the start.
  show(strongest === null ? 0 : strongest.force > 0 ? strongest.peak : strongest.start);

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
