import assert from "node:assert/strict";
import { test } from "node:test";
import { fitView, niceTicks } from "../../widgets/front_end/transform.js";

const view = { name: "plane", title: "", x: [-1, 5], y: [0, 3], equal: true, axes: true };
const screen = (map, x, y) => [map.sx * x + map.ox, map.sy * y + map.oy];

test("the corners of the view meet the corners of the plot, y upwards", () => {
  const map = fitView(view, 600);
  const [[x0, y0], [x1, y1]] = [screen(map, -1, 0), screen(map, 5, 3)];
  for (const [got, expected] of [[x0, map.left], [y0, map.bottom], [x1, map.right], [y1, map.top]]) {
    assert.ok(Math.abs(got - expected) < 1e-9);
  }
});

test("equal units stay equal, also where the drawing would be too tall", () => {
  for (const shape of [view, { ...view, y: [0, 60] }]) {
    const map = fitView(shape, 800);
    assert.ok(Math.abs(map.sx + map.sy) < 1e-9);
    assert.ok(map.height <= 460);
  }
});

test("no width yet is no error", () => {
  assert.ok(Number.isFinite(fitView(view, 0).sx));
});

test("ticks are round numbers, not more than asked for", () => {
  assert.deepEqual(niceTicks(-0.5, 4.5, 6), [0, 1, 2, 3, 4]);
  assert.deepEqual(niceTicks(0, 1, 5), [0, 0.2, 0.4, 0.6, 0.8, 1]);
  assert.deepEqual(niceTicks(0, 1, 3), [0, 0.5, 1]);
});
