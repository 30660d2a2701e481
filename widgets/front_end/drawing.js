/** One drawing: grid and axes, the marks of a view, their labels, and on top the movable handles. */

import { svg } from "./dom.js";
import { createHandles } from "./handles.js";
import { createLabels } from "./labels.js";
import { DRAWING_MARKS, presence } from "./marks.js";
import { shown as shownNumber } from "./text.js";
import { fitView, niceTicks } from "./transform.js";

/** @typedef {import("./transform.js").Transform} Transform */

const PIXELS_PER_TICK = 56;
const BEYOND = 9; // dots at the plot's edge are drawn whole
let clips = 0;

/** @param {import("./scene.js").View} view */
function gridNodes(view, /** @type {Transform} */ map) {
  const [low, high] = [(map.left - map.ox) / map.sx, (map.right - map.ox) / map.sx];
  const xs = niceTicks(low, high, (map.right - map.left) / PIXELS_PER_TICK);
  const ys = niceTicks(view.y[0], view.y[1], (map.bottom - map.top) / PIXELS_PER_TICK);
  /** @type {[string[], string[], SVGElement[]]} */
  const [lines, axes, numbers] = [[], [], []];
  for (const x of xs) {
    const at = Math.round(map.sx * x + map.ox) + 0.5; // half pixels draw crisp lines
    (x === 0 ? axes : lines).push(`M${at} ${map.top}V${map.bottom}`);
    numbers.push(svg("text", { class: "tick", x: at, y: map.bottom + 17, "text-anchor": "middle" }, shownNumber(x)));
  }
  for (const y of ys) {
    const at = Math.round(map.sy * y + map.oy) + 0.5;
    (y === 0 ? axes : lines).push(`M${map.left} ${at}H${map.right}`);
    numbers.push(svg("text", { class: "tick", x: map.left - 8, y: at + 4, "text-anchor": "end" }, shownNumber(y)));
  }
  const path = (/** @type {string} */ name, /** @type {string[]} */ d) => svg("path", { class: name, d: d.join("") });
  return [path("grid", lines), path("axis", axes), ...numbers];
}

/** @param {import("./figure.js").Figure} figure */
function createMarks(figure, /** @type {number} */ index, /** @type {SVGGElement} */ layer,
  /** @type {import("./marks.js").Labels} */ labels) {
  const { marks } = figure.scene;
  return marks.flatMap((mark, order) => {
    const render = DRAWING_MARKS[mark.kind];
    if (!render || mark.view !== index) return [];
    const drawn = render(mark, figure.output(mark.output), labels, marks.length - order);
    const group = svg("g", { class: "mark" }, ...drawn.nodes);
    layer.append(group);
    return [{ mark, group, update: drawn.update }];
  });
}

/**
 * @param {import("./figure.js").Figure} figure
 * @param {number} index  of the view
 */
export function createDrawing(figure, index) {
  const { scene, store, life } = figure;
  const view = scene.views[index];
  const clip = `casteljau-clip-${clips += 1}`;
  const frame = svg("rect");
  const layers = {
    grid: svg("g", { "aria-hidden": "true" }),
    marks: svg("g", { "aria-hidden": "true", "clip-path": `url(#${clip})` }),
    labels: svg("g", { "aria-hidden": "true" }),
  };
  const labels = createLabels(layers.labels);
  const element = svg("svg", { class: "drawing" }, svg("clipPath", { id: clip }, frame), ...Object.values(layers));
  const drawing = { element, view, index, labels, map: fitView(view, 0) };
  const handles = createHandles(figure, drawing);
  element.setAttribute("role", handles.count > 0 ? "group" : "img");
  element.setAttribute("aria-label", [view.title, scene.description].filter(Boolean).join(". "));
  const marks = createMarks(figure, index, layers.marks, labels);

  function update() {
    const { map } = drawing;
    if (map.width === 0) return; // not laid out yet, as in a hidden tab
    labels.clear();
    handles.update();
    for (const { mark, group, update: move } of marks) {
      const { shown, active } = presence(mark, store.state.step);
      group.style.display = shown ? "" : "none";
      group.classList.toggle("active", active);
      move(map, shown);
    }
    labels.place(map);
  }

  function resize(/** @type {number} */ width) {
    if (width === drawing.map.width || width === 0) return;
    const map = drawing.map = fitView(view, width);
    element.setAttribute("height", String(map.height));
    for (const [name, value] of Object.entries({ x: map.left - BEYOND, y: map.top - BEYOND,
      width: map.right - map.left + 2 * BEYOND, height: map.bottom - map.top + 2 * BEYOND })) {
      frame.setAttribute(name, String(value));
    }
    layers.grid.replaceChildren(...(view.axes ? gridNodes(view, map) : []));
    update();
  }
  life.onResize(element, resize);

  return { element, update };
}
