/* Jumps out of nested functions. */
#include <stdio.h>
static int search(int n) {
    __label__ found;
    int hit = -1;
    void look(int i) {
        if (i * i == n) {
            hit = i;
            goto found;
        }
    }
    for (int i = 0; i < 100; i++) look(i);
    return -1;
    found:
    return hit;
}

static void each(int n, void (*f)(int)) {
    for (int i = 0; i < n; i++) f(i);
}

static int deep(int depth, int limit) {
    __label__ out, other;
    int steps = 0;
    void visit(int i) {
        steps++;
        void inner(int k) {
            if (k + depth == limit) goto out;
            if (k > 50) goto other;
        }
        inner(i);
        if (depth > 0) steps += deep(depth - 1, limit);
    }
    each(4, visit);
    steps += 1000;
    {
        int v[depth + 1];
        v[depth] = 3;
        each(60, visit);
        steps += v[depth];
    }
    other:
    return steps + 7;
    out:
    return -steps;
}

int main(void) {
    printf("%d %d\n", search(49), search(50));
    printf("%d %d %d\n", deep(0, 2), deep(1, 3), deep(2, 99));
    int total = 0;
    for (int r = 0; r < 3; r++) {
        __label__ next;
        int v[r + 1];
        v[r] = r;
        void skip(int q) {
            if (q == 2) goto next;
            total += v[r];
        }
        each(5, skip);
        total += 100;
        next:
        total += 10;
    }
    printf("%d\n", total);
    return 0;
}
