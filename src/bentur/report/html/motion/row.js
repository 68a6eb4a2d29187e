// The picture of buildings in a row, from the side: what motion.js moves. animation.cpp wrote what it draws.

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
 * A picture that motion.js moves; benturPlan() is another. What it is asked comes in this order: build, frame, show.
 * @param data what animation_json() gives @param buildings the same with their samples read
 * @param svg makes an element of the stage @param number writes a number
 * @returns {unit: picture units per length, grain: what is small there, below: room for names [px], key: lines of
 *   {tone, mark, text} that say what marks mean, levels: names of those that can be chosen, none where all are
 *   seen at once (else level, choose(level)), build(stage),
 *   frame(magnification): {left, right, top, bottom} of all that moves, name(pixel): "whole", "short" or "number", by
 *   what the buildings are called, show(motion, time, pixel),
 *   contact(point): {x, y, normal}, opening(point, motion), together: of a point those that touch where it is closed,
 *   where(point), inside(motion): what is inside what it faces, where no contact is modelled, as texts, the deepest first,
 *   live(inShort): {head, rows: of a name and for each column a list of points}}; the numbers of points go on with those
 *   of watched, of which none is a contact
 */
function benturRow(data, buildings, svg, number) {
  "use strict";
  const { scene } = data;
  const breadth = scene.breadths.reduce((sum, one) => sum + one, 0);
  const unit = Math.min(320 / (scene.top - scene.bottom), 620 / breadth);
  const drawn = {};
  let magnification = 1, place;

  const y = (height) => unit * (scene.top - height);

  /** Lines of a shape as the data of a path. */
  function path(lines, place) {
    return lines.map((line) =>
      "M" + line.map((point) => `${(unit * place(point)).toFixed(2)} ${y(point[0]).toFixed(2)}`).join("L")).join("");
  }

  function build(stage) {
    drawn.ghost = svg("path", { class: "ghost" }, stage);
    drawn.shapes = scene.shapes.map(({ role, tone }) => svg("path", { class: `${role} stroke-${tone}` }, stage));
    drawn.inside = data.watched.map(() => svg("path", { class: "inside stroke-red" }, stage));
    drawn.names = buildings.map(({ tone }) => svg("text", { class: `name fill-${tone}`, "text-anchor": "middle" }, stage));
    drawn.dots = data.hinges.dots.map(({ name }) => {
      const dot = svg("rect", { class: "hinge", opacity: 0 }, stage);
      svg("title", {}, dot).textContent = name;
      return dot;
    });
    drawn.crosses = data.breaks.crosses.map(() => svg("path", { class: "break stroke-red", opacity: 0 }, stage));
  }

  const key = data.hinges.levels.map((level) => [level]);
  if (data.breaks.crosses.length > 0) key.push([{ tone: "red", mark: "\u00d7", text: data.breaks.text }]);

  function frame(magnified) {
    magnification = magnified;
    place = benturPlaces(scene, magnification, buildings.map(({ rows }) => new Array(rows).fill(0)));
    const ground = scene.shapes[0].lines[0]; // as wide as all may move
    drawn.left = unit * place(ground[0]);
    drawn.right = unit * place(ground[ground.length - 1]);
    drawn.ghost.setAttribute("d", scene.shapes.filter(({ role }) => role !== "ground" && role !== "soil")
      .map(({ lines }) => path(lines, place)).join(""));
    return { left: drawn.left, right: drawn.right, top: 0, bottom: y(scene.bottom) };
  }

  /** Names below the buildings: whole, else in short, else their numbers, each somewhat smaller where that is enough.
   * @returns which */
  function name(pixel) {
    const least = 0.8; // of the usual size
    const middles = buildings.map((_, b) => unit * (place([0, b, -1, 1, 0, 0]) + scene.breadths[b] / 2));
    const last = buildings.length - 1;
    /** The part of their size at which none touches another one or stands out at the side. */
    const fit = (texts) => {
      const halves = drawn.names.map((line, b) => {
        line.removeAttribute("style");
        line.textContent = texts[b];
        return line.getComputedTextLength() / 2;
      });
      return Math.min((middles[0] - drawn.left) / halves[0], (drawn.right - middles[last]) / halves[last],
        ...middles.slice(1).map((middle, b) => (middle - middles[b] - 5 * pixel) / (halves[b] + halves[b + 1])));
    };
    const ways = { whole: buildings.map((one) => one.name), short: data.names.short, number: buildings.map((_, b) => String(b + 1)) };
    for (const [way, texts] of Object.entries(ways)) {
      const part = fit(texts);
      if (part < least && way !== "number") continue;
      drawn.names.forEach((line, b) => {
        line.setAttribute("x", middles[b]);
        line.setAttribute("y", y(scene.bottom) + 20 * pixel);
        if (part < 1) line.style.fontSize = `calc(${(14 * Math.max(part, 0.6)).toFixed(1)}px * var(--px))`;
      });
      return way;
    }
  }

  function show(motion, now, pixel) {
    place = benturPlaces(scene, magnification, motion);
    scene.shapes.forEach(({ lines }, k) => drawn.shapes[k].setAttribute("d", path(lines, place)));
    data.watched.forEach((one, k) => drawn.inside[k].setAttribute("d", hatches(one, depthOf(one, motion), place)));
    data.hinges.dots.forEach(({ at, reached }, k) => {
      const level = reached.filter((time) => time !== null && time <= now).length;
      const dot = drawn.dots[k];
      const turned = level > 3 ? " rotate(45)" : "";
      dot.setAttribute("transform", `translate(${(unit * place(at)).toFixed(2)} ${y(at[0]).toFixed(2)})${turned}`);
      dot.setAttribute("opacity", level > 0 ? 1 : 0);
      if (dot.getAttribute("data-level") === String(level)) return;
      dot.setAttribute("data-level", level);
      const tone = level > 0 ? data.hinges.levels[level - 1].tone : "ink";
      dot.setAttribute("class", level > 1 ? `hinge fill-${tone} stroke-paper` : `hinge fill-paper stroke-${tone}`);
    });
    data.breaks.crosses.forEach(({ at, time }, k) => {
      const arm = 5 * pixel, left = (unit * place(at) - arm).toFixed(2), top = (y(at[0]) - arm).toFixed(2);
      const across = (2 * arm).toFixed(2);
      drawn.crosses[k].setAttribute("d", `M${left} ${top}l${across} ${across}m0 -${across}l-${across} ${across}`);
      drawn.crosses[k].setAttribute("opacity", time <= now ? 1 : 0);
    });
  }

  const contact = (point) => ({ x: unit * place(scene.contacts[point]), y: y(data.points[point].elevation), normal: [1, 0] });

  /** Of a floor that is watched. */
  const depthOf = ({ width, opening }, motion) => -opening.reduce((open, [b, row, weight]) => open + weight * motion[b][row], width);

  /** A band of hatches where a floor is inside what it faces, as in a still. */
  function hatches({ edge, inwards }, depth, place) {
    if (!(depth > 0)) return "";
    const band = unit * magnification * depth, tall = 0.22 * unit * scene.storey, lean = Math.min(0.25 * band, 0.5 * tall);
    const from = unit * place(edge), lines = 7, at = y(edge[0]);
    return Array.from({ length: lines }, (_, k) => from + inwards * band * k / (lines - 1))
      .map((x) => `M${(x - lean).toFixed(2)} ${(at + tall).toFixed(2)}L${(x + lean).toFixed(2)} ${(at - tall).toFixed(2)}`).join("");
  }

  function inside(motion) {
    return data.watched.map((one) => ({ text: one.text, depth: depthOf(one, motion) })).filter(({ depth }) => depth > 0)
      .sort((a, b) => b.depth - a.depth)
      .map(({ text, depth }) => text.replace("{}", `${number(depth)} ${data.units.length}`));
  }

  function opening(point, motion) {
    if (point >= data.points.length) return -depthOf(data.watched[point - data.points.length], motion);
    const { left, leftFloor, rightFloor, width } = data.points[point];
    return width + motion[left + 1][rightFloor] - motion[left][leftFloor];
  }

  const all = [...data.points, ...data.watched], together = all.map((_, i) => [i]);

  const level = (elevation) => `${number(elevation)} ${data.units.length}`;
  const pair = (gap) => `${buildings[gap].name} | ${buildings[gap + 1].name}`;
  const where = (point) => (scene.gaps.length > 1 ? `${pair(data.points[point].left)}, ` : "") +
    `${data.words.level} ${level(data.points[point].elevation)}`;

  /** What the table of openings holds: a row for each level, a column for each gap; of many gaps a row for each contact
   * point. */
  function live(inShort) {
    const called = inShort ? data.names.short : buildings.map((one) => one.name);
    const between = (gap) => `${called[gap]} | ${called[gap + 1]}`;
    const besides = (points) => (points.every((i) => i >= data.points.length) ? `, ${data.words.not_modelled}` : "");
    const most = 6;
    if (scene.gaps.length > most) {
      const of = ({ left, elevation }) => `${between(left)}, ${level(elevation)}`;
      return { head: [], rows: all.map((point, i) => ({ name: of(point) + besides([i]), points: [[i]] })), many: true };
    }
    const levels = Array.from(new Set(all.map((point) => point.elevation))).sort((a, b) => b - a);
    const names = scene.gaps.map((_, gap) => between(gap));
    return {
      head: names.length > 1 ? [data.words.level, ...names] : [],
      rows: levels.map((elevation) => {
        const points = scene.gaps.map((_, gap) =>
          all.flatMap((p, i) => (p.left === gap && p.elevation === elevation ? [i] : [])));
        return { name: level(elevation) + besides(points.flat()), points };
      }),
    };
  }

  return { unit, grain: unit * scene.storey, below: 22, key, levels: [], build, frame, name, show, contact, opening, together, where, inside, live };
}
