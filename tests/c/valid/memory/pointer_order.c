/* Pointers that are compared and subtracted as old programs do it. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct wide { int key; char pad[96]; };

static struct wide before[2], row[5], after[2];
static int numbers[3000];
static char text[] = "left,right,,forward";

/* A loop that counts down ends before the array. */
static int down(struct wide *table, int n)
{
    struct wide *p;
    int steps = 0;

    for (p = table + n - 1; p >= table; p--)
        steps = steps * 10 + p->key;
    return steps;
}

/* Both arrays are left by their own ends, in turns. */
static int merge(const int *a, const int *a_end, const int *b, const int *b_end)
{
    int n = 0;

    while (a < a_end && b < b_end)
        n += *a <= *b ? a++ != 0 : 2 * (b++ != 0);
    return n + (a_end - a) + (b_end - b);
}

static int on_stack(int depth)
{
    int cells[40], *p, *end = cells + 40, sum = 0;

    for (p = cells; p < end; p++)
        *p = depth;
    for (p = end; p > cells;)
        sum += *--p;
    return depth ? sum + on_stack(depth - 1) : sum;
}

static int more(const char *at, const char *end) { return at < end; }

int main(void)
{
    char *field = text, *comma, *grown, *moved;
    int i, *p, *a, *b, *none = NULL;
    long shift;

    for (i = 0; i < 5; i++)
        row[i].key = i + 1;
    printf("%d %d\n", down(row, 5), before[0].key + after[0].key);
    for (i = 0, p = numbers; p - numbers < 3000; p++)
        *p = ++i;
    for (i = 0, p = numbers; p < numbers + 3000; p += 7) /* beyond the end in the end */
        i += *p;
    printf("%d\n", i);
    while ((comma = strchr(field, ',')) != NULL) {
        printf("[%.*s]", (int)(comma - field), field);
        field = comma + 1;
    }
    for (i = 0, field = text; more(field, text + strlen(text)); field++)
        i += *field == ',';
    printf(" %d\n", i);
    a = malloc(500 * sizeof *a);
    b = malloc(700 * sizeof *b);
    for (i = 0; i < 700; i++) {
        b[i] = 3 * i;
        if (i < 500)
            a[i] = 4 * i;
    }
    printf("%d\n", merge(a, a + 500, b, b + 700));
    printf("%d %d\n", none < a, a > (int *)0);
    grown = malloc(10);
    strcpy(grown, "go on");
    moved = grown + 3;
    shift = moved - grown; /* a pointer into the block is corrected when that has moved */
    grown = realloc(grown, 4000);
    moved = grown + shift;
    puts(moved);
    printf("%d\n", on_stack(3));
    free(grown);
    free(a);
    free(b);
    return 0;
}
