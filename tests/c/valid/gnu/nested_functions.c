/* Nested functions: called, passed as callbacks, recursive. */
#include <stdio.h>
#include <stdlib.h>
static int apply(int (*f)(int), int n) {
    int s = 0;
    for (int i = 0; i < n; i++) s += f(i);
    return s;
}

static int outer(int k) {
    int total = 0;
    int add(int x) {
        total += x * k;
        return total;
    }
    int r = apply(add, 4);
    printf("%d %d\n", r, total);
    auto int later(int);
    int two(int a) {
        return later(a) + 1;
    }
    int later(int b) {
        return b * k;
    }
    printf("%d\n", two(5));
    {
        int inner = 3;
        void deep(int d) {
            int deeper(void) {
                return inner + d + k;
            }
            inner++;
            if (d) deep(d - 1);
            printf("%d\n", deeper());
        }
        deep(2);
        printf("in %d\n", inner);
    }
    return total;
}

static int cmp_dir(int dir, int *a, int n) {
    int cmp(const void *x, const void *y) {
        return dir * (*(int *)x - *(int *)y);
    }
    qsort(a, n, sizeof *a, cmp);
    return a[0];
}

static int fact(int n) {
    int go(int m) {
        return m <= 1 ? n : m * go(m - 1);
    }
    return go(n);
}

int main(void) {
    printf("%d\n", outer(3));
    int a[] = {3,1,2};
    printf("%d\n", cmp_dir(1, a, 3));
    printf("%d\n", cmp_dir(-1, a, 3));
    printf("%d\n", fact(4));
    struct pt {
        int x, y;
    } p = {1, 2};
    struct pt move(int d) {
        p.x += d;
        struct pt q = p;
        return q;
    }
    printf("%d %d\n", move(3).x, p.x);
    int arr[3] = {0};
    void set(int i, int v) {
        arr[i] = v;
    }
    set(1, 5);
    printf("%d\n", arr[1]);
    int find(int v) {
        __label__ none;
        for (int i = 0; i < 3; i++) if (arr[i] == v) return i;
        goto none;
        none:
        return -1;
    }
    printf("%d %d\n", find(5), find(6));
    return 0;
}
