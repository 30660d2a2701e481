/** The marks beside a drawing: a table from the kind of a mark to the function that makes it. */

import { attributeWriter, html, htmlLabel, textWriter } from "./dom.js";
import { loadExact } from "./exact.js";
import { presence } from "./marks.js";
import { exactly, isZero, Undefined, write } from "./rational.js";
import { shown } from "./text.js";
import { cssColour } from "./theme.js";

/** @typedef {import("./scene.js").Mark} Mark */
/** @typedef {import("./scene.js").Colour} Colour */
/** @typedef {import("./figure.js").Figure} Figure */
/** @typedef {{element: HTMLElement, update: () => void}} Part */


/**
 * A bar of shares as one background: one property changes per frame, and nothing is laid out anew.
 * A share below zero has no length, so the others are drawn relative to their sum.
 */
function stackedBar(/** @type {Float64Array} */ shares, /** @type {number} */ from, /** @type {Colour[]} */ colours) {
  const lengths = colours.map((_, i) => Math.max(shares[from + i], 0) || 0);
  const sum = lengths.reduce((a, b) => a + b, 0) || 1;
  let end = 0;
  const stops = colours.map((colour, i) => {
    const start = end;
    end += lengths[i] / sum;
    return `${cssColour(colour)} ${(100 * start).toFixed(1)}% ${(100 * end).toFixed(1)}%`;
  });
  return `linear-gradient(to right, ${stops.join(", ")})`;
}

/** The triangular scheme: a column for every level, each entry between the two it is made from. */
function scheme(/** @type {Figure} */ { output, store, life }, /** @type {Mark} */ mark) {
  const points = output(mark.output);
  const shares = mark.weights ? output(mark.weights) : null;
  const { sizes = [], froms = [], colors = [] } = mark;
  const labels = mark.labels ?? [];
  const width = points.size / labels.length;
  const places = sizes.flatMap((size, level) => Array.from({ length: size }, (_, i) => (
    { column: level + 1, row: 2 * i + (sizes[0] - size) + 1 })));
  const entries = labels.map((text, k) => {
    const bar = html("span", { class: "bar" });
    const coordinates = Array.from({ length: width }, () => html("span"));
    const write = coordinates.map(textWriter);
    const element = html("div", { class: "entry" }, html("b", {}, htmlLabel(text)), bar,
      html("span", { class: "value" }, ...coordinates));
    element.style.gridArea = `${places[k].row} / ${places[k].column} / span 2`;
    let last = "";
    return { element, from: froms[k] ?? 0, update(/** @type {boolean} */ present) {
      write.forEach((set, c) => set(present ? shown(points.values[k * width + c], 2) : ""));
      const background = present && shares ? stackedBar(shares.values, k * colors.length, colors) : "none";
      if (background !== last) bar.style.backgroundImage = last = background;
    } };
  });
  const grid = html("div", { class: "scheme", style: `--columns: ${sizes.length}` },
    ...entries.map((entry) => entry.element));
  let lastStep = -1;

  function goTo(/** @type {number} */ step) {
    lastStep = step;
    for (const { element: entry, from } of entries) {
      entry.classList.toggle("absent", step < from);
      entry.classList.toggle("active", from > 0 && step === from);
      entry.ariaHidden = String(step < from);
      const end = entry.offsetLeft + entry.offsetWidth;
      if (step === from && end > element.clientWidth) element.scrollLeft = end - element.clientWidth;
    }
  }

  const element = html("div", { class: "panel scroll", role: "group", "aria-label": "Triangular scheme" }, grid);
  life.onResize(element, () => { // what scrolls must be reachable by keyboard, and only then
    if (element.scrollWidth > element.clientWidth) element.tabIndex = 0;
    else element.removeAttribute("tabindex");
  });
  return {
    element,
    update() {
      const { step } = store.state;
      if (step !== lastStep) goTo(step);
      for (const entry of entries) entry.update(step >= entry.from);
    },
  };
}

/** How much every control point counts: one cell each, a bar and a number. */
function weights(/** @type {Figure} */ { output }, /** @type {Mark} */ mark) {
  const { values } = output(mark.output);
  const cells = (mark.labels ?? []).map((text, i) => {
    const bar = html("span", { class: "share" });
    const value = html("span", { class: "value" });
    const writeValue = textWriter(value);
    const writeStyle = attributeWriter(bar, "data-negative");
    return {
      element: html("div", { class: "cell", style: `--colour: ${cssColour(mark.colors?.[i] ?? i)}` },
        html("span", { class: "name" }, html("span", { class: "chip" }), htmlLabel(text)),
        html("span", { class: "bar" }, bar), value),
      update() {
        bar.style.transform = `scaleX(${Math.min(Math.abs(values[i]) || 0, 1)})`;
        writeStyle(String(values[i] < 0));
        writeValue(shown(values[i], 3));
      },
    };
  });
  const heading = mark.title ? [html("p", { class: "heading" }, htmlLabel(mark.title))] : [];
  return {
    element: html("div", { class: "panel" }, ...heading,
      html("div", { class: "cells" }, ...cells.map(({ element }) => element))),
    update: () => cells.forEach(({ update }) => update()),
  };
}

/** One value, or one point, by its name. */
function readout(/** @type {Figure} */ { output }, /** @type {Mark} */ mark) {
  const { values, size } = output(mark.output);
  const value = html("span", { class: "value" });
  const write = textWriter(value);
  return {
    element: html("p", { class: "readout", style: `--colour: ${cssColour(mark.color)}` },
      htmlLabel(mark.label ?? ""), " = ", value),
    update: () => write(size === 1 ? shown(values[0]) : `(${Array.from(values, (v) => shown(v)).join(", ")})`),
  };
}

/** Whether residuals are exactly zero, in words: "holds", or by how much it fails. */
function statement(/** @type {Figure} */ { inputsByName }, /** @type {Mark} */ mark) {
  const { run } = loadExact(/** @type {import("./scene.js").TapeData} */ (mark.tape));
  const value = html("span", { class: "value" });
  const element = html("p", { class: "statement", role: "status" }, htmlLabel(mark.label ?? ""), ": ", value);
  let last = "";
  return {
    element,
    update() {
      const inputs = inputsByName();
      const key = JSON.stringify(inputs);
      if (key === last) return;
      last = key;
      try {
        const exact = Object.fromEntries(Object.entries(inputs).map(([name, number]) => [name, exactly(number)]));
        const residuals = run(exact)("residuals");
        const holds = residuals.every(isZero);
        element.dataset.holds = String(holds);
        const list = residuals.map((r) => (String(r.d).length > 6 ? shown(Number(r.n) / Number(r.d)) : write(r)));
        value.textContent = holds ? "holds, exactly" : `off by ${list.length > 1 ? `(${list.join(", ")})` : list[0]}`;
      } catch (error) {
        if (!(error instanceof Undefined)) throw error;
        delete element.dataset.holds;
        value.textContent = "has no meaning here";
      }
    },
  };
}

/** @type {Record<string, (figure: Figure, mark: Mark) => Part>} */
export const PANEL_MARKS = { scheme, weights, readout, statement };

/** A panel that comes and goes with the steps like any mark. */
export function createPanel(/** @type {Figure} */ figure, /** @type {Mark} */ mark) {
  const part = PANEL_MARKS[mark.kind](figure, mark);
  return {
    element: part.element,
    update() {
      const { shown: visible, active } = presence(mark, figure.store.state.step);
      // Hidden, not removed: what stands below shall not jump.
      part.element.style.visibility = visible ? "" : "hidden";
      part.element.classList.toggle("active", active);
      if (visible) part.update();
    },
  };
}
