"""What sparklines keep of values over time, in Node."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path

import pytest

MODULE = Path(__file__).parents[2] / "crs_cc" / "workbench" / "static" / "series.js"
KEPT = """
const { Series } = await import(process.argv[1]);
const series = new Series();
for (let at = 0; at < 20000; at++) {
    const spike = at === 7 ? 1 : at === 400 ? -1 : 0;
    series.add("speed", at / 20, at % 1000 === 800 ? null : spike);
}
const { times, values } = series.of("speed");
console.log(JSON.stringify({
    count: times.length,
    rising: times.every((time, at) => at === 0 || time > times[at - 1]),
    most: times.filter((_, at) => values[at] === 1),
    least: times.filter((_, at) => values[at] === -1),
}));
"""


def test_old_minima_and_maxima_are_kept() -> None:
    if shutil.which("node") is None:
        pytest.skip("node not found")
    command = ["node", "--input-type=module", "-e", KEPT, MODULE.as_uri()]
    done = subprocess.run(command, capture_output=True, timeout=60, check=True)
    found = json.loads(done.stdout)
    assert found["count"] <= 4000
    assert found["rising"]
    assert found["most"] == [7 / 20]
    assert found["least"] == [400 / 20]
