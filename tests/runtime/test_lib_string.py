"""Strings and character classes, compared with Python's."""

from __future__ import annotations

import random
from itertools import takewhile

from tests.runtime.library_runner import run

CLASSES = "alnum alpha blank cntrl digit graph lower print punct space upper xdigit"

COMPARE = r"""
#include <stdio.h>
#include <string.h>
#include <stdlib.h>
static char line[100];
static int sign(int value) { return value < 0 ? -1 : value > 0; }
static void place(const char *text, const char *found)
{
    printf(" %d", found ? (int)(found - text) : -1);
}
static void tokens(char *text)
{
    char *token;
    for (token = strtok(text, ",;"); token != NULL; token = strtok(NULL, ",;"))
        printf("[%s]", token);
}
static void parts(char *text)
{
    char *part;
    while ((part = strsep(&text, ",;")) != NULL)
        printf("(%s)", part);
}
int main(void)
{
    while (fgets(line, sizeof line, stdin) != NULL) {
        char a[50], b[50], c[100], *copy;
        int n = atoi(line);
        char *text = strchr(line, ' ') + 1, *bar = strchr(text, '|');
        *bar = 0;
        strcpy(a, text);
        strcpy(b, bar + 1);
        b[strlen(b) - 1] = 0;
        int shorter = strlen(a) < strlen(b) ? strlen(a) : strlen(b);
        printf("%d %d %d %d", sign(strcmp(a, b)), sign(strncmp(a, b, n)), sign(strcasecmp(a, b)),
               sign(strncasecmp(a, b, n)));
        printf(" %d", sign(memcmp(a, b, shorter)));
        printf(" %u %u %u", strlen(a), strspn(a, b), strcspn(a, b));
        place(a, strchr(a, 'b'));
        place(a, strrchr(a, 'b'));
        place(a, index(a, 0));
        place(a, strpbrk(a, b));
        place(a, strstr(a, b));
        place(a, memchr(a, 'c', strlen(a)));
        copy = strndup(a, n);
        printf(" %s", copy);
        free(copy);
        strcpy(c, a);
        strcat(c, b);
        strncat(c, a, n);
        printf(" %s %u ", c, strnlen(c, n));
        tokens(a);
        strcpy(c, b);
        parts(c);
        printf("\n");
    }
    return 0;
}
"""


def sign(left: bytes, right: bytes) -> int:
    return (left > right) - (left < right)


def expected(n: int, a: bytes, b: bytes) -> bytes:
    short = min(len(a), len(b))
    numbers = [
        sign(a, b), sign(a[:n], b[:n]), sign(a.lower(), b.lower()),
        sign(a.lower()[:n], b.lower()[:n]), sign(a[:short], b[:short]), len(a),
        len(list(takewhile(lambda c: c in b, a))), len(list(takewhile(lambda c: c not in b, a))),
        a.find(b"b"), a.rfind(b"b"), len(a),
        next((i for i, c in enumerate(a) if c in b), -1), a.find(b), a.find(b"c"),
    ]  # fmt: skip
    joined = a + b + a[:n]
    tokens = b"".join(b"[%s]" % part for part in a.replace(b";", b",").split(b",") if part)
    parts = b"".join(b"(%s)" % part for part in b.replace(b";", b",").split(b","))
    row = b" ".join([b"%d" % number for number in numbers] + [a[:n], joined])
    return row + b" %d " % min(n, len(joined)) + tokens + parts


def test_string_functions() -> None:
    choose = random.Random(6)
    letters = b"abcAB,;\xe4"
    cases = [
        (
            choose.randrange(12),
            bytes(choose.choices(letters, k=choose.randrange(12))),
            bytes(choose.choices(letters, k=choose.randrange(4))),
        )
        for _ in range(400)
    ]
    data = b"".join(b"%d %s|%s\n" % case for case in cases)
    assert run(COMPARE, stdin=data).out.splitlines() == [expected(*case) for case in cases]


