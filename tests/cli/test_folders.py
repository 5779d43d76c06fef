"""Folders of the run's disk, patterns of names, and variable arguments before C89."""

from pathlib import Path

import pytest

from crs_cc.cli.main import main

FOLDERS = r"""
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <dirent.h>
#include <glob.h>
#include <errno.h>
static void put(const char *n) {
    FILE *f=fopen(n, "w");
    if(!f) {
        perror(n);
        exit(1);
    }
    fputs("x", f);
    fclose(f);
}
static int visible(const struct dirent *d) {
    return d->d_name[0] != '.';
}
static void g(const char *p, int flags) {
    glob_t r;
    size_t i;
    int e;
    memset(&r, 0, sizeof r);
    e=glob(p, flags, NULL, &r);
    printf("%s %d:", p, e);
    for(i=0;i<r.gl_pathc;i++) printf(" %s", r.gl_pathv[i]);
    puts("");
    globfree(&r);
}
int main(void) {
    struct dirent **e;
    int n, i;
    DIR *d;
    put("b.c");
    put("a.c");
    put("sub/x.h");
    put("sub/y.c");
    put(".hidden");
    n=scandir(".", &e, visible, alphasort);
    for(i=0;i<n;i++) {
        printf("%s%s ", e[i]->d_name, e[i]->d_type==DT_DIR?"/":"");
        free(e[i]);
    }
    free(e);
    printf("%d\n", n);
    d=opendir("sub");
    n=0;
    while(readdir(d)) n++;
    printf("%d\n", n);
    rewinddir(d);
    printf("%d\n", readdir(d)!=NULL);
    closedir(d);
    printf("%d", opendir("none")==NULL && errno==ENOENT);
    printf("%d\n", opendir("a.c")==NULL && errno==ENOTDIR);
    g("*.c", 0);
    g("*/*.[ch]", 0);
    g("sub", GLOB_MARK);
    g("s*", GLOB_MARK);
    g("none*", 0);
    g("none*", GLOB_NOCHECK);
    g("a.c", 0);
    g("sub/nope", 0);
    g("*/", 0);
    g(".h*", 0);
    return 0;
}

"""

VARARGS = r"""
#include <varargs.h>
#include <stdio.h>
static double mixed(va_alist) va_dcl {
    va_list list;
    double sum;
    va_start(list);
    sum = va_arg(list, int);
    sum += va_arg(list, double);
    va_end(list);
    return sum;
}
static char *name(first, va_alist) char *first; va_dcl {
    va_list list;
    va_start(list);
    vprintf(first, list);
    va_end(list);
    return first;
}
int main() {
    printf("%g\n", mixed(1, 2.5));
    name("%s %d\n", "x", 9);
    return 0;
}
"""


@pytest.fixture(autouse=True)
def elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def test_folders_are_listed_as_on_linux(capfd: pytest.CaptureFixture[str]) -> None:
    Path("folders.c").write_text(FOLDERS)
    assert main(["run", "-q", "folders.c"]) == 0
    assert capfd.readouterr().out.splitlines() == [
        "a.c b.c sub/ 3",
        "4",
        "1",
        "11",
        "*.c 0: a.c b.c",
        "*/*.[ch] 0: sub/x.h sub/y.c",
        "sub 0: sub/",
        "s* 0: sub/",
        "none* 3:",
        "none* 0: none*",
        "a.c 0: a.c",
        "sub/nope 3:",
        "*/ 0: sub/",
        ".h* 0: .hidden",
    ]


def test_functions_of_varargs_take_any_arguments(capfd: pytest.CaptureFixture[str]) -> None:
    Path("old.c").write_text(VARARGS)
    for options in ([], ["--unchecked"]):
        assert main(["run", "-q", "-std=gnu89", *options, "old.c"]) == 0
        assert capfd.readouterr().out == "3.5\nx 9\n"


@pytest.mark.parametrize(
    ("source", "said"),
    [
        ("#include <ucontext.h>\nint main(void) { return 0; }", "getcontext, makecontext and"),
        (
            "#include <fenv.h>\nint main(void) { return fesetround(FE_UPWARD) == 0; }",
            "rounded to nearest here; nextafter() gives bounds of a result",
        ),
        (
            "#include <fenv.h>\nint main(void) { return fetestexcept(FE_INEXACT); }",
            "fetestexcept() finds no flags",
        ),
    ],
)
def test_missing_files_are_reported(
    source: str, said: str, capfd: pytest.CaptureFixture[str]
) -> None:
    Path("wanting.c").write_text(source)
    main(["run", "wanting.c"])
    assert said in capfd.readouterr().err
