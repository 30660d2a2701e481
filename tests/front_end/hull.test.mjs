import assert from "node:assert/strict";
import test from "node:test";
import { convexHull } from "../../widgets/front_end/marks.js";

const hull = (...values) => {
  const corners = new Float64Array(values.length);
  convexHull(Float64Array.from(values), corners);
  return [...corners];
};

test("corners go round, and the first one fills up", () => {
  assert.deepEqual(hull(0, 0, 1, 3, 1, 1, 2, 0), [0, 0, 2, 0, 1, 3, 0, 0]);
  assert.deepEqual(hull(0, 0, 2, 2, 2, 0, 0, 2), [0, 0, 2, 0, 2, 2, 0, 2]);
});

test("coincident and collinear points have a hull", () => {
  assert.deepEqual(hull(1, 2, 1, 2, 1, 2), [1, 2, 1, 2, 1, 2]);
  assert.deepEqual(hull(1, 1, 0, 0, 3, 3, 2, 2), [0, 0, 3, 3, 0, 0, 0, 0]);
});
