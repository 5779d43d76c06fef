"""Memory, sorting, random numbers and integer arithmetic."""

from __future__ import annotations

import math

from tests.runtime.library_runner import run

RANDOM = r"""
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
static unsigned long long state = 88172645463325252ULL;
static unsigned below(unsigned n)      /* xorshift (G. Marsaglia, 2003) */
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (unsigned)(state >> 32) % n;
}
"""


def test_blocks_keep_their_content_and_memory_is_reused() -> None:
    source = (
        RANDOM
        + r"""
    #define N 500
    extern char __heap_start[], __heap_end[];
    static unsigned char *block[N];
    static unsigned top;
    static unsigned size[N];
    static unsigned some_size(void)
    {
        switch (below(4)) {
        case 0: return 1 + below(31);
        case 1: return 1 + below(600);
        case 2: return 1 + below(5000);
        default: return below(20) ? 1 + below(200) : 1 + below(60000);
        }
    }
    static void check(int k, unsigned count)
    {
        unsigned i;
        for (i = 0; i < count; i++)
            if (block[k][i] != (unsigned char)(k + i)) {
                puts("damage");
                exit(1);
            }
    }
    int main(void)
    {
        unsigned i, j, most = 0, live = 0;
        for (i = 0; i < 20000; i++) {
            int k = below(N), way = below(4);
            unsigned old = size[k];
            check(k, old);
            live -= old;
            size[k] = way == 0 ? 0 : some_size();
            if (way == 1) {
                block[k] = realloc(block[k], size[k]);
                check(k, old < size[k] ? old : size[k]);
            } else {
                free(block[k]);
                block[k] = way == 0 ? NULL : way == 2 ? malloc(size[k]) : calloc(size[k], 1);
                for (j = 0; way == 3 && j < size[k]; j++)
                    if (block[k][j] != 0)
                        puts("calloc");
            }
            if ((unsigned)block[k] % 16 != 0 || (way != 0 && block[k] == NULL))
                puts("bad block");
            for (j = 0; j < size[k]; j++)
                block[k][j] = k + j;
            live += size[k];
            if (live > most)
                most = live;
            if (way != 0 && (unsigned)block[k] + size[k] > top)
                top = (unsigned)block[k] + size[k];
        }
        printf("%d\n", top - (unsigned)__heap_start < 3 * most + 0x40000);
        for (i = 0; i < N; i++)
            free(block[i]);
        top = (unsigned)malloc((unsigned)__heap_end - (unsigned)__heap_start - 1000);
        printf("%d\n", top - (unsigned)__heap_start < 200);     /* behind argv */
        return 0;
    }
    """
    )
    assert run(source).out.decode().split() == ["1", "1"]


def test_the_end_of_memory_is_a_null_pointer() -> None:
    source = (
        RANDOM
        + r"""
    #include <errno.h>
    int main(void)
    {
        void *list = NULL, *block;
        int first = 0, second = 0;
        for (; (block = malloc(1000)) != NULL; list = block, first++)
            *(void **)block = list;
        printf("%d ", errno == ENOMEM);
        for (; list != NULL; list = block) {
            block = *(void **)list;
            free(list);
        }
        while (malloc(1000) != NULL)
            second++;
        printf("%d %d ", first > 1000, second == first);
        printf("%d ", malloc(0xffffffffu) == NULL && malloc(0x7ffffff0) == NULL);
        printf("%d\n", calloc(0x10000, 0x10001) == NULL && realloc(NULL, 0xfffffff0u) == NULL);
        return 0;
    }
    """
    )
    assert run(source).out.decode().split() == ["1"] * 5


def test_misuse_of_blocks_stops_the_program() -> None:
    misuses = (
        ("double free", "char *p = malloc(10); free(p); free(p);"),
        ("double free", "char *p = malloc(10); free(p); p = realloc(p, 0);"),
        ("invalid free", "char *p = malloc(10); free(p + 8);"),
        ("invalid free", "char *p = malloc(100); free(p + 32);"),
        ("invalid free", "int local; free(&local);"),
        ("out of bounds", "char *p = malloc(10); malloc(10); memset(p, 255, 40); free(p);"),
        ("use after free", "char *p = malloc(10); free(p); *p = 1;"),
    )
    for kind, misuse in misuses:
        outcome = run(RANDOM + "int main(void) { " + misuse + " return 0; }")
        assert outcome.error == kind


