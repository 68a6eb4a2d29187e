// What moves, at any time: of the samples that motion_data.cpp wrote.

/** @returns {buildings: as given, with what their samples are, motionAt(time): displacements by building and row} */
function benturSamples(data) {
  "use strict";
  /** int16 samples, little endian in base64, the rows of one instant side by side. */
  function decode(text) {
    const bytes = atob(text);
    const view = new DataView(new ArrayBuffer(bytes.length));
    for (let i = 0; i < bytes.length; ++i) view.setUint8(i, bytes.charCodeAt(i));
    const values = new Int16Array(bytes.length / 2);
    for (let i = 0; i < values.length; ++i) values[i] = view.getInt16(2 * i, true);
    return values;
  }

  const buildings = data.buildings.map((given) => ({ ...given, samples: decode(given.samples), keys: decode(given.keys) }));
  const frames = [];

  /** Joins even samples and the exact starts, peaks and ends of impacts (data.keys) into one row of instants. */
  function join() {
    const { duration, keys } = data;
    const count = data.frames;
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

  /** Displacement of a row at time t: cubic between frames, with slopes from their neighbours. */
  function displacement(building, row, t) {
    const rows = building.rows;
    const last = frames.length - 1;
    const frame = Math.min(frameAt(t), Math.max(last - 1, 0));
    const place = (k) => Math.min(Math.max(k, 0), last);
    const value = (k) => building.values[place(k) * rows + row];
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

  join();
  return {
    buildings,
    motionAt: (t) => buildings.map((building) =>
      Array.from({ length: building.rows }, (_, row) => displacement(building, row, t))),
  };
}
