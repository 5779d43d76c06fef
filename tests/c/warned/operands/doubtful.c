/* Operators with surprising effects on their operands. */
#include <stdio.h>

static int size(int v[10]) { return sizeof v; }  // warning: 'v' is a pointer here
//                                  ^
static char *name(void)
{
    char text[10] = "x";
    return text;  // warning: 'text' ends with the function, and its address is returned
//         ^
}
static int *part(void) { struct { int a[2]; } s = {{1}}; return &s.a[1]; }  // warning: 's' ends
static char *kept(void) { static char text[10]; return text; }

int main(int argc, char **argv)
{
    unsigned n = argc;
    int i = argc;

    if (n > -1)  // warning: comparison of 'unsigned int' with a negative constant
        i = 1;
    if (n == -1 || n >= 0 || i > -1)
        i = 2;
    if (argv[0] == "crs")  // warning: this compares addresses, not what stands in the strings
//      ^
        i = 3;
    i = i << 32;  // warning: shift count is >= width of type
    i = i / 0;  // warning: division by zero is undefined
    printf("%d %p %p %p\n", size(&i), name(), part(), kept());
    return 0;
}
