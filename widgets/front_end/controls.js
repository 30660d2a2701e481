/** The controls under a drawing: steps and their captions, sliders; and undo and reset above it. */

import { attributeWriter, html, htmlLabel, icon, textWriter } from "./dom.js";
import { createField } from "./field.js";
import { playSlider, playSteps } from "./play.js";
import { FINER, freeStep, nudge, snapTo } from "./snap.js";
import { format, spoken } from "./text.js";

/** @typedef {import("./figure.js").Figure} Figure */
/** @typedef {import("./scene.js").Slider} Slider */

/** A button with an icon. One that cannot act keeps its place and the focus. */
function iconButton(/** @type {Figure} */ { life }, /** @type {Parameters<typeof icon>[0]} */ symbol,
  /** @type {string} */ name, /** @type {() => void} */ action) {
  const element = html("button", { class: "button", type: "button", "aria-label": name, title: name }, icon(symbol));
  const write = attributeWriter(element, "aria-disabled");
  life.listen(element, "click", () => { if (element.getAttribute("aria-disabled") !== "true") action(); });
  return { element, enable: (/** @type {boolean} */ can) => write(String(!can)) };
}

/** A button that shows what pressing it will do: play or pause. */
function playButton(/** @type {Figure} */ figure, /** @type {string} */ what, /** @type {() => void} */ action) {
  const { element } = iconButton(figure, "play", `Play ${what}`, action);
  const setPlaying = (/** @type {boolean} */ playing) => {
    element.replaceChildren(icon(playing ? "pause" : "play"));
    element.title = `${playing ? "Pause" : "Play"} ${what}`;
    element.setAttribute("aria-label", element.title);
  };
  return { element, setPlaying };
}

/** A native range input: the browser gives it touch, focus, and its role. */
function range(/** @type {string} */ name, /** @type {number} */ low, /** @type {number} */ high,
  /** @type {number | "any"} */ step) {
  const element = html("input", { class: "range", type: "range", min: low, max: high, step, "aria-label": name });
  let last = NaN;
  const show = (/** @type {number} */ value, /** @type {string} */ text) => {
    if (value === last && Number(element.value) === value) return;
    last = value;
    element.value = String(value);
    element.style.setProperty("--filled", `${(100 * (value - low)) / (high - low)}%`);
    element.setAttribute("aria-valuetext", text);
  };
  return { element, show };
}

/** Undo and reset. */
export function createHistory(/** @type {Figure} */ figure) {
  const { store, say } = figure;
  const act = (/** @type {() => void} */ action, /** @type {string} */ said) => () => {
    figure.stopPlaying();
    action();
    say(said);
  };
  const undo = iconButton(figure, "undo", "Undo", act(store.undo, "Undone"));
  const reset = iconButton(figure, "reset", "Reset", act(store.reset, "Reset"));
  return {
    element: html("div", { class: "history" }, undo.element, reset.element),
    update() {
      undo.enable(store.canUndo());
      reset.enable(store.canReset());
    },
  };
}

/** Step back, play, step forward, scrub, and the caption of the step. */
export function createSteps(/** @type {Figure} */ figure) {
  const { scene, store, say, life } = figure;
  const last = scene.steps.length - 1;
  const announce = () => say(`Step ${store.state.step} of ${last}: ${spoken(scene.steps[store.state.step])}`);
  const go = (/** @type {number} */ step) => {
    motion.stop();
    store.setStep(step);
    store.commit();
    announce();
  };
  const back = iconButton(figure, "back", "Step back", () => go(store.state.step - 1));
  const forward = iconButton(figure, "forward", "Step forward", () => go(store.state.step + 1));
  const play = playButton(figure, "the steps", () => motion.toggle());
  const motion = playSteps(figure, announce, play.setPlaying);
  const scrubber = range("Step", 0, last, 1);
  life.listen(scrubber.element, "input", () => go(Number(scrubber.element.value)));
  const count = html("span", { class: "count", "aria-hidden": "true" });
  const writeCount = textWriter(count);
  // All captions share one cell, so that a longer one never moves the controls below it.
  const captions = scene.steps.map((text) => html("p", {}, htmlLabel(text)));

  return {
    element: html("div", { class: "steps" },
      html("div", { class: "captions" }, ...captions),
      html("div", { class: "row" }, back.element, play.element, forward.element, scrubber.element, count)),
    stop: motion.stop,
    update() {
      const { step } = store.state;
      back.enable(step > 0);
      forward.enable(step < last);
      scrubber.show(step, `${step} of ${last}`);
      writeCount(`${step} / ${last}`);
      captions.forEach((caption, i) => { caption.classList.toggle("current", i === step); });
    },
  };
}

const ARROWS = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 };

/** Dragging and arrow keys on a slider's range: snapped, and one move of the history each. */
function listenToRange(/** @type {Figure} */ { store, life }, /** @type {Slider} */ { name, low, high, snap },
  /** @type {HTMLInputElement} */ element, /** @type {() => void} */ onBegin, /** @type {() => void} */ onEnd) {
  const step = snap ?? freeStep(low, high);
  let moving = false;
  const move = (/** @type {number} */ value) => {
    onBegin();
    if (!moving) store.begin();
    moving = true;
    store.setSlider(name, value);
  };
  const release = () => {
    if (!moving) return;
    moving = false;
    store.end();
    onEnd();
  };
  life.listen(element, "input", () => move(snapTo(Number(element.value), snap ?? step / FINER, low, high)));
  life.listen(element, "keydown", (event) => {
    const sign = ARROWS[/** @type {keyof typeof ARROWS} */ (event.key)];
    if (!sign || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    move(nudge(store.state.sliders[name], sign * (event.shiftKey ? step / FINER : step), low, high));
  });
  for (const type of ["change", "keyup", "blur"]) life.listen(element, type, release);
}

/** A slider: play button where the scene asks for one, range, number field. */
export function createSlider(/** @type {Figure} */ figure, /** @type {Slider} */ slider) {
  const { store, life, say } = figure;
  const { name, low, high } = slider;
  const word = spoken(slider.label);
  const announce = () => say(`${word} = ${format(store.state.sliders[name])}`);
  // "any": while playing, the thumb stands between the stops; snapping is ours.
  const { element, show } = range(word, low, high, "any");
  const play = playButton(figure, word, () => motion.toggle());
  const motion = playSlider(figure, slider, (playing) => {
    play.setPlaying(playing);
    if (!playing) announce();
  });
  const field = createField(life, { name: `${word}, number`, low, high, accept(value) {
    motion.stop();
    store.setSlider(name, value);
    store.commit();
    announce();
  } });

  listenToRange(figure, slider, element, motion.stop, announce);
  // A range may rest between the stops after a drag: put it on the value it was snapped to.
  life.listen(element, "input", () => show(store.state.sliders[name], format(store.state.sliders[name])));

  return {
    element: html("div", { class: "slider" }, htmlLabel(slider.label), ...(slider.play ? [play.element] : []),
      element, field.input, field.message),
    stop: motion.stop,
    update() {
      const value = store.state.sliders[name];
      show(value, format(value));
      field.show(value);
    },
  };
}
