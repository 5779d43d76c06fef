"""Measures how long a program of 3,000 lines takes from the command to its result.

The program is made of modules as control programs have them, with other names and numbers in each:
structs, tables, loops, a state machine, floating point, strings. With the C library compiled
before, it runs once as new and once as known; the stages of the compiler are timed apart. Programs
of one huge function, as generators write them, are compiled at half and at full size: time
must grow with the size, not with its square. The cache is a new one, unless `CRS_CACHE` names one.

    python bench/compile.py [--lines N] [--repeat N] [--stages] [--huge]
"""

from __future__ import annotations

import argparse
import os
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

MODULE = """\
/* Module @: readings of one sensor, filtered, and what to do about them. */
#define SIZE_@ (8 + @ % 5)

struct reading_@ {
    int raw[SIZE_@];
    double mean, spread;
    unsigned valid : 1, age : 7;
    char name[16];
};

static struct reading_@ readings_@[4];
static const int limits_@[] = { 10 + @, 40, 70, 25 * @ % 90, 120 };
enum state_@ { IDLE_@, SEARCH_@, FOLLOW_@, STOP_@ };

static void update_@(struct reading_@ *r, int value)
{
    int i, sum = 0;

    for (i = SIZE_@ - 1; i > 0; i--)
        r->raw[i] = r->raw[i - 1];
    r->raw[0] = value;
    for (i = 0; i < SIZE_@; i++)
        sum += r->raw[i];
    r->mean = sum / (double)SIZE_@;
    r->spread = 0;
    for (i = 0; i < SIZE_@; i++)
        r->spread += (r->raw[i] - r->mean) * (r->raw[i] - r->mean);
    r->spread = sqrt(r->spread / SIZE_@);
    r->valid = r->spread < limits_@[value & 3];
    r->age++;
}

static enum state_@ decide_@(enum state_@ state, const struct reading_@ *r, double *speed)
{
    switch (state) {
    case IDLE_@:
        *speed = 0;
        return r->valid ? SEARCH_@ : IDLE_@;
    case SEARCH_@:
        *speed = 0.5 * r->mean / (1 + r->spread);
        if (r->mean > limits_@[1] && r->valid)
            return FOLLOW_@;
        return SEARCH_@;
    case FOLLOW_@:
        *speed += 0.1 * (limits_@[2] - r->mean);
        if (*speed > 100 || *speed < -100) {
            *speed = *speed > 0 ? 100 : -100;
            return STOP_@;
        }
        break;
    default:
        *speed *= 0.9;
        return r->age % 3 ? STOP_@ : IDLE_@;
    }
    return state;
}

static long run_@(int turns)
{
    enum state_@ state = IDLE_@;
    double speed = 0;
    long total = 0;
    char line[80];

    for (int turn = 0; turn < turns; turn++) {
        struct reading_@ *r = &readings_@[turn % 4];
        update_@(r, (turn * 37 + @) % 101);
        state = decide_@(state, r, &speed);
        sprintf(r->name, "sensor %d", turn % 4);
        if (turn % 16 == 15) {
            snprintf(line, sizeof line, "%s: %d %.2f", r->name, (int)state, speed);
            total += (long)strlen(line);
        }
        total += (long)state + (long)speed;
    }
    return total;
}

"""
HEAD = "#include <math.h>\n#include <stdio.h>\n#include <string.h>\n\n"


