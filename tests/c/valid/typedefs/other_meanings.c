/* Typedef names as labels, members, variables; parentheses around parameters. */
#include <stdio.h>
typedef char T;
typedef int U;
typedef int V;
struct s {
    int T;
    T c;
    U U;
    unsigned T2:3;
};
int g(int T) {
    return T + 1;
}

void f(int ((*x))) {
    *x = 5;
}

void f2(int (*(x)), char ((y))) {
    *x = 5 + y;
}

int (h)(U);
int h(U u) {
    return u;
}

int z1(T), z2(int (T)), z3(int T);
int z3(int T) {
    return sizeof T;
}

int main(void) {
    struct s s = {1, 'x', 3, 2};
    int v;
    {
        typedef char T;
        {
            int T = 5, c = sizeof(T);
            printf("%d %d\n", T, c);
        }
    }
    {
        T T = 3, *p = &T;
        printf("%d\n", *p);
    }
    goto T;
    puts("not");
    T:
    printf("%d %c %d\n", s.T, s.c, s.U);
    U:
    f(&v);
    printf("%d\n", v);
    f2(&v, 3);
    printf("%d %d\n", v, g(3));
    if (v == 3) goto U;
    {
        unsigned V;
        V = 3;
        printf("%u\n", V);
    }
    {
        long U = 4;
        for (int T = 0; T < 2; T++) printf("%ld ", U + T);
        puts("");
    }
    {
        enum {
            T, U
        } e = U;
        printf("%d\n", e);
    }
    printf("%d\n", z3(1));
    return 0;
}
