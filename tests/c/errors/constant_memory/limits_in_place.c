/* A constant object of a function is changed through a pointer; a copy of it may be. */
#include <string.h>

struct limits { int low, high; char name[80]; };

static void widen(struct limits *l)
{
    l->high += 10; // error: write to read-only memory
}

int main(void)
{
    const struct limits l = { 1, 2, "narrow" };
    struct limits copy = l, moved;

    widen(&copy);
    memcpy(&moved, &l, sizeof l);
    widen(&moved);
    widen((struct limits *)&l);
    return 0;
}
