/**
 * Where labels go. Each label tries places around its point and takes the one that covers the
 * least: other labels, points, curves, in this order of harm. A label that can only be put on
 * another label is hidden, and one that follows from others also in a crowd of points: an
 * unreadable label says less than none. The values still stand in the table of numbers.
 */

import { svgLabel } from "./dom.js";

const SIZE = 16;
const HEIGHT = 20; // with both scripts

/** Directions in order of preference, then the same farther away. */
const NEAR = [[0.8, -0.8], [-0.8, -0.8], [0, -1], [1, 0], [-1, 0], [0.8, 0.8], [-0.8, 0.8], [0, 1]];
const FARTHER = 12;
const PLACES = [0, FARTHER].flatMap((far) => NEAR.map(([x, y]) => ({ x, y, far })));

const COST = { label: 60, crowd: 15, outside: 30, far: 1.5, rank: 0.15, move: 2 };
/** How much covering a piece of a curve or of a point costs. */
const CURVE = 1;
const POINT = 3;
const SPACING = 7; // pixels between the samples of a line that count as obstacles
const CAPACITY = 6000;

/**
 * @typedef {object} Label
 * @property {SVGGElement} element
 * @property {number} width
 * @property {number} rank   smaller ranks choose first; 0: movable points
 * @property {number} gap    distance from the point
 * @property {number} x
 * @property {number} y
 * @property {boolean} wanted
 * @property {number} place  index into PLACES, -1 at first
 * @property {number} left
 * @property {number} top
 */

/** @param {SVGGElement} layer */
export function createLabels(layer) {
  /** @type {Label[]} */
  const labels = [];
  const obstacles = new Float64Array(3 * CAPACITY); // x, y, cost
  const near = new Float64Array(3 * CAPACITY); // those that the label being placed may meet
  let used = 0;
  let close = 0;
  let lastX = 0;
  let lastY = 0;

  function obstacle(/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ cost) {
    if (used + 3 > obstacles.length) return;
    obstacles[used] = x;
    obstacles[used + 1] = y;
    obstacles[used + 2] = cost;
    used += 3;
  }

  function cost(/** @type {Label} */ label, /** @type {number} */ index, /** @type {number} */ placed,
    /** @type {import("./transform.js").Transform} */ map) {
    const place = PLACES[index];
    const reach = label.gap + place.far;
    label.left = label.x + place.x * (reach + label.width / 2) - label.width / 2;
    label.top = label.y + place.y * (reach + HEIGHT / 2) - HEIGHT / 2;
    const right = label.left + label.width;
    const bottom = label.top + HEIGHT;
    let sum = index * COST.rank + (place.far ? COST.far : 0) - (index === label.place ? COST.move : 0);
    if (label.left < 2 || right > map.width - 2 || label.top < 2 || bottom > map.height - 2) sum += COST.outside;
    for (let k = 0; k < placed; k++) {
      const other = labels[k];
      if (other.wanted && label.left < other.left + other.width + 3 && right + 3 > other.left
        && label.top < other.top + HEIGHT && bottom > other.top) sum += COST.label;
    }
    for (let k = 0; k < close; k += 3) {
      const x = near[k];
      const y = near[k + 1];
      if (x > label.left - 2 && x < right + 2 && y > label.top && y < bottom) sum += near[k + 2];
    }
    return sum;
  }

  /** Collect the obstacles around a label once, for all the places it tries. */
  function lookAround(/** @type {Label} */ label) {
    const reach = label.gap + FARTHER + 2;
    close = 0;
    for (let k = 0; k < used; k += 3) {
      if (Math.abs(obstacles[k] - label.x) > reach + label.width) continue;
      if (Math.abs(obstacles[k + 1] - label.y) > reach + HEIGHT) continue;
      for (let c = 0; c < 3; c++) near[close + c] = obstacles[k + c];
      close += 3;
    }
  }

  return {
    /**
     * @param {string} text
     * @param {string} colour
     * @param {number} rank
     * @param {number} gap
     * @returns {Label}
     */
    add(text, colour, rank, gap) {
      const { element, width } = svgLabel(text, SIZE);
      element.style.fill = colour;
      layer.append(element);
      const label = { element, width, rank, gap, x: 0, y: 0, wanted: false, place: -1, left: 0, top: 0 };
      labels.push(label);
      labels.sort((a, b) => a.rank - b.rank);
      return label;
    },

    /** A new frame: forget the obstacles. */
    clear() { used = 0; },

    /** A point of this radius stands here. */
    point(/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ radius) {
      obstacle(x, y, POINT);
      for (const side of [-radius, radius]) {
        obstacle(x + side, y, POINT);
        obstacle(x, y + side, POINT);
      }
    },

    /** A line comes here, from the last such point unless it `starts` here. */
    line(/** @type {number} */ x, /** @type {number} */ y, /** @type {boolean} */ starts) {
      const length = starts ? SPACING : Math.hypot(x - lastX, y - lastY);
      if (length < SPACING) return; // wait for a sample farther on
      const parts = starts ? 1 : Math.min(Math.round(length / SPACING), 200);
      for (let k = 1; k <= parts; k++) {
        obstacle(lastX + ((x - lastX) * k) / parts, lastY + ((y - lastY) * k) / parts, CURVE);
      }
      lastX = x;
      lastY = y;
    },

    place(/** @type {import("./transform.js").Transform} */ map) {
      labels.forEach((label, index) => {
        let best = 0;
        let least = Infinity;
        if (label.wanted) {
          lookAround(label);
          for (let k = 0; k < PLACES.length; k++) {
            const sum = cost(label, k, index, map);
            if (sum < least) [best, least] = [k, sum];
          }
          cost(label, best, index, map); // stand there again
          label.place = best;
        }
        label.wanted &&= least < (label.rank === 0 ? COST.label : COST.crowd);
        label.element.style.display = label.wanted ? "" : "none";
        if (!label.wanted) return;
        const [x, y] = [Math.round(label.left * 10) / 10, Math.round((label.top + 0.72 * HEIGHT) * 10) / 10];
        label.element.setAttribute("transform", `translate(${x} ${y})`);
      });
    },
  };
}
