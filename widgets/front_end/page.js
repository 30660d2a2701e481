/**
 * Figures in a page without a kernel: every `<div class="casteljau-figure" data-figure="ID">` is
 * replaced by the figure whose state stands in `<script data-figure-state="ID">` as JSON.
 */

import figure from "./index.js";

/**
 * The part of anywidget's model a figure needs, in memory.
 * @param {Record<string, any>} state
 * @returns {import("./scene.js").Model}
 */
function createModel(state) {
  const events = new EventTarget();
  return {
    get: (name) => state[name],
    set(name, value) {
      state[name] = value;
      events.dispatchEvent(new Event(`change:${name}`));
    },
    on: (event, callback) => events.addEventListener(event, callback),
    off: (event, callback) => events.removeEventListener(event, callback),
    save_changes() {},
  };
}

function mount(/** @type {HTMLElement} */ place) {
  const id = CSS.escape(place.dataset.figure ?? "");
  const text = document.querySelector(`script[data-figure-state="${id}"]`)?.textContent;
  if (!text || place.dataset.mounted) return;
  place.dataset.mounted = "true"; // this script may stand in a page more than once
  try {
    const { sliders, ...state } = JSON.parse(text);
    place.replaceChildren(); // the poster
    figure.render({ model: createModel({ ...state, ...sliders }), el: place });
  } catch (error) {
    place.append(`This figure's data cannot be read: ${error}`);
  }
}

function mountAll() {
  document.querySelectorAll(".casteljau-figure").forEach((place) => mount(/** @type {HTMLElement} */ (place)));
}

if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", mountAll);
else mountAll();
