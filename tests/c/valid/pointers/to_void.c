/* void pointers: generic swap, generic search, generic stack. */
#include <stdio.h>
#include <string.h>

static void swap(void *a, void *b, unsigned size)
{
    unsigned char *p = a, *q = b;

    while (size--) {
        unsigned char t = *p;
        *p++ = *q;
        *q++ = t;
    }
}

static void *find(void *items, unsigned count, unsigned size, const void *key)
{
    char *p = items;

    for (; count; count--, p += size)
        if (memcmp(p, key, size) == 0)
            return p;
    return NULL;
}

struct stack {
    unsigned char bytes[64];
    unsigned top, size;
};

static void push(struct stack *s, const void *item)
{
    memcpy(s->bytes + s->top++ * s->size, item, s->size);
}

static void *pop(struct stack *s)
{
    return s->top ? s->bytes + --s->top * s->size : NULL;
}

int main(void)
{
    int a = 1, b = 2, v[] = { 5, 8, 13, 21 }, key = 13, none = 4, *hit;
    double x = 1.5, y = -2.5, *d;
    short pairs[2][2] = { { 1, 2 }, { 3, 4 } };
    struct stack s = { { 0 }, 0, sizeof(double) };

    swap(&a, &b, sizeof a);
    swap(&x, &y, sizeof x);
    swap(pairs[0], pairs[1], sizeof pairs[0]);
    printf("%d %d %g %g %d %d\n", a, b, x, y, pairs[0][0], pairs[1][1]);
    hit = find(v, 4, sizeof *v, &key);
    printf("%d\n", (int) (hit - v));
    printf("%d\n", find(v, 4, sizeof *v, &none) == NULL);
    for (x = 0.5; x < 4; x++)
        push(&s, &x);
    while ((d = pop(&s)))
        printf("%g ", *d);
    printf("\n");
    return 0;
}
