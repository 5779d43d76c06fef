/* Builtins and const variables in constant expressions and static initialisers. */
#include <stdio.h>
static int a[__builtin_popcount(255)];
static int b = __builtin_add_overflow_p(2147483647, 1, 0);
static int c = __builtin_ffs(8), d = __builtin_clz(1), e = __builtin_ctz(16), f=__builtin_parity(7);
static unsigned g = __builtin_bswap32(0x12345678);
static int h2 = __builtin_clrsb(3);
static unsigned long long g2 = __builtin_bswap64(0x0102030405060708ULL);
static int inf = __builtin_isinf(1.0/0.0) ;
static double nn = __builtin_fabs(-3.5), sq = __builtin_sqrt(16.0), fl = __builtin_floor(2.7),
    cs = __builtin_copysign(3.0,-0.0);
enum {
    E = __builtin_popcount(7), F = __builtin_constant_p(3)
};
static int ex = __builtin_expect(5, 1);
static int cmp = __builtin_isnan(0.0) + __builtin_signbit(-1.0);
static int len = sizeof("abc") + __builtin_strlen("hello");
static const int N = 5;
static const double PI = 3.0;
static int t1 = N * 2 + 1;
static double t2 = PI / 2;
static int t3[] = { N, N+1, -N };
static unsigned char t4 = N & 3;
static const int M = N + 1;
static int t5 = M;
static int t6 = N > 3 ? N : 0;
static const char *s = N == 5 ? "five" : "other";
int main(void){
    static int loc = N * 3;
    const int lc = 4;
    static int l2 = M;
    switch (3) {
        case __builtin_popcount(7):
        puts("yes");
    }
    printf("%d %d %d %d %d %d %x %d %llx %d\n",(int)(sizeof a/sizeof*a),b,c,d,e,f,g,h2,g2,inf);
    printf("%g %g %g %g %d %d %d %d %d\n", nn,sq,fl,cs,E,F,ex,cmp,len);
    printf("%d %g %d %d %d %d %d %d %s %d %d\n",t1,t2,t3[0],t3[1],t3[2],t4,t5,t6,s,loc,l2);
    return 0;
}
