/* Operators with surprising effects on their operands. */
#include <stdio.h>

static int size(int v[10]) { return sizeof v; }  // warning: sizeof on array parameter 'v'
//                                  ^
static char *name(void)
{
    char text[10] = "x";
    return text;  // warning: address of local variable 'text' returned
//         ^
}
static int *part(void) { struct { int a[2]; } s = {{1}}; return &s.a[1]; }  // warning: address of local variable 's'
static char *kept(void) { static char text[10]; return text; }

int main(int argc, char **argv)
{
    unsigned n = argc;
    int i = argc;

    if (n > -1)  // warning: comparison of 'unsigned int' with a negative constant
        i = 1;
    if (n == -1 || n >= 0 || i > -1)
        i = 2;
    if (argv[0] == "crs")  // warning: comparison against a string literal compares addresses, not contents
//      ^
        i = 3;
    i = i << 32;  // warning: shift count is >= width of type
    i = i / 0;  // warning: division by zero is undefined
    printf("%d %p %p %p\n", size(&i), name(), part(), kept());
    return 0;
}
