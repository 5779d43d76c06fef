/* Locals of disjoint blocks, loops and switches; declarations after statements. */
#include <stdio.h>

static int sum;

static void note(int *p) { sum += *p; *p = -1; }

int main(void)
{
    int i;

    {
        int a = 1;
        note(&a);
    }
    {
        int b = 10;
        note(&b);
        int c = b + 100;
        note(&c);
    }
    printf("%d\n", sum);
    for (i = 0; i < 3; i++) {
        int fresh = i;
        if (i == 1) {
            int fresh = 1000;
            note(&fresh);
        }
        note(&fresh);
    }
    printf("%d\n", sum);
    if (sum) {
        double sum = 0.5;
        printf("%g\n", sum);
    } else {
        char sum = 'c';
        printf("%c\n", sum);
    }
    switch (i) {
    case 3: {
        int v[4] = { 1, 2 };
        i += v[1] + v[3];
        break;
    }
    default: {
        int v = 9;
        i += v;
    }
    }
    printf("%d\n", i);
    int last = i * 2;
    printf("%d\n", last);
    return 0;
}
