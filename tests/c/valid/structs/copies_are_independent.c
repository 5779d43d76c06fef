/* Copying a struct copies its arrays and not what its pointers point to. */
#include <stdio.h>

struct record { int values[3]; int *shared; struct { char c; } inner; };

static struct record make(int *shared)
{
    struct record r = { { 1, 2, 3 }, shared, { 'a' } };
    return r;
}

static void change(struct record r)
{
    r.values[0] = 100;
    *r.shared += 1;
    r.inner.c = 'z';
}

static struct record *first(struct record *a, struct record *b) { return a->values[0] ? a : b; }

int main(void)
{
    int shared = 0;
    struct record a = make(&shared), b = a, list[3];
    int i;

    b.values[1] = 20;
    b.inner.c++;
    change(a);
    change(b);
    printf("%d %d %d %c %c\n", a.values[0], a.values[1], b.values[1], a.inner.c, b.inner.c);
    printf("%d\n", shared);
    for (i = 0; i < 3; i++) {
        list[i] = i % 2 ? b : a;
        list[i].values[2] += i;
    }
    list[0] = list[2];
    printf("%d %d %d\n", list[0].values[2], list[1].values[1], list[2].values[2]);
    list[1] = list[1];
    *first(list, list + 1) = make(0);
    printf("%d %d\n", list[0].shared == 0, list[1].values[1]);
    a = *(&a);
    a = (b = make(&i), b);
    printf("%d\n", *a.shared);
    return 0;
}
