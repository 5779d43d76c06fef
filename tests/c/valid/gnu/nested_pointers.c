/* Pointers to nested functions in recursion, left by longjmp; their locals and results. */
#include <stdio.h>
#include <stdlib.h>
#include <setjmp.h>
struct pair {
    int a;
    double b;
};
static void sort_by(int *v, int n, int sign) {
    int compare(const void *x, const void *y) {
        return sign * (*(const int *)x - *(const int *)y);
    }
    qsort(v, n, sizeof *v, compare);
}

static int levels(int n) {
    int v[3] = { n, -n, n * 2 };
    sort_by(v, 3, n % 2 ? 1 : -1);
    return v[0] + (n ? levels(n - 1) : 0);
}

static int each(int n, int (*visit)(int)) {
    return n == 0 ? 0 : visit(n) + each(n - 1, visit);
}

static int tree(int depth, int (*outer)(int)) {
    int here = depth;
    int add(int x) {
        return here * x + (outer ? outer(x) : 0);
    }
    if (depth == 0) return each(3, add);
    return tree(depth - 1, add);
}

static jmp_buf escape;
static int thrower(int n) {
    int f(int x) {
        if (x == 2) longjmp(escape, n);
        return x;
    }
    return each(3, f);
}

static int aligned(int n) {
    _Alignas(64) int big[4] = { 1, 2, 3, n };
    int len[n];
    struct pair p = { n, 0.5 };
    struct pair grow(struct pair q) {
        q.a += big[3] + (int) sizeof len;
        q.b *= 2;
        p = q;
        return p;
    }
    len[0] = 7;
    struct pair r = grow(p);
    int first(void) {
        return len[0] + ({ int t = r.a; t; });
    }
    return r.a + p.a + first() + (int) p.b;
}

static int counter(void) {
    static int calls;
    int next(void) {
        return ++calls;
    }
    int twice(void) {
        next();
        return next();
    }
    return twice() + twice();
}

static long long wide(long long base) {
    long long plus(long long x, char c, float f) {
        return base + x + c + (long long) f;
    }
    long long (*p)(long long, char, float) = plus;
    long long (*q)(long long, char, float) = &plus;
    return p(1LL << 40, 'a', 2.5f) + (p == q);
}

static int old(int n) {
    auto int odd(int);
    int even(int k) {
        return k == 0 ? n : odd(k - 1);
    }
    int odd(int k) {
        return k == 0 ? -n : even(k - 1);
    }
    return even(n) * 100 + odd(n);
}

int main(void) {
    printf("%d\n", levels(60));
    printf("%d\n", tree(5, 0));
    for (int i = 1; i < 40; i++) {
        int k = setjmp(escape);
        if (k == 0) thrower(i);
        else if (k != i) printf("wrong\n");
    }
    printf("%d %d %lld %d %d\n", aligned(5), counter(), wide(3), old(4), old(5));
    return 0;
}
