/* Packed enums, constants declared in conditions, strict alignment of local variables. */
#include <stdio.h>
#include <stdint.h>
enum __attribute__((packed)) pe {
    A, B, C = 200
};
enum pn {
    X = -1, Y = 300
} __attribute__((packed));
enum {
    LIMIT = 9
};
typedef struct {
    enum pe e;
    char c;
    enum pn n;
} S;
static int f(void) {
    if (sizeof(enum { LIMIT = 3 }) && LIMIT == 3) {
        printf("in %d\n", LIMIT);
    }
    return LIMIT;
}

static int g(int n) {
    for (int i = 2; i < 5 + sizeof(enum {LIMIT=0}); i++) n += LIMIT;
    while (n < sizeof(enum {LIMIT = 40})*10) n += LIMIT;
    switch (sizeof(enum { LIMIT = 5})) {
        default:
        n += LIMIT;
    }
    do n += LIMIT;
    while (sizeof(enum {LIMIT=1}) == 9);
    return n + LIMIT;
}

static void al(int d) {
    char c;
    __attribute__((aligned(64))) char b[10];
    _Alignas(128) int z;
    int w __attribute__((aligned(32)));
    struct {
        char q;
    } __attribute__((aligned(256))) s;
    c = 1;
    b[0] = 2;
    z = 3;
    w = 4;
    s.q = 5;
    printf("%d %d %d %d %d\n", (int)((uintptr_t)b % 64), (int)((uintptr_t)&z % 128),
        (int)((uintptr_t)&w % 32), (int)((uintptr_t)&s % 256), c + b[0] + z + w + s.q);
    if (d) al(d - 1);
}

int main(void) {
    printf("%d %d %d %d\n", (int)sizeof(enum pe), (int)sizeof(enum pn), (int)sizeof(S), C);
    enum pe v = C;
    printf("%d\n", v);
    v = B;
    printf("%d %d\n", v, (enum pe)256 == A);
    S s = { C, 'c', Y };
    printf("%d %d %d\n", s.e, s.c, s.n);
    printf("%d\n", f());
    printf("%d\n", g(0));
    al(3);
    return 0;
}
