/** The table of a figure's numbers: movable points as fields, fixed points and readouts to read. */

import { html, htmlLabel, textWriter } from "./dom.js";
import { createField } from "./field.js";
import { presence } from "./marks.js";
import { format, shown, spoken } from "./text.js";

/** @typedef {import("./figure.js").Figure} Figure */
/** @typedef {{rows: HTMLTableRowElement[], update: () => void}} Row */

const name = (/** @type {string} */ text) => html("th", { scope: "row" }, htmlLabel(text));

/** @returns {Row} */
function movableRow(/** @type {Figure} */ { scene, store, life, say },
  /** @type {import("./scene.js").PointGroup} */ group, /** @type {number} */ index) {
  const text = group.labels[index] ?? `${group.name}_${index}`;
  const view = scene.views[group.view];
  const point = () => store.state.points[group.name][index];
  const fields = /** @type {const} */ (["x", "y"]).map((axis, c) => createField(life, {
    name: `${spoken(text)} ${axis}`, low: 2 * view[axis][0] - view[axis][1], high: 2 * view[axis][1] - view[axis][0],
    accept(value) {
      const [x, y] = point();
      store.movePoint(group.name, index, c === 0 ? value : x, c === 1 ? value : y);
      store.commit();
      say(`${spoken(text)} at ${point().map((v) => format(v)).join(", ")}`);
    },
  }));
  const rows = [
    html("tr", { class: "movable" }, name(text), ...fields.map(({ input }) => html("td", {}, input))),
    html("tr", {}, html("td", { class: "messages", colspan: 3 }, ...fields.map(({ message }) => message))),
  ];
  return {
    rows,
    update() {
      for (const row of rows) row.hidden = !presence(group, store.state.step).shown;
      fields.forEach((field, c) => field.show(point()[c]));
    },
  };
}

/** Rows of values to read: `width` numbers from `offset`; empty while the mark is not shown. */
function fixedRow(/** @type {Figure} */ { store, output }, /** @type {import("./scene.js").Mark} */ mark,
  /** @type {string} */ text, /** @type {number} */ offset, /** @type {number} */ width) {
  const { values } = output(mark.output);
  const cells = Array.from({ length: width }, () => html("td", width === 1 ? { colspan: 2 } : {}));
  const write = cells.map(textWriter);
  const row = html("tr", {}, name(text), ...cells);
  return {
    rows: [row],
    update() {
      row.hidden = !presence(mark, store.state.step).shown;
      write.forEach((set, c) => set(shown(values[offset + c])));
    },
  };
}

/** @returns {Row[]} */
function fixedRows(/** @type {Figure} */ figure, /** @type {import("./scene.js").Mark} */ mark) {
  const { size } = figure.output(mark.output);
  if (mark.kind === "dots") {
    return (mark.labels ?? []).map((text, i) => fixedRow(figure, mark, text, 2 * i, 2));
  }
  if (mark.kind !== "readout") return [];
  if (size <= 2) return [fixedRow(figure, mark, mark.label ?? "", 0, size)];
  return Array.from({ length: size }, (_, i) => fixedRow(figure, mark, `${mark.label}, ${i}`, i, 1));
}

/** @param {Figure} figure */
export function createNumbers(figure) {
  const { scene, life } = figure;
  const rows = [
    ...scene.points.flatMap((group) => group.values.map((_, i) => movableRow(figure, group, i))),
    ...scene.marks.flatMap((mark) => fixedRows(figure, mark)),
  ];
  if (rows.length === 0) return null;
  const head = html("tr", {}, ...["Point", "x", "y"].map((text) => html("th", { scope: "col" }, text)));
  const element = html("details", { class: "numbers" }, html("summary", {}, "Numbers"),
    html("table", {}, html("thead", {}, head), html("tbody", {}, ...rows.flatMap((row) => row.rows))));
  const update = () => { if (element.open) rows.forEach((row) => row.update()); };
  life.listen(element, "toggle", update);
  return { element, update };
}
