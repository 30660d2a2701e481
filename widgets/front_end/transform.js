/** From the plane to pixels: y points up in the plane, down on the screen. */

/**
 * @typedef {object} Transform  x on screen is sx * x + ox, y is sy * y + oy
 * @property {number} width
 * @property {number} height
 * @property {number} left    the plot's rectangle in pixels
 * @property {number} right
 * @property {number} top
 * @property {number} bottom
 * @property {number} sx
 * @property {number} ox
 * @property {number} sy
 * @property {number} oy
 */

const MARGIN = { top: 12, right: 14, bottom: 12, left: 14 };
/** Room for the numbers on the axes. */
const NUMBERS = { bottom: 26, left: 36 };
const TALLEST = 460;
const SHAPE = 0.62; // height over width where x and y have different units

/**
 * Fit a view into `width` pixels. A view whose units are equal keeps its shape; where that would
 * be too tall, more of the plane is shown at both sides.
 * @param {import("./scene.js").View} view
 * @param {number} width
 * @returns {Transform}
 */
export function fitView(view, width) {
  const [x0, x1] = view.x;
  const [y0, y1] = view.y;
  const left = view.axes ? NUMBERS.left : MARGIN.left;
  const below = view.axes ? NUMBERS.bottom : MARGIN.bottom;
  const right = Math.max(width - MARGIN.right, left + 1);
  const across = right - left;
  const natural = view.equal ? (across * (y1 - y0)) / (x1 - x0) : across * SHAPE;
  const tall = Math.min(natural, TALLEST - MARGIN.top - below);
  const sy = -tall / (y1 - y0);
  const sx = view.equal ? -sy : across / (x1 - x0);
  return {
    width, height: Math.round(MARGIN.top + tall + below),
    left, right, top: MARGIN.top, bottom: MARGIN.top + tall,
    sx, ox: (left + right) / 2 - (sx * (x0 + x1)) / 2,
    sy, oy: MARGIN.top + tall - sy * y0,
  };
}

/**
 * The part of the plane that a drawing shows: more than its view where units are equal.
 * @param {Transform} map
 * @returns {{x: [number, number], y: [number, number]}}
 */
export function shownRange(map) {
  return {
    x: [(map.left - map.ox) / map.sx, (map.right - map.ox) / map.sx],
    y: [(map.bottom - map.oy) / map.sy, (map.top - map.oy) / map.sy],
  };
}

/**
 * Round numbers in [low, high], at most `most` of them: steps of 1, 2 or 5 times a power of ten.
 * @param {number} low
 * @param {number} high
 * @param {number} most
 */
export function niceTicks(low, high, most) {
  const rough = (high - low) / Math.max(most, 1);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((m) => m * power).find((s) => s >= rough * (1 - 1e-9)) ?? 10 * power;
  const ticks = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + step * 1e-9; k++) {
    ticks.push(Number((k * step).toPrecision(12)));
  }
  return ticks;
}
