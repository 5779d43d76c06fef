"""Figures of the results of a sweep as SVG, by matplotlib (extra `analysis`).

They are drawn without pyplot, so without state or display, and have the same bytes each time.
"""

from __future__ import annotations

import io
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.core.keyed_random import KeyedUniform
from crs_cc.recording.field_sketches import FULL, FieldSketch
from crs_cc.sim.model.world import Area
from crs_cc.sweeps.experiment import Value
from crs_cc.sweeps.report.results import Group, Results
from crs_cc.sweeps.report.statistics import summary, survival

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_SIZE_IN: Final = (7.0, 4.2)
_STYLE: Final[Any] = {
    "svg.hashsalt": "crs",  # names in the file depend on what is drawn only
    "svg.fonttype": "none",
    "font.family": "sans-serif",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.alpha": 0.3,
}
_COLOURS: Final = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#333333")
"""Distinguishable for the colour-blind (Okabe and Ito 2008, Color Universal Design)."""

_JITTER: Final = 0x4A49
_DECADES: Final = 50.0
"""The ratio of the largest to the smallest value from which an axis is logarithmic."""

MAX_GROUPS: Final = 24
"""Limit of the combinations in one figure; more cannot be distinguished."""


_WRAPPED: Final = 36
"""Characters in a line of a label; longer ones would leave no room for what they label."""

_LINE_IN: Final = 0.2
_SHORT_LEGEND: Final = 32
"""Characters up to which labels find room beside what is drawn."""


def _svg(draw: Callable[[Axes], None]) -> str:
    """Return the figure as the text of an SVG element."""
    import matplotlib as mpl
    from matplotlib.figure import Figure

    with mpl.rc_context(_STYLE):
        figure = Figure(figsize=_SIZE_IN, layout="constrained")
        draw(figure.add_subplot())
        target = io.StringIO()
        figure.savefig(target, format="svg", metadata={"Date": None, "Creator": None})
    text = target.getvalue()
    return text[text.index("<svg") :]


def is_numeric(values: Sequence[Value]) -> bool:
    """Return whether all values are numbers, which have an axis."""
    return all(isinstance(each, int | float) and not isinstance(each, bool) for each in values)


def _spans_decades(values: Sequence[float]) -> bool:
    """Return whether values span decades, so that a linear axis would hide small differences."""
    return min(values) > 0.0 and max(values) >= _DECADES * min(values)


def _levels(results: Results, name: str) -> list[Value]:
    return list(dict.fromkeys(group.parameters[name] for group in results.groups))


def box_and_strip(results: Results) -> str:
    """Return boxes with all values beside them, for each combination."""
    groups = results.groups[:MAX_GROUPS]

    def draw(axes: Axes) -> None:
        axes.boxplot(
            [group.values for group in groups],
            orientation="horizontal",
            showfliers=False,
            widths=0.5,
            medianprops={"color": _COLOURS[1]},
        )
        uniform = KeyedUniform(1, _JITTER)
        for number, group in enumerate(groups):
            jitter = uniform.draw(np.arange(len(group.values)), number) - 0.5
            axes.plot(
                group.values,
                number + 1 + 0.3 * jitter,
                "o",
                color=_COLOURS[0],
                alpha=0.5,
                markersize=3,
            )
        labels = [_wrapped(each) for each in results.labels[:MAX_GROUPS]]
        axes.set_yticks(range(1, len(groups) + 1), labels)
        _heighten(axes, _LINE_IN * sum(1 + each.count("\n") for each in labels) - 3.0)
        axes.invert_yaxis()
        axes.set_xlabel(results.label)

    return _svg(draw)


def curve(results: Results) -> str:
    """Return medians over a parameter with their 95% intervals, a line for each other one.

    The first parameter of the results must be numeric.
    """
    name = results.varied[0]

    def draw(axes: Axes) -> None:
        lines: dict[str, list[Group]] = {}
        for group in results.groups:
            others = {key: each for key, each in group.parameters.items() if key != name}
            label = ", ".join(f"{key}={each}" for key, each in others.items())
            lines.setdefault(label, []).append(group)
        for number, (label, groups) in enumerate(lines.items()):
            groups.sort(key=lambda group: float(group.parameters[name]))
            x = [float(group.parameters[name]) for group in groups]
            found = [summary(group.values) for group in groups]
            colour = _COLOURS[number % len(_COLOURS)]
            axes.plot(x, [each.median for each in found], "o-", color=colour, label=label or None)
            low, high = [each.low for each in found], [each.high for each in found]
            axes.fill_between(x, low, high, color=colour, alpha=0.2, linewidth=0)
        if len(lines) > 1:
            _legend(axes)
        if _spans_decades([float(each) for each in _levels(results, name)]):
            axes.set_xscale("log")
        axes.set_xlabel(name)
        axes.set_ylabel(f"median of {results.label}")
        axes.set_ylim(bottom=0 if results.is_time else None)

    return _svg(draw)


def heat_map(results: Results) -> str:
    """Return the medians over two parameters as colours; the results must have two of them."""
    names = results.varied[:2]
    columns, rows = (_levels(results, name) for name in names)
    table = np.full((len(rows), len(columns)), np.nan)
    for group in results.groups:
        column, row = (group.parameters[name] for name in names)
        table[rows.index(row), columns.index(column)] = np.median(group.values)

    def draw(axes: Axes) -> None:
        axes.grid(visible=False)
        image = axes.imshow(table, origin="lower", aspect="auto", cmap="viridis")
        axes.set_xticks(range(len(columns)), [str(each) for each in columns])
        axes.set_yticks(range(len(rows)), [str(each) for each in rows])
        axes.set_xlabel(names[0])
        axes.set_ylabel(names[1])
        _colour_bar(axes, image, f"median of {results.label}")

    return _svg(draw)


