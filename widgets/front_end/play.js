/** Motion a learner asked for: nothing here starts by itself. */

const PASS = 4000; // milliseconds for a slider to cross its range
const STILL = { steps: 8, interval: 700 }; // the same without animation: 1/8 of the range at a time
const STEP = 2000; // milliseconds to read the caption of a step

const reducedMotion = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

/** 0 -> 1 -> 0 as the phase runs from 0 to 2. */
const backAndForth = (/** @type {number} */ phase) => 1 - Math.abs((phase % 2) - 1);

/**
 * Start and stop a motion; while it runs, the browser owns the values.
 * @param {import("./store.js").Store} store
 * @param {() => (() => void)} begin  starts the motion, returns how to stop it
 * @param {(playing: boolean) => void} changed
 */
function createMotion(store, begin, changed) {
  let stop = /** @type {(() => void) | null} */ (null);
  const motion = {
    toggle: () => (stop ? motion.stop() : motion.start()),
    start() {
      store.begin();
      stop = begin();
      changed(true);
    },
    stop() {
      if (!stop) return;
      stop();
      stop = null;
      store.end();
      changed(false);
    },
  };
  return motion;
}

/**
 * A slider that runs from low to high and back.
 * @param {import("./figure.js").Figure} figure
 * @param {import("./scene.js").Slider} slider
 * @param {(playing: boolean) => void} changed
 */
export function playSlider({ store, life }, { name, low, high }, changed) {
  return createMotion(store, () => {
    let phase = (store.state.sliders[name] - low) / (high - low);
    const set = () => store.setSlider(name, low + (high - low) * backAndForth(phase));
    if (!reducedMotion()) return life.everyFrame((elapsed) => { phase += elapsed / PASS; set(); });
    return life.every(STILL.interval, () => {
      phase = (Math.floor(phase * STILL.steps + 1e-9) + 1) / STILL.steps;
      set();
    });
  }, changed);
}

/**
 * Steps, one after the other; it stops at the last one.
 * @param {import("./figure.js").Figure} figure
 * @param {() => void} announce
 * @param {(playing: boolean) => void} changed
 */
export function playSteps({ store, life, scene }, announce, changed) {
  const last = scene.steps.length - 1;
  const go = (/** @type {number} */ step) => {
    store.setStep(step);
    announce();
  };
  const motion = createMotion(store, () => {
    go(store.state.step >= last ? 0 : store.state.step + 1);
    return life.every(STEP, () => {
      if (store.state.step < last) go(store.state.step + 1);
      if (store.state.step >= last) motion.stop();
    });
  }, changed);
  return motion;
}
