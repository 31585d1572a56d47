"use strict";
(() => {
const body = document.body;
body.dataset.errors = "0";
addEventListener("error", () => { body.dataset.errors = String(1 + Number(body.dataset.errors)); });

const data = JSON.parse(document.getElementById("data").textContent);
const get = (object, path) => path.split(".").reduce((value, key) => value == null ? value : value[key], object);
const fixed = digits => value => value.toFixed(digits);
const whole = value => String(Math.round(value));
const figures = value => value === 0 ? "0" : value < 0.001 || value >= 1e5 ? value.toExponential(1) : String(Number(value.toPrecision(3)));

// Name in filters and in the address, heading, meaning, where it is, how it is written.
const columns = [
  ["id", "point", "Name of the point", "id", String],
  ["w", "W", "Bits of the depth word", "design.accuracy.depth", whole],
  ["k", "K", "Bits of the square root", "format.root", whole],
  ["plane", "P", "Bits of the depth of a cut plane", "format.plane", whole],
  ["n", "n", "Normal component, bits", "design.accuracy.normal", whole],
  ["g1", "g1", "Guard bits of f1", "design.accuracy.guard_linear", whole],
  ["g2", "g2", "Guard bits of f2", "design.accuracy.guard_quadratic", whole],
  ["d", "d", "Last digits of the root that are not computed", "design.accuracy.dropped_rows", whole],
  ["t", "t", "Entries along each side of the tables of lit-sphere shading; 0 with a shading processor", "design.accuracy.table_side", whole],
  ["r", "R", "Rows of the root network per register stage", "design.rows_per_stage", whole],
  ["s", "s", "Samples of a pixel along each side", "design.accuracy.supersampling", whole],
  ["p", "p", "Pixels along each side that show one that is drawn", "design.accuracy.undersampling", whole],
  ["i", "i", "Fields: every other line is drawn, and shown twice", "design.accuracy.interlaced", whole],
  ["c", "c", "Pixels of a line that a beam machine draws at once", "design.pixels_per_clock", whole],
  ["zone", "zone", "Side of a zone in pixels; none in a beam machine", "design.zones.side", whole],
  ["objects", "objects", "Object processors of a zone machine", "design.zones.processors", whole],
  ["fps", "frames/s", "Frames per second at the clock", "frames_per_second", figures],
  ["picture", "picture %", "How far the picture is from the ideal one, in percent of the whole scale", "picture_error", figures],
  ["depth", "depth", "Greatest depth error, in units of a pixel", "errors.depth_px.max", figures],
  ["silh", "silh", "Silhouette errors: pixels at which an object is missing, or is seen and should not be", "errors.silhouette", whole],
  ["part", "part", "Visible-part errors: pixels that show a wrong object, or a wrong face of the right one", "errors.visible_part", whole],
  ["cracks", "cracks", "Pixels that look through a closed surface", "errors.cracks", whole],
  ["normal", "normal \u00b0", "Normal error in degrees, 99.9 %", "errors.normal_deg.quantile_999", figures],
  ["colour", "colour", "Greatest channel difference in 1/255, 99.9 %", "errors.colour.quantile_999", whole],
  ["cells", "cells", "Logic cells", "cost.cells", whole],
  ["mhz", "MHz", "Clock: of the slowest unit, placed and routed, or estimated", "mhz", fixed(0)],
  ["routed", "routed", "Clock of the slowest unit, placed and routed", "cost.fmax_mhz", fixed(1)],
  ["latency", "lat.", "Clocks of a beam machine from a pixel that is begun to its colour", "latency", whole],
  ["mpps", "Mpix/s", "Million pixels shown per second at the clock", "pixels_per_second", value => (value / 1e6).toFixed(1)],
  ["toggles", "toggles", "Register bits that change from clock to clock, per pixel: a proxy of the power", "toggles.total", whole],
].map(([key, heading, title, path, write]) => ({ key, heading, title, path, write }));
const byKey = new Map(columns.map(column => [column.key, column]));
// The name tells these; they have no column of their own.
const inName = ["n", "g1", "g2", "d", "s", "p", "i", "c", "t", "zone", "objects", "routed", "mpps"];
const ofCost = ["cells"];
const isKnown = column => data.points.some(point => get(point, column.path) != null);
const shown = columns.filter(column => !inName.includes(column.key) && (!ofCost.includes(column.key) || isKnown(column)));

const defaults = { sort: data.measure, dir: "asc", filter: "", point: "", view: "picture" };
let state = { ...defaults };

function readAddress() {
  const given = new URLSearchParams(location.hash.slice(1));
  state = { ...defaults };
  for (const key of Object.keys(defaults)) if (given.has(key)) state[key] = given.get(key);
  if (!byKey.has(state.sort)) state.sort = defaults.sort;
  if (state.dir !== "desc") state.dir = "asc";
  if (!["picture", "map", "truth"].includes(state.view)) state.view = "picture";
}

function writeAddress() {
  const out = new URLSearchParams();
  for (const key of Object.keys(defaults)) if (state[key] !== defaults[key]) out.set(key, state[key]);
  const hash = "#" + out.toString();
  if (location.hash !== hash) history.replaceState(null, "", hash);
}

// Each word of a filter is a comparison with a column, or a part of a name; all must hold.
function filterOf(text) {
  const tests = text.trim().split(/\s+/).filter(Boolean).map(word => {
    const found = /^([a-z0-9]+)(<=|>=|!=|<|>|=)(-?[0-9.]+(?:e-?[0-9]+)?)$/i.exec(word);
    const column = found && byKey.get(found[1].toLowerCase());
    if (!column) {
      const part = word.toLowerCase();
      const kinds = { pareto: point => point.pareto.length > 0, exact: point => point.silhouette_exact, refused: point => point.refused != null };
      return kinds[part] || (point => point.id.includes(part));
    }
    const wanted = Number(found[3]);
    const compare = { "<": (a, b) => a < b, ">": (a, b) => a > b, "<=": (a, b) => a <= b, ">=": (a, b) => a >= b, "=": (a, b) => a === b, "!=": (a, b) => a !== b }[found[2]];
    return point => { const value = get(point, column.path); return value != null && compare(value, wanted); };
  });
  return point => tests.every(test => test(point));
}

function visible() {
  const keep = filterOf(state.filter);
  const column = byKey.get(state.sort);
  const sign = state.dir === "desc" ? -1 : 1;
  const order = (a, b) => {
    const [x, y] = [get(a, column.path), get(b, column.path)];
    // What has no figure stands last in either direction.
    if (x == null || y == null) return (x == null) - (y == null);
    return sign * (x < y ? -1 : x > y ? 1 : 0);
  };
  return data.points.filter(keep).map((point, index) => [point, index]).sort((a, b) => order(a[0], b[0]) || a[1] - b[1]).map(pair => pair[0]);
}

const make = (tag, properties = {}, children = []) => {
  const element = document.createElement(tag);
  for (const [key, value] of Object.entries(properties)) {
    if (key in element && key !== "list") element[key] = value; else element.setAttribute(key, value);
  }
  element.append(...children);
  return element;
};

const headings = document.querySelector("#points thead tr");
const rows = document.querySelector("#points tbody");

function drawHeadings() {
  headings.replaceChildren(...shown.map(column => {
    const button = make("button", { type: "button", textContent: column.heading, title: `${column.title}; in filters: ${column.key}` });
    button.addEventListener("click", () => {
      const again = state.sort === column.key && state.dir === "asc";
      change({ sort: column.key, dir: again ? "desc" : "asc" });
      headings.children[shown.indexOf(column)].firstChild.focus();
    });
    const cell = make("th", { scope: "col", className: column.key === "id" ? "text" : "" }, [button]);
    if (column.key === state.sort) cell.setAttribute("aria-sort", state.dir === "asc" ? "ascending" : "descending");
    return cell;
  }));
}

function mark(point) {
  const kind = point.errors == null ? "none" : (point.silhouette_exact ? "exact" : "") + (point.pareto.length ? " front" : "");
  return make("i", { className: "dot " + kind });
}

function drawRows() {
  const points = visible();
  rows.replaceChildren(...points.map(point => {
    const cells = shown.map(column => {
      const value = get(point, column.path);
      const cell = make("td", { textContent: value == null ? "\u2013" : column.write(value) });
      cell.dataset.column = column.key;
      if (column.key === "id") { cell.className = "text"; cell.prepend(mark(point)); }
      return cell;
    });
    const row = make("tr", { tabIndex: point.id === state.point ? 0 : -1, className: point.refused == null ? "" : "refused" }, cells);
    row.dataset.point = point.id;
    row.setAttribute("aria-selected", String(point.id === state.point));
    return row;
  }));
  if (!rows.querySelector("[tabindex='0']") && rows.firstChild) rows.firstChild.tabIndex = 0;
  document.getElementById("count").textContent = `${points.length} of ${data.points.length} points`;
  const kept = new Set(points.map(point => point.id));
  for (const circle of document.querySelectorAll("circle[data-point]")) {
    circle.classList.toggle("out", !kept.has(circle.dataset.point));
    circle.classList.toggle("picked", circle.dataset.point === state.point);
  }
}

function list(pairs) {
  const items = pairs.filter(([, value]) => value != null).flatMap(([name, value]) => [make("dt", { textContent: name }), make("dd", { textContent: value })]);
  return make("dl", {}, items);
}

function spreads(rows) {
  const cells = (tag, texts) => texts.map(text => make(tag, { textContent: text }));
  const line = ([name, s, write]) => make("tr", {}, cells("td", [name, write(s.max), write(s.quantile_999), figures(s.rms)]));
  return make("table", { className: "spreads" }, [make("tr", {}, cells("th", ["", "max", "99.9 %", "rms"])), ...rows.filter(row => row[1].count).map(line)]);
}

function pictureOf(point) {
  const sources = { picture: data.pictures[point.picture], map: data.pictures[point.map], truth: data.truth };
  const names = { picture: "picture", map: "error map", truth: "truth" };
  const tabs = make("div", { className: "tabs" }, Object.keys(names).map(view => {
    const button = make("button", { type: "button", textContent: names[view] });
    button.setAttribute("aria-pressed", String(view === state.view));
    button.addEventListener("click", () => { change({ view }); document.querySelector(`.tabs button:nth-child(${1 + Object.keys(names).indexOf(view)})`).focus(); });
    return button;
  }));
  const image = make("img", { id: "picture", src: sources[state.view], alt: `${names[state.view]} of ${point.id}` });
  const parts = [tabs, image];
  if (state.view === "map") parts.push(make("div", { className: "legend" }, [document.getElementById("legend").content.cloneNode(true)]));
  return parts;
}

function histogramOf(errors) {
  const classes = errors.depth_histogram;
  const most = Math.max(...classes.map(one => Math.log2(1 + one.count)));
  const bars = classes.map(one => {
    const bar = make("i", { title: `below ${one.below} words: ${one.count} pixels` });
    bar.style.height = `${100 * Math.log2(1 + one.count) / most}%`;
    return bar;
  });
  const last = classes[classes.length - 1].below;
  return [make("h3", { textContent: "Pixels by depth error (words of the base format, logarithmic)" }), make("div", { className: "bars" }, bars),
    make("div", { className: "axis" }, [make("span", { textContent: "< 1/8" }), make("span", { textContent: `< ${last}` })])];
}

function drawMeanings() {
  document.getElementById("columns").replaceChildren(list(shown.map(column => [column.heading, column.title])));
}

function drawDetail() {
  const detail = document.getElementById("detail");
  const point = data.points.find(one => one.id === state.point);
  if (!point) {
    const hint = "Select a point: click a row or a mark, or move with the arrow keys.";
    detail.replaceChildren(make("p", { className: "hint", textContent: hint }));
    return;
  }
  const parts = [make("h2", { textContent: point.id })];
  const e = point.errors;
  if (point.refused != null) parts.push(make("p", { className: "note", textContent: `Does not fit: ${point.refused}` }));
  if (e) {
    parts.push(...pictureOf(point));
    const f = point.format;
    parts.push(make("h3", { textContent: "Machine" }), list([
      ["depth, root, plane, normal", `${f.depth}, ${f.root}, ${f.plane}, ${f.normal} bits`],
      ["guard bits; digits dropped; root", `${f.guard_linear}, ${f.guard_quadratic}; ${f.dropped_rows}; ${point.design.accuracy.root_form}`],
      ["machine", point.machine.zone ? `${point.machine.objects} object processors, zones of ${point.machine.zone.width} x ${point.machine.zone.height}` : `beam of ${point.machine.objects} object processors`],
      ["slots", point.machine.slots],
      ["rows per stage", String(point.machine.rows_per_stage)],
      ["clocks per frame; latency", `${point.clocks_per_frame}; ${point.latency ?? "-"}`],
      ["frames per second", point.frames_per_second && figures(point.frames_per_second)],
      ["clock", point.mhz && `${point.mhz.toFixed(1)} MHz, ${point.cost && point.cost.fmax_mhz ? `placed and routed (estimate: ${point.mhz_estimated == null ? "none" : point.mhz_estimated.toFixed(1)})` : "estimated"}`],
      ["picture off the ideal one", `${figures(point.picture_error)} %`],
      ["register toggles per pixel", point.toggles && `${whole(point.toggles.total)} (PE1 ${whole(point.toggles.pe1)}, PE2 ${whole(point.toggles.pe2)}, root ${whole(point.toggles.root)}, depth ${whole(point.toggles.depth)})`],
      ["LUT, FF, DSP, block memories", point.cost && `${point.cost.lut}, ${point.cost.ff}, ${point.cost.dsp}, ${point.cost.bram}`],
      ["cells", point.cost && String(point.cost.cells)],
    ]));
    if (point.cost_refused) parts.push(make("p", { className: "note", textContent: `No cost: ${point.cost_refused}` }));
    parts.push(make("h3", { textContent: "Errors" }), list([
      ["missing; extra", `${e.missing}; ${e.extra} of ${e.covered}`],
      ["wrong object; wrong face", `${e.wrong_object}; ${e.wrong_face}`],
      ["cracks", String(e.cracks)],
      ["patches with a face too few or many", String(e.back_differs)],
    ]), spreads([
      ["front depth, words", e.depth_words, figures],
      ["front depth, pixels", e.depth_px, figures],
      ["back depth, pixels", e.back_px, figures],
      ["normal, degrees", e.normal_deg, figures],
      ["colour, 1/255", e.colour, whole],
      ["colour, same face", e.colour_same_face, whole],
    ]), ...histogramOf(e));
  }
  parts.push(make("h3", { textContent: "Reproduce" }), make("pre", { textContent: point.command, tabIndex: 0 }));
  if (point.emit) parts.push(make("pre", { className: "next", textContent: point.emit, tabIndex: 0 }));
  detail.replaceChildren(...parts);
}

function draw() {
  drawHeadings();
  drawRows();
  drawDetail();
  body.dataset.ready = state.sort;
}

function change(by) {
  state = { ...state, ...by };
  writeAddress();
  draw();
}

function pick(id, focus) {
  change({ point: id });
  const row = rows.querySelector(`[data-point="${CSS.escape(id)}"]`);
  if (!row) return;
  row.scrollIntoView({ block: "nearest" });
  if (focus) row.focus({ preventScroll: true });
}

rows.addEventListener("click", event => {
  const row = event.target.closest("tr");
  if (row) pick(row.dataset.point, true);
});
rows.addEventListener("keydown", event => {
  const row = event.target.closest("tr");
  const next = { ArrowDown: row.nextElementSibling, ArrowUp: row.previousElementSibling, Home: rows.firstChild, End: rows.lastChild, Enter: row, " ": row }[event.key];
  if (next === undefined) return;
  event.preventDefault();
  if (next) pick(next.dataset.point, true);
});
for (const circle of document.querySelectorAll("circle[data-point]")) {
  const title = document.createElementNS("http://www.w3.org/2000/svg", "title");
  title.textContent = circle.dataset.point;
  circle.append(title);
  circle.addEventListener("click", () => pick(circle.dataset.point, false));
}
const filter = document.getElementById("filter");
filter.addEventListener("input", () => change({ filter: filter.value }));
function fromAddress() {
  readAddress();
  filter.value = state.filter;
  draw();
  const row = state.point && rows.querySelector(`[data-point="${CSS.escape(state.point)}"]`);
  if (row) row.parentNode.parentNode.parentNode.scrollTop = Math.max(0, row.offsetTop - 120);
}
addEventListener("hashchange", fromAddress);
drawMeanings();
fromAddress();
})();
