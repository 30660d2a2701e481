/** Making elements. Text is always set as text, never as markup: labels come from a file. */

import { parseLabel } from "./text.js";

const SVG = "http://www.w3.org/2000/svg";

/**
 * @template {Element} E
 * @param {E} element
 * @param {Record<string, string | number | boolean | undefined>} attributes  false or undefined: left out
 * @param {(Node | string)[]} children
 */
function fill(element, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    // The style attribute is set through the DOM, which a strict content-security policy permits.
    if (name === "style") /** @type {any} */ (element).style.cssText = value;
    else if (value !== undefined && value !== false) element.setAttribute(name, value === true ? "" : String(value));
  }
  element.append(...children);
  return element;
}

/**
 * @template {keyof HTMLElementTagNameMap} K
 * @param {K} tag
 * @returns {HTMLElementTagNameMap[K]}
 */
export function html(tag, attributes = {}, /** @type {(Node | string)[]} */ ...children) {
  return fill(document.createElement(tag), attributes, children);
}

/**
 * @template {keyof SVGElementTagNameMap} K
 * @param {K} tag
 * @returns {SVGElementTagNameMap[K]}
 */
export function svg(tag, attributes = {}, /** @type {(Node | string)[]} */ ...children) {
  return /** @type {any} */ (fill(document.createElementNS(SVG, tag), attributes, children));
}

/** A function that sets an element's text, touching the document only when it differs. */
export function textWriter(/** @type {Element} */ element) {
  let last = element.textContent;
  return (/** @type {string} */ text) => { if (text !== last) element.textContent = last = text; };
}

/** The same for one attribute. */
export function attributeWriter(/** @type {Element} */ element, /** @type {string} */ name) {
  let last = element.getAttribute(name);
  return (/** @type {string} */ value) => { if (value !== last) element.setAttribute(name, last = value); };
}

/** A difference is written with a true minus sign. */
const typeset = (/** @type {string} */ text) => text.replaceAll(" - ", " \u2212 ");

/** A label in HTML; a subscript under a superscript stand in one column. */
export function htmlLabel(/** @type {string} */ text) {
  const label = html("span", { class: "label" });
  for (const { base, sub, sup, italic } of parseLabel(text)) {
    const letter = italic ? html("i", {}, base) : typeset(base);
    const scripts = [...(sup ? [html("sup", {}, sup)] : []), ...(sub ? [html("sub", {}, sub)] : [])];
    if (scripts.length === 0) label.append(letter);
    else if (scripts.length === 1) label.append(html("span", { class: "variable" }, letter, ...scripts));
    else label.append(html("span", { class: "variable" }, letter, html("span", { class: "scripts" }, ...scripts)));
  }
  return label;
}

const SCRIPT = 0.7; // size of sub- and superscripts
const DIGIT = 0.5 * SCRIPT; // width of their digits, as in nearly every serif

/** About how wide a letter is, as a share of the font size: enough to keep labels apart. */
const breadth = (/** @type {string} */ c) => (/[()[\]|.,:;'ijltfr ]/.test(c) ? 0.33 : /[A-Zmw]/.test(c) ? 0.7 : 0.5);

/** A label in a drawing, starting at x = 0 on the baseline; `width` is about its width in pixels. */
export function svgLabel(/** @type {string} */ text, /** @type {number} */ size) {
  const label = svg("text", { class: "label", "font-size": size });
  let width = 0;
  let back = 0; // from the end of the last token's scripts
  for (const { base, sub, sup, italic } of parseLabel(text)) {
    label.append(svg("tspan", { y: 0, dx: back, "font-style": italic ? "italic" : "normal" }, typeset(base)));
    // A subscript goes back under the superscript, whichever is longer ends the token.
    const [over, under] = [sup, sub].map((script) => script.length * DIGIT * size);
    const script = (/** @type {number} */ y, /** @type {number} */ dx, /** @type {string} */ s) => (
      label.append(svg("tspan", { y: y * size, dx, "font-size": SCRIPT * size }, s)));
    if (sup) script(-0.38, 0, sup);
    if (sub) script(0.24, -over, sub);
    back = sub ? Math.max(over - under, 0) : 0;
    width += Math.max(over, under) + [...base].reduce((sum, c) => sum + breadth(c) * size, 0);
  }
  // Moving a group around a text is free; moving the text itself lays it out again.
  return { element: svg("g", {}, label), width };
}

/** Icons are paths on a 16 x 16 grid, drawn in the text's colour. */
const ICONS = {
  play: "M5 3.2v9.6a.6.6 0 0 0 .9.5l7.6-4.8a.6.6 0 0 0 0-1L5.9 2.7a.6.6 0 0 0-.9.5z",
  pause: "M4.5 3h2.200v10H4.500zM9.3 3h2.200v10H9.300z",
  back: "M10.6 3.2 5.8 8l4.8 4.8",
  forward: "M5.4 3.2 10.2 8l-4.8 4.8",
  undo: "M5.6 3 2.8 5.800l2.8 2.800M3 5.800h6.200a3.7 3.7 0 0 1 0 7.400H6.4",
  reset: "M3.2 8a4.8 4.8 0 1 0 1.5-3.500M3 2.400v2.800h2.8",
};
const FILLED = new Set(["play", "pause"]);

/** @param {keyof typeof ICONS} name */
export function icon(name) {
  return svg("svg", { class: FILLED.has(name) ? "icon filled" : "icon", viewBox: "0 0 16 16", "aria-hidden": "true" },
    svg("path", { d: ICONS[name] }));
}