def program(lines: int) -> str:
    """Return a program of about so many lines."""
    count = max(1, lines // MODULE.count("\n"))
    modules = "".join(MODULE.replace("@", str(number)) for number in range(count))
    calls = "".join(f"    total += run_{number}(40);\n" for number in range(count))
    end = '    printf("%ld\\n", total);\n    return 0;\n}\n'
    return f"{HEAD}{modules}int main(void)\n{{\n    long total = 0;\n{calls}{end}"


def switch(size: int) -> str:
    """Return a program with a `switch` of so many cases."""
    cases = "".join(f"case {3 * i}: x += {i}; break;\n" for i in range(size))
    return f"int f(int x) {{ switch (x) {{\n{cases}}} return x; }}\nint main(void) {{ f(3); }}\n"


def statements(size: int) -> str:
    """Return a program with a function of so many statements."""
    rows = "".join(f"a = a * b + {i};\nb ^= a;\n" for i in range(size // 2))
    return f"int f(int a, int b) {{\n{rows} return b; }}\nint main(void) {{ f(3, 4); }}\n"


def branches(size: int) -> str:
    """Return a program with a function of so many branches."""
    rows = "".join(f"if (a > {i}) b += a; else b -= {i};\n" for i in range(size))
    return f"int f(int a, int b) {{\n{rows} return b; }}\nint main(void) {{ f(3, 4); }}\n"


HUGE = {switch: 60_000, statements: 60_000, branches: 5000}
"""Makers of programs of one huge function, and the size."""


def run(source: Path, environment: dict[str, str]) -> tuple[float, float]:
    """Return the wall time and the processor time of a run [s]."""
    command = [sys.executable, "-m", "crs_cc", "run", "--quiet", str(source)]
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    subprocess.run(command, env=environment, check=True, capture_output=True)
    wall_s, after = time.perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    return wall_s, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def stages(source: Path) -> dict[str, float]:
    """Return the processor time of each stage of the compiler [s]."""
    from crs_cc.core.source import Diagnostics, Location
    from crs_cc.frontend.check.checker import Unit
    from crs_cc.frontend.check.unit import check_unit
    from crs_cc.frontend.lower.unit import lower_unit
    from crs_cc.frontend.parse.lexer import lex
    from crs_cc.frontend.parse.parser import parse
    from crs_cc.frontend.preprocess.options import Options
    from crs_cc.frontend.preprocess.preprocessor import preprocess
    from crs_cc.ir.verify import verify
    from crs_cc.runtime.executable import make_executable
    from crs_cc.runtime.link import link
    from crs_cc.session.library import HEADERS, library

    times: dict[str, float] = {}

    def timed(name: str, work: Callable[[], object]) -> object:
        start = time.process_time()
        result = work()
        times[name] = time.process_time() - start
        return result

    diagnostics = Diagnostics()
    unit = Unit(str(source), diagnostics, Location(str(source)))
    text = timed("preprocess", lambda: preprocess(source, Options((), (HEADERS,)), diagnostics))
    tokens = timed("lex", lambda: lex(text.text, text.location, diagnostics))  # type: ignore[attr-defined]
    nodes = timed("parse", lambda: parse(tokens, diagnostics))  # type: ignore[arg-type]
    timed("check", lambda: check_unit(unit, nodes))  # type: ignore[arg-type]
    made = timed("lower", lambda: lower_unit(unit))
    timed("verify", lambda: verify(made))  # type: ignore[arg-type]
    whole = timed("link", lambda: link([made], library(), diagnostics))  # type: ignore[list-item]
    timed("generate", lambda: make_executable(whole, "program"))  # type: ignore[arg-type]
    return times


def print_huge(source: Path, environment: dict[str, str]) -> None:
    """Print the processor time of programs of one huge function, of half and full size."""
    for make, size in HUGE.items():
        times_s = []
        for count in (size // 2, size):
            source.write_text(make(count))
            times_s.append(run(source, environment)[1])
        name, growth = f"{size} {make.__name__}", times_s[1] / times_s[0]
        print(f"{name:16}{times_s[1]:8.2f} s of processor time, {growth:.1f} times that of half")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", 1)[0])
    parser.add_argument("--lines", type=int, default=3000, help="of the program (default 3000)")
    parser.add_argument("--repeat", type=int, default=3, help="runs of each (default 3)")
    parser.add_argument("--stages", action="store_true", help="time the stages of the compiler too")
    parser.add_argument("--huge", action="store_true", help="compile huge functions, too")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        environment = {"CRS_CACHE": str(Path(folder) / "cache"), **os.environ}
        source = Path(folder) / "program.c"
        source.write_text("int main(void) { return 0; }\n")
        run(source, environment)  # compiles the library
        text = program(options.lines)
        new, known = [], []
        for number in range(options.repeat):
            source.write_text(f"{text}/* {number} of {folder} */\n")  # in no cache
            new.append(run(source, environment))
            known.append(run(source, environment))
        print(f"{text.count(chr(10))} lines; from the command to the result, least of all")
        for name, rows in (("new program", new), ("known program", known)):
            wall_s, processor_s = (min(column) for column in zip(*rows, strict=True))
            print(f"{name:16}{wall_s:8.2f} s{processor_s:8.2f} s of processor time")
        if options.huge:
            print_huge(source, environment)
        if options.stages:
            os.environ["CRS_CACHE"] = environment["CRS_CACHE"]
            for name, seconds in stages(source).items():
                print(f"  {name:14}{seconds:8.2f} s of processor time")


if __name__ == "__main__":
    main()
