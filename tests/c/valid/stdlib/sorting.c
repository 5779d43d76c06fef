/* qsort with comparators over ints, strings, structs and pointers; bsearch. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct robot { char name[8]; int battery; double x; };

static int up(const void *a, const void *b)
{
    int x = *(const int *) a, y = *(const int *) b;
    return (x > y) - (x < y);
}

static int down(const void *a, const void *b) { return up(b, a); }
static int by_text(const void *a, const void *b) { return strcmp(*(char *const *) a, *(char *const *) b); }

static int by_battery(const void *a, const void *b)
{
    const struct robot *r = a, *s = b;

    if (r->battery != s->battery)
        return r->battery - s->battery;
    return strcmp(r->name, s->name);
}

static int by_x(const void *a, const void *b)
{
    double d = (*(struct robot *const *) a)->x - (*(struct robot *const *) b)->x;
    return d < 0 ? -1 : d > 0;
}

static int by_byte(const void *a, const void *b)
{
    return *(const unsigned char *) a - *(const unsigned char *) b;
}

static int key_cmp(const void *key, const void *item)
{
    return *(const int *) key - ((const struct robot *) item)->battery;
}

int main(void)
{
    int v[] = { 5, -3, 9, 0, 5, 2147483647, -2147483647 - 1, 7 }, n = 8, i, key;
    char *words[] = { "wall", "sonar", "bump", "turn", "ahead" };
    struct robot r[] = { { "r2", 50, 3.5 }, { "r0", 90, -1 }, { "r1", 50, 0.25 }, { "r3", 10, 7 } };
    struct robot *p[4], *hit;
    unsigned char bytes[200];
    int ok = 1;

    qsort(v, n, sizeof *v, up);
    for (i = 0; i < n; i++)
        printf("%d ", v[i]);
    qsort(v, n, sizeof *v, down);
    printf("| %d %d\n", v[0], v[7]);
    qsort(words, 5, sizeof words[0], by_text);
    for (i = 0; i < 5; i++)
        printf("%s ", words[i]);
    printf("\n");
    for (i = 0; i < 4; i++)
        p[i] = &r[i];
    qsort(p, 4, sizeof *p, by_x);
    for (i = 0; i < 4; i++)
        printf("%s ", p[i]->name);
    qsort(r, 4, sizeof *r, by_battery);
    for (i = 0; i < 4; i++)
        printf("%s%d ", r[i].name, r[i].battery);
    printf("\n");
    key = 90;
    hit = bsearch(&key, r, 4, sizeof *r, key_cmp);
    printf("%s ", hit ? hit->name : "none");
    key = 91;
    printf("%d\n", bsearch(&key, r, 4, sizeof *r, key_cmp) == NULL);
    for (i = 0; i < 200; i++)
        bytes[i] = i * 37;
    qsort(bytes, 200, 1, by_byte);
    for (i = 1; i < 200; i++)
        ok &= bytes[i - 1] <= bytes[i];
    qsort(v, 0, sizeof *v, up);
    qsort(v, 1, sizeof *v, up);
    printf("%d\n", ok);
    return 0;
}
