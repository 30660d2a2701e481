/** A question before the reveal: what a learner types is checked exactly, here in the browser. */

import { loadCheck, solution } from "./check.js";
import { Unreadable } from "./degrees.js";
import { html, htmlLabel } from "./dom.js";
import { spoken } from "./text.js";

/** @typedef {import("./figure.js").Figure} Figure */
/** @typedef {import("./scene.js").Question} Question */

let count = 0;

/** @returns {{element: HTMLElement, update: () => void}} */
export function createQuestion(/** @type {Figure} */ { life, say, inputsByName, store }, /** @type {Question} */ question) {
  const check = loadCheck(question);
  const id = `casteljau-question-${count += 1}`;
  const input = html("input", { class: "number answer", type: "text", "aria-label": spoken(question.prompt),
    "aria-describedby": id, autocomplete: "off", spellcheck: "false", autocapitalize: "off" });
  const verdict = html("p", { class: "verdict", id, role: "status" });
  const button = html("button", { class: "button word", type: "button", "aria-label": `Check: ${spoken(question.prompt)}` },
    "Check");
  const reveal = html("button", { class: "button word", type: "button", hidden: true }, "Show the answer");
  let asked = "";

  function tell(/** @type {string} */ kind, /** @type {string} */ message) {
    verdict.dataset.kind = kind;
    verdict.replaceChildren(message ? htmlLabel(message) : "");
    input.toggleAttribute("aria-invalid", kind === "unreadable");
  }
  function answer() {
    asked = JSON.stringify(inputsByName());
    try {
      const { right, message } = check(input.value, inputsByName());
      tell(right ? "right" : "wrong", message);
      reveal.hidden = right || question.variables.length > 0;
    } catch (error) {
      if (!(error instanceof Unreadable)) throw error;
      tell("unreadable", error.message);
    }
  }

  life.listen(button, "click", answer);
  life.listen(input, "keydown", (event) => { if (event.key === "Enter") answer(); });
  life.listen(input, "input", () => tell("", ""));
  life.listen(reveal, "click", () => {
    input.value = solution(question, inputsByName());
    answer();
    input.focus();
    say(`The answer is ${input.value}`);
  });

  const element = html("div", { class: "panel question", role: "group", "aria-label": "Question" },
    html("p", { class: "prompt" }, htmlLabel(question.prompt)),
    html("div", { class: "row" }, input, button, reveal), verdict);
  return {
    element,
    update() {
      const { step } = store.state;
      const here = step >= (question.from ?? 0) && (question.until === null || step <= question.until);
      element.classList.toggle("current", here);
      // An answer belongs to the figure as it stood: another state is another question.
      if (asked && question.live && asked !== JSON.stringify(inputsByName())) {
        asked = "";
        tell("", "");
        reveal.hidden = true;
      }
    },
  };
}
