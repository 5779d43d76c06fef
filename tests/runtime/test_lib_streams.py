"""Streams, program start and end, and formatted input."""

from __future__ import annotations

import pytest

from tests.runtime.library_runner import run

HEADERS = "#include <assert.h>\n#include <errno.h>\n#include <stdio.h>\n#include <stdlib.h>\n"


def body(text: str) -> str:
    """Return a program whose main has this body."""
    return HEADERS + "int main(int argc, char **argv)\n{\n" + text + "\n}\n"


def test_arguments_of_every_length_arrive() -> None:
    arguments = ["", "x", "y" * 247, "z" * 248, "w" * 249, "v" * 1000, *map(str, range(20))]
    source = body('int i; for (i = 0; i <= argc; i++) puts(argv[i] ? argv[i] : "end"); return 5;')
    outcome = run(source, arguments)
    assert outcome.out.decode().split("\n") == ["program.c", *arguments, "end", ""]
    assert outcome.status == 5


@pytest.mark.parametrize(
    ("source", "status"),
    [
        ("main() { return 3; }", 3),
        ("int main(void) { }", 0),
        ("#include <stdlib.h>\nint main(void) { exit(300); }", 44),
        ("#include <stdlib.h>\nint main(void) { _Exit(4); }", 4),
        ("int main(argc, argv) int argc; char **argv; { return argc; }", 1),
    ],
)
def test_main_in_its_forms(source: str, status: int) -> None:
    assert run(source).status == status


def test_exit_handlers_run_backwards_and_streams_are_flushed() -> None:
    source = (
        HEADERS
        + r"""
    static void first(void) { printf("first"); }
    static void second(void) { printf("second "); }
    static void many(void) { static int n; if (++n == 40) printf("forty "); }
    int main(void)
    {
        int i;
        atexit(first);
        atexit(second);
        for (i = 0; i < 40; i++)
            atexit(many);
        printf("main ");
        exit(0);
    }
    """
    )
    assert run(source).out == b"main forty second first"


def test_abort_flushes_nothing_and_stops_with_an_error() -> None:
    outcome = run(body('printf("lost"); fprintf(stderr, "seen"); abort();'))
    assert (outcome.out, outcome.err, outcome.error) == (b"", b"seen", "abort called")


def test_a_failed_assertion_says_where() -> None:
    outcome = run(body('printf("before ");\nassert(argc == 1);\nassert(argc == 2 && "why");'))
    assert outcome.out == b"before "
    text = 'program.c:9: main: Assertion `argc == 2 && "why"\' failed.\n'
    assert (outcome.err.decode(), outcome.error) == (text, "assertion failed")


def test_input_by_lines_and_characters() -> None:
    source = body(r"""
    char line[8];
    int c;
    printf("%s", fgets(line, sizeof line, stdin));
    printf("%s|\n", fgets(line, sizeof line, stdin));
    c = getchar();
    ungetc(c, stdin);
    ungetc('<', stdin);
    while ((c = getc(stdin)) != EOF)
        putchar(c);
    printf("|%d %d %d\n", feof(stdin) != 0, ferror(stdin), fgets(line, 8, stdin) == NULL);
    clearerr(stdin);
    printf("%d", feof(stdin));
    printf(" %d\n", getchar());
    return 0;""")
    outcome = run(source, stdin=b"one\ntwo and more\nthe last " + b"x" * 600)
    expected = "one\ntwo and|\n< more\nthe last " + "x" * 600 + "|1 0 1\n0 -1\n"
    assert outcome.out.decode() == expected


def test_a_prompt_is_flushed_before_input_is_read() -> None:
    source = body('printf("name? "); getchar(); fprintf(stderr, "!"); abort();')
    assert run(source, stdin=b"x").out == b"name? "


def test_standard_output_is_line_buffered_and_setvbuf_changes_that() -> None:
    assert run(body(r'printf("a\nb"); printf("c\nd"); abort();')).out == b"a\nbc\n"
    assert run(body('setbuf(stdout, NULL); printf("abc"); abort();')).out == b"abc"
    full = r'setvbuf(stdout, NULL, _IOFBF, BUFSIZ); printf("a\nb\n"); abort();'
    assert run(body(full)).out == b""
    long = r'int i; for (i = 0; i < 5000; i++) putchar("ab"[i % 2]); abort();'
    assert run(body(long)).out == b"ab" * 2048


