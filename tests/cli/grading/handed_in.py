"""Forty submissions: good, wrong, endless, hostile, and some that do not compile.

The assignment is to come to the place two metres ahead within six seconds, touching nothing.
"""

from __future__ import annotations

import os
from pathlib import Path

WORLD = """<world version="1" duration="7s"><area length="5m" width="2m"/>
<box id="crate" x="3.9m" y="1m" length="40cm" width="40cm"/>
<robot x="1m" y="1m"/>
<goal id="there" name="There" points="3" within="6s"><reach x="3m" y="1m" radius="30cm"/></goal>
<goal id="clean" name="No collision"><no-collision/></goal></world>
"""

GOOD = """/* {comment} */
#include "Nclient.h"
int main(void)
{{
    int {name};
    connect_robot(1);
    conf_tm(0);
    ac(300, 300, 0);
    sp({speed}, {speed}, 0);
    scout_pr(800, 0);
    ws(1, 1, 0, 20);
    for ({name} = 0; {name} < 3; {name}++)
        gs();
    disconnect_robot(1);
    return 0;
}}
"""


def good(speed: int = 250, name: str = "i", comment: str = "drives") -> str:
    """Return a program that meets both goals."""
    return GOOD.format(speed=speed, name=name, comment=comment)


def body(text: str) -> str:
    """Return a program with this body of `main`."""
    return f'#include "Nclient.h"\nint main(void)\n{{\n    connect_robot(1);\n    {text}\n}}\n'


BOMB = "#define A0 x x\n" + "".join(f"#define A{n} A{n - 1} A{n - 1}\n" for n in range(1, 40))

FILES: dict[str, str | bytes] = {
    # Good ones; carl has copied from berta, with other names and comments.
    "anna.c": good(),
    "berta.c": good(210),
    "carl.c": good(210, "counter", "my own work"),
    "dora/main.c": '#include "speed.h"\n' + good().replace("250", "SPEED"),
    "dora/speed.h": "#define SPEED 240\n",
    "emil/main.c": "extern void drive(void);\nint main(void) { drive(); return 0; }\n",
    "emil/sub/drive.c": good(230).replace("int main(void)", "int drive(void)"),
    "frida.c": body("conf_tm(0); vm(150, 150, 0); for (;;) gs();"),  # there, then a collision
    "ö-gustav.c": good(220),
    "prints.c": good(235)
    .replace("gs()", 'gs(), printf("%d\\n", i)')
    .replace("#include", "#include <stdio.h>\n#include", 1),
    # Wrong ones.
    "slow.c": good(50),
    "backward.c": good(245).replace("800", "-800"),
    "nothing.c": "int main(void) { return 3; }\n",
    "unconnected.c": '#include "Nclient.h"\nint main(void) { vm(100, 100, 0); return 0; }\n',
    "crash_late.c": good(225).replace("return 0", "return *(int *)0"),
    "crash_early.c": body("int a[3]; a[State[0] + 3] = 1; return a[1];"),
    "recursion.c": "int f(int n) { return f(n + 1) + n; }\nint main(void) { return f(0); }\n",
    # Not compiling.
    "semicolon.c": "int main(void)\n{\n    return 1\n}\n",
    "undeclared.c": "int main(void)\n{\n    return speed;\n}\n",
    "unlinked.c": "extern int far(void);\nint main(void) { return far(); }\n",
    "two_mains/a.c": "int main(void) { return 0; }\n",
    "two_mains/b.c": "int main(void) { return 1; }\n",
    "html_error.c": "#error <script>alert(1)</script>\n",
    "binary.c": b"\x7fELF\0\0\1\2\3" * 99,
    "empty.c": "",
    # Endless ones.
    "loop.c": "int main(void) { for (;;) ; }\n",
    "talks.c": '#include <stdio.h>\nint main(void) { for (;;) puts("' + "a" * 500 + '"); }\n',
    "waits.c": body("for (;;) ws(1, 1, 0, 255);"),
    "reads.c": "#include <stdio.h>\nint main(void) { while (getchar() != 7) ; return 0; }\n",
    # Hostile ones.
    "forks.c": "#include <unistd.h>\nint main(void) { for (;;) fork(); }\n",
    "allocates.c": "#include <stdlib.h>\nint main(void) { while (malloc(100000)) ; for (;;) ; }\n",
    "writes.c": '#include <stdio.h>\nint main(void) { FILE *f = fopen("../../x", "w");\n'
    'for (;;) fputs("0123456789", f); }\n',
    "huge.c": "int a[400000000];\nint main(void) { return a[1]; }\n",
    "bomb.c": f"{BOMB}int main(void) {{ A39 }}\n",
    "nested.c": f"int main(void) {{ return {'(' * 20000}1{')' * 20000}; }}\n",
    "itself.c": '#include "itself.c"\nint main(void) { return 0; }\n',
    "passwd.c": '#include "/etc/passwd"\nint main(void) { return 0; }\n',
    "outside.c": '#include "../../secret.h"\nint main(void) { return 0; }\n',
    "cheats.c": body("place_robot(1181, 393, 0, 0); gs();"),
    "cheats_hidden.c": body("PASTE(new_, world)();").replace(
        "int main", "#define PASTE(a, b) a##b\nint main"
    ),
    "cheats_by_request.c": "#include <crs_request.h>\n"
    + body("static struct __crs_message m; __crs_request(144, &m); for (;;) gs();"),
    "h\udcff\n.c": "#error \x1b[31m" + "long " * 1000 + "\n",
    "=1+cmd.c": "int main(void) { return 0; }\n",
    "<img src=x onerror=alert(1)>.c": "int main(void) { return 0; }\n",
    "no_code/readme.txt": "none",
    "<c>.c": good(250),  # anna's, in a file whose name looks like one of crs
    "mine/<library>/main.c": good(236),
    "HUGO.C": good(236),
    "ida.cpp": good(237),
    "names.csv": "anna,berta",
    "__MACOSX/anna.c": "",
}


def hand_in(folder: Path) -> Path:
    """Write all submissions; return their folder. Beside it is a file that they may not read."""
    (folder / "secret.h").write_text("#error the secret is 4711\n")
    submissions = folder / "submissions"
    for name, content in FILES.items():
        path = submissions / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
    (submissions / "link.c").symlink_to(folder / "secret.h")
    (submissions / "linked").mkdir()
    (submissions / "linked" / "main.c").write_text(good())
    (submissions / "linked" / "secret.h").symlink_to(folder / "secret.h")
    os.mkfifo(submissions / "pipe.c")
    return submissions
