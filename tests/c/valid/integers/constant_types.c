/* The type of an integer constant is the first in its list of types that can represent it (C17 6.4.4.1p5). */
#include <limits.h>
#include <stdio.h>

#define NAME(x) _Generic((x), int: "int", unsigned: "unsigned", long: "long", \
    unsigned long: "unsigned long", long long: "long long", \
    unsigned long long: "unsigned long long", default: "?")
#define SHOW(x) printf("%-22s %s %u\n", #x, NAME(x), (unsigned) sizeof(x))

int main(void)
{
    SHOW(0);
    SHOW(2147483647);
    SHOW(2147483648);
    SHOW(4294967295);
    SHOW(4294967296);
    SHOW(0x7fffffff);
    SHOW(0x80000000);
    SHOW(0xffffffff);
    SHOW(0x100000000);
    SHOW(0x8000000000000000);
    SHOW(037777777777);
    SHOW(040000000000);
    SHOW(1u);
    SHOW(4294967296u);
    SHOW(1l);
    SHOW(2147483648l);
    SHOW(0xffffffffl);
    SHOW(1ul);
    SHOW(1ll);
    SHOW(1LLU);
    SHOW(0xffffffffffffffffll);
    SHOW('a');
    SHOW(sizeof 1);
    SHOW(INT_MIN);
    SHOW(-2147483648);
    return 0;
}
