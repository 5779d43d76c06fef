/* printf of integers, characters and strings: every flag, width and precision. */
#include <stdio.h>

int main(void)
{
    printf("[%d] [%5d] [%-5d] [%05d] [%+d] [% d]\n", 42, 42, 42, 42, 42, 42);
    printf("[%d] [%5d] [%-5d] [%05d] [%+d] [% d]\n", -42, -42, -42, -42, -42, -42);
    printf("[%.3d] [%8.3d] [%-8.3d] [%.0d] [%+.2d]\n", 7, 7, 7, 0, 7);
    printf("[%u] [%x] [%X] [%o] [%#x] [%#o] [%#X]\n", 3000000000u, 255, 255, 8, 255, 8, 255);
    printf("[%08x] [%#10x] [%-#10x] [%#010x]\n", 0xbeef, 0xbeef, 0xbeef, 0xbeef);
    printf("[%hd] [%hhd] [%hu] [%hhu]\n", 70000, 300, 70000, 300);
    printf("[%ld] [%lu] [%lld] [%llu] [%llx]\n", -5L, 5UL, -5000000000ll, 18446744073709551615ull,
           0x123456789abcdefull);
    printf("[%20lld] [%-20lld] [%020lld]\n", 1ll << 40, 1ll << 40, -(1ll << 40));
    printf("[%c] [%5c] [%-5c] [%s] [%10s] [%-10s] [%.3s] [%10.2s]\n", 'a', 'b', 'c', "text", "text",
           "text", "text", "text");
    printf("[%*d] [%-*d] [%.*s] [%*s]\n", 6, 42, 6, 42, 2, "abc", -6, "xy");
    printf("[%%] [%5.1f%%]\n", 99.5);
    printf("[%i] [%zu] [%td]\n", 5, sizeof(int), (char *) 4 - (char *) 1);
    printf("%d\n", printf("%d%s\n", 12345, "abc"));
    printf("[%.10d] [%x] [%d]\n", 12345, -1, -2147483647 - 1);
    printf("[%-08d] [%+ d] [%+u]\n", 5, 5, 5);
    printf("[%#x] [%#o] [%.0x]\n", 0, 0, 0);
    return 0;
}
