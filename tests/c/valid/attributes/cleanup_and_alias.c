/* The attributes cleanup, alias, transparent_union; aligned functions. */
#include <stdio.h>
#include <stdlib.h>
static void done(int *p) {
    printf("done %d\n", *p);
}

static void fr(char **p) {
    printf("free %s\n", *p);
    free(*p);
}

static int f(int n) {
    int a __attribute__((cleanup(done))) = n;
    __attribute__((__cleanup__(done))) int b = n + 1;
    for (int i = 0; i < 3; i++) {
        int c __attribute__((cleanup(done))) = 100 + i;
        if (i == 1) continue;
        if (n == 2 && i == 2) break;
        if (n == 3) return a + c;
        if (n == 4) goto out;
        printf("body %d\n", c);
    }
    out:
    printf("out\n");
    return a++;
}

static int g(void) {
    char *s __attribute__((cleanup(fr))) = malloc(8);
    s[0] = 'x';
    s[1] = 0;
    return s[0];
}

int real(int x) {
    return x * 2;
}

int other(int) __attribute__((alias("real")));
static int sreal(int x) {
    return x * 3;
}

int salias(int x) __attribute__((weak, alias("sreal")));
int data = 5;
extern int dalias __attribute__((alias("data")));
typedef union {
    int *i;
    float *f;
    const void *v;
} anyp __attribute__((transparent_union));
static int take(anyp p) {
    return *p.i;
}

void af(void) __attribute__((aligned(64)));
void af(void) {
    puts("af");
}

int main(void) {
    for (int n = 1; n <= 4; n++) printf("= %d\n", f(n));
    printf("%d\n", g());
    printf("%d %d\n", other(4), salias(3));
    dalias = 7;
    printf("%d\n", data);
    int x = 3;
    float y = 2;
    printf("%d %x\n", take(&x), take(&y));
    af();
    {
        int q __attribute__((cleanup(done))) = 9;
        {
            int q2 __attribute__((cleanup(done))) = 8;
        }
        puts("mid");
    }
    int se = ({ int k __attribute__((cleanup(done))) = 42; k + 1; });
    printf("%d\n", se);
    return 0;
}
