// The picture of buildings from above: what motion.js moves where they stand in plan. plan_animation.cpp wrote what it
// draws.

/**
 * Where the points of a PlanScene are drawn at a magnification: a function of a building, its floor and a point [x, y,
 * spread along x, along y] that gives x and y.
 * @param motion by building u_x, u_y and θ · arm of each floor; nothing of a building: it is at rest
 */
function benturPlanPlaces(scene, magnification, motion) {
  "use strict";
  return (b, floor, [x, y, spreadX, spreadY]) => {
    const [moveX, moveY] = benturPlanMovement(scene, motion, b, floor, x, y);
    return [x + (magnification - 1) * spreadX + magnification * moveX, y + (magnification - 1) * spreadY + magnification * moveY];
  };
}

/** How a point of the plan moves with a floor (P-1). */
function benturPlanMovement(scene, motion, b, floor, x, y) {
  "use strict";
  if (motion[b].length === 0) return [0, 0];
  const [centreX, centreY] = scene.centres[b][floor];
  const turn = motion[b][3 * floor + 2] / scene.arm;
  return [motion[b][3 * floor] - turn * (y - centreY), motion[b][3 * floor + 1] + turn * (x - centreX)];
}

/** A picture as benturRow() makes one, @param data what plan_animation_json() gives. */
function benturPlan(data, buildings, svg, number) {
  "use strict";
  const { scene, points } = data;
  const rings = scene.outlines.map((line, b) => [line, ...scene.rings[b]]);
  const corners = rings.flat(2);
  const size = [0, 1].map((axis) => Math.max(...corners.map((at) => at[axis])) - Math.min(...corners.map((at) => at[axis])));
  const unit = Math.min(320 / size[1], 620 / size[0]);
  const rest = buildings.map(() => []);
  const drawn = {};
  let magnification = 1, place, level = scene.level;

  /** On the page, where y runs downwards. */
  const shown = (b, floor, point) => {
    const [x, y] = place(b, floor, point);
    return [unit * x, -unit * y];
  };
  const text = (numbers) => numbers.map((one) => one.toFixed(2)).join(" ");
  const ring = (b, floor, line) => `M${line.map((point) => text(shown(b, floor, point))).join("L")}Z`;
  const outline = (b, floor) => rings[b].map((line) => ring(b, floor, line)).join("");

  function build(stage) {
    drawn.ghost = svg("path", { class: "ghost" }, stage);
    drawn.floors = buildings.map(({ tone }, b) => scene.centres[b].map(() => svg("path", { class: `floor stroke-${tone}` }, stage)));
    drawn.chosen = buildings.map(({ tone }) => svg("path", { class: `footprint stroke-${tone}` }, stage));
    drawn.marks = scene.marks.map(({ cross, merged }) => svg("path", { class: merged ? "contact stroke-grey" : `${cross ? "rigidity" : "mass"} stroke-ink` }, stage));
    drawn.links = scene.links.map(() => svg("path", { class: "plan-link stroke-ink" }, stage));
    drawn.contacts = points.map(({ struck }) => [0, 1].map(() => svg("circle", { class: `contact stroke-${struck ? "red" : "grey"}` }, stage)));
    drawn.names = buildings.map(({ tone }) => svg("text", { class: `name fill-${tone}`, "text-anchor": "middle" }, stage));
  }

  function frame(magnified) {
    magnification = magnified;
    place = benturPlanPlaces(scene, magnification, rest);
    const all = buildings.flatMap((_, b) => rings[b].flat().map((point) => shown(b, 0, point)));
    const [x, y] = [0, 1].map((axis) => all.map((at) => at[axis]));
    const margin = unit * Math.max(1.05 * magnification * scene.largest, 0.04 * Math.max(...size)); // as far as all may move
    drawn.ghost.setAttribute("d", buildings.map((_, b) => outline(b, 0)).join(""));
    return { left: Math.min(...x) - margin, right: Math.max(...x) + margin, top: Math.min(...y) - margin, bottom: Math.max(...y) + margin };
  }

  /**
   * Names within the outlines at rest; where they do not all fit what the buildings are called in short, and of these
   * what is too long smaller. @returns which of both
   */
  function name(pixel) {
    place = benturPlanPlaces(scene, magnification, rest);
    const rooms = scene.names.map((ends, b) => {
      const [[left, y], [right]] = ends.map((end) => shown(b, 0, end));
      drawn.names[b].setAttribute("x", (left + right) / 2);
      drawn.names[b].setAttribute("y", y + 5 * pixel);
      return right - left - 8 * pixel;
    });
    const written = (texts) => drawn.names.map((line, b) => {
      line.removeAttribute("style");
      line.textContent = texts[b];
      return rooms[b] / Math.max(line.getComputedTextLength(), 1e-9);
    });
    if (written(buildings.map((one) => one.name)).every((part) => part > 1)) return "whole";
    written(data.names.short).forEach((part, b) => {
      if (part < 1) drawn.names[b].style.fontSize = `calc(${(14 * Math.max(part, 0.6)).toFixed(1)}px * var(--px))`;
    });
    return "short";
  }

  function show(motion, now, pixel) {
    place = benturPlanPlaces(scene, magnification, motion);
    const { floors, lower } = scene.levels[level]; // what ends below the level is pale, as the others never meet it there
    drawn.floors.forEach((all, b) => all.forEach((line, floor) => line.setAttribute("d", outline(b, floor))));
    drawn.chosen.forEach((line, b) => {
      line.setAttribute("d", outline(b, floors[b]));
      line.setAttribute("opacity", lower[b] ? 0.4 : 1);
    });
    drawn.names.forEach((line, b) => { // go with the centre of the floor
      const centre = scene.centres[b][floors[b]];
      const [x, y] = benturPlanMovement(scene, motion, b, floors[b], ...centre);
      line.setAttribute("transform", `translate(${text([unit * magnification * x, -unit * magnification * y])})`);
    });
    scene.marks.forEach(({ building, floor, at, cross, merged }, k) => {
      if (merged) { // a corner of every floor
        const [x, y] = shown(building, floors[building], at), side = 4 * pixel;
        drawn.marks[k].setAttribute("d", `M${text([x, y - side])}L${text([x + side, y + 0.7 * side])}H${text([x - side])}Z`);
        return;
      }
      drawn.marks[k].setAttribute("opacity", floor === floors[building] ? 1 : 0);
      const [x, y] = shown(building, floor, at), arm = (cross ? 5 : 0.01) * pixel;
      drawn.marks[k].setAttribute("d", `M${text([x - arm, y - arm])}l${text([2 * arm, 2 * arm])}` +
        (cross ? `m0 ${text([-2 * arm])}l${text([-2 * arm, 2 * arm])}` : ""));
    });
    scene.links.forEach((link, k) => {
      drawn.links[k].setAttribute("opacity", link.leftFloor === floors[link.left] && link.rightFloor === floors[link.right] ? 1 : 0);
      drawn.links[k].setAttribute("d", `M${faces(link).map(text).join("L")}`);
    });
    points.forEach((point, i) => faces(point).forEach(([x, y], side) => {
      const circle = drawn.contacts[i][side];
      circle.setAttribute("opacity", point.level === level ? 1 : 0);
      circle.setAttribute("cx", x.toFixed(2));
      circle.setAttribute("cy", y.toFixed(2));
    }));
  }

  const faces = ({ left, right, leftFloor, rightFloor, faces }) => [shown(left, leftFloor, faces[0]), shown(right, rightFloor, faces[1])];

  function contact(point) {
    const [[x, y], [otherX, otherY]] = faces(points[point]);
    return { x: (x + otherX) / 2, y: (y + otherY) / 2, normal: points[point].normal };
  }

  /** How far two places are apart along their normal. */
  function apart({ left, right, leftFloor, rightFloor, faces, normal, width }, motion) {
    const moved = (b, floor, [x, y]) => {
      const [moveX, moveY] = benturPlanMovement(scene, motion, b, floor, x, y);
      return normal[0] * moveX + normal[1] * moveY;
    };
    return width + moved(right, rightFloor, faces[1]) - moved(left, leftFloor, faces[0]);
  }

  // Of each point those that must be closed, too, before anything touches there: lists of places, of which one is enough.
  const meetings = new Map(), met = ({ meeting }) => meetings.get(meeting.join());
  [...points, ...scene.seams].filter(({ meeting }) => meeting).forEach((place) => {
    if (!met(place)) meetings.set(place.meeting.join(), new Map());
    met(place).set(place.family, [...(met(place).get(place.family) ?? []), place]);
  });
  const others = points.map((point) => !point.meeting ? [] :
    [...met(point)].filter(([family]) => family !== point.family).map(([, places]) => places));

  /** Where buildings touch only while others of their places are closed, the largest of what is open. */
  const opening = (point, motion) => Math.max(apart(points[point], motion),
    ...others[point].map((places) => Math.min(...places.map((place) => apart(place, motion)))));

  /** Contact points that touch where this one is closed: itself, or those of all its meeting. */
  const together = points.map((point, i) =>
    others[i].length === 0 ? [i] : points.flatMap((one, k) => (one.meeting && met(one) === met(point) ? [k] : [])));

  const metres = (elevation) => `${number(elevation)} ${data.units.length}`;
  const many = new Set(points.map(({ gap }) => gap)).size > 1;
  const pair = ({ left, right }) => `${buildings[left].name} | ${buildings[right].name}`;
  const where = (point) => (many ? `${pair(points[point])}, ` : "") +
    `${data.words.level} ${metres(points[point].elevation)}, ${points[point].along}`;

  /** What the table of openings holds: the places of the chosen level, of those that are one its contact points. */
  function live(inShort) {
    const called = data.names.short;
    const gap = (point) => (inShort ? `${called[point.left]} | ${called[point.right]}` : pair(point));
    const rows = new Map();
    points.forEach((point, i) => {
      if (point.level !== level) return;
      const name = (many ? `${gap(point)}, ` : "") + point.along;
      rows.set(name, [...(rows.get(name) ?? []), i]);
    });
    return { head: [], rows: [...rows].map(([name, all]) => ({ name, points: [all] })), many };
  }

  return {
    unit, grain: 20, below: 0, key: scene.key, build, frame, name, show, contact, opening, together, where, inside: () => [], live,
    levels: scene.levels.map(({ elevation }) => metres(elevation)),
    get level() { return level; },
    choose(other) { level = other; },
  };
}
