"""Read from a trace of Chromium what the scripts of a page cost per picture.

Chromium notes for what a thread does the processor time of that thread (`tts`, `tdur`), besides the
time of day: what other processes do meanwhile does not count.
"""

from __future__ import annotations

from bisect import bisect
from typing import Any

CATEGORIES = ["devtools.timeline", "blink.user_timing", "toplevel", "v8"]

MARK_DRAWING = """() => {
    const three = crs.views.active.view.renderer;
    const render = three.render.bind(three);
    three.render = (...given) => {
        performance.mark("drawing begins");
        render(...given);
        performance.mark("drawing ends");
    };
}"""

# What runs JavaScript or cleans up after it; layout and painting are the browser's.
SCRIPTS = frozenset({
    "BlinkScheduler_PerformMicrotaskCheckpoint", "FireAnimationFrame", "FunctionCall", "MajorGC",
    "MinorGC", "RunMicrotasks", "TimerFire", "v8.callFunction",
})  # fmt: skip


def script_times_ms(trace: list[dict[str, Any]]) -> list[float]:
    """Return for each picture the processor time of scripts besides the call that draws it [ms].

    What happens between two pictures belongs to the second one: frames that arrive, mostly.
    """
    begins = [each for each in trace if each["name"] == "drawing begins"]
    ends = [each for each in trace if each["name"] == "drawing ends"]
    thread = (begins[0]["pid"], begins[0]["tid"])
    times_us = [float(begin["tts"] - end["tts"]) for begin, end in zip(begins, ends, strict=False)]
    drawn = [each["ts"] for each in ends]
    until = -1.0
    for each in sorted(trace, key=lambda event: event.get("ts", 0)):
        if each["name"] not in SCRIPTS or (each["pid"], each["tid"]) != thread or each["ph"] != "X":
            continue
        if each["ts"] < until:  # inside the one before
            continue
        until = each["ts"] + each["dur"]
        picture = bisect(drawn, each["ts"])
        if picture < len(times_us):
            times_us[picture] += each.get("tdur", 0)  # without: as short as the clock's step
    return [time_us / 1000 for time_us in times_us[1:]]
