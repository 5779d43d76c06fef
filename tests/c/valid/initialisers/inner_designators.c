/* Designators for nested subobjects leave the rest zero. */
#include <stdio.h>
struct in {
    int x;
    int y[3];
    int z;
};
struct out {
    int a;
    struct in u;
    int b;
};
struct out g1 = { .u.y[1] = 5 };
struct out g2 = { 1, .u.y[1] = 5, 6, 7, 8 };
struct out garr[3] = { [1].u.y[2] = 4, [2] = {1}, [0].b = 9 };
static void show(struct out *p) {
    printf("%d %d %d %d %d %d %d\n", p->a, p->u.x, p->u.y[0], p->u.y[1], p->u.y[2], p->u.z, p->b);
}

static void dirty(void) {
    volatile int a[64];
    for (int i = 0; i < 64; i++) a[i] = 77;
}

static void t(void) {
    struct out l = { .u.y[1] = 5 };
    show(&l);
    struct out m = { .u = g1.u, .u.y[0] = 8 };
    show(&m);
    struct out k = { .u.y[1] = 5, .u.y[2] = 6, .b = 3};
    show(&k);
    union {
        struct in i;
        int w[5];
    } un = { .i.y[0] = 3 };
    printf("%d %d %d\n", un.w[0], un.w[1], un.w[4]);
    struct {
        union {
            struct in u;
            int q;
        };
        int r;
    } an = { .u.y[1] = 3, .r = 4 };
    printf("%d %d %d %d\n", an.u.x, an.u.y[1], an.u.z, an.r);
    struct {
        union {
            struct {
                char y[4];
                int k;
            } ;
            long long q;
        } u;
        int r;
    } a2 = { .u.y[1] = 3 };
    printf("%d %d %d %d %d\n", a2.u.y[0], a2.u.y[1], a2.u.y[3], a2.u.k, a2.r);
    struct {
        int a;
        union {
            int x;
            struct {
                int p, q[2];
            } y;
        } u;
        int b[2];
    } a3 = { .u.y.q[1] = 7, .b = {1} };
    printf("%d %d %d %d %d %d\n", a3.a, a3.u.y.p, a3.u.y.q[0], a3.u.y.q[1], a3.b[0], a3.b[1]);
}

struct bits {
    unsigned a:3, b:5;
    int c;
};
union ub {
    struct bits y;
    unsigned raw;
};
struct ub2 {
    int t;
    union {
        long long l;
        unsigned char y[8];
    } u;
} gu = { .u.y[1] = 3 };
int main(void) {
    show(&g1);
    show(&g2);
    show(garr);
    show(garr+1);
    show(garr+2);
    dirty();
    t();
    printf("%llx\n", gu.u.l);
    dirty();
    {
        struct ub2 lu = { .u.y[1] = 3 };
        printf("%llx\n", lu.u.l);
    }
    return 0;
}
