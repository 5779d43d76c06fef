/* Pointers that are computed from the names of objects, and stay inside them in unusual ways. */
#include <setjmp.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct item { int key; struct { short a, b; } in; char name[8]; };
struct list { int count; int values[1]; };

static double row[10] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
static int left[8], right[8];
static char text[] = "one two";
static struct item items[4] = {{1, {2, 3}, "a"}, {4, {5, 6}, "bc"}, {7, {8, 9}, "def"}};
static jmp_buf back;

static int from_one(void)
{
    double *v = row - 1; /* indices from 1, as in Fortran */
    int i, sum = 0;

    for (i = 1; i <= 10; i++)
        sum += (int)v[i];
    return sum;
}

static int through_members(void)
{
    short *b = &items[1].in.b;
    struct item *whole = (struct item *)((char *)b - offsetof(struct item, in.b));
    int *words = &items[0].key;

    return whole->key * 100 + words[1] + ((char *)items)[sizeof(struct item)] + (int)sizeof *whole;
}

static int grown(int n)
{
    struct list *list = malloc(sizeof *list + (n - 1) * sizeof(int));
    int i, sum = 0;

    for (list->count = i = 0; i < n; i++)
        list->values[list->count++] = i;
    for (i = 0; i < list->count; i++)
        sum += list->values[i];
    free(list);
    return sum;
}

/* One of two, and then the other; the same block again and again. */
static int one_of_two(int which)
{
    int *p = which ? left : right, *last = NULL, *now, i, sum = 0;

    p[7] = which;
    for (i = 1; i < 6; i++) {
        now = malloc(i * 40 * sizeof *now);
        now[i * 40 - 1] = i;
        if (last != NULL) {
            sum += last[(i - 1) * 40 - 1];
            free(last);
        }
        last = now;
    }
    free(last);
    return sum + left[7] + right[7];
}

/* What points into a block follows when that moves. */
static int relocated(void)
{
    char *old = malloc(40), *at = old + 30, *fresh;
    ptrdiff_t by;

    strcpy(old, "some text that is long enough for");
    fresh = malloc(400);
    memcpy(fresh, old, 40);
    by = (int)fresh - (int)old;
    at += by;
    *at = '!';
    at = fresh + (at - fresh) + 100;
    *at = 0;
    free(old);
    by = fresh[30] + *at;
    free(fresh);
    return (int)by;
}

static int landed(void)
{
    int *volatile kept = left;
    int *p = left, times = 0;

    if (setjmp(back) == 0) {
        p = right;
        kept = right;
        left[3] = 4;
        longjmp(back, 1);
    }
    p = kept;
    p[3] = 5;
    times = left[3] * 10 + right[3];
    return times;
}

int main(void)
{
    char *word = text, *end = text + strlen(text);

    while (word < end && *word != ' ')
        word++;
    printf("%s|%c|%c\n", word, end[-1], word[-3]);
    printf("%d %d %d\n", from_one(), through_members(), grown(100));
    printf("%d %d\n", one_of_two(0), one_of_two(1));
    printf("%d %d\n", relocated(), landed());
    return 0;
}