def test_failed_opens_and_writes_set_errno() -> None:
    source = body(r"""
    FILE *file = fopen("map.txt", "r");
    if (file == NULL)
        perror("map.txt");
    errno = 0;
    printf("%d", fopen("log.txt", "q") == NULL);
    printf("%d", errno == EINVAL);
    printf("%d\n", fputs("x", stdin) == EOF && ferror(stdin));
    return 0;""")
    outcome = run(source)
    assert (outcome.out, outcome.err) == (b"111\n", b"map.txt: No such file or directory\n")


SCANS = [
    # input, format, results printed as (count: values)
    ("12 34", "%d %d", "2: 12 34 0"),
    ("  -7,8", "%d,%d", "2: -7 8 0"),
    ("x", "%d", "0: 0 0 0"),
    ("", "%d", "-1: 0 0 0"),
    ("   ", "%d %d", "-1: 0 0 0"),
    ("0x1f 010 9", "%i %i %i", "3: 31 8 9"),
    ("1f 17 77", "%x %u %o", "3: 31 17 63"),
    ("12345", "%2d%2d%2d", "3: 12 34 5"),
    ("5 6 7", "%d %*d %d", "2: 5 7 0"),
    ("50%", "%d%%%n", "1: 50 3 0"),
    ("a=1 b=2", "a=%d b=%d", "2: 1 2 0"),
    ("a=1 c=2", "a=%d b=%d", "1: 1 0 0"),
    ("99999999999", "%d", "1: 2147483647 0 0"),
]


def test_scanf_of_integers() -> None:
    calls = "".join(
        "a = b = c = 0; "
        f'n = sscanf("{text}", "{form}", &a, &b, &c); printf("%d: %d %d %d\\n", n, a, b, c);\n'
        for text, form, _ in SCANS
    )
    out = run(body(f"int a, b, c, n;\n{calls}return 0;")).out.decode().splitlines()
    assert out == [expected for _, _, expected in SCANS]


def test_scanf_of_words_sets_and_floating_numbers() -> None:
    source = body(r"""
    char a[20], b[20], c[4] = "...";
    double x = 0;
    float y = 0;
    short s = 7;
    long long l = 0;
    int n = scanf("%s %5[a-c] %*[^:]:%3c", a, b, c);
    printf("%d %s %s %.3s\n", n, a, b, c);
    n = scanf("%lf%f%hd%lld", &x, &y, &s, &l);
    printf("%d %g %g %d %lld\n", n, x, y, s, l);
    n = scanf("%f%f%f", &y, &y, &y);
    printf("%d %g %d\n", n, y, getchar());
    return 0;""")
    text = b"word  abcabcabc rest:x y  1.5e3 -0x1p-2 70000 9000000000 inf nan 1e5x"
    assert run(source, stdin=text).out.decode().splitlines() == [
        "3 word abcab x y",
        "4 1500 -0.25 4464 9000000000",
        "3 100000 120",
    ]


def test_clocks_follow_simulated_time() -> None:
    source = r"""
    #include <errno.h>
    #include <stdio.h>
    #include <sys/time.h>
    #include <time.h>
    #include <unistd.h>
    int main(void)
    {
        struct timeval now;
        struct timespec short_time = {1, 250000000}, wrong = {0, 1000000000};
        int i;
        printf("%ld %ld\n", time(NULL), clock());
        for (i = 0; i < 3; i++)
            usleep(100000);
        gettimeofday(&now, NULL);
        printf("%ld %ld\n", (long)now.tv_sec, (long)now.tv_usec);
        sleep(2);
        nanosleep(&short_time, NULL);
        printf("%d %d\n", nanosleep(&wrong, NULL), errno == EINVAL);
        gettimeofday(&now, NULL);
        printf("%ld %ld %ld\n", (long)now.tv_sec, (long)now.tv_usec, (long)clock());
        printf("%.1f %d\n", difftime(time(NULL), 946684800L), getpid());
        return 0;
    }
    """
    assert run(source).out.decode().splitlines() == [
        "946684800 0",
        "946684800 300000",
        "-1 0",
        "946684803 550000 1775000",
        "3.0 1",
    ]


def test_the_buffer_of_fgetln_lasts_until_the_next_call() -> None:
    source = body(
        "size_t n; char *line; while ((line = fgetln(stdin, &n)) != NULL)"
        ' printf("%u %.*s|", (unsigned)n, (int)n, line); printf("%u", (unsigned)n); return 0;'
    )
    assert run(source, stdin=b"one\n\nlast").out == b"4 one\n|1 \n|4 last|0"
