"""A recorded run as an animation: GIF or APNG.

The scenery is drawn once, and the paths grow on it; robots and movable objects are drawn for each
picture. Size and number of the pictures are bounded, so a long run is shown faster: at 1, 2, 5, 10,
20, ... times real time.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.cli.recording_plot import movables_at, recorded_picture
from crs_cc.cli.run_plot import in_world_m
from crs_cc.plot.picture import PlotDrawing
from crs_cc.plot.raster import Raster, blank, draw, flat, palette, save_film, smaller
from crs_cc.recording import topics
from crs_cc.recording.marks import at_time, drawn_marks
from crs_cc.recording.mcap_records import NS

if TYPE_CHECKING:
    from crs_cc.core.arrays import FloatArray
    from crs_cc.recording.recording import Frame, Recording

MAX_PICTURES: Final = 200
PER_SECOND: Final = 10
MAX_ROBOTS: Final = 40_000
"""Robots drawn in all pictures together."""

MAX_MARKS: Final = 1000
"""Of those that programs drew, the last ones are shown."""

_LONG_SIDE_PX: Final = 520.0
_HOLD_MS: Final = 1500  # the last picture


def write_animation(recording: Recording, path: Path) -> None:
    """Write the animation of a recorded run.

    Raises:
        CrsError: the recording is not valid.
        OSError: the file cannot be written.
    """
    pictures = list(_Film(recording).pictures())
    durations_ms = [1000 // PER_SECOND] * (len(pictures) - 1) + [_HOLD_MS]
    save_film(path, pictures, durations_ms)


def speed_for(simulated_s: float, pictures: int) -> int:
    """Return the playback speed of a run of a length, relative to real time.

    >>> [speed_for(seconds, 200) for seconds in (3.0, 20.0, 21.0, 600.0)]
    [1, 1, 2, 50]
    """
    wanted, power = simulated_s * PER_SECOND / pictures, 1
    while True:
        for factor in (1, 2, 5):
            if factor * power >= wanted:
                return factor * power
        power *= 10


class _Film:
    def __init__(self, recording: Recording) -> None:
        self._recording = recording
        picture = recorded_picture(recording)
        robots = len(picture.paths)
        most = min(MAX_PICTURES, max(2, MAX_ROBOTS // max(1, robots)))
        self._speed = speed_for(recording.end_ns / NS, most - 1)
        self._drawing = PlotDrawing(picture, _LONG_SIDE_PX)
        self._world = picture.world
        self._contacts = self._contact_times()
        self._last: FloatArray = np.full((2, robots), np.nan)
        self._starts = [robot_path.robot.start for robot_path in picture.paths]
        self._misled = [number for number, _ in self._drawing.visibly_drifted()]
        self._odometry = recording.frames(topic=topics.ODOMETRY.topic)
        self._believed = self._ahead = next(self._odometry, None)
        self._shown: FloatArray | None = None  # what odometry believed in the last picture
        self._dashes = 0
        self._palette: Raster | None = None
        self._marks = drawn_marks(recording)

    def pictures(self) -> Iterator[Raster]:
        """Yield the pictures."""
        scenery = self._drawing.scenery()
        canvas = blank(scenery)
        draw(scenery, canvas)
        self._palette = self._colours(canvas)
        for at_s, frame in self._instants():
            self._extend(canvas, frame, at_s)
            yield self._finished(canvas, frame, at_s)

    def _instants(self) -> Iterator[tuple[float, Frame]]:
        """Yield the instants of the pictures, each with the last frame up to it."""
        every_s, end_s, number = self._speed / PER_SECOND, self._recording.end_ns / NS, 0
        last: Frame | None = None
        for frame in self._recording.frames():
            while last is not None and frame.time_s > number * every_s + 1e-9:
                yield number * every_s, last
                number += 1
            last = frame
        while last is not None and number * every_s < end_s:
            yield number * every_s, last
            number += 1
        if last is not None:
            yield end_s, last

    def _extend(self, canvas: Raster, frame: Frame, at_s: float) -> None:
        """Draw the paths since the last picture, and new contacts."""
        robots = len(self._recording.roster_at(frame.time_ns).robots)
        here = frame.values[:2, :robots]
        with self._drawing.layer() as page:
            for number in range(min(robots, self._last.shape[1])):
                if np.isfinite(self._last[0, number]) and np.isfinite(here[0, number]):
                    way = np.array([self._last[:, number], here[:, number]])
                    if (way[0] != way[1]).any():
                        self._drawing.path(number, way)
            self._extend_believed(at_s)
            while self._contacts and self._contacts[-1][0] <= at_s + 1e-9:
                self._drawing.contact(*self._contacts.pop()[1:])
        draw(page, canvas)
        self._last[:, : here.shape[1]] = here[:, : self._last.shape[1]]

    def _extend_believed(self, at_s: float) -> None:
        """Draw every other piece of the odometry's paths where they differ from the true ones."""
        while self._ahead is not None and self._ahead.time_s <= at_s + 1e-9:
            self._believed = self._ahead
            self._ahead = next(self._odometry, None)
        if not self._misled or self._believed is None:
            return
        own = self._believed.values[:2]
        here = np.array(in_world_m(self._starts[: own.shape[1]], *own))
        if self._shown is not None and self._dashes % 2 == 0:
            known = min(here.shape[1], self._shown.shape[1])
            for number in (each for each in self._misled if each < known):
                way = np.array([self._shown[:, number], here[:, number]])
                if np.isfinite(way).all():
                    self._drawing.path(number, way, 1.0)
        self._shown, self._dashes = here, self._dashes + 1

    def _finished(self, canvas: Raster, frame: Frame, at_s: float) -> Raster:
        """Return the picture of an instant."""
        roster = self._recording.roster_at(frame.time_ns)
        image = canvas.copy()
        with self._drawing.layer() as page:
            self._drawing.marks(at_time(self._marks, at_s)[-MAX_MARKS:])
            robots = len(roster.robots)
            for obj, _ in movables_at(self._world, roster.objects, frame, robots):
                self._drawing.standing(obj)
            for number in range(min(robots, self._last.shape[1])):
                x_m, y_m, heading_rad = frame.values[:3, number].tolist()
                if np.isfinite(x_m):
                    self._drawing.robot(number, (x_m, y_m), heading_rad)
            speed = f" ({self._speed} x real time)" if self._speed > 1 else ""
            self._drawing.clock(f"{at_s:.1f} s{speed}")
        draw(page, image)
        assert self._palette is not None
        return flat(smaller(image), self._palette)

    def _colours(self, canvas: Raster) -> Raster:
        """Return a palette for all pictures: robots are in the legend."""
        image = canvas.copy()
        with self._drawing.layer() as page:
            self._drawing.contact(*self._drawing.low.tolist())
            self._drawing.marks([each.drawing for each in self._marks[-MAX_MARKS:]])
            for obj in self._drawing.movable():
                self._drawing.standing(obj)
        draw(page, image)
        return palette(smaller(image))

    def _contact_times(self) -> list[tuple[float, float, float]]:
        """Return time and place of contacts, the last one first."""
        found = []
        for time_ns, data in self._recording.data(topics.EVENT.topic):
            if data.get("kind") == "collision":
                with self._recording.errors():
                    x_m, y_m = float(data["x_m"]), float(data["y_m"])
                found.append((time_ns / NS, x_m, y_m))
        return sorted(found, reverse=True)[-5000:]
