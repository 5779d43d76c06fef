/* _Thread_local, _Atomic, sizeof of expressions with bit-fields, a ?: b, arithmetic on void pointers. */
#include <stdio.h>
_Thread_local int tl = 3;
static _Thread_local int tl2;
_Atomic int at = 4;
_Atomic(int) at2 = 5;
struct s {
    int b : 5;
    unsigned u : 3;
} s = {3, 7};
int a[3][4];
typedef int row[4];
static inline int sq(int x) {
    return x * x;
}
_Noreturn void stop(void);
int main(void){
    at++;
    at2 += at;
    printf("%d %d %d %d\n", tl, tl2, at, at2);
    printf("%d %d\n", (int)sizeof(1 ? s.b : 1), (int)sizeof(s.u + 0));
    row *r = a;
    r[1][2] = 5;
    printf("%d %d\n", a[1][2], (int)(sizeof a / sizeof *a));
    printf("%s\n", __func__);
    int x = 3;
    x = x ?: 5;
    printf("%d %d\n", x, 0 ?: 7);
    char c = 200;
    printf("%d %d\n", c, 'ab');
    printf("%d\n", sq(3));
    if (sizeof(long double) > 4) printf("ok\n");
    void *vp = a;
    vp += 4;
    vp++;
    printf("%d\n", (int)((char *)vp - (char *)a));
    return 0;
}

