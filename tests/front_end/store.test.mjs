import assert from "node:assert/strict";
import { beforeEach, mock, test } from "node:test";
import { createStore } from "../../widgets/front_end/store.js";

const scene = {
  points: [{ name: "P", values: [[0, 0], [1, 2]] }],
  sliders: [{ name: "t", low: 0, high: 1, value: 0.5 }],
  steps: ["start", "one", "two"],
  step: 0,
};

/** anywidget's model as the store knows it; `told` counts the messages to Python. */
function createModel(traits = {}) {
  const values = { points: { P: [[0, 0], [1, 2]] }, t: 0.5, step: 0, ...traits };
  const listeners = [];
  return {
    values,
    listeners,
    told: 0,
    get: (name) => values[name],
    set(name, value) {
      values[name] = value;
      listeners.filter(([event]) => event === `change:${name}`).forEach(([, callback]) => callback());
    },
    on(event, callback) { listeners.push([event, callback]); },
    off(event, callback) {
      listeners.splice(listeners.findIndex(([e, c]) => e === event && c === callback), 1);
    },
    save_changes() { this.told += 1; },
  };
}

beforeEach(() => mock.timers.reset());

test("a store opens with the model's values", () => {
  const store = createStore(createModel({ t: 0.25, points: { P: [[3, 3], [4, 4]] }, step: 2 }), scene);
  assert.deepEqual(store.state, { points: { P: [[3, 3], [4, 4]] }, sliders: { t: 0.25 }, step: 2 });
});

test("during a drag Python is told every 100 ms, and once on release", () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const model = createModel();
  const store = createStore(model, scene);
  store.begin();
  for (let i = 1; i <= 60; i++) { // one second of frames
    store.movePoint("P", 0, i, 0);
    mock.timers.tick(16);
  }
  assert.ok(model.told >= 8 && model.told <= 10, `told ${model.told} times`);
  store.movePoint("P", 0, 99, 0);
  const before = model.told;
  store.end();
  assert.equal(model.told, before + 1);
  assert.deepEqual(model.values.points.P[0], [99, 0]);
  mock.timers.tick(1000);
  assert.equal(model.told, before + 1);
});

test("what Python sends during a drag is ignored, and the browser's value wins", () => {
  const model = createModel();
  const store = createStore(model, scene);
  store.begin();
  store.movePoint("P", 0, 5, 5);
  model.set("t", 0.9);
  model.set("points", { P: [[7, 7], [7, 7]] });
  assert.deepEqual(store.state.points.P[0], [5, 5]);
  assert.equal(store.state.sliders.t, 0.5);
  store.end();
  assert.deepEqual(model.values.points.P, [[5, 5], [1, 2]]);
  assert.equal(model.values.t, 0.5);
});

test("otherwise what Python sends is shown, can be undone, and is not echoed", () => {
  const model = createModel();
  const store = createStore(model, scene);
  let drawn = 0;
  store.onChange(() => { drawn += 1; });
  model.set("t", 0.9);
  assert.equal(store.state.sliders.t, 0.9);
  assert.ok(drawn > 0);
  assert.equal(model.told, 0);
  store.undo();
  assert.equal(store.state.sliders.t, 0.5);
  assert.equal(model.values.t, 0.5);
});

test("the model never holds the store's own arrays", () => {
  const model = createModel();
  const store = createStore(model, scene);
  store.movePoint("P", 0, 1, 1);
  store.commit();
  const sent = model.values.points;
  store.movePoint("P", 0, 2, 2);
  assert.deepEqual(sent.P[0], [1, 1]);
  store.commit();
});

test("a gesture is one entry of the history, however many moves it made", () => {
  const store = createStore(createModel(), scene);
  store.begin();
  for (let i = 1; i <= 9; i++) store.movePoint("P", 0, i, i);
  store.end();
  store.setStep(1);
  store.commit();
  store.undo();
  assert.equal(store.state.step, 0);
  assert.deepEqual(store.state.points.P[0], [9, 9]);
  store.undo();
  assert.deepEqual(store.state.points.P[0], [0, 0]);
  assert.equal(store.canUndo(), false);
});

test("a gesture that changes nothing leaves no entry", () => {
  const store = createStore(createModel(), scene);
  store.begin();
  store.end();
  assert.equal(store.canUndo(), false);
});

test("reset returns to the scene's values and can be undone", () => {
  const store = createStore(createModel({ t: 0.25 }), scene);
  assert.equal(store.canReset(), true);
  store.reset();
  assert.equal(store.state.sliders.t, 0.5);
  assert.equal(store.canReset(), false);
  store.undo();
  assert.equal(store.state.sliders.t, 0.25);
});

test("steps stay between the first and the last", () => {
  const model = createModel();
  const store = createStore(model, scene);
  store.setStep(9);
  assert.equal(store.state.step, 2);
  store.setStep(-1);
  assert.equal(store.state.step, 0);
  model.set("step", 7);
  assert.equal(store.state.step, 2);
});

test("a trait the model sends in another shape is not taken", () => {
  const model = createModel();
  const store = createStore(model, scene);
  model.set("points", { P: [[7, 7]] });
  assert.deepEqual(store.state.points.P, [[0, 0], [1, 2]]);
});

test("closing tells Python the last value and takes every listener away", () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const model = createModel();
  const store = createStore(model, scene);
  store.setSlider("t", 0.75);
  store.close();
  assert.equal(model.values.t, 0.75);
  assert.equal(model.listeners.length, 0);
  mock.timers.tick(1000);
  assert.equal(model.told, 1);
});

test("points on an axis keep their height", () => {
  const flat = { ...scene, points: [{ ...scene.points[0], along: "x" }] };
  const store = createStore(createModel(), flat);
  store.movePoint("P", 1, 3, 9);
  assert.deepEqual(store.state.points.P, [[0, 0], [3, 2]]);
});
