/* Bytes without a value may be copied, swapped and passed on as long as nothing depends on them. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct mixed { char tag; double number; short tail; };

static void copy_bytes(void *to, const void *from, unsigned size)
{
    char *t = to;
    const char *f = from;

    while (size-- > 0)
        *t++ = *f++;
}

static void copy_words(int *to, const int *from, int count)
{
    int i;

    for (i = 0; i < count; i++)
        to[i] = from[i];
}

static void swap(int *a, int *b)
{
    int t = *a;

    *a = *b;
    *b = t;
}

static struct mixed pass(struct mixed m)
{
    return m;
}

static int by_tag(const void *a, const void *b)
{
    return ((const struct mixed *) a)->tag - ((const struct mixed *) b)->tag;
}

int main(void)
{
    struct mixed a, b, c[5];
    int half[8], other[8], i;
    char *block;

    a.tag = 'a';                             /* the padding and `tail` have no value */
    a.number = 1.5;
    copy_bytes(&b, &a, sizeof b);
    printf("%c %g\n", b.tag, b.number);
    for (i = 0; i < 4; i++)
        half[i] = i;
    copy_words(other, half, 8);
    swap(&other[0], &other[7]);
    printf("%d %d\n", other[7], other[1]);
    b = pass(a);
    memcpy(&a, &b, sizeof a);
    printf("%c %g\n", a.tag, a.number);
    for (i = 0; i < 5; i++) {
        c[i].tag = 'e' - i;
        c[i].number = i;
    }
    qsort(c, 5, sizeof c[0], by_tag);
    for (i = 0; i < 5; i++)
        printf("%c%g ", c[i].tag, c[i].number);
    block = malloc(100);
    strcpy(block, "grown");
    block = realloc(block, 5000);
    memmove(block + 10, block, 100);
    printf("%s\n", block + 10);
    free(block);
    return 0;
}
