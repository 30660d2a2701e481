import assert from "node:assert/strict";
import { test } from "node:test";
import { freeStep, nudge, snapTo } from "../../widgets/front_end/snap.js";

test("a value snaps to the nearest multiple", () => {
  assert.equal(snapTo(0.3, 0.125, 0, 1), 0.25);
  assert.equal(snapTo(0.32, 0.125, 0, 1), 0.375);
  assert.equal(snapTo(0.29, 0.1, 0, 1), 0.3);
  assert.equal(snapTo(-0.06, 0.125, -1, 1), 0);
});

test("snapping stays in the range, on the grid where the grid has a place there", () => {
  assert.equal(snapTo(7, 0.25, 0, 1.1), 1);
  assert.equal(snapTo(-7, 0.25, -0.3, 1), -0.25);
  assert.equal(snapTo(0.55, 1, 0.5, 0.6), 0.55);
});

test("nudging moves by the step from wherever the point is, and back again", () => {
  assert.equal(nudge(0.3, 0.125, 0, 1), 0.425);
  assert.equal(nudge(nudge(0.3, 0.125, 0, 1), -0.125, 0, 1), 0.3);
  assert.equal(nudge(0.95, 0.125, 0, 1), 1);
});

test("what does not snap moves by a round step near a hundredth of the range", () => {
  assert.equal(freeStep(0, 1), 0.01);
  assert.equal(freeStep(-5, 5), 0.1);
});
