/**
 * The walls between a figure and the page it stands in: a shadow root, so that no style leaks in
 * or out; keys that stay inside; a voice for screen readers; and a place for bad news.
 */

import { html } from "./dom.js";
import { createLife } from "./life.js";

/** @typedef {ReturnType<typeof createShell>} Shell */

/** @param {HTMLElement} parent */
export function createShell(parent) {
  const host = html("div", { class: "casteljau-host" });
  const shadow = host.attachShadow({ mode: "open" });
  const style = html("style");
  style.textContent = CASTELJAU_STYLE; // figure.css, minified, put in by build.py
  const alert = html("p", { class: "alert", role: "alert", hidden: true });
  const voice = html("p", { class: "unseen", "aria-live": "polite" });
  const root = html("div", { class: "casteljau" }, alert);
  shadow.append(style, root, voice);
  parent.append(host);

  const notice = (/** @type {string} */ message) => {
    alert.textContent = message;
    alert.hidden = false;
  };
  const fail = (/** @type {unknown} */ error) => {
    const message = `This figure stopped: ${error instanceof Error ? error.message : error}`;
    if (alert.textContent === message) return; // the same failure on every frame is one failure
    notice(message);
    console.error(error);
  };
  const life = createLife(fail);

  // JupyterLab's command mode listens for single letters on the document: typing "3/8" or pressing
  // an arrow must not delete or select cells. Shortcuts with Ctrl, Meta or Alt, and Tab, stay the host's.
  life.listen(root, "keydown", (event) => {
    if (!event.ctrlKey && !event.metaKey && !event.altKey && event.key !== "Tab") event.stopPropagation();
  });

  /** @param {string} text */
  const say = (text) => {
    // The same sentence twice would not be a change, and so not be spoken.
    voice.textContent = voice.textContent === text ? `${text}\u00a0` : text;
  };
  const close = () => {
    life.end();
    host.remove();
  };
  return { root, life, say, notice, fail, close };
}
