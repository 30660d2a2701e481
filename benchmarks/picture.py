"""A picture of times side by side: how many times longer than ours others take."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import matplotlib.pyplot as plt

COLOURS = {"ours": "#0072b2", "others": "#6f6f6f"}


def draw(rows: Sequence[tuple[str, Mapping[str, float]]], file: str) -> None:
    """Save a line from 1, our time, to every other one's time divided by ours; logarithmic."""
    count = sum(len(times) + 1 for _, times in rows)
    figure, axes = plt.subplots(figsize=(8, 0.175 * count + 0.8), layout="constrained")
    y = 0.0
    marks, names = [], []
    for name, times in rows:
        axes.text(1.15, y - 0.85, name, fontsize=8.5, fontweight="bold", va="center")
        for who, ms in sorted(times.items(), key=lambda item: item[1]):
            own = who == "ours"
            ratio = ms / times["ours"]
            colour = COLOURS["ours" if own else "others"]
            axes.plot([1, ratio], [y, y], color=colour, linewidth=2, marker="o", markevery=[1],
                      markersize=5)  # fmt: skip
            told = f"{_short(ms)} ms" if own else f"{_short(ratio)}x"
            side = 1.15 if ratio >= 1 else 1 / 1.15
            axes.text(ratio * side, y, told, ha="left" if ratio >= 1 else "right", va="center",
                      fontsize=7.5, color=colour)  # fmt: skip
            marks.append(y)
            names.append("casteljau" if own else who)
            y += 1
        y += 1.3
    axes.axvline(1, color=COLOURS["ours"], linewidth=0.6, zorder=0)
    axes.set(xscale="log", yticks=marks, yticklabels=names, ylim=(y - 1.8, -1.6))
    low, high = axes.get_xlim()
    axes.set_xlim(low / 2, high * 3)
    axes.tick_params(axis="y", length=0, labelsize=8)
    axes.spines[["top", "right", "left"]].set_visible(False)
    axes.set_xlabel("time, as a multiple of ours")
    figure.savefig(file, dpi=150)
    plt.close(figure)


def _short(number: float) -> str:
    return f"{number:,.0f}" if number >= 100 else f"{number:.2g}"
