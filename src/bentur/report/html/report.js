// The page of a report: its moving buildings (motion.js), and its sortable, downloadable impact list. Reads the page's own
// data alone; no request ever leaves the page. Text reaches the page by textContent, never as markup.
"use strict";
(() => {
  const words = {};
  const motion = document.getElementById("stage") ? move() : undefined; // a page may have tables alone

  function move() {
    const data = JSON.parse(document.getElementById("data").textContent);
    Object.assign(words, data.words);
    const parts = {};
    for (const id of ["stage", "timeline", "scrub", "clock", "event", "live", "play", "previous", "next", "hardest", "speed", "slow",
      "magnify", "magnified"]) {
      parts[id] = document.getElementById(id);
    }
    parts.timeAxis = document.getElementById("time-axis");
    parts.buildingKey = document.getElementById("building-key");
    parts.level = document.getElementById("level");
    parts.levelChoice = document.getElementById("level-choice");
    parts.steady = true;
    return benturMotion(parts, data);
  }

  function html(name, text) {
    const element = document.createElement(name);
    if (text !== undefined) element.textContent = text;
    return element;
  }

  // ---------------------------------------------------------------- the impact list

  function value(row, column) {
    const text = row.cells[column].textContent.trim();
    const number_ = Number(text.replace("\u2212", "-"));
    return text === "" || Number.isNaN(number_) ? text : number_;
  }

  /** Numbers by size, texts by alphabet, what is missing last. */
  function compare(a, b, direction) {
    const missing = (x) => x === "–";
    if (missing(a) || missing(b)) return missing(a) - missing(b);
    if (typeof a === "number" && typeof b === "number") return direction * (a - b);
    return direction * String(a).localeCompare(String(b), document.documentElement.lang);
  }

  function sort(table, column, direction) {
    const body = table.tBodies[0];
    const rows = Array.from(body.rows);
    rows.sort((a, b) => compare(value(a, column), value(b, column), direction));
    body.append(...rows);
    Array.from(table.tHead.lastElementChild.cells).forEach((cell, i) => {
      if (i === column) cell.setAttribute("aria-sort", direction > 0 ? "ascending" : "descending");
      else cell.removeAttribute("aria-sort");
    });
    const byForce = column === Number(table.dataset.sorted) && direction < 0;
    const [hardest, first] = document.querySelectorAll("#in-sight span");
    table.tHead.rows[0].classList.toggle("titles", byForce); // which says in print that the hardest come first
    hardest.hidden = !byForce;
    first.hidden = byForce;
  }

  function save() {
    const link = html("a"), csv = JSON.parse(document.getElementById("impacts-csv").textContent);
    link.href = URL.createObjectURL(new Blob([csv], { type: "text/csv" }));
    link.download = "impacts.csv";
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  }

  function buildList() {
    const table = document.getElementById("impact-list");
    if (!table) return;
    Array.from(table.tHead.lastElementChild.cells).forEach((cell, column) => {
      const button = html("button"); // over the whole cell
      button.type = "button";
      button.className = "sorter";
      button.setAttribute("aria-label", cell.childNodes[0].textContent);
      cell.append(button);
      button.addEventListener("click", () =>
        sort(table, column, cell.getAttribute("aria-sort") === "descending" ? 1 : -1));
      if (column === Number(table.dataset.sorted)) cell.setAttribute("aria-sort", "descending");
    });
    document.getElementById("download").addEventListener("click", save);
    if (!motion) return;
    const byNumber = new Map(motion.impacts.map((impact) => [String(impact.number), impact]));
    for (const row of table.tBodies[0].rows) {
      const cell = row.cells[0];
      const impact = byNumber.get(cell.textContent.trim());
      const button = html("button", cell.textContent.trim());
      button.type = "button";
      button.title = words.show_impact;
      cell.replaceChildren(button);
      button.addEventListener("click", () => {
        document.getElementById("motion").scrollIntoView();
        motion.showImpact(impact);
      });
    }
  }

  /** Opens all that is folded away, or closes it again. */
  function buildUnfold() {
    const button = document.getElementById("unfold");
    if (!button) return;
    button.addEventListener("click", () => {
      const all = document.querySelectorAll(".appendix, .appendix details");
      const open = Array.from(all).some((one) => !one.open);
      for (const one of all) one.open = open;
    });
  }

  const telephone = matchMedia("(max-width: 40rem)").matches;

  /** Of a long list the first are in sight, which says of how many, until all are asked for. */
  function shortenList() {
    const most = telephone ? 8 : 15, table = document.getElementById("impact-list");
    if (!table || table.tBodies[0].rows.length <= most) return;
    const note = document.getElementById("in-sight");
    table.classList.add("short");
    note.querySelector("b").textContent = most;
    note.hidden = false;
    note.querySelector("button").addEventListener("click", () => {
      table.classList.remove("short");
      note.hidden = true;
    });
  }

  /** On a telephone the worst gaps are in sight, the others once they are asked for. */
  function shortenGaps() {
    if (!telephone) return;
    for (const note of document.querySelectorAll(".more-gaps")) {
      const table = note.previousElementSibling.querySelector("table");
      table.classList.add("short");
      note.hidden = false;
      note.querySelector("button").addEventListener("click", () => {
        table.classList.remove("short");
        note.hidden = true;
      });
    }
  }

  /** On a telephone details are folded away. */
  function foldOnTelephones() {
    if (!telephone) return;
    for (const one of document.querySelectorAll("details.fold")) one.open = false;
  }

  buildList();
  shortenList();
  shortenGaps();
  buildUnfold();
  foldOnTelephones();
  document.documentElement.classList.add("ready");
})();
