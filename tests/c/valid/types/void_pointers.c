/* void pointers hold any object pointer and convert back without a cast. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef int (*compare)(const void *, const void *);

static void exchange(void *a, void *b, size_t size)
{
    char spare[64];
    memcpy(spare, a, size);
    memcpy(a, b, size);
    memcpy(b, spare, size);
}

static void sort(void *base, size_t count, size_t size, compare less)
{
    char *p = base;
    for (size_t i = 1; i < count; i++)
        for (size_t j = i; j > 0 && less(p + j * size, p + (j - 1) * size) < 0; j--)
            exchange(p + j * size, p + (j - 1) * size, size);
}

static int by_int(const void *a, const void *b)
{
    const int *x = a, *y = b;
    return *x < *y ? -1 : *x > *y;
}

static int by_text(const void *a, const void *b) { return strcmp(*(char **) a, *(char **) b); }
static int by_double(const void *a, const void *b)
{
    return (*(const double *) a > *(const double *) b) - (*(const double *) a < *(const double *) b);
}

int main(void)
{
    int n[] = { 5, -2, 9, 0 };
    const char *words[] = { "pear", "apple", "fig" };
    double d[] = { 0.5, -1e9, 2.25 };
    void *any = n;
    int *back = any;

    sort(n, 4, sizeof *n, by_int);
    sort(words, 3, sizeof *words, by_text);
    sort(d, 3, sizeof *d, by_double);
    printf("%d %d %d %d\n", n[0], n[1], back[2], ((int *) any)[3]);
    printf("%s %s %s\n", words[0], words[1], words[2]);
    printf("%g %g %g\n", d[0], d[1], d[2]);
    return 0;
}
