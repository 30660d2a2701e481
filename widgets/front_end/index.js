/** The anywidget module: draw a model into an element, and say how to take it away again. */

import { createFigure } from "./figure.js";
import { createShell } from "./shell.js";
import { followTheme } from "./theme.js";

/**
 * Draw, or say why not. CASTELJAU_VERSION is the package's version, put in by build.py.
 * @returns {() => void} take it away
 */
function draw(/** @type {import("./scene.js").Model} */ model, /** @type {HTMLElement} */ parent) {
  const shell = createShell(parent);
  try {
    const scene = model.get("scene");
    followTheme(shell.root, scene?.palette, shell.life);
    if (scene?.version === CASTELJAU_VERSION) createFigure(shell, model);
    else {
      shell.notice(`This figure was made by casteljau ${scene?.version ?? "(no version)"}, but its front end is `
        + `casteljau ${CASTELJAU_VERSION}. Run the cell again (or reinstall casteljau) to redraw it.`);
    }
  } catch (error) {
    shell.fail(error);
  }
  return shell.close;
}

/** @param {{model: import("./scene.js").Model, el: HTMLElement}} view */
function render({ model, el }) {
  let close = draw(model, el);
  const redraw = () => {
    close();
    close = draw(model, el);
  };
  model.on("change:scene", redraw);
  return () => {
    model.off("change:scene", redraw);
    close();
  };
}

export default { render };
