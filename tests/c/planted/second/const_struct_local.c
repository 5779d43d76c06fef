/* A constant struct in a function is handed to one that changes it. */
#include <stdio.h>
struct limits { int low, high; };
static void widen(struct limits *l) { l->high += 10; } // error: write to read-only memory
int main(void)
{
    const struct limits l = {1, 2};
    struct limits copy = l;
    widen(PLANT((struct limits *)&l, &copy));
    printf("%d\n", l.high);
    return 0;
}
