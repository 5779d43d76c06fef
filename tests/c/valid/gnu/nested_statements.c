/* Statement expressions inside each other, as values. */
#include <stdio.h>
#define MAX(a,b) ({ __typeof__(a) _a = (a); __typeof__(b) _b = (b); _a > _b ? _a : _b; })
#define MAX3(a,b,c) MAX(MAX(a,b),c)
#define MAX4(a,b,c,d) MAX(MAX(a,b),MAX(c,d))
#define abs2(x) ({ int x_ = (x); if (x_ < 0) x_ = -x_; x_; })
struct p {
    int x, y;
};
int main(void){
    int n=3;
    printf("%d\n", MAX3(n++, 2, 7));
    printf("%d %d\n", MAX4(1,9,n,4), n);
    printf("%g\n", MAX3(1.5, MAX(2.5f,1), 2));
    int q = ({ int r = ({ int s = 5; s + ({ s * 2; }); }); r * 2; });
    printf("%d\n", q);
    struct p v = ({ struct p w = {1,2}; w.x = ({ int t = w.y; t + 3; }); w; });
    printf("%d %d\n", v.x, v.y);
    printf("%d\n", ({ struct p w = {4,5}; w; }).y);
    printf("%d\n", abs2(abs2(-3) - abs2(-9)));
    int i = ({ goto out; 3; });
    out:
    printf("out\n");
    printf("%d\n", ({ int k = 0; for (int j = 0; j < ({ int m = 4; m; }); j++) k += j; k; }));
    int z = ({ lab: if (n < 10) { n++; goto lab; } n; });
    printf("%d\n", z);
    int nested(int);
    printf("n %d\n", nested(5));
    return 0;
}

#define MAX2(a,b) ({ __typeof__(a) _m = MAX(a,b); MAX(_m, b); })
int nested(int a) {
    return MAX2(a, 4) + ({ ({ a * 2; }); }) + ({ ; ({ int q = a; ({ q + 1; }); }); });
}