def survival_curves(results: Results) -> str:
    """Return the share of runs in which a goal is not met yet, over time."""
    groups = results.groups[: len(_COLOURS)]

    def draw(axes: Axes) -> None:
        for group, label, colour in zip(groups, results.labels, _COLOURS, strict=False):
            met = [each for each, is_met in zip(group.values, group.reached, strict=True) if is_met]
            ended = [
                each for each, is_met in zip(group.values, group.reached, strict=True) if not is_met
            ]
            found = survival(met, ended)
            times, shares = (0.0, *found.times), (1.0, *found.shares)
            low, high = (1.0, *found.low), (1.0, *found.high)
            axes.step(times, shares, where="post", color=colour, label=label)
            axes.fill_between(times, low, high, step="post", color=colour, alpha=0.15, linewidth=0)
        _legend(axes)
        axes.set_ylim(0.0, 1.03)
        axes.set_xlim(left=0.0)
        axes.set_xlabel(results.label)
        axes.set_ylabel("share of runs without")

    return _svg(draw)


def convergence(results: Results) -> str:
    """Return the medians of the first seeds over how many they are, for each combination."""
    from matplotlib.ticker import MaxNLocator

    groups = results.groups[: len(_COLOURS)]

    def draw(axes: Axes) -> None:
        for group, label, colour in zip(groups, results.labels, _COLOURS, strict=False):
            counts = range(1, len(group.values) + 1)
            medians = [float(np.median(group.values[:count])) for count in counts]
            axes.plot(counts, medians, color=colour, label=label)
        _legend(axes)
        axes.xaxis.set_major_locator(MaxNLocator(integer=True))
        axes.set_xlabel("seeds")
        axes.set_ylabel(f"median of {results.label}")

    return _svg(draw)


def visits(places_m: FloatArray, cell_m: float, area: Area) -> str:
    """Return where in the area robots were, as colours.

    Args:
        places_m: x and y at equal steps of time, (n, 2).
        cell_m: the size of the cells.
        area: the area of the world.
    """
    low, high = places_m.min(axis=0), places_m.max(axis=0)
    edges = [
        np.arange(low[axis], high[axis] + 2.0 * cell_m, cell_m) - 0.5 * cell_m for axis in (0, 1)
    ]
    counts, *_ = np.histogram2d(places_m[:, 0], places_m[:, 1], bins=edges)
    share = np.where(counts > 0, counts, np.nan) / len(places_m)

    def draw(axes: Axes) -> None:
        axes.grid(visible=False)
        image = axes.pcolormesh(*edges, 100.0 * share.T, cmap="magma_r", rasterized=True)
        _show_area(axes, area)
        _colour_bar(axes, image, "share of the time [%]")

    return _svg(draw)


def field_map(sketch: FieldSketch, age_s: float, area: Area) -> str:
    """Return the contents of a pheromone field, as colours.

    Args:
        sketch: the field at the last instant of which it is known.
        age_s: for how long it has evaporated since [s].
        area: the area of the world.
    """
    rows, columns = sketch.shares.shape
    x_m = sketch.x_m + sketch.square_m * np.arange(columns + 1)
    y_m = sketch.y_m + sketch.square_m * np.arange(rows + 1)
    shares = np.where(sketch.shares > 0, sketch.shares, np.nan) / FULL

    def draw(axes: Axes) -> None:
        axes.grid(visible=False)
        amounts = sketch.maximum_after(age_s) * shares
        image = axes.pcolormesh(x_m, y_m, amounts, cmap="magma_r", rasterized=True, vmin=0.0)
        _show_area(axes, area)
        _colour_bar(axes, image, sketch.name)

    return _svg(draw)


def _wrapped(label: str) -> str:
    r"""Return a label in lines that are not too long, if its parts permit it.

    >>> _wrapped("define.SPEED=100, world.food.items=5, setup=noisy")
    'define.SPEED=100, world.food.items=5,\nsetup=noisy'
    """
    lines = [""]
    for part in label.split(", "):
        joined = f"{lines[-1]}, {part}" if lines[-1] else part
        if len(joined) <= _WRAPPED or not lines[-1]:
            lines[-1] = joined
        else:
            lines[-1] += ","
            lines.append(part)
    return "\n".join(lines)


def _heighten(axes: Axes, by_in: float) -> None:
    """Make the figure higher, if there is anything to add."""
    figure: Any = axes.figure
    width_in, height_in = figure.get_size_inches()
    figure.set_size_inches(width_in, height_in + max(0.0, by_in))


def _legend(axes: Axes) -> None:
    """Explain the lines: beside them if there is room, else below the axes."""
    handles, labels = axes.get_legend_handles_labels()
    if max(map(len, labels)) <= _SHORT_LEGEND:
        axes.legend()
        return
    wrapped = [_wrapped(each) for each in labels]
    _heighten(axes, _LINE_IN * sum(1 + each.count("\n") for each in wrapped))
    figure = axes.figure
    assert figure is not None
    figure.legend(handles, wrapped, loc="outside lower center", frameon=False)


def _show_area(axes: Axes, area: Area) -> None:
    axes.set_aspect("equal")
    axes.set_xlim(area.x_min_m, area.x_max_m)
    axes.set_ylim(area.y_min_m, area.y_max_m)
    axes.set_xlabel("x [m]")
    axes.set_ylabel("y [m]")


def _colour_bar(axes: Axes, image: Any, label: str) -> None:
    figure = axes.figure
    assert figure is not None
    figure.colorbar(image, ax=axes, label=label)
