/**
 * The learner's state: control points, sliders, step. Holds its history for undo, and keeps the
 * model (hence Python) informed without flooding it.
 *
 * The browser owns the values during a gesture (a drag, a held key, playing): what Python sends
 * meanwhile is ignored, and the browser's value wins when the gesture ends. Otherwise what
 * Python sends is shown.
 */

/** @typedef {import("./scene.js").State} State */
/** @typedef {ReturnType<typeof createStore>} Store */

/** Milliseconds between two messages to the model while values keep changing. */
const INTERVAL = 100;
const HISTORY = 200;

const copy = (/** @type {any} */ value) => JSON.parse(JSON.stringify(value));
const same = (/** @type {any} */ a, /** @type {any} */ b) => JSON.stringify(a) === JSON.stringify(b);

/** @returns {State} */
function initial(/** @type {import("./scene.js").Scene} */ scene) {
  return copy({
    points: Object.fromEntries(scene.points.map(({ name, values }) => [name, values])),
    sliders: Object.fromEntries(scene.sliders.map(({ name, value }) => [name, value])),
    step: scene.step,
  });
}

/**
 * @param {import("./scene.js").Model} model
 * @param {import("./scene.js").Scene} scene
 * @param {import("./life.js").Life["guarded"]} guarded  around what timers and the model call
 */
export function createStore(model, scene, guarded = (action) => action) {
  const start = initial(scene);
  const level = new Set(scene.points.filter(({ along }) => along === "x").map(({ name }) => name));
  const traits = ["points", "step", ...scene.sliders.map(({ name }) => name)];
  const state = initial(scene);
  /** @type {State[]} */
  const past = [];
  let gestures = 0;
  let saving = false;
  /** @type {ReturnType<typeof setTimeout> | null} */
  let timer = null;
  let notify = () => {};

  const existing = (/** @type {number} */ step) => Math.min(Math.max(step, 0), Math.max(scene.steps.length - 1, 0));

  const read = (/** @type {string} */ trait) => (trait in state.sliders ? state.sliders[trait]
    : trait === "points" ? state.points : state.step);

  /** Take the model's values where it has any. */
  function receive() {
    const points = model.get("points");
    for (const name of Object.keys(state.points)) {
      if (points?.[name]?.length === start.points[name].length) state.points[name] = copy(points[name]);
    }
    for (const name of Object.keys(state.sliders)) state.sliders[name] = model.get(name) ?? state.sliders[name];
    state.step = existing(model.get("step") ?? state.step);
  }

  function save() {
    timer = null;
    const changed = traits.filter((trait) => !same(model.get(trait), read(trait)));
    if (changed.length === 0) return;
    saving = true; // our own set() calls come back as change events
    for (const trait of changed) model.set(trait, copy(read(trait)));
    saving = false;
    model.save_changes();
  }

  function flush() {
    if (timer !== null) clearTimeout(timer);
    save();
  }

  function touched() {
    timer ??= setTimeout(guarded(save), INTERVAL);
    notify();
  }

  /** Close a chapter of the history: undo returns to the state before it. */
  function commit() {
    if (!same(state, last)) {
      past.push(last);
      if (past.length > HISTORY) past.shift();
      last = copy(state);
    }
    flush();
    notify();
  }

  const adopt = guarded(() => {
    if (saving || gestures > 0) return;
    receive();
    commit();
  });

  receive();
  let last = copy(state);
  for (const trait of traits) model.on(`change:${trait}`, adopt);

  return {
    state,
    commit,
    onChange(/** @type {() => void} */ action) { notify = action; },

    /** @type {(name: string, index: number, x: number, y: number) => void} */
    movePoint(name, index, x, y) {
      const point = state.points[name][index];
      if (level.has(name)) y = start.points[name][index][1];
      if (point[0] === x && point[1] === y) return;
      [point[0], point[1]] = [x, y];
      touched();
    },
    setSlider(/** @type {string} */ name, /** @type {number} */ value) {
      if (state.sliders[name] === value) return;
      state.sliders[name] = value;
      touched();
    },
    setStep(/** @type {number} */ step) {
      if (state.step === existing(step)) return;
      state.step = existing(step);
      touched();
    },

    /** A gesture begins: Python is not listened to until it ends. Gestures may overlap. */
    begin() { gestures += 1; },
    end() {
      gestures -= 1;
      commit();
    },
    /** The state before the current gesture, to give up a drag. */
    before: () => last,

    canUndo: () => past.length > 0 || !same(state, last),
    undo() {
      const previous = same(state, last) ? past.pop() : last;
      if (!previous) return;
      Object.assign(state, copy(previous));
      last = copy(previous);
      flush();
      notify();
    },
    canReset: () => !same(state, start),
    reset() {
      Object.assign(state, copy(start));
      commit();
    },

    close() {
      for (const trait of traits) model.off(`change:${trait}`, adopt);
      flush();
    },
  };
}
