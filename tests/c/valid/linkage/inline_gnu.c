/* The attribute gnu_inline. */
#include <stdio.h>
extern inline __attribute__((gnu_inline)) int twice(int x) {
    return 2 * x;
}

int twice(int x) {
    return 2 * x;
}

extern inline __attribute__((__gnu_inline__, always_inline)) int thrice(int x) {
    return 3 * x;
}

inline __attribute__((gnu_inline)) int four(int x) {
    return 4 * x;
}

inline int five(int x) {
    return 5 * x;
}

extern int five(int);
int main(void) {
    printf("%d %d %d %d\n", twice(2), thrice(3), four(4), five(1));
    return 0;
}
