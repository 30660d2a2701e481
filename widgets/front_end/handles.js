/**
 * Movable points: sliders in two dimensions, by pointer, keyboard, or tapping.
 *
 * From outside, one tab stop leads to the last used handle; once the focus is among the handles,
 * each is a tab stop, so that Tab walks them by itself and leaves at the end.
 */

import { svg } from "./dom.js";
import { listenForDrags } from "./drag.js";
import { listenForNudges } from "./nudges.js";
import { presence } from "./marks.js";
import { freeStep } from "./snap.js";
import { format, spoken } from "./text.js";
import { cssColour } from "./theme.js";

/** @typedef {import("./figure.js").Figure} Figure */
/**
 * @typedef {object} Drawing
 * @property {SVGSVGElement} element
 * @property {import("./scene.js").View} view
 * @property {number} index  of the view
 * @property {import("./marks.js").Labels} labels
 * @property {import("./transform.js").Transform} map
 *
 * @typedef {object} Handle
 * @property {SVGGElement} element
 * @property {string} group  name of its group of points
 * @property {number} index
 * @property {string} name   as spoken
 * @property {number} step   of snapping and nudging
 * @property {import("./labels.js").Label} label
 * @property {boolean} hidden  at this step
 */

const TOUCH = 22; // radius: a finger needs 44 px
const BODY = 7.5;
const RING = 14;

/** @returns {Handle} */
function createHandle(/** @type {Drawing} */ drawing, /** @type {import("./scene.js").PointGroup} */ group,
  /** @type {number} */ index) {
  const text = group.labels[index] ?? `${group.name}_${index}`;
  const colour = cssColour(group.colors[index] ?? index);
  const element = svg("g", {
    class: "handle", role: "slider", style: `--colour: ${colour}`, "aria-label": spoken(text),
    "aria-roledescription": "movable point", "aria-valuemin": drawing.view.x[0], "aria-valuemax": drawing.view.x[1],
  },
  svg("circle", { class: "touch", r: TOUCH }), svg("circle", { class: "ring", r: RING }),
  svg("rect", { class: "body", x: -BODY, y: -BODY, width: 2 * BODY, height: 2 * BODY, rx: 3 }),
  svg("circle", { class: "core", r: 2.5 }));
  return { element, group: group.name, index, name: spoken(text), step: group.snap ?? freeStep(...drawing.view.x),
    label: drawing.labels.add(text, colour, 0, RING), hidden: false };
}

/**
 * @param {Figure} figure
 * @param {Drawing} drawing
 */
export function createHandles(figure, drawing) {
  const { scene, store, life, say } = figure;
  const { element: drawn } = drawing;
  const handles = scene.points.filter((group) => group.view === drawing.index)
    .flatMap((group) => group.values.map((_, i) => createHandle(drawing, group, i)));
  const layer = svg("g", { class: "handles" }, ...handles.map(({ element }) => element));
  drawn.append(layer);

  let selected = /** @type {Handle | null} */ (null);

  const at = (/** @type {Handle} */ handle) => store.state.points[handle.group][handle.index];
  const value = (/** @type {Handle} */ handle) => at(handle).map((v) => format(v)).join(", ");
  const find = (/** @type {Event} */ event) => handles.find(({ element }) => event.composedPath().includes(element));
  const announce = (/** @type {Handle} */ handle) => say(`${handle.name} at ${value(handle)}`);

  function roving(/** @type {Handle | undefined} */ active, /** @type {boolean} */ inside) {
    for (const handle of handles) handle.element.tabIndex = inside || handle === active ? 0 : -1;
  }

  function select(/** @type {Handle | null} */ handle) {
    selected?.element.classList.remove("selected");
    handle?.element.classList.add("selected");
    drawn.classList.toggle("placing", handle !== null);
    if (handle) say(`${handle.name} selected; tap the drawing to place it there`);
    else if (selected) say(`${selected.name} not selected`);
    selected = handle;
  }

  function onEscape(/** @type {KeyboardEvent} */ event) {
    if (event.key !== "Escape") return;
    const dragged = drag.cancel();
    if (!dragged && !find(event) && !selected) return;
    event.preventDefault();
    select(null);
    figure.leaveDrawing();
  }

  // On the root, since Chromium makes an SVG element that listens for focus a tab stop itself.
  life.listen(figure.root, "focusin", (event) => { if (find(event)) roving(find(event), true); });
  life.listen(figure.root, "focusout", (event) => {
    if (find(event) && !layer.contains(event.relatedTarget)) roving(find(event), false);
  });
  life.listen(figure.root, "keydown", onEscape);
  listenForNudges(figure, drawing, find, announce);
  const drag = listenForDrags(figure, drawing, handles, {
    onMoved: announce,
    onTap: (handle) => select(handle === selected ? null : handle),
    onBackground(place) {
      if (!selected) return;
      const handle = selected;
      select(null);
      place(handle);
    },
  });
  roving(handles[0], false);

  /** Handles come and go with the steps; the tab stop is one that is there. */
  function comeAndGo() {
    let changed = false;
    for (const handle of handles) {
      const group = scene.points.find(({ name }) => name === handle.group);
      const hidden = !presence(group ?? {}, store.state.step).shown;
      if (hidden === handle.hidden) continue;
      changed = true;
      handle.hidden = hidden;
      handle.label.wanted = false;
      handle.element.toggleAttribute("hidden", hidden);
      if (hidden && handle === selected) select(null);
    }
    if (changed) roving(handles.find(({ hidden }) => !hidden), false);
  }

  function update() {
    const { map, labels } = drawing;
    comeAndGo();
    for (const handle of handles) {
      if (handle.hidden) continue;
      const [x, y] = at(handle);
      const [px, py] = [map.sx * x + map.ox, map.sy * y + map.oy];
      handle.label.x = px;
      handle.label.y = py;
      handle.label.wanted = true;
      labels.point(px, py, BODY + 3);
      const place = `translate(${Math.round(px * 100) / 100} ${Math.round(py * 100) / 100})`;
      if (handle.element.getAttribute("transform") === place) continue;
      handle.element.setAttribute("transform", place);
      handle.element.setAttribute("aria-valuenow", String(x));
      handle.element.setAttribute("aria-valuetext", `x ${format(x)}, y ${format(y)}`);
    }
  }

  return { count: handles.length, update };
}
