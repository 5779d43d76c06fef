/* The limits of the integer types of an ILP32 machine. */
#include <stdio.h>
#include <limits.h>
#include <stdint.h>

int main(void)
{
    printf("%d %d %d %d\n", CHAR_BIT, SCHAR_MIN, SCHAR_MAX, UCHAR_MAX);
    printf("%d %d\n", CHAR_MIN, CHAR_MAX);
    printf("%d %d %d\n", SHRT_MIN, SHRT_MAX, USHRT_MAX);
    printf("%d %d %u\n", INT_MIN, INT_MAX, UINT_MAX);
    printf("%ld %ld %lu\n", LONG_MIN, LONG_MAX, ULONG_MAX);
    printf("%lld %lld %llu\n", LLONG_MIN, LLONG_MAX, ULLONG_MAX);
    printf("%d %d %u\n", INT8_MIN, INT16_MAX, UINT32_MAX);
    printf("%u %u %u\n", (unsigned) sizeof(int32_t), (unsigned) sizeof(uint8_t),
           (unsigned) sizeof(int64_t));
    printf("%u %u\n", (unsigned) sizeof(intptr_t), (unsigned) sizeof(size_t));
#if INT_MAX == 2147483647 && LONG_MAX == INT_MAX && UCHAR_MAX > 0
    printf("limits work in #if\n");
#endif
    return 0;
}
