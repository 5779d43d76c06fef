/* Which integer type an enum is: unsigned without negative constants, 64 bits if need be. */
#include <stdio.h>
enum u {
    A, B = 5
};
enum n {
    M = -1, N
};
enum big {
    L = 0x80000000u, K
};
enum ll {
    Q = 0x100000000LL, R = -1
};
enum huge {
    H = 0xffffffffffffffffULL
};
enum fwd;
enum u8 {
    Z = 255
};
struct bf {
    enum u u:3;
    enum n n:3;
};
int main(void){
    enum u u = A;
    enum n n = M;
    enum big b = L;
    enum ll q = Q;
    printf("%d %d\n", u - 1 < 0, n - 1 < 0);
    u--;
    printf("%d %lld %g\n", u > 0, (long long)u, (double)u);
    printf("%d %d %d %d %d\n", (int)sizeof u, (int)sizeof n, (int)sizeof b, (int)sizeof q,
        (int)sizeof(enum huge));
    printf("%d %d %d %d\n", (int)sizeof A, (int)sizeof L, (int)sizeof Q, (int)sizeof R);
    printf("%lld %lld\n", (long long)q, (long long)(b + 0));
    struct bf f = {5, -2};
    printf("%d %d\n", f.u, f.n);
    printf("%d %d\n", A - 1 < 0, L > 0);
    switch (u) {
        case A: break;
        case B: break;
        default: printf("def\n");
    }
    int *p = (int *)&u;
    enum u *pu = (enum u *)p;
    printf("%d %d\n", *pu == u, -(u == A));
    printf("%d\n", n < A);
    printf("%s\n", _Generic(u, unsigned: "unsigned", int: "int"));
    printf("%s %s\n", _Generic(n, unsigned: "unsigned", int: "int"), _Generic(A,
        unsigned: "unsigned", int: "int"));
    printf("%d\n", u < -1);
    printf("%u %d\n", (u & 0x80000000) >> 31, (int)(u >> 31));
    return 0;
}

