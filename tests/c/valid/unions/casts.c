/* Casts to a union choose the member by the type of the value. */
#include <stdio.h>
union u {
    int i;
    double d;
    char *s;
    float f;
};
typedef union u U;
static void show(union u x, int k){
    if (k==0) printf("%d\n", x.i);
    else if (k==1) printf("%g\n", x.d);
    else printf("%s\n", x.s);
}
int main(void){
    int i = 5;
    U v;
    show((union u)i, 0);
    show((U)2.5, 1);
    show((U)(char*)"txt", 2);
    v = (U)7;
    printf("%d\n", v.i);
    printf("%g\n", ((U)1.5f).f);
    return 0;
}

