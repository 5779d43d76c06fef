/* The type of an integer constant depends on its form (C17 6.4.4.1). */
#include <stdio.h>

#define SIZE(x) ((unsigned) sizeof(x))

int main(void)
{
    printf("%d %d %d %d\n", 10, 010, 0x10, 0);
    printf("%u %x %X\n", 4294967295u, 0xDEADBEEF, 0Xabcdef);
    printf("%ld %lu %lld %llu\n", 5L, 5UL, 5LL, 5ULL);
    printf("%u %u %u %u\n", SIZE(1), SIZE(1u), SIZE(1L), SIZE(1ll));
    printf("%u %u %u\n", SIZE(2147483647), SIZE(2147483648), SIZE(0x80000000));
    printf("%u %u\n", SIZE(4294967295), SIZE(0xFFFFFFFF));
    printf("%u %u\n", SIZE(4294967296), SIZE(0x100000000));
    printf("%d %d\n", 2147483648 > 0, -2147483648 < 0);
    printf("%d\n", 0xFFFFFFFF > -1);
    printf("%lld\n", 9223372036854775807);
    printf("%llu\n", 0xFFFFFFFFFFFFFFFF);
    printf("%d %d %d %d\n", 'a', '\n', '\0', '\\');
    printf("%d %d %d\n", '\x41', '\101', '\377');
    printf("%u\n", SIZE('a'));
    printf("%d\n", 0x7fLu == 127);
    return 0;
}
