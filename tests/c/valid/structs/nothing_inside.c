/* Empty structs and arrays have size zero, and can be passed. */
#include <stdio.h>
struct e {
};
union u {
};
struct h {
    int a;
    struct e e;
    int b;
    struct e t[3];
};
struct e ge;
struct e arr[4];
struct w {
    int x[0];
} w0;
struct e id(struct e x) {
    return x;
}
int f(int a, struct e x, int b) {
    return a * 10 + b;
}
int main(void){
    struct e x = {}, y;
    y = x;
    x = id(y);
    struct h h = {1, {}, 2, {}};
    int v[3] = {};
    struct h hh = {};
    printf("%d %d %d %d %d\n", (int)sizeof(struct e), (int)sizeof(union u), (int)sizeof h, h.b,
        (int)sizeof arr);
    printf("%d %d %d %d\n", f(1, x, 2), v[2], hh.b, (int)((char*)&h.b - (char*)&h.e));
    printf("%d\n", (int)sizeof w0);
    return 0;
}