SORT = (
    RANDOM
    + r"""
struct item { int key, number; char padding[3]; };
static struct item items[2048];
static long compared;
static int by_key(const void *left, const void *right)
{
    compared++;
    return ((const struct item *)left)->key - ((const struct item *)right)->key;
}
static void order(int kind, int n)
{
    int i;
    for (i = 0; i < n; i++) {
        items[i].number = i;
        switch (kind) {
        case 0: items[i].key = i; break;
        case 1: items[i].key = -i; break;
        case 2: items[i].key = 7; break;
        case 3: items[i].key = i < n / 2 ? i : n - i; break;
        case 4: items[i].key = i % 2 ? i : n / 2 + i / 2; break;
        case 5: items[i].key = i % 17; break;
        default: items[i].key = below(n);
        }
    }
}
static void sort(int n, int stable)
{
    int kind, i;
    for (kind = 0; kind < 7; kind++) {
        order(kind, n);
        compared = 0;
        qsort(items, n, sizeof *items, by_key);
        for (i = 1; i < n; i++)
            if (items[i - 1].key > items[i].key ||
                (stable && items[i - 1].key == items[i].key &&
                 items[i - 1].number > items[i].number))
                printf("kind %d, %d of %d\n", kind, i, n);
        printf("%ld\n", compared);
    }
}
int main(int argc, char **argv)
{
    int n, sizes[] = {0, 1, 2, 3, 5, 8, 31, 100, 1000, 2048}, i;
    if (argc > 1)
        while (malloc(8) != NULL)
            ;
    for (i = 0; i < 10; i++)
        sort(sizes[i], argc == 1);
    return 0;
}
"""
)
SIZES = (0, 1, 2, 3, 5, 8, 31, 100, 1000, 2048)


def test_qsort_is_stable_and_never_slow() -> None:
    counts = iter(run(SORT).out.decode().splitlines())
    for n in SIZES:
        for _ in range(7):
            assert int(next(counts)) <= n * math.ceil(math.log2(n or 1)) + 1


def test_qsort_is_fast_without_memory_too() -> None:
    counts = iter(run(SORT, ["full"]).out.decode().splitlines())
    for n in SIZES:
        for _ in range(7):
            assert int(next(counts)) <= 2 * n * math.ceil(math.log2(n or 1)) + 2


def test_bsearch_finds_existing_elements() -> None:
    source = (
        RANDOM
        + r"""
    static int by_value(const void *a, const void *b) { return *(int *)a - *(int *)b; }
    int main(void)
    {
        int v[20], n, key, i;
        for (n = 0; n <= 20; n++) {
            for (i = 0; i < n; i++)
                v[i] = 2 * i;
            for (key = -1; key < 41; key++) {
                int *found = bsearch(&key, v, n, sizeof *v, by_value);
                int there = key >= 0 && key % 2 == 0 && key / 2 < n;
                if (there ? found != v + key / 2 : found != NULL)
                    printf("%d of %d\n", key, n);
            }
        }
        return 0;
    }
    """
    )
    assert run(source).out == b""


def test_random_numbers_are_those_of_linux() -> None:
    source = (
        RANDOM
        + r"""
    int main(void)
    {
        printf("%d %d %d\n", rand(), rand(), rand());
        srand(42);
        printf("%d ", rand());
        srandom(42);
        printf("%ld\n", random());
        return 0;
    }
    """
    )
    # arguments are evaluated from the last to the first
    assert run(source).out.decode() == "1681692777 846930886 1804289383\n71876166 71876166\n"


def test_integer_arithmetic() -> None:
    source = (
        RANDOM
        + r"""
    int main(void)
    {
        div_t d = div(-7, 2);
        ldiv_t l = ldiv(7, -2);
        lldiv_t ll = lldiv(-70000000001LL, 3);
        printf("%d %d %ld %ld %lld %lld\n", d.quot, d.rem, l.quot, l.rem, ll.quot, ll.rem);
        printf("%d %ld %lld\n", abs(-4), labs(-5L), llabs(-6000000000LL));
        printf("%d %d %d\n", getenv("HOME") == NULL, system(NULL), system("ls"));
        return 0;
    }
    """
    )
    assert run(source).out.decode().splitlines() == [
        "-3 -1 -3 1 -23333333333 -2",
        "4 5 6000000000",
        "1 0 -1",
    ]


def test_unseeded_random_numbers_are_uniform_and_reproducible() -> None:
    source = r"""
    #include <stdio.h>
    #include <stdlib.h>
    #include <string.h>
    int main(void)
    {
        int counts[6] = {0}, ones = 0, i;
        unsigned char bytes[1000];
        for (i = 0; i < 6000; i++)
            counts[arc4random_uniform(6)]++;
        arc4random_buf(bytes, sizeof bytes);
        for (i = 0; i < (int)sizeof bytes; i++)
            ones += __builtin_popcount(bytes[i]);
        printf("%u %d", arc4random(), ones);
        for (i = 0; i < 6; i++)
            printf(" %d", counts[i]);
        return arc4random_uniform(1) + arc4random_uniform(0);
    }
    """
    first, second = run(source), run(source)
    assert first == second
    assert first.status == 0
    _, ones, *counts = map(int, first.out.split())
    assert abs(ones - 4000) < 4 * math.sqrt(2000)
    assert all(abs(count - 1000) < 4 * math.sqrt(1000 * 5 / 6) for count in counts)