def test_copying() -> None:
    source = r"""
    #include <stdio.h>
    #include <string.h>
    int main(void)
    {
        char a[12] = "0123456789", b[12], *rest, *at;
        memmove(a + 2, a, 6);
        puts(a);
        memmove(a, a + 2, 6);
        puts(a);
        memset(b, 'x', sizeof b);
        strncpy(b, "ab", 5);
        printf("%d%d%d %c\n", b[2], b[3], b[4], b[5]);
        strncpy(b, "abcdefgh", 3);
        printf("%.4s\n", b);
        bzero(b, sizeof b);
        bcopy("hello", b, 5);
        at = stpcpy(b + 5, "!");
        printf("%s %d\n", b, (int)(at - b));
        printf("%d\n", (int)((char *)memccpy(a, "one.two", '.', 7) - a));
        strcpy(a, "  p q ");
        for (at = strtok_r(a, " ", &rest); at != NULL; at = strtok_r(NULL, " ", &rest))
            printf("[%s]", at);
        printf(" %d %d\n", strxfrm(b, "abc", 2), memcmp("a\0b", "a\0c", 3) < 0);
        return 0;
    }
    """
    assert run(source).out.decode().splitlines() == [
        "0101234589",
        "0123454589",
        "000 x",
        "abc",
        "hello! 6",
        "4",
        "[p][q] 3 1",
    ]


def test_every_character_is_in_its_classes() -> None:
    names = CLASSES.split()
    calls = " | ".join(f"!!is{name}(c) << {bit}" for bit, name in enumerate(names))
    source = (
        "#include <ctype.h>\n#include <stdio.h>\nint main(void) { int c; "
        "for (c = -1; c < 256; c++) "
        f'printf("%d %d %d\\n", {calls}, tolower(c), toupper(c)); return 0; }}'
    )
    rows = [tuple(map(int, row.split())) for row in run(source).out.decode().splitlines()]
    for c, (classes, lower, upper) in zip(range(-1, 256), rows, strict=True):
        text = chr(c) if 0 <= c < 128 else "\x80"
        known = text < "\x80"
        tests = {
            "alnum": text.isalnum(), "alpha": text.isalpha(), "blank": text in " \t",
            "cntrl": c in range(32) or c == 127, "digit": text.isdigit(),
            "graph": text.isprintable() and text != " ", "lower": text.islower(),
            "print": text.isprintable(), "upper": text.isupper(),
            "punct": text.isprintable() and text != " " and not text.isalnum(),
            "space": text in " \t\n\v\f\r", "xdigit": text in "0123456789abcdefABCDEF",
        }  # fmt: skip
        assert classes == sum((known and tests[name]) << bit for bit, name in enumerate(names)), c
        assert (lower, upper) == ((ord(text.lower()), ord(text.upper())) if known else (c, c))


def test_error_texts_are_those_of_linux() -> None:
    source = r"""
    #include <errno.h>
    #include <stdio.h>
    #include <string.h>
    int main(void)
    {
        int numbers[] = {0, EPERM, ENOENT, EINVAL, ERANGE, EDOM, ENOMEM, EILSEQ, ECONNREFUSED,
                         9999};
        int i;
        for (i = 0; i < 10; i++)
            puts(strerror(numbers[i]));
        return 0;
    }
    """
    numbers = (0, 1, 2, 22, 34, 33, 12, 84, 111, 9999)
    known = dict.fromkeys(numbers, "")
    known.update({
        0: "Success", 1: "Operation not permitted", 2: "No such file or directory",
        22: "Invalid argument", 34: "Numerical result out of range",
        33: "Numerical argument out of domain", 12: "Cannot allocate memory",
        84: "Invalid or incomplete multibyte or wide character", 111: "Connection refused",
        9999: "Unknown error 9999",
    })  # fmt: skip
    assert run(source).out.decode().splitlines() == list(known.values())
