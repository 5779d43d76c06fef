/* Bit-fields of more than 32 bits are calculated with in their own width, as gcc does. */
#include <stdio.h>
struct s {
    unsigned long long a:40, b:33;
    long long c:35;
    unsigned d:20;
    int e:7;
    unsigned long long f:64;
    unsigned g:32;
    long long h:10;
} s = { 0xffffffffff, 0x1ffffffff, -1, 0xfffff, -1, ~0ull, ~0u, -3 };
int main(void){
    printf("%llx %llx\n", (unsigned long long)(s.a + 1), (unsigned long long)(s.a * s.a));
    printf("%llx\n", (unsigned long long)(s.a << 4));
    printf("%lld\n", (long long)(s.c - 1));
    s.c = 0x3ffffffff;
    printf("%lld\n", (long long)(s.c + 1));
    printf("%d\n", s.b + 1 == 0);
    printf("%d %d\n", (int)sizeof(1 ? s.a : s.b), (int)sizeof(s.a + 0));
    printf("%llx\n", (unsigned long long)-s.a);
    printf("%llx\n", (unsigned long long)~s.a);
    printf("%llx %d\n", (unsigned long long)(s.a + s.b), s.d - 0x100000 < 0);
    printf("%llx %d\n", (unsigned long long)(s.f + 1), s.g + 1 == 0);
    printf("%d %d\n", s.h < 0u, s.h - 5 < 0);
    printf("%llx\n", s.a + 1LL);
    s.a = 5;
    printf("%lld %llx\n", (long long)(s.a - 6), (unsigned long long)(s.a - 6));
    s.a -= 6;
    printf("%llx\n", (unsigned long long)s.a);
    printf("%llx %llx\n",(unsigned long long)(s.a += 3), (unsigned long long)(s.a++));
    unsigned long long x = 1;
    x <<= s.d & 31;
    printf("%d\n", s.a > -1);
    printf("%d\n", (int)(s.b >> 3));
    return 0;
}

