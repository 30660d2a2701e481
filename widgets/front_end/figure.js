/**
 * A figure: the learner's state goes through the tape, and what comes out goes to the parts
 * (drawings, controls, panels, numbers). A change of state asks for one frame; a frame runs the
 * tape once and lets every part update what it shows.
 */

import { createHistory, createSlider, createSteps } from "./controls.js";
import { html, htmlLabel } from "./dom.js";
import { createDrawing } from "./drawing.js";
import { DRAWING_MARKS } from "./marks.js";
import { createNumbers } from "./numbers.js";
import { createPanel, PANEL_MARKS } from "./panels.js";
import { createQuestion } from "./question.js";
import { createStore } from "./store.js";
import { load } from "./tape.js";

/** @typedef {import("./scene.js").Scene} Scene */
/** @typedef {import("./scene.js").Model} Model */
/** @typedef {import("./shell.js").Shell} Shell */
/** @typedef {ReturnType<typeof createContext>} Figure  what the parts of a figure share */
/** @typedef {{element: Element, update: () => void}} Part */

function checkKinds(/** @type {Scene} */ scene) {
  const known = { ...DRAWING_MARKS, ...PANEL_MARKS };
  const strange = scene.marks.find(({ kind }) => !Object.hasOwn(known, kind));
  if (strange) {
    throw new Error(`Expected marks of the kinds ${Object.keys(known).join(", ")}; received "${strange.kind}". `
      + "Run the cell again, or reinstall casteljau.");
  }
}

/** Write the state in the order of the tape's inputs: points row by row, then sliders. */
function pack(/** @type {Scene} */ scene, /** @type {import("./scene.js").State} */ state,
  /** @type {Float64Array} */ inputs) {
  let k = 0;
  for (const { name } of scene.points) {
    for (const [x, y] of state.points[name]) {
      inputs[k] = x;
      inputs[k + 1] = y;
      k += 2;
    }
  }
  for (const { name } of scene.sliders) inputs[k++] = state.sliders[name];
}

function createContext(/** @type {Shell} */ shell, /** @type {Model} */ model) {
  /** @type {Scene} */
  const scene = model.get("scene");
  checkKinds(scene);
  const tape = load(scene.tape, scene.axes);
  const store = createStore(model, scene, shell.life.guarded);
  shell.life.onEnd(store.close);
  const inputs = new Float64Array(scene.tape.inputs.length - scene.axes.length);
  const run = () => {
    pack(scene, store.state, inputs);
    tape.run(inputs);
  };
  run();
  return {
    scene, store, run, root: shell.root, life: shell.life, say: shell.say,
    output(/** @type {string} */ name) {
      if (!Object.hasOwn(tape.outputs, name)) throw new Error(`A mark uses "${name}", which is no output of the tape.`);
      return tape.outputs[name];
    },
    /** The figure's inputs as they stand, by the names the tape has for them. */
    inputsByName: () => Object.fromEntries(Array.from(inputs, (value, i) => [scene.tape.inputs[i], value])),
    /** Where the focus goes when a learner leaves the drawing with Escape. */
    leaveDrawing() {
      /** @type {HTMLElement | null} */ (shell.root.querySelector(".after :is(button, input, summary)"))?.focus();
    },
    stopPlaying: () => {},
  };
}

/** Beside the drawing stand panels that are high and not too wide; a readout is one line. */
function standsBeside(/** @type {Scene} */ scene) {
  return scene.marks.some(({ kind }) => kind === "scheme" || kind === "weights")
    && scene.marks.every(({ sizes = [] }) => sizes.length <= 5);
}

/**
 * Draw the model's scene into a shell.
 * @param {Shell} shell
 * @param {Model} model
 */
export function createFigure(shell, model) {
  const figure = createContext(shell, model);
  const { scene, store, life } = figure;

  const drawings = scene.views.map((_, index) => createDrawing(figure, index));
  const history = createHistory(figure);
  const steps = scene.steps.length > 0 ? [createSteps(figure)] : [];
  const sliders = scene.sliders.map((slider) => createSlider(figure, slider));
  const panels = scene.marks.filter(({ kind }) => Object.hasOwn(PANEL_MARKS, kind))
    .map((mark) => createPanel(figure, mark));
  const questions = scene.questions.map((question) => createQuestion(figure, question));
  const numbers = createNumbers(figure);
  figure.stopPlaying = () => [...steps, ...sliders].forEach((control) => control.stop());

  const elements = (/** @type {Part[]} */ parts) => parts.map(({ element }) => element);
  const views = drawings.map(({ element }, i) => html("div", { class: "view" },
    ...(scene.views[i].title ? [html("p", { class: "heading" }, htmlLabel(scene.views[i].title))] : []), element));
  shell.root.append(html("div", { class: standsBeside(scene) ? "layout beside" : "layout" },
    html("div", { class: "head" }, html("p", { class: "title" }, htmlLabel(scene.title)), history.element),
    html("div", { class: "views" }, ...views),
    html("div", { class: "after controls" }, ...elements(steps),
      ...(questions.length > 0 ? [html("div", { class: "questions" }, ...elements(questions))] : []),
      ...(sliders.length > 0 ? [html("div", { class: "sliders" }, ...elements(sliders))] : [])),
    ...(panels.length > 0 ? [html("div", { class: "after panels" }, ...elements(panels))] : []),
    ...(numbers ? [html("div", { class: "after table" }, numbers.element)] : [])));

  /** @type {Part[]} */
  const parts = [...drawings, history, ...steps, ...questions, ...sliders, ...panels, ...(numbers ? [numbers] : [])];
  const draw = () => {
    figure.run();
    for (const part of parts) part.update();
  };
  store.onChange(life.framed(draw));
  draw();
}
