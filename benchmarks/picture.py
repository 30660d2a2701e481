"""A picture of times side by side: how many times longer than ours others take."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import matplotlib.pyplot as plt

COLOURS = {"ours": "#0072b2", "others": "#8c8c8c"}


def draw(rows: Sequence[tuple[str, Mapping[str, float]]], file: str) -> None:
    """Save bars of every row's times, divided by ours, on a logarithmic axis."""
    count = sum(len(times) + 1 for _, times in rows)
    figure, axes = plt.subplots(figsize=(8, 0.19 * count + 0.8), layout="constrained")
    y = 0.0
    marks, names = [], []
    for name, times in rows:
        ours = times["ours"]
        axes.text(1.06, y - 0.95, name, fontsize=8.5, fontweight="bold", va="center")
        for who, ms in sorted(times.items(), key=lambda item: item[1]):
            own = who == "ours"
            ratio = ms / ours
            axes.barh(y, ratio, left=0, color=COLOURS["ours" if own else "others"], height=0.7)
            axes.text(ratio * 1.06, y, f"{ms:.3g} ms" + ("" if own else f"  {ratio:.3g}x"),
                      va="center", fontsize=7.5)  # fmt: skip
            marks.append(y)
            names.append("casteljau" if own else who)
            y += 1
        y += 1.4
    axes.set(xscale="log", yticks=marks, yticklabels=names)
    axes.set_xlim(right=axes.get_xlim()[1] * 8)
    axes.tick_params(axis="y", length=0, labelsize=8)
    axes.invert_yaxis()
    axes.spines[["top", "right", "left"]].set_visible(False)
    axes.set_xlabel("time, as a multiple of ours")
    figure.savefig(file, dpi=150)
    plt.close(figure)
