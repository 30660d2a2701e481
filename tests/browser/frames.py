"""How long a figure takes from a pointer's event to the frame that shows it."""

from typing import NamedTuple

import numpy as np
from playwright.sync_api import Locator

from browser.figures import place, points

# Only listens: to the event before the figure does, and to the curve's change after it.
WATCH = """(figure) => {
  const curve = figure.querySelector(".mark .path");
  const [times, pending] = [window.casteljauTimes = [], []];
  const channel = new MessageChannel();
  let event;
  window.addEventListener("pointermove", () => { event ??= performance.now(); }, true);
  // A message sent while a frame is made arrives when it is made.
  channel.port1.onmessage = () => {
    const [began, changed] = pending.shift();
    times.push([changed - began, performance.now() - began]);
  };
  new MutationObserver(() => {
    if (event === undefined) return;
    pending.push([event, performance.now()]);
    event = undefined;
    channel.port2.postMessage(0);
  }).observe(curve, { attributeFilter: ["d"] });
}"""


class Times(NamedTuple):
    """Milliseconds from the events of a drag."""

    changed: np.ndarray  # until the document is changed
    drawn: np.ndarray  # until the frame with the change is made

    def summary(self) -> str:
        return (
            f"median {np.median(self.drawn):.1f} ms, 95% {np.quantile(self.drawn, 0.95):.1f} ms; "
            f"document changed after {np.median(self.changed):.1f} ms ({len(self.drawn)} moves)"
        )


def measure(figure: Locator, moves: int) -> Times:
    """Drag the second point around a circle by mouse, far enough that every move changes it."""
    figure.locator(".drawing").scroll_into_view_if_needed()
    figure.evaluate(WATCH)
    mouse = figure.page.mouse
    x, y = points(figure)[1]
    radius = np.ptp(points(figure)[:, 0]) / 8
    angles = np.linspace(0, 12 * np.pi, moves + 1)
    centre, corner = place(figure, x, y), place(figure, x + radius, y)
    pixels = corner[0] - centre[0]
    mouse.move(*centre)
    mouse.down()
    for number, angle in enumerate(angles, 1):
        mouse.move(centre[0] + pixels * np.cos(angle), centre[1] + pixels * np.sin(angle))
        figure.page.wait_for_function("(n) => casteljauTimes.length >= n", arg=number)
    mouse.up()
    changed, drawn = np.array(figure.page.evaluate("casteljauTimes")).T
    return Times(changed, drawn)
