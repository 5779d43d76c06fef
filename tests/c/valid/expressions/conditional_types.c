/* The type of `c ? a : b` is the common type, whichever operand is selected (C17 6.5.15). */
#include <stdio.h>
#include <stddef.h>

struct point { int x, y; };
static void nothing(int *n) { ++*n; }
static void more(int *n) { *n += 10; }

int main(void)
{
    int zero = 0, n = 0;
    char c = 'c';
    struct point a = { 1, 2 }, b = { 3, 4 };
    const int constant = 7;
    int array[3] = { 5, 6, 7 };
    void *p = &n;

    printf("%u %u\n", (unsigned) sizeof(1 ? c : c), (unsigned) sizeof(1 ? 1 : 1.0));
    printf("%d %d\n", (zero ? 1u : -1) > 0, (zero ? 1 : -1) > 0);
    printf("%g\n", (zero ? 1.5 : 7) / 2);
    printf("%d %d\n", (zero ? a : b).x, (!zero ? a : b).y);
    printf("%d\n", *(zero ? &constant : &n));
    printf("%d\n", *(int *) (zero ? p : array));
    printf("%d\n", (zero ? NULL : array)[1]);
    printf("%d\n", (zero ? array : array + 1)[1]);
    (zero ? nothing : more)(&n);
    zero ? nothing(&n) : more(&n);
    printf("%d\n", n);
    printf("%s\n", zero ? "yes" : n > 5 ? "large" : "small");
    printf("%lld\n", zero ? -1 : 5000000000);
    printf("%d\n", zero ? 1 : zero ? 2 : zero ? 3 : 4);
    return 0;
}
